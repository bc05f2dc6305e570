#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

/// What a round tool can open of a part and what it swept, on a raster, and how near its centre came to the walls, by brute
/// force over the true curves. Shares nothing with the kernel that makes paths: its own evaluation of curves, its own
/// distances.
namespace blossom::test {

using Polyline = std::vector<Vec2>;

/// A point of a rational B-spline by de Boor's recursion.
inline Vec2 pointOf(const Spline2& s, double u) {
  const auto degree = static_cast<std::size_t>(s.degree);
  std::size_t span = degree;
  while (span + 1 < s.poles.size() && s.knots[span + 1] <= u) ++span;
  std::vector<Vec3> d(s.poles.begin() + static_cast<std::ptrdiff_t>(span - degree),
                      s.poles.begin() + static_cast<std::ptrdiff_t>(span + 1));
  for (std::size_t r = 1; r <= degree; ++r)
    for (std::size_t j = degree; j >= r; --j) {
      const double low = s.knots[span - degree + j], high = s.knots[span + 1 + j - r];
      const double share = high > low ? (u - low) / (high - low) : 0;
      d[j] = (1 - share) * d[j - 1] + share * d[j];
    }
  return d[degree].head<2>() / d[degree].z();
}

/// Points of a segment, with lines between them that are within about `chord` of it.
inline Polyline sampled(const Segment& segment, double chord) {
  if (const auto* line = std::get_if<Line2>(&segment)) return {line->from, line->to};
  Polyline points;
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const double step = 2 * std::acos(std::max(0.0, 1 - chord / arc->radius));
    const int count = std::max(2, static_cast<int>(std::ceil(std::abs(arc->sweep) / step)));
    for (int i = 0; i <= count; ++i) {
      const double angle = arc->start + arc->sweep * i / count;
      points.emplace_back(arc->center + arc->radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
  }
  const auto& spline = std::get<Spline2>(segment);
  const auto degree = static_cast<std::size_t>(spline.degree);
  for (std::size_t i = degree; i < spline.poles.size(); ++i) {
    const double a = spline.knots[i], b = spline.knots[i + 1];
    if (!(b > a)) continue;
    for (int count = 4;; count *= 2) {  // until the points between are near the lines
      Polyline run;
      for (int k = 0; k <= 2 * count; ++k)
        run.push_back(pointOf(spline, k == 2 * count ? b : a + (b - a) * k / (2 * count)));
      double off = 0;
      for (std::size_t k = 1; k < run.size(); k += 2) off = std::max(off, (run[k] - (run[k - 1] + run[k + 1]) / 2).norm());
      if (off > 4 * chord && count < 1 << 14) continue;
      points.insert(points.end(), run.begin(), run.end());
      break;
    }
  }
  return points;
}

struct ShortLine {
  Vec2 from, to;
  [[nodiscard]] double distance(const Vec2& p) const {
    const Vec2 along = to - from;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((p - from).dot(along) / squared, 0.0, 1.0) : 0;
    return (from + t * along - p).norm();
  }
};

inline std::vector<ShortLine> linesOf(const Region& part, double chord) {
  std::vector<ShortLine> lines;
  for (const Path& loop : part.loops) {
    Polyline ring;
    for (const Segment& segment : loop.segments) {
      const Polyline points = sampled(segment, chord);
      ring.insert(ring.end(), points.begin(), points.end() - 1);  // the next one begins there: rounding leaves no gap
    }
    for (std::size_t i = 0; i < ring.size(); ++i) lines.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
  return lines;
}

/// Marks of nodes at even distances in x and y.
class Raster {
 public:
  Raster(const Vec2& low, const Vec2& high, double step)
      : low_(low),
        step_(step),
        columns_(static_cast<int>(std::ceil((high.x() - low.x()) / step)) + 1),
        rows_(static_cast<int>(std::ceil((high.y() - low.y()) / step)) + 1) {}

  using Marks = std::vector<char>;
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] Vec2 at(int column, int row) const { return low_ + step_ * Vec2(column, row); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  /// The nodes within a radius of any of the lines.
  [[nodiscard]] Marks within(const std::vector<ShortLine>& lines, double radius) const {
    std::vector<int> change(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_ + 1), 0);
    for (const ShortLine& line : lines) {
      const double bottom = std::min(line.from.y(), line.to.y()) - radius,
                   top = std::max(line.from.y(), line.to.y()) + radius;
      const int first = std::max(0, static_cast<int>(std::ceil((bottom - low_.y()) / step_)));
      const int last = std::min(rows_ - 1, static_cast<int>(std::floor((top - low_.y()) / step_)));
      for (int row = first; row <= last; ++row) {
        const auto [left, right] = across(line, radius, low_.y() + step_ * row);
        const int begin = std::max(0, static_cast<int>(std::ceil((left - low_.x()) / step_)));
        const int end = std::min(columns_, static_cast<int>(std::floor((right - low_.x()) / step_)) + 1);
        if (begin >= end) continue;
        const std::size_t base = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1);
        ++change[base + static_cast<std::size_t>(begin)];
        --change[base + static_cast<std::size_t>(end)];
      }
    }
    Marks marks(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), 0);
    for (int row = 0; row < rows_; ++row) {
      int depth = 0;
      for (int column = 0; column < columns_; ++column) {
        depth += change[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
                        static_cast<std::size_t>(column)];
        marks[index(column, row)] = depth > 0;
      }
    }
    return marks;
  }

