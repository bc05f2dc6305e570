#include "kernel/parts/sharp_edges.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <gp_Vec.hxx>
#include <optional>

#include "core/angle.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

/// Outward normal of a face at a point of one of its edges; nothing where it has none, as at the tip of a cone.
std::optional<gp_Dir> normalAt(const TopoDS_Edge& edge, const TopoDS_Face& face, double share) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return {};
  const gp_Pnt2d uv = curve->Value(first + share * (last - first));
  gp_Pnt point;
  gp_Vec du, dv;
  BRepAdaptor_Surface(face, Standard_False).D1(uv.X(), uv.Y(), point, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  if (normal.Magnitude() < 1e-12) return {};
  return gp_Dir(face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal);
}

bool meetsSmoothly(const TopoDS_Edge& edge, const TopoDS_Face& a, const TopoDS_Face& b) {
  constexpr double smooth = toRadians(0.5);
  for (const double share : {0.21, 0.5, 0.83}) {
    const auto one = normalAt(edge, a, share), other = normalAt(edge, b, share);
    if (one && other && one->Angle(*other) > smooth) return false;
  }
  return true;
}

}  // namespace

EdgeSorter::EdgeSorter(const TopoDS_Shape& shape) { TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_); }

EdgeSort EdgeSorter::sort(const TopoDS_Edge& edge) const {
  if (BRep_Tool::Degenerated(edge)) return EdgeSort::Seam;
  const int place = faces_.FindIndex(edge);
  if (place == 0) return EdgeSort::Free;
  const TopTools_ListOfShape& around = faces_(place);
  if (around.Extent() != 2) return EdgeSort::Free;
  if (around.First().IsSame(around.Last())) return EdgeSort::Seam;
  return meetsSmoothly(edge, TopoDS::Face(around.First()), TopoDS::Face(around.Last())) ? EdgeSort::Smooth : EdgeSort::Sharp;
}

std::vector<TopoDS_Edge> sharpEdges(const TopoDS_Shape& shape) {
  const EdgeSorter sorter(shape);
  std::vector<TopoDS_Edge> sharp;
  for (const TopoDS_Shape& each : subShapesOf(shape, TopAbs_EDGE))
    if (sorter.sort(TopoDS::Edge(each)) == EdgeSort::Sharp) sharp.push_back(TopoDS::Edge(each));
  return sharp;
}

}  // namespace blossom::modeling
