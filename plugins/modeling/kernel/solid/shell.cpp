#include "kernel/solid/shell.h"

#include <fmt/format.h>

#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>

#include "core/error.h"
#include "core/place_text.h"
#include "core/units.h"
#include "geometry/occt/sub_shape.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/largest_size.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/solid/wall_check.h"

namespace blossom::modeling {

namespace {

constexpr double tolerance = 1e-4;

TopoDS_Shape opened(const TopoDS_Shape& solid, const TopTools_ListOfShape& open, double offset, GeomAbs_JoinType join) {
  BRepOffsetAPI_MakeThickSolid maker;
  maker.MakeThickSolidByJoin(solid, open, offset, tolerance, BRepOffset_Skin, Standard_False, Standard_False, join);
  return maker.IsDone() ? maker.Shape() : TopoDS_Shape();
}

TopoDS_Shape onlyShell(const TopoDS_Shape& shape) {
  const auto shells = subShapesOf(shape, TopAbs_SHELL);
  return shells.size() == 1 ? shells.front() : TopoDS_Shape();
}

/// The solid between the given faces and their offset, which nothing opens.
TopoDS_Shape hollow(const TopoDS_Shape& solid, double offset, GeomAbs_JoinType join) {
  BRepOffsetAPI_MakeOffsetShape maker;
  maker.PerformByJoin(solid, offset, tolerance, BRepOffset_Skin, Standard_False, Standard_False, join);
  if (!maker.IsDone()) return {};
  const TopoDS_Shape own = onlyShell(solid), other = onlyShell(maker.Shape());
  if (own.IsNull() || other.IsNull()) return {};
  BRep_Builder builder;
  TopoDS_Solid made;
  builder.MakeSolid(made);
  builder.Add(made, offset < 0 ? own : other);
  builder.Add(made, (offset < 0 ? other : own).Reversed());
  return made;
}

/// Walls inside hold less than the solid; an offset that turned inside out holds more. Where the walls meet, OpenCASCADE 7.8
/// returns the solid itself.
bool isPlausible(const TopoDS_Shape& made, const TopoDS_Shape& solid, double offset) {
  if (!isGoodSolid(made)) return false;
  const double volume = volumeOf(made);
  return offset > 0 ? volume > 0 : volume > 0 && volume < volumeOf(solid) * (1 - 1e-9);
}

/// Sharp corners if they can be had, else rounded ones. Null when neither works.
TopoDS_Shape tried(const TopoDS_Shape& solid, const TopTools_ListOfShape& open, double offset) {
  for (const GeomAbs_JoinType join : {GeomAbs_Intersection, GeomAbs_Arc}) {
    try {
      TopoDS_Shape made = open.IsEmpty() ? hollow(solid, offset, join) : opened(solid, open, offset, join);
      if (isPlausible(made, solid, offset)) return made;
    } catch (const Standard_Failure&) {
      continue;  // the other join may work
    }
  }
  return {};
}

TopTools_ListOfShape facesToOpen(const TopoDS_Shape& shape, const std::vector<int>& indices) {
  TopTools_ListOfShape open;
  const Brep brep(shape);
  for (const int index : indices)
    if (const TopoDS_Face face = faceOf(brep, index); !open.Contains(face)) open.Append(face);
  if (open.Extent() == static_cast<int>(subShapesOf(shape, TopAbs_FACE).size()))
    throw Error(ErrorCode::InvalidInput, "All faces are to be opened, so no wall is left.", "Leave some faces closed.");
  return open;
}

[[noreturn]] void refuseThin(double thickness, const ThinWall& thin) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("Walls of {} mm do not fit this shape: near {} they would pass through each other.",
                          formatNumber(thickness), placeText(thin.place)),
              "Use a smaller thickness, or make the shape thicker there.");
}

}  // namespace

ShellResult shell(const TopoDS_Shape& shape, const ShellOptions& o, const Progress& progress) {
  const auto solids = subShapesOf(shape, TopAbs_SOLID);
  if (solids.size() != 1)
    throw Error(ErrorCode::InvalidInput,
                solids.empty() ? "Only a solid can be hollowed; the input is none."
                               : fmt::format("One solid can be hollowed at a time; the input has {}.", solids.size()),
                "Give one closed solid.");
  if (!(o.thickness > 1e-6))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The thickness must be above 0; it is {} mm.", formatNumber(o.thickness)));
  const TopTools_ListOfShape open = facesToOpen(shape, o.openFaces);
  const auto walls = [&](double thickness) {
    return tried(solids.front(), open, o.side == ShellSide::Inside ? -thickness : thickness);
  };
  progress.report(0.1, "Hollowing");
  const TopoDS_Shape made = walls(o.thickness);
  if (!made.IsNull()) {
    progress.report(0.4, "Measuring walls");
    if (const auto thin = thinWall(solids.front(), o.openFaces, made, o.thickness, progress)) refuseThin(o.thickness, *thin);
    return {finishedSolid(made, {"The solid cannot be hollowed.", ""})};
  }
  progress.report(0.5, "Looking for the thickest wall");
  const auto largest = largestSize(
      o.thickness, [&](double size) { return !walls(size).IsNull(); }, progress);
  if (largest)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("Walls of {} mm do not fit this shape: the thickest possible are about {} mm.",
                            formatNumber(o.thickness), roundedDown(*largest)),
                "Use a smaller thickness, or open other faces.");
  throw Error(ErrorCode::InvalidInput, "This shape cannot be hollowed: its faces cannot be moved parallel to themselves.",
              "Open other faces, or hollow the shape before it gets its small roundings.");
}

}  // namespace blossom::modeling
