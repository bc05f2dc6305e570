#include "geometry/measure/counted_twice.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "core/place_text.h"
#include "geometry/mesh/closed_triangles.h"
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"

namespace blossom {
namespace {

struct Body {
  std::vector<Triangle3> triangles;
  Bounds box;
};

std::vector<Body> bodiesOf(const Mesh& triangles, const MeshTopology& topology, const Progress& progress) {
  std::vector<Body> bodies(topology.components.size());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    if (f % 4096 == 0) progress.check();
    Body& body = bodies[static_cast<std::size_t>(topology.componentOfFace[f])];
    const std::vector<Vec3> corners = facePoints(triangles, f);
    body.triangles.push_back({corners[0], corners[1], corners[2]});
    for (const Vec3& p : corners) body.box.add(p);
  }
  return bodies;
}

bool isWithin(const Bounds& inner, const Bounds& outer) {
  return (inner.low.array() >= outer.low.array()).all() && (inner.high.array() <= outer.high.array()).all();
}

/// A point of the first body that lies within another and counts as solid once more; bodies do not intersect.
std::optional<Vec3> nestedPlace(const std::vector<Body>& bodies, const Progress& progress) {
  for (const Body& body : bodies) {
    const auto& [a, b, c] = body.triangles.front();
    const Vec3 place = (a + b + c) / 3;  // bodies may touch in vertices and edges
    int around = 0;
    for (const Body& other : bodies)
      if (&other != &body && isWithin(body.box, other.box))
        around += static_cast<int>(std::lround(windingNumber(other.triangles, place, progress)));
    const bool fits = signedVolume(body.triangles) >= 0 ? around == 0 : around >= 1;
    if (around != 0 && !fits) return place;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> countedTwice(const Mesh& mesh, const Progress& progress) {
  const Mesh triangles = triangulated(mesh, progress).first;
  const MeshTopology topology = meshTopology(triangles, progress);
  if (!topology.closed()) return std::nullopt;
  if (const auto crossing = firstCrossing(triangles, progress))
    return fmt::format("Its faces intersect near {}: the volume counts space that several of its parts hold as often.",
                       placeText(crossing->place));
  if (topology.components.size() < 2) return std::nullopt;
  if (const auto place = nestedPlace(bodiesOf(triangles, topology, progress), progress))
    return fmt::format("A body at {} lies within another and looks outwards like it: the volume counts its space twice.",
                       placeText(*place));
  return std::nullopt;
}

}  // namespace blossom
