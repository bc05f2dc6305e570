#include "geometry/occt/sub_shape.h"

#include <fmt/format.h>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "core/error.h"

namespace blossom {

namespace {

TopoDS_Shape partOf(const Brep& brep, TopAbs_ShapeEnum type, int index, const char* one, const char* many) {
  TopTools_IndexedMapOfShape parts;
  if (!brep.shape().IsNull()) TopExp::MapShapes(brep.shape(), type, parts);
  if (index < 0 || index >= parts.Extent())
    throw Error(ErrorCode::NotFound,
                fmt::format("The shape has {} {}; {} {} is not among them.", parts.Extent(), many, one, index),
                fmt::format("Pick the {} again: the shape may have changed. They are counted from 0.", one));
  return parts(index + 1);
}

}  // namespace

std::vector<TopoDS_Shape> subShapesOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape map;
  if (!shape.IsNull()) TopExp::MapShapes(shape, type, map);
  return {map.cbegin(), map.cend()};
}

TopAbs_ShapeEnum shapeTypeOf(SubShapeKind kind) {
  return kind == SubShapeKind::Face ? TopAbs_FACE : kind == SubShapeKind::Edge ? TopAbs_EDGE : TopAbs_VERTEX;
}

std::string subShapeKindName(SubShapeKind kind) {
  switch (kind) {
    case SubShapeKind::Face:
      return "face";
    case SubShapeKind::Edge:
      return "edge";
    case SubShapeKind::Vertex:
      return "vertex";
    case SubShapeKind::Whole:
      break;
  }
  return "part";
}

SubShapeKind subShapeKindOf(const std::string& name) {
  if (name == "face") return SubShapeKind::Face;
  if (name == "edge") return SubShapeKind::Edge;
  return name == "vertex" ? SubShapeKind::Vertex : SubShapeKind::Whole;
}

TopoDS_Face faceOf(const Brep& brep, int index) { return TopoDS::Face(partOf(brep, TopAbs_FACE, index, "face", "faces")); }
TopoDS_Edge edgeOf(const Brep& brep, int index) { return TopoDS::Edge(partOf(brep, TopAbs_EDGE, index, "edge", "edges")); }
TopoDS_Vertex vertexOf(const Brep& brep, int index) {
  return TopoDS::Vertex(partOf(brep, TopAbs_VERTEX, index, "vertex", "vertices"));
}

}  // namespace blossom
