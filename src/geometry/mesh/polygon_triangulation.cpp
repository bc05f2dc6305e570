#include "geometry/mesh/polygon_triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>

#include "geometry/mesh/large_polygon.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom {
namespace {

using CornerTriples = std::vector<std::array<int, 3>>;

/// Twice the signed area of a triangle.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Coordinates in the polygon's best plane, seen from the tip of its normal.
std::vector<Vec2> flattened(std::span<const Vec3> polygon) {
  const Vec3 normal = vectorArea(polygon).normalized();
  const Vec3 x = normal.unitOrthogonal();
  const Vec3 y = normal.cross(x);
  std::vector<Vec2> result;
  result.reserve(polygon.size());
  for (const Vec3& p : polygon) result.emplace_back(x.dot(p - polygon[0]), y.dot(p - polygon[0]));
  return result;
}

/// Of the coordinates of a polygon.
struct Extent {
  double largest = 0;  ///< away from the origin
  double across = 0;   ///< from one corner to any other
};

Extent extentOf(std::span<const Vec3> polygon) {
  Extent extent;
  for (const Vec3& p : polygon) {
    extent.largest = std::max(extent.largest, p.cwiseAbs().maxCoeff());
    extent.across = std::max(extent.across, (p - polygon[0]).cwiseAbs().maxCoeff());
  }
  return extent;
}

/// What rounding of its corners may come to.
double roundingOf(const Extent& extent) { return 16 * std::numeric_limits<double>::epsilon() * extent.largest; }

/// A distance from an edge below this may be rounding of the polygon's corners, or is insignificant.
double nothing(const Extent& extent) { return std::max(1e-9 * extent.across, roundingOf(extent)); }

/// Twice the area of triangles that lie upside down.
double turnedOver(const std::vector<Vec2>& points, const CornerTriples& triangles) {
  const auto at = [&](int i) -> const Vec2& { return points[static_cast<std::size_t>(i)]; };
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += std::max(0.0, -turn(at(a), at(b), at(c)));
  return sum;
}

/// Both triangles of the diagonal must turn the right way, and by more than rounding; of two such diagonals the shorter one.
CornerTriples splitQuad(std::span<const Vec3> quad) {
  const std::vector<Vec2> p = flattened(quad);
  const double minimum = nothing(extentOf(quad)) * std::max((p[0] - p[2]).norm(), (p[1] - p[3]).norm());
  const double first = std::min(turn(p[0], p[1], p[2]), turn(p[0], p[2], p[3]));
  const double second = std::min(turn(p[0], p[1], p[3]), turn(p[1], p[2], p[3]));
  const bool bothGood = first > minimum && second > minimum;
  const bool shorter = (quad[0] - quad[2]).squaredNorm() <= (quad[1] - quad[3]).squaredNorm();
  if (bothGood ? shorter : first >= second) return {{0, 1, 2}, {0, 2, 3}};
  return {{0, 1, 3}, {1, 2, 3}};
}

class EarClipper {
 public:
  /// @param nothing a corner so close to an ear hinders it, and an ear so flat is none, as long as there are others; then
  /// one that is no deeper in it does not
  EarClipper(std::vector<Vec2> points, double nothing)
      : points_(std::move(points)), left_(points_.size()), nothing_(nothing) {
    std::iota(left_.begin(), left_.end(), 0);
  }

  CornerTriples run(bool spikesFirst) {
    CornerTriples triangles;
    if (spikesFirst) clipSpikes(triangles);
    std::size_t place = 0;
    while (left_.size() > 3) {
      place = nextEar(place % left_.size());
      triangles.push_back(corner(place));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(place));
      // Going on with the vertex after next makes fewer slivers than a fan around one vertex.
      ++place;
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  const Vec2& at(int i) const { return points_[static_cast<std::size_t>(i)]; }

  std::array<int, 3> corner(std::size_t place) const {
    const std::size_t count = left_.size();
    return {left_[(place + count - 1) % count], left_[place], left_[(place + 1) % count]};
  }

  double cornerTurn(std::size_t place) const {
    const auto [a, b, c] = corner(place);
    return turn(at(a), at(b), at(c));
  }

  bool isEar(std::size_t place, double nothing) const {
    const auto ears = corner(place);
    const Vec2 &a = at(ears[0]), &b = at(ears[1]), &c = at(ears[2]);
    const double ab = nothing * (b - a).norm(), bc = nothing * (c - b).norm(), ca = nothing * (a - c).norm();
    if (turn(a, b, c) <= std::max({ab, bc, ca, 0.0})) return false;
    return std::none_of(left_.begin(), left_.end(), [&](int i) {
      const Vec2& p = at(i);
      if (i == ears[0] || i == ears[1] || i == ears[2] || p == a || p == b || p == c) return false;
      return turn(a, b, p) >= -ab && turn(b, c, p) >= -bc && turn(c, a, p) >= -ca;
    });
  }

  /// Corners to which the outline goes and comes back where it was, but for rounding, with which it may cross itself there:
  /// any other ear beside them would fold back.
  void clipSpikes(CornerTriples& triangles) {
    for (std::size_t place = 0, inVain = 0; left_.size() > 3 && inVain < left_.size(); ++inVain) {
      place %= left_.size();
      const auto [a, b, c] = corner(place);
      if (isSpike(at(a), at(b), at(c), nothing_)) {
        triangles.push_back({a, b, c});
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(place));
        place += left_.size() - 1;  // the one before may be one now
        inVain = 0;
      } else {
        ++place;
      }
    }
  }

  /// Corners in line leave ears enough that are not flat. A polygon that touches itself but for rounding has ears that
  /// others reach into by little more than that; one that crosses itself may have none: then the most convex corner goes.
  std::size_t nextEar(std::size_t from) const {
    const std::size_t count = left_.size();
    for (const double nothing : {nothing_, 0.0, -nothing_, -16 * nothing_, -256 * nothing_})
      for (std::size_t k = 0; k < count; ++k)
        if (const std::size_t place = (from + k) % count; isEar(place, nothing)) return place;
    std::size_t best = 0;
    for (std::size_t place = 1; place < count; ++place)
      if (cornerTurn(place) > cornerTurn(best)) best = place;
    return best;
  }

  std::vector<Vec2> points_;
  std::vector<int> left_;
  double nothing_;
};

}  // namespace

Vec3 vectorArea(std::span<const Vec3> polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  return sum / 2;
}

std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon) { return triangulate(polygon, Progress::none()); }

std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon, const Progress& progress) {
  constexpr std::size_t large = 256;  // below it the plain clipper is the quicker one
  if (polygon.size() < 3) return {};
  if (polygon.size() == 3) return {{0, 1, 2}};
  if (polygon.size() == 4) return splitQuad(polygon);
  const std::vector<Vec2> points = flattened(polygon);
  const Extent extent = extentOf(polygon);
  const auto clipped = [&](bool spikesFirst) {
    return points.size() > large ? triangulateLarge(points, nothing(extent), spikesFirst, progress)
                                 : EarClipper(points, nothing(extent)).run(spikesFirst);
  };
  CornerTriples triangles = clipped(false);
  const double turned = turnedOver(points, triangles);
  if (turned <= roundingOf(extent) * extent.across) return triangles;
  // It crosses itself; where that is by rounding alone, spikes that go first leave a polygon that does not.
  CornerTriples others = clipped(true);
  return turnedOver(points, others) < turned ? others : triangles;
}

}  // namespace blossom
