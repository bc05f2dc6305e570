#include "kernel/manifold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <tuple>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/numeric/union_find.h"

namespace blossom::morphology {

namespace {

using EdgeEnds = std::pair<int, int>;  // the lower vertex first

struct Side {
  EdgeEnds edge;
  int face;
  std::size_t corner;  ///< index in faceVertices where the half-edge starts
  std::size_t next;    ///< where it ends
  bool forward;        ///< from the lower vertex to the higher
};

/// Sorted by their edges, those of one edge in the order of the faces.
std::vector<Side> sidesOf(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(mesh.faceVertices.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto start = static_cast<std::size_t>(mesh.faceStarts[f]);
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t next = (k + 1) % face.size();
      const int a = face[k], b = face[next];
      sides.push_back({{std::min(a, b), std::max(a, b)}, static_cast<int>(f), start + k, start + next, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::tie(a.edge, a.corner) < std::tie(b.edge, b.corner); });
  return sides;
}

/// Calls `visit(sides)` for every edge.
template <class Visit>
void forEachEdge(std::span<const Side> sides, const Visit& visit) {
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    while (to < sides.size() && sides[to].edge == sides[from].edge) ++to;
    visit(sides.subspan(from, to - from));
  }
}

/// Sorts the faces round an edge by the direction in which they leave it.
class Round {
 public:
  Round(const Mesh& mesh, int low, int high) : mesh_(mesh), from_(mesh.points[static_cast<std::size_t>(low)]) {
    axis_ = (mesh.points[static_cast<std::size_t>(high)] - from_).normalized();
    x_ = axis_.unitOrthogonal();
    y_ = axis_.cross(x_);
  }
  /// Towards the corner that is farthest from the edge, as the normal of a sliver has no digits left. A face leaves its edge
  /// to the left, normal x direction of travel, where a triangle always lies and a polygon may bulge to the other side.
  [[nodiscard]] double angle(const Side& side) const {
    const auto points = facePoints(mesh_, static_cast<std::size_t>(side.face));
    Vec3 away = Vec3::Zero();
    for (const Vec3& p : points) {
      const Vec3 across = (p - from_) - axis_.dot(p - from_) * axis_;
      if (across.squaredNorm() > away.squaredNorm()) away = across;
    }
    if (points.size() > 3 && vectorArea(points).cross(side.forward ? axis_ : Vec3(-axis_)).dot(away) < 0) away = -away;
    return std::atan2(away.dot(y_), away.dot(x_));
  }

 private:
  const Mesh& mesh_;
  Vec3 from_, axis_, x_, y_;
};

constexpr double together = 1e-6;  ///< radians: faces round an edge that lie on each other, but for the digits of files

double angleBetween(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

/// Of faces that lie on each other, those that run forwards first: what is between them is then the gap of two bodies that
/// touch, never a body without thickness, which would connect the two.
void putGapsBetween(std::vector<std::pair<double, Side>>& sorted) {
  const std::size_t n = sorted.size();
  for (std::size_t round = 0; round < n; ++round)
    for (std::size_t k = 0; k < n; ++k) {
      auto& [here, side] = sorted[k];
      auto& [there, next] = sorted[(k + 1) % n];
      if (!side.forward && next.forward && angleBetween(here, there) <= together) std::swap(side, next);
    }
}

/// Clockwise of a face that runs forwards along the edge lies the inside, up to the next face that runs backwards.
std::vector<std::pair<Side, Side>> wedges(const Mesh& mesh, std::span<const Side> sides) {
  const Round round(mesh, sides[0].edge.first, sides[0].edge.second);
  std::vector<std::pair<double, Side>> sorted;
  for (const Side& side : sides) sorted.emplace_back(round.angle(side), side);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  putGapsBetween(sorted);
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
  const auto unite = [&](const Side& a, const Side& b) {
    if (a.forward == b.forward) return;
    corners.unite(a.corner, b.next);
    corners.unite(a.next, b.corner);
  };
  forEachEdge(sidesOf(mesh), [&](std::span<const Side> sides) {
    if (sides.size() == 2) return unite(sides[0], sides[1]);
    progress.check();
    for (const auto& [a, b] : wedges(mesh, sides)) unite(a, b);
  });
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
std::map<EdgeEnds, int> middlesOfSharedEdges(const Mesh& mesh, std::vector<Vec3>& points) {
  std::map<EdgeEnds, int> middles;
  forEachEdge(sidesOf(mesh), [&](std::span<const Side> sides) {
    if (sides.size() <= 2) return;
    const auto [low, high] = sides[0].edge;
    middles[sides[0].edge] = static_cast<int>(points.size());
    const auto at = [&](int v) { return points[static_cast<std::size_t>(v)]; };
    points.emplace_back((at(low) + at(high)) / 2);
  });
  return middles;
}

/// Cuts a triangle at the first of its edges that has a middle, and what comes of it at the others.
void addCut(std::array<int, 3> t, const std::map<EdgeEnds, int>& middles, Mesh& result) {
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

namespace {

/// Equal places are one corner.
Mesh withSharedCorners(const Mesh& mesh, const Progress& progress) {
  Mesh shared = mesh;
  const std::vector<int> first = mergeEqualPoints(mesh.points, progress);
  for (int& corner : shared.faceVertices) corner = first[static_cast<std::size_t>(corner)];
  return shared;
}

/// Around the edge, faces that run forwards and backwards take turns. Faces in one direction count as in order.
bool takeTurns(const Mesh& mesh, std::span<const Side> sides) {
  const Round round(mesh, sides[0].edge.first, sides[0].edge.second);
  std::vector<std::pair<double, bool>> sorted;
  for (const Side& side : sides) sorted.emplace_back(round.angle(side), side.forward);
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const auto& [here, forward] = sorted[k];
    const auto& [there, alsoForward] = sorted[(k + 1) % sorted.size()];
    if (forward == alsoForward && angleBetween(there, here) > together) {
      // Of faces that lie on each other the sort has taken one first: the other may be the one that is next.
      const auto swaps = [&](std::size_t at, std::size_t with) {
        return sorted[at].second != sorted[with].second && angleBetween(sorted[at].first, sorted[with].first) <= together;
      };
      const std::size_t n = sorted.size(), next = (k + 1) % n;
      if (!swaps(k, (k + n - 1) % n) && !swaps(next, (next + 1) % n)) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<TwistedEdge> firstTwistedEdge(const Mesh& mesh, const Progress& progress) {
  const Mesh shared = withSharedCorners(mesh, progress);
  std::optional<TwistedEdge> found;
  forEachEdge(sidesOf(shared), [&](std::span<const Side> sides) {
    if (found || sides.size() <= 2 || sides[0].edge.first == sides[0].edge.second) return;
    progress.check();
    if (takeTurns(shared, sides)) return;
    const auto at = [&](int v) { return shared.points[static_cast<std::size_t>(v)]; };
    found = TwistedEdge{(at(sides[0].edge.first) + at(sides[0].edge.second)) / 2, {}};
    for (const Side& side : sides) found->faces.push_back(static_cast<std::size_t>(side.face));
  });
  return found;
}

}  // namespace blossom::morphology
