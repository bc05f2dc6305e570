#include "kernel/parts/mesh_solid.h"

#include <fmt/format.h>

#include <Precision.hxx>

#include "core/error.h"
#include "core/place_text.h"
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/occt/joined_faces.h"
#include "geometry/occt/occt.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/guarded.h"

namespace blossom::modeling {

namespace {

constexpr std::size_t mostFaces = 20'000;

/// Corners at one place as one: most formats write them once for each face.
Mesh withSharedCorners(const Mesh& mesh) {
  const std::vector<int> first = mergeClosePoints(mesh.points, Precision::Confusion());
  Mesh shared = mesh;
  for (int& v : shared.faceVertices) v = first[static_cast<std::size_t>(v)];
  return shared;
}

void refuseOpen(const Mesh& mesh, const MeshTopology& topology) {
  for (const MeshEdge& edge : topology.edges) {
    if (edge.balanced()) continue;
    const Vec3 middle =
        (mesh.points[static_cast<std::size_t>(edge.low)] + mesh.points[static_cast<std::size_t>(edge.high)]) / 2;
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("The mesh bounds no solid: it is open, or its faces look different ways, near {}.", placeText(middle)),
        "Close and orient it in the program that made it.");
  }
}

void refuseCrossing(const Mesh& mesh, const Progress& progress) {
  if (const auto crossing = firstCrossing(triangulated(mesh, progress).first, progress))
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The mesh bounds no solid: it crosses itself near {}.", placeText(crossing->place)),
                "Repair it in the program that made it.");
}

}  // namespace

TopoDS_Shape solidOfMesh(const Mesh& mesh, const Progress& progress) {
  if (mesh.faceCount() > mostFaces)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("A mesh of {} faces is too large for a solid of planar faces; the limit is {}.",
                            mesh.faceCount(), mostFaces),
                "Simplify it first, or use it where meshes are taken.");
  if (mesh.faceCount() == 0)
    throw Error(ErrorCode::InvalidInput, "The mesh has no faces, so it bounds no solid.", "Choose a closed mesh.");
  const Mesh shared = withSharedCorners(mesh);
  refuseOpen(shared, meshTopology(shared, progress));
  refuseCrossing(shared, progress);
  const Complaint complaint{"The mesh bounds no valid solid.",
                            "It may cross itself: repair it in the program that made it."};
  return guarded(complaint.message, complaint.hint, [&] {
    const TopoDS_Shape faces = toShape(mesh);
    progress.check();
    const TopoDS_Shape joined = withJoinedFaces(faces, JoinedEdges::Join);
    // Joining is a convenience: where it spoils the shape, every polygon stays a face.
    return finishedSolid(!joined.IsNull() && isGoodSolid(joined) ? joined : toShape(mesh), complaint);
  });
}

}  // namespace blossom::modeling
