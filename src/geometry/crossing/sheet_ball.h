#pragma once
#include <algorithm>
#include <array>
#include <compare>
#include <cstdlib>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/crossing/divided_triangles.h"
#include "geometry/crossing/sheet_mesh.h"
#include "geometry/crossing/smooth_sheets.h"
#include "geometry/mesh/triangle_distance.h"
#include "geometry/numeric/box_tree.h"

namespace blossom {

/// The triangles in a ball, divided until they are small.
class SheetBall {
 public:
  SheetBall(const SheetMesh& mesh, const SmoothSheets& sheets, const Vec3& middle, double radius)
      : sheets_(sheets), middle_(middle), radius_(radius) {
    const Box3 box(Vec3(middle.array() - radius), Vec3(middle.array() + radius));
    for (const SheetBlock& block : mesh.blocks) {
      if (!block.box.intersects(box)) continue;
      for (std::uint32_t k = block.first; k < block.first + block.count; ++k)
        if (reaches(mesh.at(mesh.triangles[k]))) take(mesh, mesh.triangles[k]);
    }
  }

  /// Leaves what lies within a part of the ball with all its corners.
  void keepWhole(double share) {
    const double within = share * radius_;
    std::erase_if(triangles, [&](const SheetTriangle& t) {
      const Triangle3 corners = at(t);
      return std::any_of(corners.begin(), corners.end(), [&](const Vec3& p) { return (p - middle_).norm() > within; });
    });
  }

  /// Halves the sides that are longer than `longest` or farther than `off` from the smooth face, as often as it takes; those
  /// up to `fine` are not looked at.
  void divide(double longest, double off, double fine, const Progress& progress) {
    constexpr int rounds = 14;
    constexpr std::size_t many = 20000;
    const auto tooLong = [&](const Vec3& p, const Vec3& q, const Vec3& middle) {
      const Vec3 along = q - p;
      return along.squaredNorm() > longest * longest ||
             along.cross(middle - p).squaredNorm() > off * off * along.squaredNorm();
    };
    const auto wanted = [&](const Triangle3& t) { return reaches(t); };
    TriangleDivision division(points, triangles, sheets_, tooLong, fine);
    for (int round = 0; round < rounds && division.count() < many; ++round) {
      progress.check();
      if (!division.divideOnce(wanted)) break;
    }
    triangles = division.triangles(wanted);
  }

  [[nodiscard]] Triangle3 at(const SheetTriangle& t) const {
    return {points[static_cast<std::size_t>(t.corners[0])], points[static_cast<std::size_t>(t.corners[1])],
            points[static_cast<std::size_t>(t.corners[2])]};
  }

  std::vector<Vec3> points;
  std::vector<SheetTriangle> triangles;

 private:
  [[nodiscard]] bool reaches(const Triangle3& t) const {
    return (closestOnTriangle(middle_, t) - middle_).squaredNorm() <= radius_ * radius_;
  }

  void take(const SheetMesh& mesh, SheetTriangle t) {
    for (int& corner : t.corners) {
      const auto [found, isNew] = numbers_.try_emplace(corner, static_cast<int>(points.size()));
      if (isNew) points.push_back(mesh.points[static_cast<std::size_t>(corner)]);
      corner = found->second;
    }
    triangles.push_back(t);
  }

  const SmoothSheets& sheets_;
  Vec3 middle_;
  double radius_;
  std::unordered_map<int, int> numbers_;
};

/// What hangs together over sides, all of its triangles turned one way round.
struct LocalSheet {
  std::vector<Triangle3> triangles;
  std::vector<SheetTriangle> onFace;     ///< the same on their faces, with the corners in the same order
  std::vector<std::array<bool, 3>> rim;  ///< whether the side from corner k to the next is of one triangle alone
  std::vector<Vec3> points;              ///< corners within the ball
  BoxTree<3> tree;                       ///< of the triangles

  void finish() {
    std::vector<Box3> boxes;
    boxes.reserve(triangles.size());
    for (const Triangle3& t : triangles) boxes.push_back(boxOf(t));
    tree = BoxTree<3>(boxes);
  }
};

/// The sheets of a ball, by numbers from 1.
class SheetsOfBall {
 public:
  explicit SheetsOfBall(const SheetBall& ball)
      : ball_(ball), mark_(ball.triangles.size(), 0), sides_(3 * ball.triangles.size()) {
    listSides();
    int count = 0;
    for (std::size_t k = 0; k < mark_.size(); ++k)
      if (mark_[k] == 0) flood(k, ++count);
  }

