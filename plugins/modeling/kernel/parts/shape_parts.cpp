#include "kernel/parts/shape_parts.h"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <cmath>

namespace blossom::modeling {

std::vector<TopoDS_Shape> looseParts(const TopoDS_Shape& shape, TopAbs_ShapeEnum type, TopAbs_ShapeEnum within) {
  std::vector<TopoDS_Shape> parts;
  if (shape.IsNull()) return parts;
  for (TopExp_Explorer each(shape, type, within); each.More(); each.Next()) parts.push_back(each.Current());
  return parts;
}

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

double diagonalOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  if (!shape.IsNull()) BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

}  // namespace blossom::modeling
