#include "kernel/rounding/attempts.h"

#include <utility>
#include <vector>

#include "geometry/mesh/mesh_topology.h"
#include "kernel/convex/convex_surface.h"
#include "kernel/manifold.h"
#include "kernel/plane_triangles.h"
#include "kernel/self_crossing.h"
#include "kernel/side_by_side.h"

namespace blossom::morphology {

namespace {

Mesh movedFrom(Mesh mesh, const Vec3& centre) {
  for (Vec3& p : mesh.points) p += centre;
  return mesh;
}

/// Corners that follow each other have places of their own.
bool everyEdgeHasLength(const Mesh& mesh) {
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto corners = facePoints(mesh, f);
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (corners[k] == corners[(k + 1) % corners.size()]) return false;
  }
  return true;
}

/// The face as triangles between its corners, or as it is where that fails.
void addSplit(const Mesh& mesh, std::size_t face, Mesh& result) {
  const std::vector<int> corners(mesh.face(face).begin(), mesh.face(face).end());
  const auto triangles = trianglesBetween(mesh.points, {corners}, vectorArea(facePoints(mesh, face)));
  if (triangles.size() != corners.size() - 2) {
    result.addFace(corners);
    return;
  }
  for (const auto& triangle : triangles) result.addFace(triangle);
}

template <class Which>
Mesh withSplit(const Mesh& mesh, const Which& which) {
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (mesh.face(f).size() > 3 && which(f))
      addSplit(mesh, f, result);
    else
      result.addFace(mesh.face(f));
  return result;
}

}  // namespace

std::optional<Mesh> Attempts::asIs(const Mesh& mesh) {
  crossing_.reset();
  if (mesh.faceCount() == 0) return std::nullopt;
  Mesh there = movedFrom(mesh, centre_);
  if (!everyEdgeHasLength(there)) return std::nullopt;
  if (isConvexSurface(there)) return there;  // which crosses nowhere, and is told at once
  bool isClosed = false, isSound = false;
  sideBySide(
      progress_, [&] { crossing_ = firstCrossing(there, progress_); },
      [&] {
        isClosed = meshTopology(mesh).closed();
        isSound = isClosed && !firstTwistedEdge(there, progress_);
      });
  if (!isClosed) crossing_.reset();
  if (crossing_ || !isSound) return std::nullopt;
  return there;
}

std::optional<Mesh> Attempts::withFewerPolygons(Mesh mesh) {
  constexpr int maximumRounds = 8;
  for (int round = 0; round <= maximumRounds; ++round) {
    if (auto made = asIs(mesh)) return made;
    if (!crossing_) return std::nullopt;
    const std::size_t before = mesh.faceCount();
    const auto isHit = [&](std::size_t f) { return f == crossing_->first || f == crossing_->second; };
    mesh = withSplit(mesh, [&](std::size_t f) { return round == maximumRounds || isHit(f); });
    if (mesh.faceCount() == before) return std::nullopt;
  }
  return asIs(mesh);
}

}  // namespace blossom::morphology
