#pragma once
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace blossom::modeling {

/// Continuity of the faces at an edge.
enum class EdgeSort {
  Sharp,
  Smooth,  ///< normals within half a degree
  Seam,    ///< the same face on both sides, or no length
  Free     ///< not exactly two faces
};

/// Classifies the edges of a shape by their faces.
class EdgeSorter {
 public:
  explicit EdgeSorter(const TopoDS_Shape&);
  [[nodiscard]] EdgeSort sort(const TopoDS_Edge&) const;

 private:
  TopTools_IndexedDataMapOfShapeListOfShape faces_;
};

/// All sharp edges, in the order of their numbers.
std::vector<TopoDS_Edge> sharpEdges(const TopoDS_Shape&);

}  // namespace blossom::modeling
