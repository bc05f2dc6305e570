#include "kernel/compare/distance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/parallel.h"
#include "geometry/numeric/box_tree.h"

namespace blossom::minkowski {
namespace {

struct FieldEdge {
  Vec2 from, to;
};

double squaredDistanceTo(const FieldEdge& edge, const Vec2& p) {
  const Vec2 along = edge.to - edge.from;
  const double part = std::clamp((p - edge.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (edge.from + part * along - p).squaredNorm();
}

/// The edges of polygons with a tree around them.
class FieldBoundary {
 public:
  FieldBoundary(const Polygons& shape, const Progress& progress) {
    for (const Polygon& part : shape) {
      add(part.outer);
      for (const Loop& hole : part.holes) add(hole);
    }
    std::vector<Box2> boxes;
    for (const FieldEdge& edge : edges_) boxes.emplace_back(edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to));
    constexpr std::size_t leafSize = 4;
    tree_ = BoxTree<2>(boxes, leafSize, progress);
  }

  /// @param atMost a distance that is not exceeded
  [[nodiscard]] double distance(const Vec2& p, double atMost) const {
    double best = atMost * atMost;
    tree_.walk([&](const Box2& box) { return squaredDistance(box, p); },
               [&](std::size_t i) { best = std::min(best, squaredDistanceTo(edges_[i], p)); },
               [&](double distance) { return distance < best; });
    return std::sqrt(best);
  }

  /// Where the horizontal line at y passes the boundary, from left to right.
  [[nodiscard]] std::vector<double> passages(double y) const {
    std::vector<double> places;
    const double far = std::numeric_limits<double>::max();
    tree_.meeting(Box2(Vec2(-far, y), Vec2(far, y)), [&](std::size_t i) {
      const FieldEdge& edge = edges_[i];
      if ((edge.from.y() > y) == (edge.to.y() > y)) return;
      const double part = (y - edge.from.y()) / (edge.to.y() - edge.from.y());
      places.push_back(edge.from.x() + part * (edge.to.x() - edge.from.x()));
    });
    std::sort(places.begin(), places.end());
    return places;
  }

 private:
  void add(const Loop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) edges_.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }

  std::vector<FieldEdge> edges_;
  BoxTree<2> tree_;
};

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// The pieces of the outlines, each from side to side of a cell. Sides are numbered by the node at their lower or left end:
/// horizontal ones first.
class SquareMarch {
 public:
  SquareMarch(const std::vector<double>& field, const FieldGrid& grid)
      : field_(field), grid_(grid), next_(2 * grid.nodes(), nowhere) {}

  /// Negative values lie to the left of the pieces.
  void march(const Progress& progress) {
    for (std::size_t row = 0; row + 1 < grid_.rows; ++row) {
      progress.check();
      for (std::size_t column = 0; column + 1 < grid_.columns; ++column) cutCell(row * grid_.columns + column);
    }
  }

  std::vector<Loop> loops(const Progress& progress) {
    std::vector<Loop> loops;
    for (std::size_t side = 0; side < next_.size(); ++side) {
      if (next_[side] == nowhere) continue;
      progress.check();
      Loop& loop = loops.emplace_back();
      for (std::size_t at = side; next_[at] != nowhere;) {
        loop.push_back(place(at));
        const std::size_t after = next_[at];
        next_[at] = nowhere;
        at = after;
      }
    }
    return loops;
  }

 private:
  void cutCell(std::size_t node) {
    const std::size_t above = node + grid_.columns;
    const std::array<double, 4> values{field_[node], field_[node + 1], field_[above + 1], field_[above]};
    const auto inside = [&](std::size_t corner) { return values[corner % 4] < 0; };
    const std::size_t count =
        static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [](double v) { return v < 0; }));
    if (count == 0 || count == 4) return;
    const std::array<std::size_t, 4> sides{node, grid_.nodes() + node + 1, above, grid_.nodes() + node};
    const bool twice = count == 2 && inside(0) == inside(2);
    const bool joined = values[0] + values[1] + values[2] + values[3] < 0;
    for (std::size_t k = 0; k < 4; ++k) {  // side k runs from corner k to the next one, counter-clockwise
      if (!inside(k) || inside(k + 1)) continue;
      std::size_t last = (k + 3) % 4;           // around the corner that is inside
      if (twice && joined) last = (k + 1) % 4;  // around the one that is not
      while (!twice && (inside(last) || !inside(last + 1))) last = (last + 1) % 4;
      next_[sides[k]] = static_cast<std::uint32_t>(sides[last]);
    }
  }

  /// Where the field is 0 along a side. Kept off the nodes, so that loops do not touch.
  [[nodiscard]] Vec2 place(std::size_t side) const {
    const bool upright = side >= grid_.nodes();
    const std::size_t node = upright ? side - grid_.nodes() : side, other = node + (upright ? grid_.columns : 1);
    constexpr double least = 1e-6;
    const double part = std::clamp(field_[node] / (field_[node] - field_[other]), least, 1 - least);
    return grid_.node(node % grid_.columns, node / grid_.columns) + part * grid_.step * (upright ? Vec2(0, 1) : Vec2(1, 0));
  }

  const std::vector<double>& field_;
  const FieldGrid& grid_;
  std::vector<std::uint32_t> next_;  ///< the side at which the piece ends that begins at a side
};

}  // namespace

FieldGrid fieldGrid(const Box2& box, std::size_t cells) {
  FieldGrid grid;
  grid.step = box.sizes().maxCoeff() / static_cast<double>(cells);
  const auto nodesOver = [&](double size) { return static_cast<std::size_t>(std::ceil(size / grid.step - 1e-9)) + 3; };
  grid.columns = nodesOver(box.sizes().x());
  grid.rows = nodesOver(box.sizes().y());
  const Vec2 covered = grid.step * Vec2(static_cast<double>(grid.columns - 1), static_cast<double>(grid.rows - 1));
  grid.origin = box.center() - covered / 2;
  return grid;
}

std::vector<double> signedDistances(const Polygons& shape, const FieldGrid& grid, const Progress& progress) {
  const FieldBoundary boundary(shape, progress);
  std::vector<double> field(grid.nodes());
  constexpr std::size_t rowsAtOnce = 4;
  parallelFor(grid.rows, rowsAtOnce, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      progress.check();
      const std::vector<double> passages = boundary.passages(grid.node(0, row).y());
      double atMost = std::numeric_limits<double>::max() / 2;
      atMost = std::sqrt(atMost);
      for (std::size_t column = 0; column < grid.columns; ++column) {
        const Vec2 p = grid.node(column, row);
        const double distance = boundary.distance(p, atMost);
        const auto left = std::upper_bound(passages.begin(), passages.end(), p.x()) - passages.begin();
        field[row * grid.columns + column] = left % 2 == 1 ? -distance : distance;
        atMost = (distance + grid.step) * (1 + 1e-12);  // no field grows faster
      }
    }
  });
  return field;
}

std::vector<double> blendedField(const std::vector<double>& a, const std::vector<double>& b, double t) {
  std::vector<double> field(a.size());
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = (1 - t) * a[i] + t * b[i];
  return field;
}

std::vector<Loop> negativeOutlines(const std::vector<double>& field, const FieldGrid& grid, const Progress& progress) {
  SquareMarch march(field, grid);
  march.march(progress);
  return march.loops(progress);
}

}  // namespace blossom::minkowski
