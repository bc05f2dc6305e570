#include "kernel/manifold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/union_find.h"

namespace blossom::morphology {

namespace {

struct Side {
  int face;
  std::size_t corner;  ///< index in faceVertices where the half-edge starts
  std::size_t next;    ///< where it ends
  bool forward;        ///< from the lower vertex to the higher
};

using EdgeSides = std::map<std::pair<int, int>, std::vector<Side>>;

EdgeSides sidesOf(const Mesh& mesh) {
  EdgeSides sides;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto start = static_cast<std::size_t>(mesh.faceStarts[f]);
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t next = (k + 1) % face.size();
      const int a = face[k], b = face[next];
      sides[{std::min(a, b), std::max(a, b)}].push_back({static_cast<int>(f), start + k, start + next, a < b});
    }
  }
  return sides;
}

/// Sorts the faces round an edge by the direction in which they leave it.
class Round {
 public:
  Round(const Mesh& mesh, int low, int high) : mesh_(mesh), from_(mesh.points[static_cast<std::size_t>(low)]) {
    axis_ = (mesh.points[static_cast<std::size_t>(high)] - from_).normalized();
    x_ = axis_.unitOrthogonal();
    y_ = axis_.cross(x_);
  }
  /// Faces leave their edge to its left: normal x direction of travel.
  [[nodiscard]] double angle(const Side& side) const {
    const auto points = facePoints(mesh_, static_cast<std::size_t>(side.face));
    const Vec3 inward = vectorArea(points).cross(side.forward ? axis_ : Vec3(-axis_));
    return std::atan2(inward.dot(y_), inward.dot(x_));
  }

 private:
  const Mesh& mesh_;
  Vec3 from_, axis_, x_, y_;
};

/// Clockwise of a face that runs forwards along the edge lies the inside, up to the next face that runs backwards.
std::vector<std::pair<Side, Side>> wedges(const Mesh& mesh, const std::pair<int, int>& edge,
                                          const std::vector<Side>& sides) {
  if (sides.size() == 2) return {{sides[0], sides[1]}};
  const Round round(mesh, edge.first, edge.second);
  std::vector<std::pair<double, Side>> sorted;
  for (const Side& side : sides) sorted.emplace_back(round.angle(side), side);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::pair<Side, Side>> pairs;
  std::vector<bool> used(sorted.size());
  const std::size_t n = sorted.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!sorted[k].second.forward) continue;
    for (std::size_t step = 1; step < n; ++step) {
      const std::size_t other = (k + n - step) % n;
      if (sorted[other].second.forward || used[other]) continue;
      used[other] = true;
      pairs.emplace_back(sorted[k].second, sorted[other].second);
      break;
    }
  }
  return pairs;
}

}  // namespace

Mesh manifoldOf(const Mesh& mesh, const Progress& progress) {
  UnionFind corners(mesh.faceVertices.size());
  for (const auto& [edge, sides] : sidesOf(mesh)) {
    progress.check();
    for (const auto& [a, b] : wedges(mesh, edge, sides)) {
      if (a.forward == b.forward) continue;
      corners.unite(a.corner, b.next);
      corners.unite(a.next, b.corner);
    }
  }
  Mesh result;
  result.name = mesh.name;
  result.color = mesh.color;
  result.faceStarts = mesh.faceStarts;
  result.faceVertices.resize(mesh.faceVertices.size());
  std::vector<int> made(mesh.faceVertices.size(), -1);
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c) {
    int& vertex = made[corners.find(c)];
    if (vertex < 0) {
      vertex = static_cast<int>(result.points.size());
      result.points.push_back(mesh.points[static_cast<std::size_t>(mesh.faceVertices[c])]);
    }
    result.faceVertices[c] = vertex;
  }
  return result;
}

namespace {

/// Edges of more than two faces, each with the vertex for its middle, which is one of the result's.
std::map<std::pair<int, int>, int> middlesOfSharedEdges(const Mesh& mesh, std::vector<Vec3>& points) {
  std::map<std::pair<int, int>, int> middles;
  for (const auto& [edge, sides] : sidesOf(mesh)) {
    if (sides.size() <= 2) continue;
    middles[edge] = static_cast<int>(points.size());
    const auto at = [&](int v) { return points[static_cast<std::size_t>(v)]; };
    points.emplace_back((at(edge.first) + at(edge.second)) / 2);
  }
  return middles;
}

/// Cuts a triangle at the first of its edges that has a middle, and what comes of it at the others.
void addCut(std::array<int, 3> t, const std::map<std::pair<int, int>, int>& middles, Mesh& result) {
  for (int k = 0; k < 3; ++k) {
    const auto found = middles.find({std::min(t[0], t[1]), std::max(t[0], t[1])});
    if (found != middles.end()) {
      addCut({t[0], found->second, t[2]}, middles, result);
      addCut({found->second, t[1], t[2]}, middles, result);
      return;
    }
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  result.addFace(t);
}

}  // namespace

Mesh manifoldOfTriangles(const Mesh& triangles, const Progress& progress) {
  Mesh mesh = manifoldOf(triangles, progress);
  Mesh cut;
  cut.name = mesh.name;
  cut.color = mesh.color;
  cut.points = mesh.points;
  const auto middles = middlesOfSharedEdges(mesh, cut.points);
  if (middles.empty()) return mesh;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    addCut({face[0], face[1], face[2]}, middles, cut);
  }
  return manifoldOf(cut, progress);
}

}  // namespace blossom::morphology
