#include "kernel/slivers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/arrangement/numbers.h"
#include "kernel/manifold.h"

namespace blossom::morphology {

namespace {

/// The faces of each shell.
std::vector<std::vector<std::size_t>> facesOfShells(const MeshTopology& topology) {
  std::vector<std::vector<std::size_t>> faces(topology.components.size());
  for (std::size_t f = 0; f < topology.componentOfFace.size(); ++f)
    faces[static_cast<std::size_t>(topology.componentOfFace[f])].push_back(f);
  return faces;
}

/// Calls visit(a, b, c) with the corners of the triangles that a face is divided into from its first corner. Some of them
/// turn the other way where it is not convex: sums of their normals are right, those of their areas are not.
template <class Visit>
void forEachTriangle(const Mesh& mesh, std::size_t face, const Visit& visit) {
  const auto corners = mesh.face(face);
  const auto at = [&](std::size_t k) -> const Vec3& { return mesh.points[static_cast<std::size_t>(corners[k])]; };
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) visit(at(0), at(k), at(k + 1));
}

/// Whether doubles know that the two sides of a shell are farther from each other than a thickness, on average.
bool isSurelyThicker(double thickness, const Mesh& mesh, const std::vector<std::size_t>& shell) {
  const Vec3& from = mesh.points[static_cast<std::size_t>(mesh.face(shell.front())[0])];
  double sixVolumes = 0, twoAreas = 0, fanAreas = 0, farthest = 0, count = 8;
  for (const std::size_t f : shell) {
    Vec3 ofFace = Vec3::Zero();
    forEachTriangle(mesh, f, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const Vec3 normal = (b - a).cross(c - a);
      sixVolumes += normal.dot(a - from);
      ofFace += normal;
      fanAreas += normal.norm();
      farthest = std::max(farthest, (a - from).norm());
      ++count;
    });
    twoAreas += ofFace.norm();
  }
  const double roundOff = count * std::numeric_limits<double>::epsilon() * farthest;
  return 2 * std::abs(sixVolumes) / 6 > (thickness * twoAreas + 4 * roundOff * fanAreas) / 2;
}

/// The same of shells on a grid, in whole numbers: doubles would not know what is left of the volume.
bool isThinner(double thickness, double unit, const Mesh& mesh, const std::vector<std::size_t>& shell) {
  using namespace arrangement;
  const auto onGrid = [unit](const Vec3& p) {
    return Grid3{std::llround(p[0] / unit), std::llround(p[1] / unit), std::llround(p[2] / unit)};
  };
  const Grid3 from = onGrid(mesh.points[static_cast<std::size_t>(mesh.face(shell.front())[0])]);
  Whole sixVolumes = 0;
  double twoAreas = 0;
  for (const std::size_t f : shell) {
    Vec3 ofFace = Vec3::Zero();
    forEachTriangle(mesh, f, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const Grid3 first = onGrid(a);
      const Normal3 normal = cross(onGrid(b) - first, onGrid(c) - first);
      sixVolumes += dot(normal, first - from);
      ofFace += Vec3(static_cast<double>(normal[0]), static_cast<double>(normal[1]), static_cast<double>(normal[2]));
    });
    twoAreas += ofFace.norm();
  }
  return twoAreas == 0 || 2 * std::abs(sixVolumes.convert_to<double>()) / 6 < thickness / unit * twoAreas / 2;
}

}  // namespace

std::optional<Mesh> withoutSlivers(const Mesh& mesh, const MeshTopology& topology, double thickness, double unit,
                                   const Progress& progress) {
  Mesh result;
  result.points = mesh.points;
  bool isLess = false;
  for (const auto& shell : facesOfShells(topology)) {
    progress.check();
    if (!isSurelyThicker(thickness, mesh, shell) && isThinner(thickness, unit, mesh, shell))
      isLess = true;
    else
      for (const std::size_t f : shell) result.addFace(mesh.face(f));
  }
  if (!isLess) return std::nullopt;
  return manifoldOf(result, progress);
}

}  // namespace blossom::morphology
