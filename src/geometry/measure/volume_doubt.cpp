#include "geometry/measure/volume_doubt.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include "core/place_text.h"
#include "geometry/mesh/closed_triangles.h"
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/winding_field.h"

namespace blossom {
namespace {

using Triangles = std::vector<Triangle3>;

Triangle3 triangleAt(const Mesh& triangles, std::size_t f) {
  const auto face = triangles.face(f);
  const auto corner = [&](std::size_t k) { return triangles.points[static_cast<std::size_t>(face[k])]; };
  return {corner(0), corner(1), corner(2)};
}

/// The triangles by a number that each has.
template <class NumberOf>
std::vector<Triangles> grouped(const Mesh& triangles, std::size_t count, const NumberOf& numberOf,
                               const Progress& progress) {
  std::vector<Triangles> groups(count);
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    if (f % 4096 == 0) progress.check();
    groups[numberOf(f)].push_back(triangleAt(triangles, f));
  }
  return groups;
}

/// Corners at one place are one, as they are for crossings: components part where surfaces meet along an edge.
Mesh joined(Mesh triangles) {
  const std::vector<Vec3>& points = triangles.points;
  const auto at = [&](int v) { return std::tuple(points[v].x(), points[v].y(), points[v].z(), v); };
  std::vector<int> sorted(points.size()), first(points.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](int a, int b) { return at(a) < at(b); });
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const bool repeats = k > 0 && points[sorted[k]] == points[sorted[k - 1]];
    first[sorted[k]] = repeats ? first[sorted[k - 1]] : sorted[k];
  }
  for (int& v : triangles.faceVertices) v = first[v];
  return triangles;
}

bool isWrong(const WindingField::Range& range) { return range.first < 0 || range.second > 1; }

/// Where parts hold the same space, or one is inside out, and their surfaces meet.
std::optional<std::string> doubtWhereFacesMeet(const Mesh& triangles, const WindingField& field, const Progress& progress) {
  WindingField::Range range{0, 1};
  const auto counts = [&](const Triangle3& a, const Triangle3& b) {
    if (isWrong(range)) return false;
    range = field.whereTheyMeet(a, b).value_or(WindingField::Range{0, 1});
    return isWrong(range);
  };
  const std::vector<MeshCrossing> found = crossings(triangles, counts, progress);
  if (found.empty()) return std::nullopt;
  const std::string place = placeText(found.front().place);
  if (range.second > 1)
    return fmt::format("Its faces intersect near {}: the volume counts space that several of its parts hold as often.",
                       place);
  return fmt::format("Its faces meet near {}, and a part there is inside out: the volume counts its space below zero.",
                     place);
}

}  // namespace

std::optional<std::string> volumeDoubt(const Mesh& mesh, const Progress& progress) {
  Mesh triangles = triangulated(mesh, progress).first;
  if (!meshTopology(triangles, progress).closed()) return std::nullopt;
  triangles = joined(std::move(triangles));
  const MeshTopology topology = meshTopology(triangles, progress);
  const auto component = [&](std::size_t f) { return static_cast<std::size_t>(topology.componentOfFace[f]); };
  const WindingField field(grouped(
                               triangles, 1, [](std::size_t) { return 0; }, progress)
                               .front(),
                           progress);
  if (auto doubt = doubtWhereFacesMeet(triangles, field, progress)) return doubt;
  // Along a component, the winding number on either side changes only where other faces meet it, and there it is right.
  for (const Triangles& part : grouped(triangles, topology.components.size(), component, progress)) {
    progress.check();
    const auto [front, back] = pointsBesideLargest(part);
    const std::string place = placeText((front + back) / 2);
    for (const Vec3& p : {front, back}) {
      const int winding = field.at(p);
      if (winding > 1)
        return fmt::format("A body at {} lies within another and looks outwards like it: the volume counts its space twice.",
                           place);
      if (winding < 0) return fmt::format("A body at {} is inside out: its volume counts below zero.", place);
    }
  }
  return std::nullopt;
}

}  // namespace blossom
