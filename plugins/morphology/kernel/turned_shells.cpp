#include "kernel/turned_shells.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/mesh/closed_triangles.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/winding_field.h"
#include "kernel/rounding/mean_thickness.h"

namespace blossom::morphology {

namespace {

Triangle3 triangleAt(const Mesh& triangles, std::size_t f) {
  const auto face = triangles.face(f);
  const auto corner = [&](std::size_t k) { return triangles.points[static_cast<std::size_t>(face[k])]; };
  return {corner(0), corner(1), corner(2)};
}

std::vector<std::vector<Triangle3>> shellsOf(const Mesh& triangles, const MeshTopology& topology) {
  std::vector<std::vector<Triangle3>> shells(topology.components.size());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f)
    shells[static_cast<std::size_t>(topology.componentOfFace[f])].push_back(triangleAt(triangles, f));
  return shells;
}

void turn(Mesh& mesh, std::size_t face) {
  std::reverse(mesh.faceVertices.begin() + mesh.faceStarts[face], mesh.faceVertices.begin() + mesh.faceStarts[face + 1]);
}

/// How often solid covers the emptier side of a triangle: less than 0 beside one that is turned, 1 or more within a body.
double leastBeside(const WindingField& field, const std::vector<Triangle3>& of) {
  const auto [front, back] = pointsBesideLargest(of);
  return std::min(field.at(front), field.at(back));
}

/// Where shells lie that are not as they should be; nothing for the others.
struct Places {
  std::vector<std::optional<Vec3>> insideOut;  ///< by shell
  std::optional<Vec3> bodyInBody;              ///< of a body within another one
};

Places placesOf(const Mesh& triangles, const MeshTopology& topology, const Progress& progress) {
  if (topology.components.size() == 1)
    return {{meanThickness(triangles) < 0 ? std::optional(triangles.points.front()) : std::nullopt}, std::nullopt};
  const auto shells = shellsOf(triangles, topology);
  std::vector<Triangle3> all;
  for (const auto& shell : shells) all.insert(all.end(), shell.begin(), shell.end());
  const WindingField field(std::move(all), progress);
  Places found;
  for (const auto& shell : shells) {
    progress.check();
    const double least = leastBeside(field, shell);
    // Shells that cross others are so in part only.
    const auto isAllSo = [&](const auto& isSo) {
      return isSo(least) && std::all_of(shell.begin(), shell.end(),
                                        [&](const Triangle3& triangle) { return isSo(leastBeside(field, {triangle})); });
    };
    const bool isWrong = isAllSo([](double sides) { return sides < 0; });
    found.insideOut.push_back(isWrong ? std::optional(shell.front()[0]) : std::nullopt);
    if (!found.bodyInBody && isAllSo([](double sides) { return sides > 0.5; })) found.bodyInBody = shell.front()[0];
  }
  return found;
}

}  // namespace

void turnOutwards(CheckedSolid& solid, const Subject& subject, const Progress& progress) {
  const MeshTopology topology = meshTopology(solid.triangles, progress);
  const auto [found, bodyInBody] = placesOf(solid.triangles, topology, progress);
  solid.bodyInBody = bodyInBody;
  const auto isFound = [](const std::optional<Vec3>& place) { return place.has_value(); };
  if (std::none_of(found.begin(), found.end(), isFound)) return;
  for (std::size_t f = 0; f < solid.triangles.faceCount(); ++f)
    if (found[static_cast<std::size_t>(topology.componentOfFace[f])]) turn(solid.triangles, f);
  if (std::all_of(found.begin(), found.end(), isFound)) {
    solid.warnings.push_back(fmt::format("{} was inside out and has been turned.", subject.name));
    return;
  }
  for (const auto& place : found)
    if (place)
      solid.warnings.push_back(fmt::format("{} has a body near {} that was inside out and has been turned.", subject.name,
                                           subject.place(*place)));
}

}  // namespace blossom::morphology
