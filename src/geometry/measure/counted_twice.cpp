#include "geometry/measure/counted_twice.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"

namespace blossom {
namespace {

struct Body {
  Mesh triangles;
  Bounds box;
  bool outwards = true;
};

std::vector<Body> bodiesOf(const Mesh& triangles, const MeshTopology& topology, const Progress& progress) {
  std::vector<Body> bodies(topology.components.size());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    if (f % 4096 == 0) progress.check();
    Body& body = bodies[static_cast<std::size_t>(topology.componentOfFace[f])];
    std::vector<int> corners;
    for (const int v : triangles.face(f)) {
      const Vec3& p = triangles.points[static_cast<std::size_t>(v)];
      body.box.add(p);
      corners.push_back(static_cast<int>(body.triangles.points.size()));
      body.triangles.points.push_back(p);
    }
    body.triangles.addFace(corners);
  }
  for (Body& body : bodies) body.outwards = signedVolume(body.triangles) >= 0;
  return bodies;
}

/// How often a closed surface goes around a point away from it: the sum of the solid angles of its triangles (van Oosterom
/// and Strackee 1983), in full turns.
double windingNumber(const Mesh& triangles, const Vec3& point, const Progress& progress) {
  double sum = 0;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    if (f % 4096 == 0) progress.check();
    const auto corner = [&](std::size_t k) -> Vec3 {
      return triangles.points[static_cast<std::size_t>(triangles.face(f)[k])] - point;
    };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

bool isWithin(const Bounds& inner, const Bounds& outer) {
  return (inner.low.array() >= outer.low.array()).all() && (inner.high.array() <= outer.high.array()).all();
}

/// A point of the first body that lies within another and counts as solid once more; bodies do not intersect.
std::optional<Vec3> nestedPlace(const std::vector<Body>& bodies, const Progress& progress) {
  for (const Body& body : bodies) {
    const auto& corners = body.triangles.points;
    const Vec3 place = (corners[0] + corners[1] + corners[2]) / 3;  // bodies may touch in vertices and edges
    int around = 0;
    for (const Body& other : bodies)
      if (&other != &body && isWithin(body.box, other.box))
        around += static_cast<int>(std::lround(windingNumber(other.triangles, place, progress)));
    const bool fits = body.outwards ? around == 0 : around >= 1;
    if (around != 0 && !fits) return place;
  }
  return std::nullopt;
}

std::string placeOf(const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

}  // namespace

std::optional<std::string> countedTwice(const Mesh& mesh, const Progress& progress) {
  const Mesh triangles = triangulated(mesh, progress).first;
  const MeshTopology topology = meshTopology(triangles, progress);
  if (!topology.closed()) return std::nullopt;
  if (const auto crossing = firstCrossing(triangles, progress))
    return fmt::format("Its faces intersect near {}: the volume counts space that several of its parts hold as often.",
                       placeOf(crossing->place));
  if (topology.components.size() < 2) return std::nullopt;
  if (const auto place = nestedPlace(bodiesOf(triangles, topology, progress), progress))
    return fmt::format("A body at {} lies within another and looks outwards like it: the volume counts its space twice.",
                       placeOf(*place));
  return std::nullopt;
}

}  // namespace blossom
