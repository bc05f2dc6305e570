#include "kernel/rims.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/numeric/union_find.h"
#include "kernel/cage.h"

namespace blossom::subdivision {
namespace {

constexpr double sameShare = 1e-9;  // of the size

/// A half-edge of the rim, from vertex to vertex.
using HalfEdge = std::pair<int, int>;

std::vector<HalfEdge> rimOf(const Mesh& mesh, const Progress& progress) {
  std::vector<HalfEdge> rim;
  for (const MeshEdge& edge : meshTopology(mesh, progress).edges) {
    if (edge.forward + edge.backward != 1) continue;
    rim.push_back(edge.forward == 1 ? HalfEdge(edge.low, edge.high) : HalfEdge(edge.high, edge.low));
  }
  return rim;
}

double sizeOf(const Mesh& mesh) {
  Vec3 low = mesh.points.front(), high = low;
  for (const Vec3& p : mesh.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

/// For each half-edge of the rim the places that it runs between, as numbers of places.
std::map<HalfEdge, std::vector<std::size_t>> byPlace(const Mesh& mesh, const std::vector<HalfEdge>& rim) {
  std::vector<Vec3> ends;
  for (const auto& [from, to] : rim)
    for (const int v : {from, to}) ends.push_back(mesh.points[static_cast<std::size_t>(v)]);
  const std::vector<int> place = mergeClosePoints(ends, sameShare * sizeOf(mesh));
  std::map<HalfEdge, std::vector<std::size_t>> edges;
  for (std::size_t e = 0; e < rim.size(); ++e) edges[{place[2 * e], place[2 * e + 1]}].push_back(e);
  return edges;
}

/// The mesh with every vertex replaced by the lowest of its set.
Mesh renumbered(const Mesh& mesh, UnionFind& sets) {
  std::vector<std::size_t> lowest(mesh.points.size(), mesh.points.size());
  for (std::size_t v = 0; v < lowest.size(); ++v) lowest[sets.find(v)] = std::min(lowest[sets.find(v)], v);
  std::vector<int> number(mesh.points.size(), -1);
  Mesh result = mesh;
  result.points.clear();
  for (std::size_t v = 0; v < number.size(); ++v) {
    const std::size_t kept = lowest[sets.find(v)];
    if (kept == v) {
      number[v] = static_cast<int>(result.points.size());
      result.points.push_back(mesh.points[v]);
    } else {
      number[v] = number[kept];
    }
  }
  const auto renumber = [&](int& v) { v = number[static_cast<std::size_t>(v)]; };
  for (int& v : result.faceVertices) renumber(v);
  // What both halves say of a common edge or vertex is said once; the sharper one counts.
  std::map<HalfEdge, double> creases;
  for (Crease& crease : result.creases) {
    renumber(crease.from);
    renumber(crease.to);
    double& sharpness = creases[std::minmax(crease.from, crease.to)];
    sharpness = std::max(sharpness, crease.sharpness);
  }
  result.creases.clear();
  for (const auto& [ends, sharpness] : creases) result.creases.push_back({ends.first, ends.second, sharpness});
  std::map<int, double> corners;
  for (const Corner& corner : mesh.corners) {
    double& sharpness = corners[number[static_cast<std::size_t>(corner.vertex)]];
    sharpness = std::max(sharpness, corner.sharpness);
  }
  result.corners.clear();
  for (const auto& [vertex, sharpness] : corners) result.corners.push_back({vertex, sharpness});
  return result;
}

}  // namespace

JoinedRims joinRims(const Mesh& mesh, const Progress& progress) {
  if (mesh.points.empty()) return {mesh, 0};
  const std::vector<HalfEdge> rim = rimOf(mesh, progress);
  if (rim.empty()) return {mesh, 0};
  const auto edges = byPlace(mesh, rim);
  UnionFind sets(mesh.points.size());
  for (const auto& [places, here] : edges) {
    progress.check();
    const auto back = edges.find({places.second, places.first});
    if (places.first >= places.second || back == edges.end() || here.size() != 1 || back->second.size() != 1) continue;
    const HalfEdge there = rim[here[0]], andBack = rim[back->second[0]];
    sets.unite(static_cast<std::size_t>(there.first), static_cast<std::size_t>(andBack.second));
    sets.unite(static_cast<std::size_t>(there.second), static_cast<std::size_t>(andBack.first));
  }
  Mesh joined = renumbered(mesh, sets);
  const std::size_t gone = mesh.points.size() - joined.points.size();
  if (gone == 0) return {mesh, 0};
  return {std::move(joined), gone};
}

JoinedRims joinedCage(const Mesh& mesh, Scheme scheme, const Progress& progress) {
  try {
    JoinedRims joined = joinRims(mesh, progress);
    if (joined.joined > 0) checkCage(joined.mesh, scheme, progress);
    return joined;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput) throw;
    return {mesh, 0};  // what is wrong with the mesh itself, its own check says
  }
}

}  // namespace blossom::subdivision
