#include "geometry/crossing/local_sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "geometry/mesh/triangle_distance.h"

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

  /// Halves every side that is longer than `longest`, as often as it takes.
  void divide(double longest, const Progress& progress) {
    constexpr int rounds = 14;
    constexpr std::size_t many = 20000;
    for (int round = 0; round < rounds && triangles.size() < many; ++round) {
      progress.check();
      std::vector<SheetTriangle> next;
      bool divided = false;
      for (const SheetTriangle& t : triangles)
        if (reaches(at(t))) divided |= divideInto(next, t, longest);
      triangles = std::move(next);
      if (!divided) return;
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

  /// The middle of a side, one point for both its triangles.
  int middleOf(const SheetTriangle& t, std::size_t a, std::size_t b) {
    const auto [found, isNew] =
        middles_.try_emplace(sideBetween(t.corners[a], t.corners[b]), static_cast<int>(points.size()));
    if (isNew) {
      const Vec3& p = points[static_cast<std::size_t>(t.corners[a])];
      const Vec3& q = points[static_cast<std::size_t>(t.corners[b])];
      const Vec3 smooth = sheets_.frame(t.face, (t.at[a] + t.at[b]) / 2).point;
      // Beside a pole the mean of the parameters may be far away.
      const bool sane = (smooth - (p + q) / 2).norm() < (p - q).norm();
      points.push_back(sane ? smooth : Vec3((p + q) / 2));
    }
    return found->second;
  }

  bool divideInto(std::vector<SheetTriangle>& next, const SheetTriangle& t, double longest) {
    std::array<int, 3> middle{-1, -1, -1};  // of the side from corner k to the next
    std::array<Vec2, 3> middleAt;
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const Vec3& p = points[static_cast<std::size_t>(t.corners[k])];
      const Vec3& q = points[static_cast<std::size_t>(t.corners[l])];
      if ((p - q).squaredNorm() <= longest * longest) continue;
      middle[k] = middleOf(t, k, l);
      middleAt[k] = (t.at[k] + t.at[l]) / 2;
      ++count;
    }
    if (count == 0) {
      next.push_back(t);
      return false;
    }
    // Round the triangle, corners and middles; a fan of it, in which the middles of two sides come first.
    std::vector<std::pair<int, Vec2>> round;
    for (std::size_t k = 0; k < 3; ++k) {
      round.emplace_back(t.corners[k], t.at[k]);
      if (middle[k] >= 0) round.emplace_back(middle[k], middleAt[k]);
    }
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      const auto &x = round[a % round.size()], &y = round[b % round.size()], &z = round[c % round.size()];
      next.push_back({{x.first, y.first, z.first}, {x.second, y.second, z.second}, t.face});
    };
    const auto isMiddle = [&](std::size_t k) {
      return std::find(middle.begin(), middle.end(), round[k % round.size()].first) != middle.end();
    };
    if (count == 3) {
      add(5, 0, 1), add(1, 2, 3), add(3, 4, 5), add(1, 3, 5);
      return true;
    }
    std::size_t from = 0;
    while (!isMiddle(from) || (count == 2 && !isMiddle(from + 2))) ++from;
    for (std::size_t k = 1; k + 1 < round.size(); ++k) add(from, from + k, from + k + 1);
    return true;
  }

  const SmoothSheets& sheets_;
  Vec3 middle_;
  double radius_;
  std::map<int, int> numbers_;
  std::map<TriangleSide, int> middles_;
};

/// What hangs together over sides, all of its triangles turned one way round.
struct LocalSheet {
  std::vector<Triangle3> triangles;
  std::vector<std::array<bool, 3>> rim;  ///< whether the side from corner k to the next is of one triangle alone
  std::vector<Vec3> points;              ///< corners within the ball
};

