#include "kernel/solid_check.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/shape/bounds.h"
#include "kernel/manifold.h"
#include "kernel/self_crossing.h"
#include "kernel/slivers.h"
#include "kernel/turned_shells.h"

namespace blossom::morphology {

namespace {

constexpr double farthest = 1e9;  // mm

struct NumbersHash {
  template <class Numbers>
  std::size_t operator()(const Numbers& numbers) const {
    std::size_t sum = 0;
    for (const auto number : numbers)
      sum = (std::rotl(sum, 5) ^ std::hash<typename Numbers::value_type>()(number)) * 0x9E3779B97F4A7C15ULL;
    return sum;
  }
};

/// Faces that use the same place use the same vertex, and no face uses one twice in a row.
Mesh withSharedPoints(const Mesh& mesh, const Progress& progress) {
  const std::vector<int> first = mergeEqualPoints(mesh.points, progress);
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<int> face;
    for (const int v : mesh.face(f)) {
      const int vertex = first[static_cast<std::size_t>(v)];
      if (face.empty() || face.back() != vertex) face.push_back(vertex);
    }
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() > 2) result.addFace(face);
  }
  return result;
}

/// The vertices of a face from the lowest one on, so that equal faces read alike.
std::vector<int> fromLowest(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Bodies that share a whole face are one body: the face and its counterpart, which looks back at it, enclose nothing.
Mesh withoutInnerWalls(const Mesh& mesh, const Progress& progress) {
  std::unordered_map<std::vector<int>, std::vector<std::size_t>, NumbersHash> waiting;  // for their counterparts
  waiting.reserve(mesh.faceCount());
  std::vector<bool> inner(mesh.faceCount());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (f % 4096 == 0) progress.check();
    const std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    const auto back = waiting.find(fromLowest({face.rbegin(), face.rend()}));
    if (back == waiting.end() || back->second.empty()) {
      waiting[fromLowest(face)].push_back(f);
      continue;
    }
    inner[f] = inner[back->second.back()] = true;
    back->second.pop_back();
  }
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (!inner[f]) result.addFace(mesh.face(f));
  return result;
}

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
    if (auto thicker = withoutSlivers(solid.triangles, topology, step, step, progress))
      solid.triangles = *std::move(thicker);
  if (solid.triangles.faceCount() == 0) throw enclosesNothing(subject);
  turnOutwards(solid, subject, progress);
  if (solid.bodyInBody)
    solid.warnings.push_back(fmt::format("{} has a body near {} that lies within another one: both are taken as one.",
                                         subject.name, subject.place(*solid.bodyInBody)));
  if (signedVolume(solid.triangles) <= 1e-12 * bounds(solid.triangles).diagonal() * area(solid.triangles))
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
