#include "manipulators/place_under_mouse.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/edit/motion_symmetry.h"
#include "kernel/grid/motion_point.h"

namespace blossom::sweep {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Where a ray enters a box; infinity when it misses. One that runs within a side of the box or through an edge of it, to
/// rounding, does not miss it: it may pass exactly where two boxes meet.
double enter(const Ray& ray, const FloatBox& box) {
  Vec3 low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    low[axis] = static_cast<double>(box.low[k]) - ray.origin[axis];
    high[axis] = static_cast<double>(box.high[k]) - ray.origin[axis];
  }
  constexpr double rounding = 1e-12;  // of the distances, a thousand times that of what is computed here
  const double rim = rounding * std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  double from = 0, to = infinite;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double along = ray.direction[axis];
    if (along == 0) {
      if (low[axis] > rim || high[axis] < -rim) return infinite;
      continue;
    }
    const auto [near, far] = std::minmax({(low[axis] - rim) / along, (high[axis] + rim) / along});
    from = std::max(from, near);
    to = std::min(to, far);
  }
  return from <= to ? from : infinite;
}

/// Barycentric coordinates of b and c, and the distance; nothing when the ray misses the triangle (Möller and Trumbore).
std::optional<Vec3> enter(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, p = ray.direction.cross(ac);
  const double det = ab.dot(p);
  if (det == 0) return std::nullopt;
  const Vec3 from = ray.origin - a, q = from.cross(ab);
  const double beta = from.dot(p) / det, gamma = ray.direction.dot(q) / det, distance = ac.dot(q) / det;
  constexpr double rim = 1e-9;  // cells have no gaps between them
  if (!(beta >= -rim && gamma >= -rim && beta + gamma <= 1 + rim && distance >= 0)) return std::nullopt;
  return Vec3(beta, gamma, distance);
}

double between(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

struct PlaceFinder::Cell {
  std::size_t k = 0, l = 0;  ///< its first row and column
  double alongU = 0, alongV = 0, distance = infinite;
};

PlaceFinder::PlaceFinder(const LiveGrid& grid) : grid_(grid) {
  const MotionGrid& points = grid.grid();
  if (points.countU < 2 || points.countV < 2) return;
  std::vector<FloatBox> boxes((points.countU - 1) * (points.countV - 1));
  for (std::size_t k = 0, i = 0; k + 1 < points.countU; ++k)
    for (std::size_t l = 0; l + 1 < points.countV; ++l, ++i)
      for (const std::size_t du : {0UL, 1UL})
        for (const std::size_t dv : {0UL, 1UL}) boxes[i].add(points.pointAt(k + du, l + dv));
  cells_ = RayTree(boxes);
}

void PlaceFinder::hitCell(const Ray& ray, std::size_t cell, Cell& nearest) const {
  const MotionGrid& points = grid_.grid();
  const std::size_t k = cell / (points.countV - 1), l = cell % (points.countV - 1);
  const Vec3 a = points.pointAt(k, l), u = points.pointAt(k + 1, l), uv = points.pointAt(k + 1, l + 1),
             v = points.pointAt(k, l + 1);
  if (const auto hit = enter(ray, a, u, uv); hit && hit->z() < nearest.distance)
    nearest = {k, l, hit->x() + hit->y(), hit->y(), hit->z()};
  if (const auto hit = enter(ray, a, uv, v); hit && hit->z() < nearest.distance)
    nearest = {k, l, hit->x(), hit->x() + hit->y(), hit->z()};
}

std::optional<PlaceFinder::Cell> PlaceFinder::firstCell(const Ray& ray) const {
  Cell nearest;
  cells_.walk([&](const FloatBox& box) { return enter(ray, box); },
              [&](int cell) { hitCell(ray, static_cast<std::size_t>(cell), nearest); }, nearest.distance);
  if (nearest.distance == infinite) return std::nullopt;
  return nearest;
}

PlaceHit PlaceFinder::refined(const Ray& ray, const Cell& cell) const {
  const Motion& motion = grid_.motion();
  const auto us = grid_.us(), vs = grid_.vs();
  const double stepU = us[cell.k + 1] - us[cell.k], stepV = vs[cell.l + 1] - vs[cell.l];
  const MotionPlace start{between(us[cell.k], us[cell.k + 1], std::clamp(cell.alongU, 0.0, 1.0)),
                          between(vs[cell.l], vs[cell.l + 1], std::clamp(cell.alongV, 0.0, 1.0))};
  const auto inside = [&](double u) {
    return motion.closedU == ClosedU::No ? std::clamp(u, motion.domainU().first, motion.domainU().second) : u;
  };
  double u = start.u, v = start.v, distance = cell.distance;
  bool arrived = false;
  constexpr int mostSteps = 24;
  for (int step = 0; step < mostSteps; ++step) {
    const MotionPoint x = evaluate(motion, insidePeriod(motion, u), v);
    const Vec3 off = ray.origin + distance * ray.direction - x.point;
    arrived = off.norm() <= 1e-12 * (1 + distance);
    // off = x_u du + x_v dv - d ds by Cramer's rule.
    const Vec3 across = x.du.cross(x.dv);
    const double det = across.dot(ray.direction);
    if (arrived || det == 0) break;
    const double du = off.dot(x.dv.cross(ray.direction)) / det, dv = off.dot(ray.direction.cross(x.du)) / det;
    // At most a cell at once: where the surface is seen nearly edge on, a whole step may lead to another sheet of it.
    const double share = 1 / std::max({1.0, std::abs(du) / stepU, std::abs(dv) / stepV});
    u = inside(u + share * du);
    v = std::clamp(v + share * dv, motion.domainV().first, motion.domainV().second);
    distance -= share * off.dot(across) / det;
  }
  // Another sheet of the surface, or none: the ray misses it within the cell.
  constexpr double cells = 3;
  if (!arrived || std::abs(u - start.u) > cells * stepU || std::abs(v - start.v) > cells * stepV) u = start.u, v = start.v;
  PlaceHit hit = placeHit(motion, {insidePeriod(motion, u), v});
  hit.distance = (hit.point - ray.origin).dot(ray.direction);
  return hit;
}

std::optional<PlaceHit> PlaceFinder::find(const Ray& ray) const {
  const auto cell = firstCell(ray);
  if (!cell) return std::nullopt;
  return refined(ray, *cell);
}

PlaceHit placeHit(const Motion& motion, const MotionPlace& at) {
  const MotionPoint x = evaluate(motion, at.u, at.v);
  const Vec3 across = x.du.cross(x.dv);
  const double length = across.norm();
  return {at, x.point, length > 0 ? Vec3(across / length) : Vec3::Zero(), 0};
}

}  // namespace blossom::sweep