class Sheets {
 public:
  explicit Sheets(const Ball& ball) : ball_(ball), mark_(ball.triangles.size(), 0) {
    for (std::size_t k = 0; k < ball.triangles.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) bySide_[side(k, i)].push_back(k);
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
        for (const std::size_t other : bySide_.at(side(k, i))) {
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
      for (std::size_t i = 0; i < 3; ++i) rim[i] = bySide_.at(side(k, i)).size() == 1;
      if (mark_[k] < 0) std::swap(t[0], t[1]), std::swap(rim[1], rim[2]);
      result.triangles.push_back(t);
      result.rim.push_back(rim);
      for (const int corner : ball_.triangles[k].corners) {
        const auto c = static_cast<std::size_t>(corner);
        if (!taken[c] && (ball_.points[c] - middle).norm() <= radius) result.points.push_back(ball_.points[c]);
        taken[c] = true;
      }
    }
    return result;
  }

 private:
  [[nodiscard]] TriangleSide side(std::size_t k, std::size_t i) const {
    const auto& corners = ball_.triangles[k].corners;
    return sideBetween(corners[i], corners[(i + 1) % 3]);
  }
  /// Whether a triangle runs along its side from the lower number to the higher one.
  [[nodiscard]] bool runsUp(std::size_t k, const TriangleSide& wanted) const {
    const auto& corners = ball_.triangles[k].corners;
    for (std::size_t i = 0; i < 3; ++i)
      if (side(k, i) == wanted) return corners[i] < corners[(i + 1) % 3];
    return true;
  }

  const Ball& ball_;
  std::map<TriangleSide, std::vector<std::size_t>> bySide_;
  std::vector<int> mark_;  ///< number of the sheet, negative where the triangle is turned; 0: none
};

/// The signed distance of a point from a sheet; 0 where the nearest point lies on the rim.
double distanceFrom(const LocalSheet& sheet, const Vec3& p) {
  double least = std::numeric_limits<double>::max();
  for (const Triangle3& t : sheet.triangles) least = std::min(least, (closestOnTriangle(p, t) - p).squaredNorm());
  // Of the triangles around the nearest point the one that is seen most from the front tells the side.
  double best = -1, result = 0;
  for (std::size_t k = 0; k < sheet.triangles.size(); ++k) {
    const Triangle3& t = sheet.triangles[k];
    const Vec3 foot = closestOnTriangle(p, t);
    if ((foot - p).squaredNorm() > least * (1 + 1e-9) + 1e-300) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!sheet.rim[k][i]) continue;
      const Vec3 &a = t[i], along = t[(i + 1) % 3] - a;
      if (along.cross(foot - a).squaredNorm() <= 1e-18 * along.squaredNorm() * along.squaredNorm()) return 0;
    }
    const double height = (p - foot).dot((t[1] - t[0]).cross(t[2] - t[0]).normalized());
    if (std::abs(height) > best) best = std::abs(height), result = std::copysign(std::sqrt(least), height);
  }
  return result;
}

/// The lesser of how far points reach on either side of a sheet.
double reachThrough(const std::vector<Vec3>& points, const LocalSheet& sheet, const Progress& progress) {
  double above = 0, below = 0;
  for (const Vec3& p : points) {
    progress.check();
    const double d = distanceFrom(sheet, p);
    above = std::max(above, d);
    below = std::max(below, -d);
  }
  return std::min(above, below);
}

}  // namespace

Passage passageAt(const SheetMesh& mesh, const SmoothSheets& smooth, const SheetMeeting& meeting, double radius,
                  const Progress& progress) {
  Ball ball(mesh, smooth, meeting.point, radius);
  ball.divide(radius / 4, progress);
  Sheets sheets(ball);
  const double slack = radius / 16;
  const auto first = sheets.triangleAt(meeting.first, meeting.point, slack);
  const auto second = sheets.triangleAt(meeting.second, meeting.point, slack);
  if (!first || !second || !sheets.flood(*first, 1) || !sheets.flood(*second, 2)) return {};
  const LocalSheet a = sheets.sheet(1, meeting.point, radius), b = sheets.sheet(2, meeting.point, radius);
  return {true, std::max(reachThrough(a.points, b, progress), reachThrough(b.points, a, progress))};
}

}  // namespace blossom
