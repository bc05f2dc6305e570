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
#include "geometry/shape/bounds.h"
#include "kernel/arrangement/numbers.h"
#include "kernel/manifold.h"
#include "kernel/self_crossing.h"
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
  std::unordered_map<std::array<double, 3>, int, NumbersHash> seen;
  seen.reserve(mesh.points.size());
  std::vector<int> first;
  for (const Vec3& p : mesh.points) {  // + 0.0: there is one zero only
    if (first.size() % 4096 == 0) progress.check();
    first.push_back(seen.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}, static_cast<int>(first.size())).first->second);
  }
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

/// Whether the two sides of each shell on a grid are nearer to each other than a step, on average over its area. In whole
/// numbers: doubles would not know what is left of the volume.
std::vector<bool> shellsThinnerThan(double step, const Mesh& mesh, const MeshTopology& topology) {
  using namespace arrangement;
  struct Sums {
    std::optional<Grid3> corner;  ///< from which volumes are seen
    Whole sixVolumes = 0;
    double twoAreas = 0;
  };
  std::vector<Sums> sums(topology.components.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    Sums& shell = sums[static_cast<std::size_t>(topology.componentOfFace[f])];
    const auto corner = [&](std::size_t k) {
      const Vec3& p = mesh.points[static_cast<std::size_t>(mesh.face(f)[k])];
      return Grid3{std::llround(p[0] / step), std::llround(p[1] / step), std::llround(p[2] / step)};
    };
    const Grid3 first = corner(0);
    if (!shell.corner) shell.corner = first;
    const Normal3 normal = cross(corner(1) - first, corner(2) - first);
    shell.sixVolumes += dot(normal, first - *shell.corner);
    shell.twoAreas +=
        Vec3(static_cast<double>(normal[0]), static_cast<double>(normal[1]), static_cast<double>(normal[2])).norm();
  }
  std::vector<bool> isThin;
  isThin.reserve(sums.size());
  for (const Sums& shell : sums)
    isThin.push_back(2 * std::abs(shell.sixVolumes.convert_to<double>()) / 6 < shell.twoAreas / 2);
  return isThin;
}

/// Without shells that rounding may have turned inside out.
Mesh withoutSlivers(Mesh triangles, double step, const Progress& progress) {
  const MeshTopology topology = meshTopology(triangles, progress);
  if (!(step > 0) || topology.components.size() < 2) return triangles;
  const std::vector<bool> isThin = shellsThinnerThan(step, triangles, topology);
  if (std::none_of(isThin.begin(), isThin.end(), [](bool thin) { return thin; })) return triangles;
  Mesh result;
  result.points = triangles.points;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f)
    if (!isThin[static_cast<std::size_t>(topology.componentOfFace[f])]) result.addFace(triangles.face(f));
  return manifoldOf(result, progress);
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

CheckedSolid checkedSolid(const Mesh& mesh, double step, const Subject& subject, const Progress& progress) {
  refuseUnusable(mesh, subject);
  progress.report(0, "Checking the input");
  const Mesh shared = withSharedPoints(mesh, progress);
  if (shared.faceCount() == 0)
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is empty: all of its faces are without area.", subject.name),
                "Choose a solid or a closed mesh.");
  const Mesh outer = withoutInnerWalls(shared, progress);
  if (outer.faceCount() == 0) throw enclosesNothing(subject);
  refuseOpen(outer, meshTopology(outer, progress), subject);
  CheckedSolid solid{withoutDegenerate(manifoldOf(triangulated(outer, progress).first, progress), subject), {}};
  solid.triangles = withoutSlivers(manifoldOfTriangles(solid.triangles, progress), step, progress);
  const double size = bounds(solid.triangles).diagonal();
  turnOutwards(solid, subject, progress);
  if (signedVolume(solid.triangles) <= 1e-12 * size * size * size) throw enclosesNothing(subject);
  refuseCrossing(solid, subject, progress);
  return solid;
}

}  // namespace blossom::morphology
