#include "part_input.h"

#include <fmt/format.h>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp_Face.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>

#include "core/error.h"
#include "geometry/occt/occt.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/planar/planar.h"
#include "kernel/medial/boundary.h"

namespace blossom::pocket {

namespace {

constexpr double flatWithin = 1e-5;  // mm

/// The plane of a flat face with its normal out of the solid.
gp_Ax3 frameOf(const TopoDS_Face& face, const std::string& name) {
  const GeomLib_IsPlanarSurface flat(BRep_Tool::Surface(face), flatWithin);
  if (!flat.IsPlanar())
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is not flat.", name), "Choose a flat face of the part.");
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  const BRepGProp_Face surface(face);
  surface.Bounds(u0, u1, v0, v1);
  gp_Pnt at;
  gp_Vec normal;
  surface.Normal((u0 + u1) / 2, (v0 + v1) / 2, at, normal);
  if (!(normal.Magnitude() > 0))
    throw Error(ErrorCode::InvalidInput, fmt::format("{} has no normal.", name), "Choose another face.");
  const gp_Dir up(normal);
  const gp_Pnt origin = flat.Plan().Location();
  // A face that looks straight up keeps its x and y; others begin at the world's origin seen from outside.
  if (up.IsEqual(gp::DZ(), 1e-9)) return {gp_Pnt(0, 0, origin.Z()), gp::DZ(), gp::DX()};
  const double ahead = gp_Vec(gp::Origin(), origin).Dot(gp_Vec(up));
  const gp_Pnt foot = gp::Origin().Translated(ahead * gp_Vec(up));
  const gp_Dir side = up.IsParallel(gp::DZ(), 1e-9) ? gp::DX() : gp::DZ().Crossed(up);
  return {foot, up, side};
}

Part fromFace(const TopoDS_Face& face, const std::string& name) {
  const gp_Ax3 frame = frameOf(face, name);
  gp_Trsf down;
  down.SetTransformation(frame);
  const TopoDS_Shape flat = BRepBuilderAPI_Transform(face, down, true).Shape();
  Part part;
  part.region = toRegion({planarCurves(flat).paths, FillRule::EvenOdd});
  part.placing = down.Inverted();
  part.fromFace = true;
  part.looksUp = frame.Direction().IsEqual(gp::DZ(), 1e-9) && frame.XDirection().IsEqual(gp::DX(), 1e-9);
  part.height = part.looksUp ? frame.Location().Z() : 0;
  return part;
}

bool hasSolid(const TopoDS_Shape& shape) { return TopExp_Explorer(shape, TopAbs_SOLID).More(); }

std::string endsOf(const Path& path) {
  return fmt::format("from {} to {}", placeText(startPoint(path)), placeText(endPoint(path)));
}

/// The region in a drawing, whose open lines are refused with their place or left out.
Part fromCurves(const Curves& drawn, OpenLines openLines) {
  Curves curves = joined(drawn);
  std::vector<Path> open;
  for (const Path& path : curves.paths)
    if (!path.closed && !path.segments.empty()) open.push_back(path);
  Part part;
  if (!open.empty()) {
    if (open.size() == curves.paths.size())
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("The drawing has no closed outline; {} {}.",
                              open.size() == 1 ? "its only line runs" : "the first of its open lines runs", endsOf(open[0])),
                  "Close an outline in the drawing.");
    if (openLines != OpenLines::LeaveOut)
      throw Error(ErrorCode::InvalidInput, fmt::format("A line is open: it runs {}.", endsOf(open[0])),
                  openLines == OpenLines::RefuseForNow ? "Close the gap in the drawing, or skip open lines (--skip-open)."
                                                       : "Close the gap in the drawing, or delete the line.");
    std::erase_if(curves.paths, [](const Path& path) { return !path.closed; });
    part.warnings.push_back(fmt::format(
        "{} left out; {} runs {}.", open.size() == 1 ? "One open line was" : fmt::format("{} open lines were", open.size()),
        open.size() == 1 ? "it" : "the first", endsOf(open[0])));
  }
  part.region = toRegion(curves);
  return part;
}

int faceCount(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) ++count;
  return count;
}

Part fromBrep(const Brep& brep, int index, OpenLines openLines) {
  if (index >= 0) return fromFace(faceOf(brep, index), fmt::format("Face {}", index));
  if (hasSolid(brep.shape()))
    throw Error(ErrorCode::InvalidInput, "The input is a solid; which of its faces is meant?",
                "Choose one of its flat faces: --face 0, or pick it in the view.");
  if (faceCount(brep.shape()) == 1)
    return fromFace(TopoDS::Face(TopExp_Explorer(brep.shape(), TopAbs_FACE).Current()), "The face");
  return fromCurves(planarCurves(brep.shape()), openLines);
}

}  // namespace

InputSpec partInput(std::string asks) {
  return {.name = "part",
          .help = "A region, closed curves, or a solid of which a flat face is chosen.",
          .kinds = {ShapeKind::Region, ShapeKind::Curves, ShapeKind::Brep},
          .asks = std::move(asks)};
}

ParameterSpec partFace() { return optional(subShape("face")); }

Part partOf(const Shape& shape, const SubShapeValue& face, OpenLines openLines) {
  if (const Brep* brep = shape.get<Brep>()) return fromBrep(*brep, face.index, openLines);
  if (face.index > 0)
    throw Error(ErrorCode::NotFound, fmt::format("The outline has one face; face {} is not among them.", face.index),
                "Leave the face out.");
  if (const Curves* curves = shape.get<Curves>()) return fromCurves(*curves, openLines);
  const Region* region = shape.get<Region>();
  if (!region) throwWrongKind(shape);
  Part part;
  part.region = *region;
  return part;
}

}  // namespace blossom::pocket
