#pragma once
#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace blossom::modeling {

/// The parts of one type, each once, in the order of their numbers (geometry/occt/sub_shape.h).
std::vector<TopoDS_Shape> partsOf(const TopoDS_Shape&, TopAbs_ShapeEnum type);
/// Those parts that do not belong to a part of type `within`: wires that bound no face.
std::vector<TopoDS_Shape> looseParts(const TopoDS_Shape&, TopAbs_ShapeEnum type, TopAbs_ShapeEnum within);
/// Signed volume; negative when the faces look inward.
double volumeOf(const TopoDS_Shape&);
double areaOf(const TopoDS_Shape&);
/// Diagonal of the box around the shape; 0 when it is empty.
double sizeOf(const TopoDS_Shape&);

}  // namespace blossom::modeling
