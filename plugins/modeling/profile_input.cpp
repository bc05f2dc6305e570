#include "profile_input.h"

#include <fmt/format.h>

#include <TopLoc_Location.hxx>
#include <algorithm>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include "core/error.h"
#include "core/place_text.h"
#include "core/units.h"
#include "geometry/occt/occt.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/planar/outline_crossing.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/solid/arrange.h"
#include "wire_outlines.h"

namespace blossom::modeling {

namespace {

std::string place(const Vec2& p) {
  const auto rounded = [](double v) { return formatNumber(std::round(v * 1000) / 1000 + 0.0); };
  return fmt::format("({}, {})", rounded(p.x()), rounded(p.y()));
}

/// Where a place of a drawing lies in space; of one in z = 0, the two coordinates it was drawn with.
std::string place(const Vec2& p, const gp_Trsf& drawing) {
  const gp_Pnt at = gp_Pnt(p.x(), p.y(), 0).Transformed(drawing);
  return drawing.Form() == gp_Identity ? place(p) : placeText({at.X(), at.Y(), at.Z()});
}

void checkCrossings(const Region& region, const gp_Trsf& drawing) {
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    if (const auto at = selfCrossing(region.loops[i]))
      throw Error(ErrorCode::InvalidInput, fmt::format("The outline crosses itself near {}.", place(*at, drawing)),
                  "Redraw it there, or trim what crosses.");
    for (std::size_t k = 0; k < i; ++k)
      if (const auto at = crossing(region.loops[i], region.loops[k]))
        throw Error(ErrorCode::InvalidInput, fmt::format("Two outlines cross or touch near {}.", place(*at, drawing)),
                    "Move them apart, or unite them first.");
  }
}

TopoDS_Shape filled(const Region& region, const gp_Trsf& drawing = {}) {
  if (region.loops.empty())
    throw Error(ErrorCode::InvalidInput, "The region is empty.", "Give a region with at least one outline.");
  checkCrossings(region, drawing);
  return toFaces(region).Moved(TopLoc_Location(drawing));
}

TopoDS_Shape ofCurves(const Curves& given, bool fill) {
  const Curves curves = joined(given);
  if (curves.paths.empty())
    throw Error(ErrorCode::InvalidInput, "There are no curves in the input.", "Give a drawing that holds some.");
  const auto isOpen = [](const Path& path) { return !path.closed; };
  const auto open = std::find_if(curves.paths.begin(), curves.paths.end(), isOpen);
  if (open == curves.paths.end() && fill) return filled(toRegion(curves));
  if (open != curves.paths.end() && fill && !std::all_of(curves.paths.begin(), curves.paths.end(), isOpen))
    throw Error(ErrorCode::InvalidInput,
                fmt::format("One of the outlines is open: it begins at {} and ends at {}.", place(startPoint(*open)),
                            place(endPoint(*open))),
                "Close it or delete it; or turn \"solid\" off to get sheets.");
  return toWires(curves);
}

constexpr double chordDistance = 0.005;

bool hasSplines(const Region& region) {
  const auto isSpline = [](const Segment& segment) { return std::holds_alternative<Spline2>(segment); };
  return std::any_of(region.loops.begin(), region.loops.end(),
                     [&](const Path& loop) { return std::any_of(loop.segments.begin(), loop.segments.end(), isSpline); });
}

std::vector<Segment> chordsFor(const std::vector<Segment>& segments) {
  std::vector<Segment> chords;
  for (const Segment& segment : segments) {
    if (!std::holds_alternative<Spline2>(segment)) {
      chords.push_back(segment);
      continue;
    }
    const std::vector<Vec2> points = flatten(segment, chordDistance);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) chords.emplace_back(Line2{points[i], points[i + 1]});
  }
  return chords;
}

/// Wires and edges that close in a plane as faces, as closed paths of a drawing are; the rest as it is.
TopoDS_Shape withFilledWires(const TopoDS_Shape& shape) {
  const WireOutlines wires = wireOutlines(shape);
  if (wires.outlines.empty()) return shape;
  std::vector<TopoDS_Shape> parts;
  if (!wires.others.IsNull()) parts.push_back(wires.others);
  for (const FlatOutlines& each : wires.outlines) parts.push_back(filled(toRegion(each.drawing), each.place));
  return compoundOf(parts);
}

TopoDS_Shape wiresOf(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> parts = subShapesOf(shape, TopAbs_WIRE);
  for (const TopoDS_Shape& edge : looseParts(shape, TopAbs_EDGE, TopAbs_WIRE)) parts.push_back(edge);
  return compoundOf(parts);
}

TopoDS_Shape ofBrep(const Brep& brep, const SubShapeValue& face, bool fill) {
  if (face.index < 0 && !subShapesOf(brep.shape(), TopAbs_SOLID).empty())
    throw Error(ErrorCode::InvalidInput, "The input is a solid; which of its faces is meant?",
                "Choose one of its flat faces.");
  const TopoDS_Shape shape = face.index < 0 ? brep.shape() : faceOf(brep, face.index);
  return fill ? withFilledWires(shape) : wiresOf(shape);
}

}  // namespace

TopoDS_Shape profileShape(const Shape& shape, const SubShapeValue& face, bool fill) {
  if (const auto* brep = shape.get<Brep>()) return ofBrep(*brep, face, fill);
  if (face.index > 0)
    throw Error(ErrorCode::NotFound, fmt::format("The outline has one face; face {} is not among them.", face.index),
                "Leave the face out.");
  if (const auto* region = shape.get<Region>()) return fill ? filled(*region) : toWires(toCurves(*region));
  if (const auto* curves = shape.get<Curves>()) return ofCurves(*curves, fill);
  const TopoDS_Shape edges = asBrep(shape).shape();
  return fill ? withFilledWires(edges) : edges;
}

Shape withoutSplines(const Shape& shape, std::vector<std::string>& warnings) {
  if (const auto* curves = shape.get<Curves>()) {
    const Curves whole = joined(*curves);
    const bool closed = std::all_of(whole.paths.begin(), whole.paths.end(), [](const Path& path) { return path.closed; });
    return closed && !whole.paths.empty() ? withoutSplines(toRegion(whole), warnings) : shape;
  }
  const auto* region = shape.get<Region>();
  if (!region || !hasSplines(*region)) return shape;
  Region chords = *region;
  for (Path& loop : chords.loops) loop.segments = chordsFor(loop.segments);
  warnings.push_back(
      fmt::format("The free-form curves of the outline were made into straight pieces, at most {} mm away from them.",
                  formatNumber(chordDistance)));
  return chords;
}

}  // namespace blossom::modeling
