#include "kernel/cage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/union_find.h"

namespace blossom::subdivision {
namespace {

[[noreturn]] void refuse(std::string message, std::string hint) {
  throw Error(ErrorCode::InvalidInput, std::move(message), std::move(hint));
}

void checkPoints(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (!mesh.points[i].allFinite())
      refuse(fmt::format("Vertex {} of the cage has a coordinate that is no number.", i + 1),
             "Correct the coordinate where the cage was made.");
}

void checkFaces(const Mesh& mesh, Scheme scheme) {
  if (mesh.faceCount() == 0) refuse("The cage has no face.", "Give a mesh with at least one face.");
  std::vector<int> sorted;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3)
      refuse(fmt::format("Face {} of the cage has {} vertices.", f + 1, face.size()), "Delete it: a face needs three.");
    if (scheme == Scheme::Loop && face.size() != 3)
      refuse(fmt::format("Face {} of the cage has {} vertices; Loop takes triangles only.", f + 1, face.size()),
             "Split the faces into triangles, or choose the scheme Catmull-Clark.");
    sorted.assign(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
      refuse(fmt::format("Face {} of the cage runs through vertex {} twice.", f + 1, *twice + 1),
             "Delete the face or give it vertices that differ.");
  }
}

void checkEdges(const MeshTopology& topology) {
  for (const MeshEdge& edge : topology.edges) {
    if (edge.forward + edge.backward > 2)
      refuse(fmt::format("{} faces meet at the edge from vertex {} to vertex {} of the cage.", edge.forward + edge.backward,
                         edge.low + 1, edge.high + 1),
             "Delete faces until two are left at every edge.");
    if (edge.forward > 1 || edge.backward > 1)
      refuse(fmt::format("The two faces at the edge from vertex {} to vertex {} of the cage are turned differently.",
                         edge.low + 1, edge.high + 1),
             "Turn faces round until all of them run counter-clockwise seen from outside.");
  }
}

/// One fan of faces round every vertex: corners that meet over an edge are one set, and each vertex has one set.
void checkFans(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<std::size_t> after(mesh.faceVertices.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto from = static_cast<std::size_t>(mesh.faceStarts[f]), to = static_cast<std::size_t>(mesh.faceStarts[f + 1]);
    for (std::size_t c = from; c < to; ++c) after[c] = c + 1 < to ? c + 1 : from;
  }
  UnionFind corners(mesh.faceVertices.size());
  for (const MeshEdge& edge : topology.edges) {
    if (!edge.manifold()) continue;
    const auto a = static_cast<std::size_t>(edge.corners[0]), b = static_cast<std::size_t>(edge.corners[1]);
    corners.unite(a, after[b]);
    corners.unite(b, after[a]);
  }
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> fan(mesh.points.size(), none);
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c) {
    std::size_t& known = fan[static_cast<std::size_t>(mesh.faceVertices[c])];
    if (known == none) known = corners.find(c);
    if (known != corners.find(c))
      refuse(fmt::format("Parts of the cage touch at vertex {} without sharing an edge.", mesh.faceVertices[c] + 1),
             "Give each part a vertex of its own there.");
  }
  if (const auto unused = std::find(fan.begin(), fan.end(), none); unused != fan.end())
    refuse(fmt::format("Vertex {} of the cage belongs to no face.", unused - fan.begin() + 1), "Delete the vertex.");
}

bool validSharpness(double sharpness) { return std::isfinite(sharpness) && sharpness >= 0; }

void checkTags(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(topology.edges.size());
  for (const MeshEdge& edge : topology.edges) edges.emplace_back(edge.low, edge.high);
  std::sort(edges.begin(), edges.end());
  for (const Crease& crease : mesh.creases) {
    const auto [low, high] = std::minmax(crease.from, crease.to);
    if (!std::binary_search(edges.begin(), edges.end(), std::pair<int, int>(low, high)))
      refuse(
          fmt::format("The crease from vertex {} to vertex {} follows no edge of the cage.", crease.from + 1, crease.to + 1),
          "Delete the crease or let it follow an edge.");
    if (!validSharpness(crease.sharpness))
      refuse(fmt::format("The crease from vertex {} to vertex {} has a sharpness below 0.", crease.from + 1, crease.to + 1),
             "Sharpness runs from 0, smooth, to 10, sharp.");
  }
  for (const Corner& corner : mesh.corners) {
    if (corner.vertex < 0 || static_cast<std::size_t>(corner.vertex) >= mesh.points.size())
      refuse(fmt::format("A corner names vertex {}, which the cage does not have.", corner.vertex + 1),
             "Delete the corner.");
    if (!validSharpness(corner.sharpness))
      refuse(fmt::format("The corner at vertex {} has a sharpness below 0.", corner.vertex + 1),
             "Sharpness runs from 0, smooth, to 10, sharp.");
  }
}

}  // namespace

void checkCage(const Mesh& mesh, Scheme scheme, const Progress& progress) {
  checkPoints(mesh);
  checkFaces(mesh, scheme);
  const MeshTopology topology = meshTopology(mesh, progress);
  checkEdges(topology);
  checkFans(mesh, topology);
  checkTags(mesh, topology);
}

}  // namespace blossom::subdivision
