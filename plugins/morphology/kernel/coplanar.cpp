#include "kernel/coplanar.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

#include "core/parallel.h"
#include "geometry/mesh/mesh_topology.h"
#include "kernel/coplanar_regions.h"
#include "kernel/plane_triangles.h"

namespace blossom::morphology {

namespace {

constexpr std::size_t regionsOfPart = 64;  // that are worked on beside others

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Which vertices stay: corners of the regions, and what bends the chains between them.
class Chains {
 public:
  Chains(const Mesh& mesh, const MeshTopology& topology, const std::vector<int>& regionOfFace, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), next_(mesh.points.size()), stays_(mesh.points.size(), false) {
    std::vector<bool> corner(mesh.points.size(), false);
    for (const MeshEdge& edge : topology.edges) {
      if (edge.manifold() && regionOfFace[at(edge.faces[0])] == regionOfFace[at(edge.faces[1])]) continue;
      next_[at(edge.low)].push_back(edge.high);
      next_[at(edge.high)].push_back(edge.low);
      if (!edge.manifold()) corner[at(edge.low)] = corner[at(edge.high)] = true;
    }
    for (std::size_t v = 0; v < next_.size(); ++v) stays_[v] = corner[v] || (!next_[v].empty() && next_[v].size() != 2);
  }
  void lock(int v) { stays_[at(v)] = true; }
  /// All vertices that stay, after `lock`.
  [[nodiscard]] std::vector<bool> simplified() const {
    std::vector<bool> stays = stays_, seen(stays_.size(), false);
    for (std::size_t v = 0; v < next_.size(); ++v)
      if (stays_[v])
        for (const int next : next_[v])
          if (!seen[at(next)]) thin(walk(static_cast<int>(v), next, seen), stays);
    for (std::size_t v = 0; v < next_.size(); ++v)
      if (!next_[v].empty() && !stays_[v] && !seen[v]) thinRing(static_cast<int>(v), stays, seen);
    return stays;
  }

 private:
  /// From a corner along a chain to the next one, or round to the start.
  [[nodiscard]] std::vector<int> walk(int from, int next, std::vector<bool>& seen) const {
    std::vector<int> chain{from};
    while (!stays_[at(next)] && next != from) {
      seen[at(next)] = true;
      const int previous = chain.back();
      chain.push_back(next);
      const auto& both = next_[at(next)];
      next = both[0] == previous ? both[1] : both[0];
    }
    chain.push_back(next);
    return chain;
  }
  void thinRing(int start, std::vector<bool>& stays, std::vector<bool>& seen) const {
    std::vector<int> ring = walk(start, next_[at(start)][0], seen);
    seen[at(start)] = true;
    const auto distance = [&](int v) { return (mesh_.points[at(v)] - mesh_.points[at(start)]).squaredNorm(); };
    const auto far = std::max_element(ring.begin(), ring.end(), [&](int a, int b) { return distance(a) < distance(b); });
    stays[at(start)] = stays[at(*far)] = true;
    thin({ring.begin(), far + 1}, stays);
    thin({far, ring.end()}, stays);
  }
  /// Douglas and Peucker: keeps the farthest vertex while it is too far from the chord.
  void thin(const std::vector<int>& chain, std::vector<bool>& stays) const {
    if (chain.size() < 3) return;
    const Vec3 &a = mesh_.points[at(chain.front())], &b = mesh_.points[at(chain.back())];
    const Vec3 along = b - a;
    const double squared = along.squaredNorm();
    double most = -1;
    std::size_t worst = 0;
    for (std::size_t k = 1; k + 1 < chain.size(); ++k) {
      const Vec3 offset = mesh_.points[at(chain[k])] - a;
      const double t = squared > 0 ? std::clamp(offset.dot(along) / squared, 0.0, 1.0) : 0;
      const double distance = (offset - t * along).norm();
      if (distance > most) {
        most = distance;
        worst = k;
      }
    }
    if (most <= tolerance_) return;
    stays[at(chain[worst])] = true;
    const auto middle = chain.begin() + static_cast<std::ptrdiff_t>(worst);
    thin({chain.begin(), middle + 1}, stays);
    thin({middle, chain.end()}, stays);
  }

