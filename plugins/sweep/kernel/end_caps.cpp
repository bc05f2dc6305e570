#include "kernel/end_caps.h"

#include <fmt/format.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/place_text.h"
#include "geometry/occt/occt.h"
#include "kernel/end_outline.h"
#include "kernel/end_poles.h"
#include "kernel/sharp_end.h"

namespace blossom::sweep {

namespace {

/// Normal of the plane through all poles within `tolerance`.
std::optional<Vec3> planeNormal(const std::vector<Vec4>& poles, const Vec3& origin, double tolerance) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vec4& pole : poles) scatter += (euclidean(pole) - origin) * (euclidean(pole) - origin).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Vec3 normal = solver.eigenvectors().col(0);
  for (const Vec4& pole : poles)
    if (std::abs(normal.dot(euclidean(pole) - origin)) > nearAt(pole, tolerance)) return {};
  return normal;
}

gp_Pnt toPoint(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// The boundary edge of a face of the side that runs along an end.
/// @param near in the parameter
TopoDS_Edge endEdge(const TopoDS_Face& side, double v, double near) {
  for (TopExp_Explorer explorer(side, TopAbs_EDGE); explorer.More(); explorer.Next()) {
    TopoDS_Edge edge = TopoDS::Edge(explorer.Current());
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, side, first, last);
    if (curve.IsNull() || BRep_Tool::Degenerated(edge)) continue;
    const gp_Pnt2d a = curve->Value(first), b = curve->Value(last);
    if (std::abs(a.Y() - v) < near && std::abs(b.Y() - v) < near) return edge;
  }
  throw Error(ErrorCode::Degenerate, "An end of the sweep has no boundary to close.",
              "Sections below 1e-7 mm are points to a solid: make the motion larger, or leave out --solid.");
}

/// Straight lines from the end curve to its centre, over the same knots and weights: the boundary is shared homogeneously.
Surface cone(const Surface& surface, bool atEnd, const Vec3& apex) {
  Surface result{surface.degreeU, 1, surface.knotsU, {0, 0, 1, 1}, {}};
  for (const Vec4& pole : endPoles(surface, atEnd)) {
    result.poles.push_back(pole);
    result.poles.emplace_back(pole[3] * apex.x(), pole[3] * apex.y(), pole[3] * apex.z(), pole[3]);
  }
  return result;
}

/// A planar face within the end edges of all parts, which it shares.
TopoDS_Face planarCap(const std::vector<SidePart>& sides, double v, double near, const gp_Pln& plane) {
  BRepBuilderAPI_MakeWire wire;
  for (const SidePart& side : sides) wire.Add(endEdge(side.face, v, near));
  if (wire.IsDone()) {
    BRepBuilderAPI_MakeFace maker(plane, wire.Wire(), Standard_True);
    if (maker.IsDone()) return maker.Face();
  }
  throw Error(ErrorCode::Degenerate, "An end of the sweep could not be closed by a plane.",
              "Look at the surface without --solid: its end may cross itself.");
}

}  // namespace

Error crossingAt(const Vec3& at, double size, const std::string& why, const char* remedy) {
  return Error(ErrorCode::Degenerate, fmt::format("The swept solid crosses itself near {}{}", placeText(at, size, 4), why),
               remedy);
}

Cap makeCap(const Surface& surface, const std::vector<SidePart>& sides, bool atEnd, SharpEnds sharp, double near,
            double size, const Progress& progress) {
  const std::vector<Vec4> poles = endPoles(surface, atEnd);
  const Vec3 origin = middleOf(poles);
  if (isPoint(poles, origin, near)) return {EndCap::Point, {}};
  if (sharp == SharpEnds::Sewn && isSharpEnd(surface, atEnd, near)) return {EndCap::Edge, {}};
  const auto [first, last] = surface.domainV();
  const double v = atEnd ? last : first;
  if (const auto normal = planeNormal(poles, origin, std::max(near, 1e-9))) {
    // OCCT neither refuses such an outline nor ends when it is to triangulate one that is run through twice.
    if (const auto crossing = outlineCrossing(surface, atEnd, *normal, progress))
      throw crossingAt(*crossing, size,
                       fmt::format(": its section at the {}, v = {:.4g}, does.", atEnd ? "end" : "start", v),
                       "Even out the scaling and rotation along u there, or leave out --solid: the surface alone may cross "
                       "itself.");
    const gp_Pln plane(toPoint(origin), gp_Dir(normal->x(), normal->y(), normal->z()));
    return {EndCap::Planar, {planarCap(sides, v, 1e-9 * (last - first), plane)}};
  }
  Cap cap{EndCap::Cone, {}};
  for (const SidePart& side : sides) cap.faces.push_back(toFace(cone(side.surface, atEnd, origin)));
  return cap;
}

}  // namespace blossom::sweep
