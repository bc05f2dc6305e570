#pragma once
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace blossom::modeling {

/// How the faces beside an edge meet.
enum class EdgeSort {
  Sharp,
  Smooth,  ///< within half a degree
  Seam,    ///< one face on both sides, or no length
  Free     ///< not exactly two faces
};

/// Sorts the edges of a shape by the faces beside them.
class EdgeSorter {
 public:
  explicit EdgeSorter(const TopoDS_Shape&);
  [[nodiscard]] EdgeSort sort(const TopoDS_Edge&) const;

 private:
  TopTools_IndexedDataMapOfShapeListOfShape faces_;
};

/// Every sharp edge, in the order of their numbers.
std::vector<TopoDS_Edge> sharpEdges(const TopoDS_Shape&);

}  // namespace blossom::modeling
