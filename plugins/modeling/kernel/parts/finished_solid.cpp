#include "kernel/parts/finished_solid.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

bool isValid(const TopoDS_Shape& shape) { return BRepCheck_Analyzer(shape).IsValid(); }

bool isClosed(const TopoDS_Shape& solid) {
  const auto shells = partsOf(solid, TopAbs_SHELL);
  for (const TopoDS_Shape& shell : shells)
    if (!BRep_Tool::IsClosed(shell)) return false;
  return !shells.empty();
}

/// Below this a solid is a sheet folded onto itself.
bool hasVolume(const TopoDS_Shape& solid) {
  const double size = sizeOf(solid);
  return std::abs(volumeOf(solid)) > 1e-12 * size * size * size;
}

/// Nothing when the solid is not good.
std::optional<TopoDS_Shape> outward(const TopoDS_Shape& given) {
  TopoDS_Solid solid = TopoDS::Solid(given);
  if (!isClosed(solid) || !hasVolume(solid)) return {};
  if (volumeOf(solid) < 0 && !BRepLib::OrientClosedSolid(solid)) return {};
  if (volumeOf(solid) < 0) solid.Reverse();
  if (!isValid(solid)) return {};
  return solid;
}

TopoDS_Shape mended(const TopoDS_Shape& shape) {
  ShapeFix_Shape fix(shape);
  fix.Perform();
  return fix.Shape();
}

/// Null when one of them cannot be made good.
TopoDS_Shape goodSolids(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> solids;
  for (const TopoDS_Shape& each : partsOf(shape, TopAbs_SOLID)) {
    const auto solid = outward(each);
    if (!solid) return {};
    solids.push_back(*solid);
  }
  return solids.empty() ? TopoDS_Shape() : compoundOf(solids);
}

}  // namespace

TopoDS_Shape finishedSolid(const TopoDS_Shape& shape, const Complaint& complaint) {
  TopoDS_Shape solids = goodSolids(shape);
  if (solids.IsNull() && !shape.IsNull()) solids = goodSolids(mended(shape));
  if (solids.IsNull()) throw Error(ErrorCode::Degenerate, complaint.message, complaint.hint);
  return solids;
}

bool isGoodSolid(const TopoDS_Shape& shape) { return !shape.IsNull() && !goodSolids(shape).IsNull(); }

TopoDS_Shape finishedSheet(const TopoDS_Shape& shape, const Complaint& complaint) {
  if (!shape.IsNull() && isValid(shape)) return shape;
  if (!shape.IsNull())
    if (TopoDS_Shape better = mended(shape); isValid(better)) return better;
  throw Error(ErrorCode::Degenerate, complaint.message, complaint.hint);
}

}  // namespace blossom::modeling