  /// The triangle of a face nearest to a point, of those equally near the one nearest by its parameters.
  [[nodiscard]] std::optional<std::size_t> triangleAt(const SheetPlace& place, const Vec3& point, double slack) const {
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < ball_.triangles.size(); ++k) {
      const SheetTriangle& t = ball_.triangles[k];
      if (t.face != place.face) continue;
      const double off = ((t.at[0] + t.at[1] + t.at[2]) / 3 - place.at).squaredNorm();
      if (off >= least || (closestOnTriangle(point, ball_.at(t)) - point).norm() > slack) continue;
      least = off, best = k;
    }
    return best;
  }

  [[nodiscard]] int sheetOf(std::size_t triangle) const { return std::abs(mark_[triangle]); }

  [[nodiscard]] LocalSheet sheet(int number, const Vec3& middle, double radius) const {
    LocalSheet result;
    std::vector<bool> taken(ball_.points.size());
    for (std::size_t k = 0; k < ball_.triangles.size(); ++k) {
      if (std::abs(mark_[k]) != number) continue;
      SheetTriangle t = ball_.triangles[k];
      std::array<bool, 3> rim{};
      for (std::size_t i = 0; i < 3; ++i) rim[i] = over(k, i).size() == 1;
      if (mark_[k] < 0) std::swap(t.corners[0], t.corners[1]), std::swap(t.at[0], t.at[1]), std::swap(rim[1], rim[2]);
      result.triangles.push_back(ball_.at(t));
      result.onFace.push_back(t);
      result.rim.push_back(rim);
      for (const int corner : ball_.triangles[k].corners) {
        const auto c = static_cast<std::size_t>(corner);
        if (!taken[c] && (ball_.points[c] - middle).norm() <= radius) result.points.push_back(ball_.points[c]);
        taken[c] = true;
      }
    }
    result.finish();
    return result;
  }

 private:
  /// The numbers of its ends, the lower one first.
  using TriangleSide = std::pair<int, int>;
  [[nodiscard]] TriangleSide side(std::size_t k, std::size_t i) const {
    const auto& corners = ball_.triangles[k].corners;
    return std::minmax({corners[i], corners[(i + 1) % 3]});
  }
  struct Listed {
    TriangleSide side;
    std::size_t triangle = 0, which = 0;  ///< of its three sides
    friend auto operator<=>(const Listed&, const Listed&) = default;
  };

  void listSides() {
    for (std::size_t k = 0; k < mark_.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) sides_[3 * k + i] = {side(k, i), k, i};
    std::sort(sides_.begin(), sides_.end());
    from_.resize(sides_.size());
    for (std::size_t first = 0, e = 0; e < sides_.size(); ++e) {
      if (sides_[e].side != sides_[first].side) first = e;
      from_[3 * sides_[e].triangle + sides_[e].which] = first;
    }
  }

  /// The triangles that have side i of triangle k.
  [[nodiscard]] std::span<const Listed> over(std::size_t k, std::size_t i) const {
    const std::size_t first = from_[3 * k + i];
    std::size_t last = first;
    while (last < sides_.size() && sides_[last].side == sides_[first].side) ++last;
    return std::span(sides_).subspan(first, last - first);
  }

  /// Marks what hangs together with a triangle.
  void flood(std::size_t seed, int number) {
    std::vector<std::size_t> open{seed};
    mark_[seed] = number;
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
        for (const Listed& other : over(k, i)) {
          if (mark_[other.triangle] != 0) continue;
          const bool sameWay = runsUp(k, i) != runsUp(other.triangle, other.which);
          mark_[other.triangle] = sameWay ? mark_[k] : -mark_[k];
          open.push_back(other.triangle);
        }
    }
  }

  /// Whether a triangle runs along a side from the lower number to the higher one.
  [[nodiscard]] bool runsUp(std::size_t k, std::size_t i) const {
    const auto& corners = ball_.triangles[k].corners;
    return corners[i] < corners[(i + 1) % 3];
  }

  const SheetBall& ball_;
  std::vector<int> mark_;          ///< number of the sheet, negative where the triangle is turned
  std::vector<Listed> sides_;      ///< sorted
  std::vector<std::size_t> from_;  ///< of side i of triangle k, at 3 k + i: its first place in `sides_`
};

}  // namespace blossom
