#pragma once
#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "geometry/occt/sub_shape.h"

namespace blossom::modeling {

/// Those that belong to no sub-shape of type `within`, such as wires that bound no face.
std::vector<TopoDS_Shape> looseParts(const TopoDS_Shape&, TopAbs_ShapeEnum type, TopAbs_ShapeEnum within);
/// Signed volume; negative when the faces look inward.
double volumeOf(const TopoDS_Shape&);
double areaOf(const TopoDS_Shape&);
/// Diagonal of the bounding box; 0 when the shape is empty.
double diagonalOf(const TopoDS_Shape&);

}  // namespace blossom::modeling
