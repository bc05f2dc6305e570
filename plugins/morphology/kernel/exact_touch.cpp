#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "kernel/exact_types.h"
#include "kernel/touching.h"

namespace blossom::morphology {

namespace {

std::vector<std::array<int, 3>> cornersOf(const Mesh& triangles) {
  std::vector<std::array<int, 3>> corners;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const auto face = triangles.face(f);
    corners.push_back({face[0], face[1], face[2]});
  }
  return corners;
}

/// Each shell by itself, over the same points.
std::vector<Mesh> shellsOf(const Mesh& triangles, const MeshTopology& topology) {
  std::vector<Mesh> shells(topology.components.size());
  for (Mesh& shell : shells) shell.points = triangles.points;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f)
    shells[static_cast<std::size_t>(topology.componentOfFace[f])].addFace(triangles.face(f));
  return shells;
}

Mesh turned(const Mesh& mesh) {
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    result.addFace(std::array{face[0], face[2], face[1]});
  }
  return result;
}

Nef nefOfTetrahedron(const std::array<Vec3, 4>& corners) {
  return nefOf(hullOf(toPoints({corners.begin(), corners.end()})));
}

/// What lies in an odd number of them; halved again and again, so that most are small.
Nef oddOnes(const std::vector<std::array<Vec3, 4>>& tetrahedra, std::size_t from, std::size_t to, const Progress& progress) {
  progress.check();
  if (to - from == 1) return nefOfTetrahedron(tetrahedra[from]);
  const std::size_t middle = (from + to) / 2;
  return symmetricDifferenceOf(oddOnes(tetrahedra, from, middle, progress), oddOnes(tetrahedra, middle, to, progress));
}

Nef nefOfShell(const Mesh& shell, const Subject& subject, const Progress& progress) {
  const std::vector<int> touching = touchingVertices(shell);
  if (touching.empty()) return nefOf(surfaceFrom(toPoints(shell.points), cornersOf(shell), subject.name));
  auto apart = pulledApart(shell, progress);
  if (!apart)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} touches itself near {} in a way that cannot be followed.", subject.name,
                            subject.place(shell.points[static_cast<std::size_t>(touching.front())])),
                "Move the touching parts apart, or let them overlap.");
  const Nef moved = nefOf(surfaceFrom(toPoints(apart->shell.points), cornersOf(apart->shell), subject.name));
  std::erase_if(apart->between, [](const auto& corners) { return !haveVolume(toPoints({corners.begin(), corners.end()})); });
  if (apart->between.empty()) return moved;
  return symmetricDifferenceOf(moved, oddOnes(apart->between, 0, apart->between.size(), progress));
}

}  // namespace

Solid exactSolid(const Mesh& triangles, const Subject& subject, const Progress& progress) {
  const MeshTopology topology = meshTopology(triangles, progress);
  const std::vector<Mesh> shells = shellsOf(triangles, topology);
  const auto touches = [](const Mesh& shell) { return !touchingVertices(shell).empty(); };
  if (std::none_of(shells.begin(), shells.end(), touches))
    return solidFrom(surfaceFrom(toPoints(triangles.points), cornersOf(triangles), subject.name));
  std::vector<NefShell> made;
  for (const Mesh& shell : shells) {
    const double volume = signedVolume(shell);
    made.push_back({nefOfShell(volume < 0 ? turned(shell) : shell, subject, progress), std::abs(volume), volume >= 0});
  }
  return solidFrom(nefOf(std::move(made)));
}

}  // namespace blossom::morphology
