#include "geometry/mesh/mesh_crossing.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/triangle_crossing.h"

namespace blossom {
namespace {

struct CrossingBox {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  void add(const CrossingBox& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  [[nodiscard]] bool meets(const CrossingBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// A triangle with area and the face it belongs to.
struct FaceTriangle {
  Triangle3 at;
  std::size_t face = 0;
  CrossingBox box;
};

/// Boxes around boxes over triangles in the order of their faces; a node also knows the last triangle below it.
class CrossingTree {
 public:
  CrossingTree(const std::vector<FaceTriangle>& triangles, const Progress& progress) : triangles_(triangles) {
    order_.resize(triangles.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!triangles.empty()) build(0, order_.size(), progress);
  }

  /// Calls `visit` for every triangle behind `from` whose box meets that of `from`.
  template <class Visit>
  void visitBehind(std::size_t from, const Visit& visit) const {
    std::vector<std::size_t> waiting{0};
    const CrossingBox& box = triangles_[from].box;
    while (!waiting.empty()) {
      const Node& node = nodes_[waiting.back()];
      waiting.pop_back();
      if (node.last <= from || !node.box.meets(box)) continue;
      if (node.right == 0) {
        for (std::size_t k = node.begin; k < node.end; ++k)
          if (order_[k] > from && triangles_[order_[k]].box.meets(box)) visit(order_[k]);
      } else {
        waiting.push_back(node.left);
        waiting.push_back(node.right);
      }
    }
  }

 private:
  struct Node {
    CrossingBox box;
    std::size_t begin = 0, end = 0, last = 0;
    std::size_t left = 0, right = 0;  // 0: a leaf
  };

  std::size_t build(std::size_t begin, std::size_t end, const Progress& progress) {
    constexpr std::size_t leafSize = 4;
    progress.check();
    Node node;
    node.begin = begin;
    node.end = end;
    for (std::size_t k = begin; k < end; ++k) {
      node.box.add(triangles_[order_[k]].box);
      node.last = std::max(node.last, order_[k]);
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back(node);
    if (end - begin > leafSize) {
      const std::size_t middle = split(begin, end, node.box);
      const std::size_t left = build(begin, middle, progress), right = build(middle, end, progress);
      nodes_[index].left = left;
      nodes_[index].right = right;
    }
    return index;
  }

  std::size_t split(std::size_t begin, std::size_t end, const CrossingBox& box) {
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const auto centre = [&](std::size_t k) { return triangles_[k].box.low[axis] / 2 + triangles_[k].box.high[axis] / 2; };
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) { return centre(a) < centre(b); });
    return middle;
  }

  const std::vector<FaceTriangle>& triangles_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
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
  const auto [triangles, faces] = triangulated(mesh, progress);
  std::vector<FaceTriangle> result;
  result.reserve(triangles.faceCount());
  for (std::size_t t = 0; t < triangles.faceCount(); ++t) {
    progress.check();
    FaceTriangle made;
    made.face = static_cast<std::size_t>(faces[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      made.at[k] = triangles.points[static_cast<std::size_t>(triangles.face(t)[k])];
      made.box.add({made.at[k], made.at[k]});
    }
    if (!isCollapsed(made.at)) result.push_back(made);
  }
  return result;
}

/// Of triangle `from` with one behind it, the one of the lowest face; then with the lowest triangle.
std::optional<MeshCrossing> crossingOf(std::size_t from, const std::vector<FaceTriangle>& triangles,
                                       const CrossingTree& tree, const CrossingJudge& counts) {
  std::optional<MeshCrossing> found;
  std::size_t lowest = triangles.size();
  tree.visitBehind(from, [&](std::size_t other) {
    if (other >= lowest) return;
    const auto place = crossingElsewhere(triangles[from].at, triangles[other].at);
    if (!place || !counts(triangles[from].at, triangles[other].at)) return;
    found = MeshCrossing{*place, triangles[from].face, triangles[other].face};
    lowest = other;
  });
  return found;
}

}  // namespace

std::optional<MeshCrossing> firstCrossing(const Mesh& mesh, const Progress& progress) {
  refuseWhatIsNoPlace(mesh);
  const std::vector<FaceTriangle> triangles = trianglesWithArea(mesh, progress);
  const CrossingTree tree(triangles, progress);
  std::optional<MeshCrossing> found;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    progress.check();
    // All triangles of a polygon are tested before the first crossing is returned.
    if (found && triangles[k].face != found->first) break;
    const auto here = crossingOf(k, triangles, tree, [](const Triangle3&, const Triangle3&) { return true; });
    if (here && (!found || here->second < found->second)) found = here;
  }
  return found;
}

std::vector<MeshCrossing> crossings(const Mesh& mesh, const CrossingJudge& counts, const Progress& progress) {
  refuseWhatIsNoPlace(mesh);
  const std::vector<FaceTriangle> triangles = trianglesWithArea(mesh, progress);
  const CrossingTree tree(triangles, progress);
  std::vector<MeshCrossing> found;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    progress.check();
    if (const auto here = crossingOf(k, triangles, tree, counts)) found.push_back(*here);
  }
  return found;
}

}  // namespace blossom
