#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/mesh/mesh.h"
#include "geometry/shape/shape.h"
#include "geometry/values/surface_curvature.h"

namespace blossom {

struct TessellationOptions {
  /// mm, largest distance between the shape and its polygons; 0: 1/1000 of the shape's diagonal, 1/8000 for planar
  /// drawings, curves and toolpaths.
  double chord = 0.05;
  /// radians, maximum angle between normals of neighbouring vertices; features far smaller than the chord may exceed it
  double angle = 0.3;
  bool curvature = false;  ///< of every point, too
};

/// Triangles, lines and points that represent a shape on the screen or in a mesh file. `points` and `normals` have equal
/// length; `normals` is empty for planar drawings.
struct Tessellation {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  ///< unit length, outward for solids
  /// For each point with respect to its normal; empty unless they were asked for. Of faces and patches from the second
  /// derivatives of their surfaces, of meshes from their triangles (mesh/discrete_curvature.h).
  std::vector<SurfaceCurvature> curvatures;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> faceOfTriangle;       ///< number of the face (see geometry/occt/sub_shape.h), for picking
  std::vector<Color> faceColors;         ///< per face; empty when the shape has no colours of its own
  std::vector<std::vector<Vec3>> edges;  ///< edges of a B-rep or curves of a drawing, as polylines
  std::vector<int> edgeIndices;          ///< number of the edge for each of `edges`; -1: none
  std::vector<Color> edgeColors;         ///< per polyline of `edges`; empty when they have no colours of their own
  bool colorsTellKinds = false;          ///< what an edge is: they stay, whatever is selected
  std::vector<Vec3> vertices;            ///< by number; for picking, not drawn
  std::vector<Vec3> markers;             ///< free points
  std::vector<Color> markerColors;       ///< of each; empty when they have no colours of their own
};

/// Tessellates any shape within `options.chord`. @throws Error Cancelled, Degenerate.
Tessellation tessellate(const Shape&, const TessellationOptions& = {}, const Progress& = Progress::none());

/// The triangles as one mesh with shared vertices. Points closer than 1e-7 mm are merged, so that the mesh of a closed solid
/// is closed.
Mesh toMesh(const Tessellation&);

/// The mesh of a shape, as OBJ, OFF, PLY and 3MF store it; a mesh itself is returned as it is.
/// @throws Error InvalidInput when the shape has no faces.
Mesh meshOf(const Shape&, const TessellationOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom
