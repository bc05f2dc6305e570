#include "geometry/mesh/winding_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/angle.h"
#include "geometry/mesh/common_area.h"

namespace blossom {

/// A circle around a point that the surface passes through, on which winding numbers are compared.
struct WindingField::Ring {
  Vec3 center, axis;
  double radius = 0;
};

namespace {

constexpr double ringShare = 0.02;  ///< radius of a ring, as a share of what two triangles have in common
/// Where a ring stands on what two triangles have in common: not in its middle, where regular meshes have corners.
constexpr double ringPlace = 0.4567;

Vec3 normalOf(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

/// The part of a line from + t * along, |along| = 1, that lies in a triangle whose plane holds the line.
struct Stretch {
  double from = std::numeric_limits<double>::infinity(), to = -from;
};

Stretch stretchWithin(const Triangle3& t, const Vec3& start, const Vec3& along, double rounding) {
  const Vec3 across = normalOf(t).cross(along);
  std::array<double, 3> side{}, place{};
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = (t[k] - start).dot(across);
    if (std::abs(side[k]) <= rounding) side[k] = 0;
    place[k] = (t[k] - start).dot(along);
  }
  Stretch found;
  const auto reach = [&](double at) {
    found.from = std::min(found.from, at);
    found.to = std::max(found.to, at);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double rise = side[next] - side[k];
    if (side[k] == 0) reach(place[k]);
    if ((side[k] < 0 && side[next] > 0) || (side[k] > 0 && side[next] < 0))
      reach(place[k] - side[k] / rise * (place[next] - place[k]));
  }
  return found;
}

}  // namespace

WindingField::WindingField(std::vector<Triangle3> triangles, const Progress& progress) : triangles_(std::move(triangles)) {
  std::vector<Box3> boxes;
  boxes.reserve(triangles_.size());
  for (const Triangle3& t : triangles_) boxes.push_back(boxOf(t));
  tree_ = BoxTree<3>(boxes, 4, progress);
}

/// How much the winding number rises from one point to another: by 1 for every triangle passed from front to back.
int WindingField::risenBetween(const Vec3& from, const Vec3& to) const {
  int risen = 0;
  Box3 box(from);
  box.extend(to);
  tree_.meeting(box, [&](std::size_t item) {
    const Triangle3& t = triangles_[item];
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double before = (from - t[0]).dot(normal), after = (to - t[0]).dot(normal);
    if ((before > 0) == (after > 0)) return;
    const Vec3 hit = from + before / (before - after) * (to - from);
    for (std::size_t k = 0; k < 3; ++k)
      if ((t[(k + 1) % 3] - t[k]).cross(hit - t[k]).dot(normal) < 0) return;
    risen += before > 0 ? 1 : -1;
  });
  return risen;
}

int WindingField::at(const Vec3& p) const {
  if (tree_.empty()) return 0;
  const Box3& all = tree_.nodes().front().box;
  const auto along = [&](int axis) {
    Vec3 outside = p;
    outside[axis] = all.min()[axis] - all.diagonal().norm();
    return risenBetween(outside, p);
  };
  if (!all.contains(p)) return 0;
  const int x = along(0), y = along(1);
  return x == y || x == along(2) ? x : y;
}

WindingField::Range WindingField::around(const Ring& ring) const {
  const Vec3 u = ring.axis.unitOrthogonal(), v = ring.axis.cross(u);
  // Each plane of a triangle meets the ring at two opposite angles; between them nothing changes.
  std::vector<double> turns;
  const Vec3 reach = Vec3::Constant(2 * ring.radius);
  tree_.meeting(Box3(ring.center - reach, ring.center + reach), [&](std::size_t item) {
    const Vec3 trace = normalOf(triangles_[item]).cross(ring.axis);
    if (!(trace.norm() > 1e-9)) return;
    const double turn = std::atan2(trace.dot(v), trace.dot(u));
    turns.push_back(turn);
    turns.push_back(turn > 0 ? turn - fullTurn / 2 : turn + fullTurn / 2);
  });
  std::sort(turns.begin(), turns.end());
  std::vector<Vec3> stops;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const double next = k + 1 < turns.size() ? turns[k + 1] : turns.front() + fullTurn;
    if (next - turns[k] < 1e-7) continue;  // one plane, or as good as one
    const double turn = (turns[k] + next) / 2;
    stops.push_back(ring.center + ring.radius * (std::cos(turn) * u + std::sin(turn) * v));
  }
  int winding = at(stops.front());
  Range range{winding, winding};
  for (std::size_t k = 1; k < stops.size(); ++k) {
    winding += risenBetween(stops[k - 1], stops[k]);
    range = {std::min(range.first, winding), std::max(range.second, winding)};
  }
  return range;
}

std::optional<WindingField::Range> WindingField::whereTheyMeet(const Triangle3& a, const Triangle3& b) const {
  const Vec3 normal = normalOf(a), other = normalOf(b);
  const Vec3 along = normal.cross(other);
  Box3 both = boxOf(a);
  both.extend(boxOf(b));
  const double size = both.diagonal().norm(), coarsest = 1e-9 * std::max(size, 1e-4 * both.max().cwiseAbs().maxCoeff());
  if (along.norm() > 1e-7) {
    const Vec3 axis = along.normalized();
    // A point of both planes near to both triangles.
    const Vec3 middle = (a[0] + a[1] + a[2]) / 3;
    const Vec3 towards = axis.cross(normal);
    const Vec3 start = middle + (b[0] - middle).dot(other) / towards.dot(other) * towards;
    const Stretch ofA = stretchWithin(a, start, axis, coarsest), ofB = stretchWithin(b, start, axis, coarsest);
    const double from = std::max(ofA.from, ofB.from), to = std::min(ofA.to, ofB.to);
    if (!(to - from > coarsest)) return std::nullopt;
    return around({start + (from + ringPlace * (to - from)) * axis, axis, ringShare * (to - from)});
  }
  const std::vector<Vec3> common = commonPolygon(a, b);
  if (common.size() < 3) return std::nullopt;
  Vec3 middle = Vec3::Zero();
  double weights = 0;
  for (std::size_t k = 0; k < common.size(); ++k) {
    const double weight = 1 + ringPlace * static_cast<double>(k);
    middle += weight * common[k];
    weights += weight;
  }
  const double width = areaOf(common) / size;
  if (!(width > coarsest)) return std::nullopt;
  const Vec3 place = middle / weights, aside = ringShare * width * normal;
  const int before = at(place + aside), behind = before + risenBetween(place + aside, place - aside);
  return Range{std::min(before, behind), std::max(before, behind)};
}

}  // namespace blossom
