#include "geometry/crossing/local_sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "geometry/crossing/divided_triangles.h"
#include "geometry/mesh/triangle_distance.h"
#include "geometry/numeric/box_tree.h"

namespace blossom {
namespace {

using TriangleSide = std::pair<int, int>;

TriangleSide sideBetween(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// The triangles in a ball, divided until they are small.
class Ball {
 public:
  Ball(const SheetMesh& mesh, const SmoothSheets& sheets, const Vec3& middle, double radius)
      : sheets_(sheets), middle_(middle), radius_(radius) {
    const Box3 box(Vec3(middle.array() - radius), Vec3(middle.array() + radius));
    for (const SheetBlock& block : mesh.blocks) {
      if (!block.box.intersects(box)) continue;
      for (std::uint32_t k = block.first; k < block.first + block.count; ++k)
        if (reaches(mesh.at(mesh.triangles[k]))) take(mesh, mesh.triangles[k]);
    }
  }

  /// Halves the sides that are longer than `longest` or farther than `off` from the smooth face, as often as it takes.
  void divide(double longest, double off, const Progress& progress) {
    constexpr int rounds = 14;
    constexpr std::size_t many = 20000;
    const auto tooLong = [&](const Vec3& p, const Vec3& q, const Vec3& middle) {
      const Vec3 along = q - p;
      return along.squaredNorm() > longest * longest ||
             along.cross(middle - p).squaredNorm() > off * off * along.squaredNorm();
    };
    for (int round = 0; round < rounds && triangles.size() < many; ++round) {
      progress.check();
      std::erase_if(triangles, [&](const SheetTriangle& t) { return !reaches(at(t)); });
      if (!divideOnce(points, triangles, sheets_, tooLong)) return;
    }
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

class Sheets {
 public:
  explicit Sheets(const Ball& ball) : ball_(ball), mark_(ball.triangles.size(), 0) {
    sides_.reserve(3 * ball.triangles.size());
    for (std::size_t k = 0; k < ball.triangles.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) sides_.emplace_back(side(k, i), k);
    std::sort(sides_.begin(), sides_.end());
  }

  /// The triangle of a face nearest to a point, of those equally near the one nearest by its parameters.
  [[nodiscard]] std::optional<std::size_t> triangleAt(const SheetPlace& place, const Vec3& point, double slack) const {
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < ball_.triangles.size(); ++k) {
      const SheetTriangle& t = ball_.triangles[k];
      if (t.face != place.face) continue;
      if ((closestOnTriangle(point, ball_.at(t)) - point).norm() > slack) continue;
      const double off = ((t.at[0] + t.at[1] + t.at[2]) / 3 - place.at).squaredNorm();
      if (off < least) least = off, best = k;
    }
    return best;
  }

  /// Marks the sheet of a triangle by a number; false when it has another one already.
  bool flood(std::size_t from, int number) {
    if (mark_[from] != 0) return false;
    std::vector<std::size_t> open{from};
    mark_[from] = number;
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
        for (const auto& [which, other] : over(side(k, i))) {
          if (other == k || mark_[other] != 0) continue;
          const bool sameWay = runsUp(k, side(k, i)) != runsUp(other, side(k, i));
          mark_[other] = sameWay ? mark_[k] : -mark_[k];
          open.push_back(other);
        }
    }
    return true;
  }

  [[nodiscard]] LocalSheet sheet(int number, const Vec3& middle, double radius) const {
    LocalSheet result;
    std::vector<bool> taken(ball_.points.size());
    for (std::size_t k = 0; k < ball_.triangles.size(); ++k) {
      if (std::abs(mark_[k]) != number) continue;
      Triangle3 t = ball_.at(ball_.triangles[k]);
      std::array<bool, 3> rim{};
      for (std::size_t i = 0; i < 3; ++i) rim[i] = over(side(k, i)).size() == 1;
      if (mark_[k] < 0) std::swap(t[0], t[1]), std::swap(rim[1], rim[2]);
      result.triangles.push_back(t);
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
  [[nodiscard]] TriangleSide side(std::size_t k, std::size_t i) const {
    const auto& corners = ball_.triangles[k].corners;
    return sideBetween(corners[i], corners[(i + 1) % 3]);
  }
  [[nodiscard]] std::span<const std::pair<TriangleSide, std::size_t>> over(const TriangleSide& side) const {
    const auto from = std::lower_bound(sides_.begin(), sides_.end(), std::pair(side, std::size_t{0}));
    const auto to = std::find_if(from, sides_.end(), [&](const auto& each) { return each.first != side; });
    return {from, to};
  }

  /// Whether a triangle runs along its side from the lower number to the higher one.
  [[nodiscard]] bool runsUp(std::size_t k, const TriangleSide& wanted) const {
    const auto& corners = ball_.triangles[k].corners;
    for (std::size_t i = 0; i < 3; ++i)
      if (side(k, i) == wanted) return corners[i] < corners[(i + 1) % 3];
    return true;
  }

  const Ball& ball_;
  std::vector<std::pair<TriangleSide, std::size_t>> sides_;  ///< sorted, with the triangles that have them
  std::vector<int> mark_;  ///< number of the sheet, negative where the triangle is turned; 0: none
};

/// Whether a point of a triangle lies on a side of it that is part of the rim.
bool isOnRim(const Triangle3& t, const std::array<bool, 3>& rim, const Vec3& foot) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!rim[i]) continue;
    const Vec3 &a = t[i], along = t[(i + 1) % 3] - a;
    if (along.cross(foot - a).squaredNorm() <= 1e-18 * along.squaredNorm() * along.squaredNorm()) return true;
  }
  return false;
}

/// The signed distance of a point from a sheet; 0 where the nearest point lies on the rim.
double distanceFrom(const LocalSheet& sheet, const Vec3& p) {
  constexpr double same = 1 + 1e-9;
  double least = std::numeric_limits<double>::max();
  std::vector<std::pair<std::size_t, Vec3>> nearest;
  const auto visit = [&](std::size_t k) {
    const Vec3 foot = closestOnTriangle(p, sheet.triangles[k]);
    const double squared = (foot - p).squaredNorm();
    if (squared > least * same) return;
    if (squared * same < least) nearest.clear();
    least = std::min(least, squared);
    nearest.emplace_back(k, foot);
  };
  sheet.tree.walk([&](const Box3& box) { return squaredDistance(box, p); }, visit,
                  [&](double squared) { return squared <= least * same; });
  // Of the triangles around the nearest point the one that is seen most from the front tells the side.
  double best = -1, result = 0;
  for (const auto& [k, foot] : nearest) {
    const Triangle3& t = sheet.triangles[k];
    if (isOnRim(t, sheet.rim[k], foot)) return 0;
    const double height = (p - foot).dot((t[1] - t[0]).cross(t[2] - t[0]).normalized());
    if (std::abs(height) > best) best = std::abs(height), result = std::copysign(std::sqrt(least), height);
  }
  return result;
}

/// How far points reach on either side of a sheet.
Passage reachThrough(const std::vector<Vec3>& points, const LocalSheet& sheet, const Progress& progress) {
  constexpr std::size_t enough = 400;
  const std::size_t stride = points.size() / enough + 1;
  double above = 0, below = 0;
  for (std::size_t k = 0; k < points.size(); k += stride) {
    progress.check();
    const double d = distanceFrom(sheet, points[k]);
    above = std::max(above, d);
    below = std::max(below, -d);
  }
  return {true, std::min(above, below), std::max(above, below)};
}

}  // namespace

Passage passageAt(const SheetMesh& mesh, const SmoothSheets& smooth, const SheetMeeting& meeting, double radius, double off,
                  const Progress& progress) {
  Ball ball(mesh, smooth, meeting.point, radius);
  ball.divide(radius / 4, off, progress);
  Sheets sheets(ball);
  const double slack = radius / 16;
  const auto first = sheets.triangleAt(meeting.first, meeting.point, slack);
  const auto second = sheets.triangleAt(meeting.second, meeting.point, slack);
  if (!first || !second || !sheets.flood(*first, 1) || !sheets.flood(*second, 2)) return {};
  const LocalSheet a = sheets.sheet(1, meeting.point, radius), b = sheets.sheet(2, meeting.point, radius);
  const Passage ofA = reachThrough(a.points, b, progress), ofB = reachThrough(b.points, a, progress);
  return ofA.lesser < ofB.lesser ? ofB : ofA;
}

}  // namespace blossom
