#include "kernel/ball.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "core/error.h"

namespace blossom::morphology {

namespace {

using Triangle = std::array<int, 3>;

struct Directions {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

Directions icosahedron() {
  constexpr double g = std::numbers::phi;
  Directions d;
  d.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : d.points) p.normalize();
  d.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return d;
}

Directions divided(const Directions& coarse) {
  Directions fine;
  fine.points = coarse.points;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [it, fresh] = middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(fine.points.size()));
    if (fresh)
      fine.points.push_back(
          (coarse.points[static_cast<std::size_t>(a)] + coarse.points[static_cast<std::size_t>(b)]).normalized());
    return it->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

/// Distance from the origin to the nearest face of the unit ball.
double nearestFace(const Directions& d) {
  double nearest = 1;
  const auto at = [&](int k) -> const Vec3& { return d.points[static_cast<std::size_t>(k)]; };
  for (const auto& [a, b, c] : d.triangles)
    nearest = std::min(nearest, (at(b) - at(a)).cross(at(c) - at(a)).normalized().dot(at(a)));
  return nearest;
}

}  // namespace

BallResult ball(const BallOptions& options) {
  if (!(options.radius > 0) || !std::isfinite(options.radius))
    throw Error(ErrorCode::InvalidParameter, "The radius of a ball must be above 0.", "Give a radius in mm.");
  if (options.subdivisions < 0 || options.subdivisions > maximumSubdivisions)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The subdivisions of a ball must lie between 0 and {}; they are {}.", maximumSubdivisions,
                            options.subdivisions),
                "Two subdivisions make 320 faces, three 1280.");
  Directions directions = icosahedron();
  for (int k = 0; k < options.subdivisions; ++k) directions = divided(directions);
  const double nearest = nearestFace(directions);
  const double radius = options.fit == BallFit::Inscribed ? options.radius : options.radius / nearest;
  BallResult result;
  for (const Vec3& p : directions.points) result.mesh.points.push_back(radius * p);
  for (const auto& triangle : directions.triangles) result.mesh.addFace(triangle);
  result.deviation = options.fit == BallFit::Inscribed ? options.radius * (1 - nearest) : radius - options.radius;
  result.mesh.name = "Ball";
  return result;
}

}  // namespace blossom::morphology