  const Mesh& mesh_;
  double tolerance_;
  std::vector<std::vector<int>> next_;
  std::vector<bool> stays_;
};

/// From a vertex to the next one along the boundary of a region, counter-clockwise.
struct Step {
  int region = 0, from = 0, to = 0;
  friend bool operator==(const Step&, const Step&) = default;
  friend bool operator<(const Step& a, const Step& b) {
    return std::tie(a.region, a.from, a.to) < std::tie(b.region, b.from, b.to);
  }
};

/// In order: by region, then by where they begin.
std::vector<Step> boundarySteps(const Mesh& mesh, const MeshTopology& topology, const std::vector<int>& regionOfFace) {
  std::vector<bool> isWithin(mesh.faceVertices.size(), false);  // sides between two triangles of one region
  for (const MeshEdge& edge : topology.edges)
    if (edge.manifold() && regionOfFace[at(edge.faces[0])] == regionOfFace[at(edge.faces[1])])
      isWithin[at(edge.corners[0])] = isWithin[at(edge.corners[1])] = true;
  std::vector<Step> others, boundary;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < 3; ++k)
      if (!isWithin[3 * f + k]) others.push_back({regionOfFace[f], face[k], face[(k + 1) % 3]});
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  for (const Step& step : others)
    if (!std::binary_search(others.begin(), others.end(), Step{step.region, step.to, step.from})) boundary.push_back(step);
  return boundary;
}

/// The loops that the steps of one region make. @param steps in order
std::vector<std::vector<int>> loopsAlong(std::span<const Step> steps) {
  std::vector<std::vector<int>> loops;
  std::vector<bool> gone(steps.size(), false);
  const auto nextFrom = [&](int vertex) {
    const auto at =
        std::lower_bound(steps.begin(), steps.end(), vertex, [](const Step& step, int from) { return step.from < from; });
    auto k = static_cast<std::size_t>(at - steps.begin());
    while (k < steps.size() && steps[k].from == vertex && gone[k]) ++k;
    return k < steps.size() && steps[k].from == vertex ? k : steps.size();
  };
  for (std::size_t start = 0; start < steps.size(); ++start) {
    if (gone[start]) continue;
    std::vector<int> loop;
    for (std::size_t k = start; k < steps.size(); k = nextFrom(steps[k].to)) {
      loop.push_back(steps[k].from);
      gone[k] = true;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// The boundary of each region as loops of vertices, counter-clockwise.
std::vector<std::vector<std::vector<int>>> loopsOf(const Mesh& mesh, const MeshTopology& topology,
                                                   const std::vector<int>& regionOfFace, std::size_t count,
                                                   const Progress& progress) {
  const std::vector<Step> steps = boundarySteps(mesh, topology, regionOfFace);
  std::vector<std::size_t> starts(count + 1, 0);  // of the steps of each region
  for (const Step& step : steps) ++starts[at(step.region) + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::vector<std::vector<int>>> loops(count);
  parallelFor(count, regionsOfPart, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t r = first; r < last; ++r)
      loops[r] = loopsAlong(std::span(steps).subspan(starts[r], starts[r + 1] - starts[r]));
  });
  return loops;
}

bool repeats(std::vector<int> loop) {
  std::sort(loop.begin(), loop.end());
  return std::adjacent_find(loop.begin(), loop.end()) != loop.end();
}

double areaOf(const Mesh& mesh, const std::vector<std::array<int, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += (mesh.points[at(b)] - mesh.points[at(a)]).cross(mesh.points[at(c)] - mesh.points[at(a)]).norm() / 2;
  return sum;
}

/// Vertices that lie in one place with another: there the surface touches itself, which it must go on doing in common
/// vertices and edges.
std::vector<int> touchingPlaces(const Mesh& mesh) {
  const auto place = [&](int v) -> std::array<double, 3> {
    const Vec3& p = mesh.points[at(v)];
    return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
  };
  std::vector<int> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
  std::vector<int> touching;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool before = k > 0 && place(order[k - 1]) == place(order[k]);
    const bool after = k + 1 < order.size() && place(order[k + 1]) == place(order[k]);
    if (before || after) touching.push_back(order[k]);
  }
  return touching;
}

/// The vertices of the loops that stay, each loop from its lowest on: what is made of them does not depend on the others.
std::vector<std::vector<int>> thinnedLoops(const std::vector<std::vector<int>>& loops, const std::vector<bool>& stays) {
  std::vector<std::vector<int>> thinned;
  for (const auto& loop : loops) {
    std::vector<int> left;
    for (const int v : loop)
      if (stays[at(v)]) left.push_back(v);
    if (left.size() < 3) continue;
    std::rotate(left.begin(), std::min_element(left.begin(), left.end()), left.end());
    thinned.push_back(std::move(left));
  }
  std::sort(thinned.begin(), thinned.end());
  return thinned;
}

/// Across what the loops enclose together.
Vec3 normalOf(const Mesh& mesh, const std::vector<std::vector<int>>& loops) {
  Vec3 sum = Vec3::Zero();
  for (const auto& loop : loops) {
    std::vector<Vec3> polygon;
    polygon.reserve(loop.size());
    for (const int v : loop) polygon.push_back(mesh.points[at(v)]);
    sum += vectorArea(polygon);
  }
  return sum;
}

using Faces = std::vector<std::vector<int>>;

/// What a region is made of anew.
struct Covering {
  Faces faces;
  bool isWhole = false;
};

/// The faces of a region from its thinned loops; false when they would not cover it.
bool facesOf(const Mesh& mesh, const std::vector<std::vector<int>>& loops, const Vec3& normal, double area, double slack,
             Faces& faces) {
  if (loops.empty()) return true;  // thinned away: the neighbours meet
  if (loops.size() == 1 && !repeats(loops.front())) {
    std::vector<Vec3> polygon;
    for (const int v : loops.front()) polygon.push_back(mesh.points[at(v)]);
    double covered = 0;
    for (const auto& [a, b, c] : triangulate(polygon))
      covered += (polygon[at(b)] - polygon[at(a)]).cross(polygon[at(c)] - polygon[at(a)]).norm() / 2;
    faces.push_back(loops.front());
    return std::abs(covered - area) <= slack;
  }
  const auto triangles = trianglesBetween(mesh.points, loops, normal);
  for (const auto& triangle : triangles) faces.emplace_back(triangle.begin(), triangle.end());
  return !triangles.empty() && std::abs(areaOf(mesh, triangles) - area) <= slack;
}

/// Whether each vertex is the end of three edges at least: none would be left out between two faces.
bool keepsAllVertices(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<int> edges(mesh.points.size(), 0);
  for (const MeshEdge& edge : topology.edges) {
    if (!edge.manifold()) return false;
    ++edges[at(edge.low)];
    ++edges[at(edge.high)];
  }
  return std::all_of(edges.begin(), edges.end(), [](int count) { return count >= 3; });
}

}  // namespace

Mesh joinedCoplanar(const Mesh& mesh, const CoplanarOptions& options, const Progress& progress) {
  const MeshTopology topology = meshTopology(mesh, progress);
  const CoplanarRegions regions = coplanarRegions(mesh, topology, options.tolerance);
  if (regions.count == mesh.faceCount() && keepsAllVertices(mesh, topology)) return mesh;
  const auto& regionOfFace = regions.ofFace;
  const auto loops = loopsOf(mesh, topology, regionOfFace, regions.count, progress);
  std::vector<double> area(regions.count);
  double largest = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) area[at(regionOfFace[f])] += vectorArea(facePoints(mesh, f)).norm();
  for (const Vec3& p : mesh.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  Chains chains(mesh, topology, regionOfFace, options.tolerance);
  for (const int v : touchingPlaces(mesh)) chains.lock(v);

  std::vector<bool> kept(regions.count, false);  // regions whose triangles stay
  for (bool again = true; again;) {
    again = false;
    progress.check();
    const std::vector<bool> stays = chains.simplified();
    std::vector<Covering> coverings(regions.count);
    parallelFor(regions.count, regionsOfPart, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t r = first; r < last; ++r) {
        if (kept[r]) continue;
        const auto thinned = thinnedLoops(loops[r], stays);
        const double slack = 1e-9 * area[r] + 10 * options.tolerance * largest;
        coverings[r].isWhole = facesOf(mesh, thinned, normalOf(mesh, thinned), area[r], slack, coverings[r].faces);
      }
    });
    Mesh result;
    result.points = mesh.points;
    for (std::size_t r = 0; r < regions.count; ++r) {
      if (kept[r]) continue;
      if (coverings[r].isWhole) {
        for (const auto& face : coverings[r].faces) result.addFace(face);
        continue;
      }
      kept[r] = again = true;
      for (const auto& loop : loops[r])
        for (const int v : loop) chains.lock(v);
    }
    if (again) continue;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f)
      if (kept[at(regionOfFace[f])]) result.addFace(mesh.face(f));
    return result;
  }
  return mesh;
}

}  // namespace blossom::morphology