  /// The nodes in the area that closed polylines enclose, by the even-odd rule.
  [[nodiscard]] Marks inside(const std::vector<ShortLine>& lines) const {
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
    for (const ShortLine& line : lines) {
      const auto [a, b] = line.from.y() < line.to.y() ? std::pair(line.from, line.to) : std::pair(line.to, line.from);
      const int first = std::max(0, static_cast<int>(std::floor((a.y() - low_.y()) / step_)));
      for (int row = first; row < rows_ && low_.y() + step_ * row < b.y(); ++row) {
        const double y = low_.y() + step_ * row;
        if (y >= a.y())
          crossings[static_cast<std::size_t>(row)].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
    }
    Marks marks(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), 0);
    for (int row = 0; row < rows_; ++row) {
      std::vector<double>& xs = crossings[static_cast<std::size_t>(row)];
      std::sort(xs.begin(), xs.end());
      std::size_t passed = 0;
      for (int column = 0; column < columns_; ++column) {
        while (passed < xs.size() && xs[passed] <= at(column, row).x()) ++passed;
        marks[index(column, row)] = passed % 2 == 1;
      }
    }
    return marks;
  }

 private:
  /// Where a row crosses the area within a radius of a line: that area is convex, so its rim is met twice at most.
  static std::pair<double, double> across(const ShortLine& line, double radius, double y) {
    double left = 1e300, right = -1e300;
    const auto take = [&](double x) {
      left = std::min(left, x);
      right = std::max(right, x);
    };
    for (const Vec2& p : {line.from, line.to}) {
      const double squared = radius * radius - (y - p.y()) * (y - p.y());
      if (squared < 0) continue;
      take(p.x() - std::sqrt(squared));
      take(p.x() + std::sqrt(squared));
    }
    const Vec2 along = line.to - line.from;
    const double length = along.norm();
    if (length == 0 || along.y() == 0) return {left, right};
    const Vec2 normal(-along.y() / length, along.x() / length);
    for (const double side : {-radius, radius}) {
      const double t = (y - line.from.y() - side * normal.y()) / along.y();
      if (t >= 0 && t <= 1) take(line.from.x() + t * along.x() + side * normal.x());
    }
    return {left, right};
  }

  Vec2 low_;
  double step_;
  int columns_, rows_;
};

/// A part and a tool: what the tool can open, and how deep a way of its centre cuts into the walls.
class ReachOracle {
 public:
  /// Curves are taken within `chord`; the raster has about `nodes` nodes.
  ReachOracle(const Region& part, double radius, double chord, double nodes)
      : radius_(radius), lines_(linesOf(part, chord)), raster_(rasterOf(lines_, nodes)) {
    const Raster::Marks inside = raster_.inside(lines_), beside = raster_.within(lines_, radius + 2 * chord);
    Raster::Marks legal(inside.size());
    for (std::size_t i = 0; i < legal.size(); ++i) legal[i] = inside[i] && !beside[i];
    // Every node that a tool with its centre on a legal node covers: surely within reach.
    std::vector<ShortLine> rim;
    for (int row = 0; row < raster_.rows(); ++row)
      for (int column = 0; column < raster_.columns(); ++column)
        if (legal[raster_.index(column, row)] && onRim(legal, column, row))
          rim.push_back({raster_.at(column, row), raster_.at(column, row)});
    reach_ = raster_.within(rim, radius);
    for (std::size_t i = 0; i < legal.size(); ++i) reach_[i] = reach_[i] || legal[i];
    sortIntoCells();
    inside_ = inside;
  }

  [[nodiscard]] double reachable() const {
    return raster_.step() * raster_.step() * static_cast<double>(std::count(reach_.begin(), reach_.end(), 1));
  }

