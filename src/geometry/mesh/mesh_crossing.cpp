#include "geometry/mesh/mesh_crossing.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/triangle_crossing.h"
#include "geometry/numeric/box_tree.h"

namespace blossom {
namespace {

/// A triangle with area and the face it belongs to.
struct FaceTriangle {
  Triangle3 at;
  std::size_t face = 0;
  Box3 box;
};

void refuseWhatIsNoPlace(const Mesh& mesh) {
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    if (!mesh.points[k].allFinite())
      throw Error(ErrorCode::InvalidInput, fmt::format("The mesh has a point, number {}, that is not a number.", k + 1),
                  "Export the mesh again.");
  const int count = static_cast<int>(mesh.points.size());
  for (const int v : mesh.faceVertices)
    if (v < 0 || v >= count)
      throw Error(ErrorCode::InvalidInput, fmt::format("A face asks for point {}, and there are {} points.", v + 1, count),
                  "Export the mesh again.");
}

std::vector<FaceTriangle> trianglesWithArea(const Mesh& mesh, const Progress& progress) {
  const auto both = triangulated(mesh, progress);
  const Mesh& triangles = both.first;
  std::vector<FaceTriangle> result(triangles.faceCount());
  std::vector<char> isFlat(result.size());
  parallelFor(result.size(), 512, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      FaceTriangle& made = result[t];
      made.face = static_cast<std::size_t>(both.second[t]);
      for (std::size_t k = 0; k < 3; ++k) {
        made.at[k] = triangles.points[static_cast<std::size_t>(triangles.face(t)[k])];
        made.box.extend(made.at[k]);
      }
      isFlat[t] = isCollapsed(made.at) ? 1 : 0;
    }
  });
  std::size_t count = 0;
  for (std::size_t t = 0; t < result.size(); ++t)
    if (!isFlat[t]) result[count++] = result[t];
  result.resize(count);
  return result;
}

BoxTree<3> treeOver(const std::vector<FaceTriangle>& triangles, const Progress& progress) {
  std::vector<Box3> boxes;
  boxes.reserve(triangles.size());
  for (const FaceTriangle& triangle : triangles) boxes.push_back(triangle.box);
  constexpr std::size_t leafSize = 4;
  return BoxTree<3>(boxes, leafSize, progress);
}

/// Of triangle `from` with one behind it, the one of the lowest face; then with the lowest triangle.
std::optional<MeshCrossing> crossingOf(std::size_t from, const std::vector<FaceTriangle>& triangles, const BoxTree<3>& tree,
                                       const CrossingJudge& counts) {
  std::optional<MeshCrossing> found;
  std::size_t lowest = triangles.size();
  const Box3& box = triangles[from].box;
  const auto visit = [&](std::size_t other) {
    if (other >= lowest || !box.intersects(triangles[other].box)) return;
    const auto place = crossingElsewhere(triangles[from].at, triangles[other].at);
    if (!place || !counts(triangles[from].at, triangles[other].at)) return;
    found = MeshCrossing{*place, triangles[from].face, triangles[other].face};
    lowest = other;
  };
  tree.meeting(box, visit, from + 1);
  return found;
}

}  // namespace

std::optional<MeshCrossing> firstCrossing(const Mesh& mesh, const Progress& progress) {
  refuseWhatIsNoPlace(mesh);
  const std::vector<FaceTriangle> triangles = trianglesWithArea(mesh, progress);
  const BoxTree<3> tree = treeOver(triangles, progress);
  constexpr std::size_t atATime = 8192;  // so that what crosses early is not looked for to the end
  std::optional<MeshCrossing> found;
  for (std::size_t start = 0; start < triangles.size(); start += atATime) {
    std::vector<std::optional<MeshCrossing>> here(std::min(atATime, triangles.size() - start));
    parallelFor(here.size(), 64, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        progress.check();
        here[k] = crossingOf(start + k, triangles, tree, [](const Triangle3&, const Triangle3&) { return true; });
      }
    });
    for (std::size_t k = 0; k < here.size(); ++k) {
      // All triangles of a polygon are tested before the first crossing is returned.
      if (found && triangles[start + k].face != found->first) return found;
      if (here[k] && (!found || here[k]->second < found->second)) found = here[k];
    }
  }
  return found;
}

std::vector<MeshCrossing> crossings(const Mesh& mesh, const CrossingJudge& counts, const Progress& progress) {
  refuseWhatIsNoPlace(mesh);
  const std::vector<FaceTriangle> triangles = trianglesWithArea(mesh, progress);
  const BoxTree<3> tree = treeOver(triangles, progress);
  std::vector<MeshCrossing> found;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    progress.check();
    if (const auto here = crossingOf(k, triangles, tree, counts)) found.push_back(*here);
  }
  return found;
}

}  // namespace blossom
