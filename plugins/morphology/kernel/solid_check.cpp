#include "kernel/solid_check.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"
#include "kernel/flatness.h"
#include "kernel/manifold.h"
#include "kernel/rounding/mean_thickness.h"
#include "kernel/rounding/slivers.h"
#include "kernel/self_crossing.h"
#include "kernel/turned_shells.h"
#include "kernel/welded.h"

namespace blossom::morphology {

namespace {

constexpr double farthest = 1e9;  // mm

void refuseOpen(const Mesh& mesh, const MeshTopology& topology, const Subject& subject) {
  for (const MeshEdge& edge : topology.edges) {
    if (edge.balanced()) continue;
    const Vec3 middle =
        (mesh.points[static_cast<std::size_t>(edge.low)] + mesh.points[static_cast<std::size_t>(edge.high)]) / 2;
    const int faces = edge.forward + edge.backward;
    if (faces == 1)
      throw Error(
          ErrorCode::InvalidInput,
          fmt::format("{} is open: an edge near {} has a face on one side only.", subject.name, subject.place(middle)),
          "Close the hole in the program that made the mesh, or repair the mesh.");
    if (faces == 2)
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{} is twisted: two faces near {} are oriented against each other.", subject.name,
                              subject.place(middle)),
                  "Orient all faces outwards, then try again.");
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("{} is not a manifold: {} faces meet in an edge near {}.", subject.name, faces, subject.place(middle)),
        "Remove inner walls and doubled faces.");
  }
}

Error enclosesNothing(const Subject& subject) {
  return Error(ErrorCode::InvalidInput, fmt::format("{} encloses no volume.", subject.name),
               "Choose a solid or a closed mesh.");
}

/// @param shared as withSharedPoints() returns it
CheckedSolid checkedShells(const Mesh& shared, double step, const Subject& subject, const Progress& progress) {
  if (shared.faceCount() == 0) throw enclosesNothing(subject);
  refuseOpen(shared, meshTopology(shared, progress), subject);
  CheckedSolid solid{withoutDegenerate(manifoldOf(triangulated(shared, progress).first, progress), subject), {}};
  solid.triangles = manifoldOfTriangles(solid.triangles, progress);
  const MeshTopology topology = meshTopology(solid.triangles, progress);
  if (step > 0)
    if (auto thicker = withoutSlivers(solid.triangles, topology, step, step, progress)) {
      solid.triangles = *std::move(thicker);
      solid.isLess = true;
    }
  if (solid.triangles.faceCount() == 0) throw enclosesNothing(subject);
  turnOutwards(solid, subject, progress);
  if (solid.bodyInBody)
    solid.warnings.push_back(fmt::format("{} has a body near {} that lies within another one: both are taken as one.",
                                         subject.name, subject.place(*solid.bodyInBody)));
  if (meanThickness(solid.triangles) <= 2 * thicknessOfRounding * bounds(solid.triangles).diagonal())
    throw enclosesNothing(subject);
  constexpr double near = 4;  // steps: enough for the rounding of both
  refuseCrossing(solid, near * step, subject, progress);
  return solid;
}

}  // namespace

void refuseUnusable(const Mesh& mesh, const Subject& subject) {
  if (mesh.faceCount() == 0)
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is empty: it has no faces.", subject.name),
                "Choose a solid or a closed mesh.");
  for (const int v : mesh.faceVertices)
    if (v < 0 || static_cast<std::size_t>(v) >= mesh.points.size())
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{} names the vertex {}, but there are {}.", subject.name, v, mesh.points.size()),
                  "Export the mesh again.");
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const Vec3& p = mesh.points[k];
    if (!p.allFinite())
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{} has a vertex, number {}, whose coordinates are not numbers.", subject.name, k),
                  "Export the mesh again.");
    if (p.cwiseAbs().maxCoeff() > farthest)
      throw Error(ErrorCode::LimitExceeded,
                  fmt::format("{} reaches to {}, farther than 1e9 mm from the origin.", subject.name, subject.place(p)),
                  "Scale it down or move it to the origin.");
  }
}

bool isClosed(const Mesh& mesh, const Progress& progress) {
  const MeshTopology topology = meshTopology(withSharedPoints(mesh, progress), progress);
  return std::all_of(topology.edges.begin(), topology.edges.end(), [](const MeshEdge& edge) { return edge.balanced(); });
}

CheckedSolid checkedSolid(const Mesh& mesh, double step, const Subject& subject, const Progress& progress) {
  refuseUnusable(mesh, subject);
  progress.report(0, "Checking the input");
  const Mesh shared = withSharedPoints(mesh, progress);
  if (shared.faceCount() == 0)
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is empty: all of its faces are without area.", subject.name),
                "Choose a solid or a closed mesh.");
  const Mesh outer = withoutInnerWalls(shared, progress);
  try {
    return checkedShells(outer, step, subject, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput || outer.faceCount() == shared.faceCount()) throw;
    // Bodies in a ring, joined where they share whole faces and touching in a part of one: apart they only touch.
    try {
      return checkedShells(shared, step, subject, progress);
    } catch (const Error& other) {
      if (other.code() != ErrorCode::InvalidInput) throw;
    }
    throw;
  }
}

}  // namespace blossom::morphology