  struct Left {
    double area = 0;
    Vec2 at = Vec2::Zero();
  };
  /// What lies within reach and not within `swept` of the ways of the tool's centre.
  [[nodiscard]] Left left(const std::vector<ShortLine>& ways, double swept) const {
    const Raster::Marks cut = raster_.within(ways, swept);
    Left result;
    for (int row = 0; row < raster_.rows(); ++row)
      for (int column = 0; column < raster_.columns(); ++column) {
        const std::size_t i = raster_.index(column, row);
        if (!reach_[i] || cut[i]) continue;
        if (result.area == 0) result.at = raster_.at(column, row);
        result.area += raster_.step() * raster_.step();
      }
    return result;
  }

  /// mm that a tool with its centre here cuts into a wall; large outside of the part.
  [[nodiscard]] double gouge(const Vec2& p) const {
    double nearest = radius_;
    const Vec2 cell = (p - corner_) / radius_;
    const int x = static_cast<int>(std::floor(cell.x())), y = static_cast<int>(std::floor(cell.y()));
    for (int row = std::max(0, y - 1); row <= std::min(cellRows_ - 1, y + 1); ++row)
      for (int column = std::max(0, x - 1); column <= std::min(cellColumns_ - 1, x + 1); ++column)
        for (const std::size_t i : cells_[cellIndex(column, row)]) nearest = std::min(nearest, lines_[i].distance(p));
    return isInside(p, nearest) ? radius_ - nearest : radius_ + nearest;
  }

 private:
  static Raster rasterOf(const std::vector<ShortLine>& lines, double nodes) {
    Vec2 low = lines.front().from, high = low;
    for (const ShortLine& line : lines) {
      low = low.cwiseMin(line.from);
      high = high.cwiseMax(line.from);
    }
    const Vec2 size = high - low;
    return {low, high, std::sqrt(size.x() * size.y() / nodes)};
  }

  [[nodiscard]] bool onRim(const Raster::Marks& legal, int column, int row) const {
    for (const auto& [x, y] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
      const int c = column + x, r = row + y;
      if (c < 0 || r < 0 || c >= raster_.columns() || r >= raster_.rows() || !legal[raster_.index(c, r)]) return true;
    }
    return false;
  }

  /// Lines by squares as large as the tool's radius, each in all squares that its box meets.
  void sortIntoCells() {
    Vec2 high = lines_.front().from;
    corner_ = high;
    for (const ShortLine& line : lines_) {
      corner_ = corner_.cwiseMin(line.from);
      high = high.cwiseMax(line.from);
    }
    cellColumns_ = static_cast<int>((high.x() - corner_.x()) / radius_) + 1;
    cellRows_ = static_cast<int>((high.y() - corner_.y()) / radius_) + 1;
    cells_.resize(static_cast<std::size_t>(cellColumns_) * static_cast<std::size_t>(cellRows_));
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Vec2 a = (lines_[i].from.cwiseMin(lines_[i].to) - corner_) / radius_;
      const Vec2 b = (lines_[i].from.cwiseMax(lines_[i].to) - corner_) / radius_;
      for (int row = static_cast<int>(a.y()); row <= static_cast<int>(b.y()); ++row)
        for (int column = static_cast<int>(a.x()); column <= static_cast<int>(b.x()); ++column)
          cells_[cellIndex(column, row)].push_back(i);
    }
  }
  [[nodiscard]] std::size_t cellIndex(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cellColumns_) + static_cast<std::size_t>(column);
  }

  /// The node beside the point tells when no wall lies between; else the lines to the right are counted.
  [[nodiscard]] bool isInside(const Vec2& p, double nearest) const {
    const Vec2 node = (p - raster_.at(0, 0)) / raster_.step();
    if (nearest > raster_.step()) {
      const int column = static_cast<int>(std::lround(node.x())), row = static_cast<int>(std::lround(node.y()));
      const bool on = column >= 0 && row >= 0 && column < raster_.columns() && row < raster_.rows();
      return on && inside_[raster_.index(column, row)];
    }
    bool in = false;
    for (const ShortLine& line : lines_) {
      if ((line.from.y() <= p.y()) == (line.to.y() <= p.y())) continue;
      const double t = (p.y() - line.from.y()) / (line.to.y() - line.from.y());
      if (line.from.x() + t * (line.to.x() - line.from.x()) > p.x()) in = !in;
    }
    return in;
  }

  double radius_;
  std::vector<ShortLine> lines_;
  Raster raster_;
  Raster::Marks reach_, inside_;
  Vec2 corner_ = Vec2::Zero();
  int cellColumns_ = 0, cellRows_ = 0;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace blossom::test
