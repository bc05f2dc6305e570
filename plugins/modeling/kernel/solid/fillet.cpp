#include "kernel/solid/fillet.h"

#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include "core/error.h"

namespace blossom::modeling {

namespace {

TopoDS_Shape rounded(const TopoDS_Shape& shape, const std::vector<TopoDS_Edge>& edges, double radius) {
  BRepFilletAPI_MakeFillet maker(shape);
  for (const TopoDS_Edge& edge : edges)
    if (maker.Contour(edge) == 0) maker.Add(radius, edge);  // an edge may be in the smooth run of an earlier one
  maker.Build();
  return maker.IsDone() ? maker.Shape() : TopoDS_Shape();
}

TopoDS_Shape cutOff(const TopoDS_Shape& shape, const std::vector<TopoDS_Edge>& edges, double distance, double ratio) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  BRepFilletAPI_MakeChamfer maker(shape);
  for (const TopoDS_Edge& edge : edges) {
    if (maker.Contour(edge) != 0) continue;
    maker.Add(distance, distance * ratio, edge, TopoDS::Face(faces.FindFromKey(edge).First()));
  }
  maker.Build();
  return maker.IsDone() ? maker.Shape() : TopoDS_Shape();
}

}  // namespace

FilletResult fillet(const TopoDS_Shape& shape, const FilletOptions& o, const Progress& progress) {
  return blend(shape, o.edges, o.radius, {"rounded", "radius"}, rounded, progress);
}

ChamferResult chamfer(const TopoDS_Shape& shape, const ChamferOptions& o, const Progress& progress) {
  if (o.second < 0)
    throw Error(ErrorCode::InvalidParameter, "The second distance is below 0.", "Use 0 for equal distances.");
  const double ratio = o.second > 0 && o.distance > 0 ? o.second / o.distance : 1;
  const auto attempt = [ratio](const TopoDS_Shape& s, const std::vector<TopoDS_Edge>& edges, double distance) {
    return cutOff(s, edges, distance, ratio);
  };
  return blend(shape, o.edges, o.distance, {"chamfered", "distance"}, attempt, progress);
}

}  // namespace blossom::modeling
