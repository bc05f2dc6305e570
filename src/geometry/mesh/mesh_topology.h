#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom {

/// The faces at one edge of a mesh.
struct MeshEdge {
  int low = 0, high = 0;               ///< vertex indices, low < high
  int forward = 0, backward = 0;       ///< faces that run from low to high, and back
  std::array<int, 2> faces{-1, -1};    ///< the first two of them
  std::array<int, 2> corners{-1, -1};  ///< index in faceVertices where the edge starts in each of these faces
  [[nodiscard]] bool manifold() const { return forward == 1 && backward == 1; }
  [[nodiscard]] bool balanced() const { return forward == backward; }
};

/// A part of a mesh connected through edges with exactly two faces.
struct MeshComponent {
  std::size_t faces = 0;
  std::size_t fans = 0;  ///< vertices, those where only corners touch counted once for each side
  std::size_t halfEdges = 0;
  bool closed = true;  ///< every edge is run through as often forwards as backwards
  /// (2 - Euler characteristic) / 2; of closed components only.
  [[nodiscard]] int genus() const;
};

struct MeshTopology {
  std::vector<MeshEdge> edges;
  std::vector<int> componentOfFace;
  std::vector<MeshComponent> components;
  [[nodiscard]] bool closed() const;  ///< and not empty
};

/// Hand-written because CGAL's Surface_mesh holds no edge of three faces: what is wrong with a mesh is to be told.
/// O(n log n). @throws Error InvalidInput when a face names a vertex that does not exist, Cancelled.
MeshTopology meshTopology(const Mesh&, const Progress& = Progress::none());

/// Triangles (indices into the polygon) of a simple polygon, convex or not, planar or nearly; always size - 2 of them for 3
/// and more points. Quads take the better diagonal, larger polygons are clipped ear by ear in their best plane. O(n^2).
/// Hand-written because CGAL's constrained triangulations put new points where the sides of a polygon cross.
std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon);

/// Half the sum of the cross products (Newell): the normal of a planar polygon with its area as length.
Vec3 vectorArea(std::span<const Vec3> polygon);

/// The points of face f.
std::vector<Vec3> facePoints(const Mesh&, std::size_t f);

/// Same shape with triangles only; the faces stay in order. The second result is the face each triangle came from.
std::pair<Mesh, std::vector<int>> triangulated(const Mesh&, const Progress& = Progress::none());

/// Volume by the divergence theorem over the triangles; meaningful for closed meshes.
double signedVolume(const Mesh& triangles);
double area(const Mesh& triangles);

}  // namespace blossom
