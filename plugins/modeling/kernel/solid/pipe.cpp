#include "kernel/solid/pipe.h"

#include <fmt/format.h>

#include <BRepAdaptor_CompCurve.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <gp_Ax3.hxx>
#include <limits>
#include <string>
#include <vector>

#include "core/angle.h"
#include "core/error.h"
#include "core/place_text.h"
#include "core/units.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/crossing_warning.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/guarded.h"
#include "kernel/parts/placement.h"
#include "kernel/parts/profile.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/parts/sound_bodies.h"
#include "kernel/solid/path_turns.h"

namespace blossom::modeling {

namespace {

TopoDS_Wire onePath(const TopoDS_Shape& shape) {
  if (!subShapesOf(shape, TopAbs_FACE).empty())
    throw Error(ErrorCode::InvalidInput, "The path is an area, not a curve.", "Give a curve as the second input.");
  const Profile profile = profileOf(shape);
  if (profile.wires.size() != 1)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The path must be one curve without gaps; it has {} parts.", profile.wires.size()),
                "Join its parts end to end.");
  return profile.wires.front();
}

/// The frame at the start of a path: z along it.
gp_Ax3 startOf(const TopoDS_Wire& path) {
  const BRepAdaptor_CompCurve curve(path);
  gp_Pnt point;
  gp_Vec tangent;
  curve.D1(curve.FirstParameter(), point, tangent);
  if (tangent.Magnitude() < 1e-9)
    throw Error(ErrorCode::InvalidInput, "The path has no direction at its start.", "Let it begin in another point.");
  const gp_Dir along(tangent);
  // What was up in the profile stays up where it can.
  const gp_Dir up = along.IsParallel(gp::DZ(), 1e-6) ? gp::DY() : gp::DZ();
  return {point, along, up.Crossed(along)};
}

TopoDS_Shape placed(const TopoDS_Shape& profile, const TopoDS_Wire& path) {
  gp_Trsf toStart;
  toStart.SetTransformation(startOf(path), gp_Ax3(gp::XOY()));
  return profile.Moved(TopLoc_Location(toStart));
}

std::string written(const gp_Pnt& p) { return placeText(toVec(p.XYZ())); }

/// Where to look when no pipe comes of a path: at its corner, unless it bends more tightly than the outline reaches.
std::string placeToLookAt(const PathTurns& turns, double reach) {
  constexpr double smooth = 1e-3;
  if (turns.corner > smooth && turns.radius > reach)
    return fmt::format(" Its sharpest corner, of {:.3g} degrees, is in {}.", toDegrees(turns.corner),
                       written(turns.cornerAt));
  if (std::isfinite(turns.radius))
    return fmt::format(" Its tightest bend, with a radius of {:.4g} mm, is near {}.", turns.radius, written(turns.bend));
  return {};
}

/// Farthest the outline reaches from the path.
double reachOf(const TopoDS_Shape& profile, const TopoDS_Wire& path) {
  gp_Trsf flat;
  flat.SetTransformation(startOf(path));
  Bnd_Box box;
  BRepBndLib::AddOptimal(profile.Moved(TopLoc_Location(flat)), box, Standard_False, Standard_False);
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  box.Get(x0, y0, z0, x1, y1, z1);
  return std::max({std::abs(x0), std::abs(x1), std::abs(y0), std::abs(y1)});
}

Complaint tooTight() {
  return {"The outline cannot be moved along this path.",
          "The path may bend more tightly than the outline is wide: use a smaller outline or a wider bend."};
}

/// How far the outline reaches in every direction around the path; 0 where the path is not inside it.
double reachAllAround(const TopoDS_Shape& profile, const TopoDS_Wire& path) {
  const TopoDS_Vertex center = BRepBuilderAPI_MakeVertex(startOf(path).Location());
  const auto distanceTo = [&](const TopoDS_Shape& shape) {
    const BRepExtrema_DistShapeShape distance(center, shape);
    return distance.IsDone() ? distance.Value() : std::numeric_limits<double>::infinity();
  };
  double reach = 0;
  for (const TopoDS_Shape& face : subShapesOf(profile, TopAbs_FACE)) {
    if (distanceTo(face) > Precision::Confusion()) continue;
    double here = std::numeric_limits<double>::infinity();
    for (const TopoDS_Shape& wire : subShapesOf(face, TopAbs_WIRE)) here = std::min(here, distanceTo(wire));
    reach = std::max(reach, std::isfinite(here) ? here : 0);
  }
  return reach;
}

/// Where the outline reaches the centre of a bend in every direction, it passes through itself on the other side.
void refuseFold(const PathTurns& turns, double reach) {
  constexpr double rounding = 1e-9;
  if (reach < turns.radius * (1 - rounding)) return;
  throw Error(ErrorCode::Degenerate,
              fmt::format("{} It would cut through itself near {}, where the path bends with a radius of {:.6g} mm and the "
                          "outline reaches {:.6g} mm all around it.",
                          tooTight().message, written(turns.bend), turns.radius, reach),
              tooTight().hint);
}

class Piper {
 public:
  /// `place` says where the path is most likely at fault.
  Piper(TopoDS_Wire path, PipeCorners corners, const std::string& place)
      : path_(std::move(path)), corners_(corners), located_(tooTight()) {
    located_.message += place;
  }

  [[nodiscard]] TopoDS_Shape along(const TopoDS_Wire& outline, bool solid) const {
    BRepOffsetAPI_MakePipeShell maker(path_);
    maker.SetMode(Standard_False);
    maker.SetTransitionMode(corners_ == PipeCorners::Mitred ? BRepBuilderAPI_RightCorner : BRepBuilderAPI_RoundCorner);
    maker.Add(outline);
    if (!maker.IsReady()) fail();
    maker.Build();
    if (!maker.IsDone() || (solid && !maker.MakeSolid())) fail();
    return solid ? finishedSolid(maker.Shape(), located_) : finishedSheet(maker.Shape(), located_);
  }

  [[nodiscard]] TopoDS_Shape along(const TopoDS_Face& face, const Progress& progress) const {
    if (!BRep_Tool::IsClosed(BRepTools::OuterWire(face))) fail();
    const TopoDS_Wire outer = BRepTools::OuterWire(face);
    TopoDS_Shape body = along(outer, true);
    bool cut = false;
    for (const TopoDS_Shape& hole : subShapesOf(face, TopAbs_WIRE)) {
      progress.check();
      if (hole.IsSame(outer)) continue;
      body = BRepAlgoAPI_Cut(body, along(TopoDS::Wire(hole), true)).Shape();
      cut = true;
    }
    return cut ? finishedSolid(body, located_) : body;
  }

 private:
  [[noreturn]] void fail() const { throw Error(ErrorCode::Degenerate, located_.message, located_.hint); }

  TopoDS_Wire path_;
  PipeCorners corners_;
  Complaint located_;
};

}  // namespace

PipeResult pipe(const TopoDS_Shape& profileShape, const TopoDS_Shape& pathShape, const PipeOptions& o,
                const Progress& progress) {
  const TopoDS_Wire path = onePath(pathShape);
  const Complaint complaint{tooTight().message, "Simplify the path or make the outline smaller."};
  const PathTurns turns = guarded(complaint.message, complaint.hint, [&] { return turnsOf(path); });
  const double reach =
      guarded(complaint.message, complaint.hint, [&] { return o.place ? reachOf(placed(profileShape, path), path) : 0; });
  const std::string place = placeToLookAt(turns, reach);
  return guarded(complaint.message + place, complaint.hint, [&] {
    const TopoDS_Shape there = o.place ? placed(profileShape, path) : profileShape;
    if (o.place) refuseFold(turns, reachAllAround(there, path));
    const Profile profile = profileOf(there);
    PipeResult result;
    result.solid = !profile.faces.empty();
    const Piper piper(path, o.corners, place);
    progress.report(0.1, "Moving the outline along the path");
    std::vector<TopoDS_Shape> solids, made;
    for (const TopoDS_Face& face : profile.faces) solids.push_back(piper.along(face, progress));
    if (!solids.empty()) made.push_back(soundBodies(solids, tooTight(), progress));
    std::vector<TopoDS_Shape> sheets;
    for (const TopoDS_Wire& wire : profile.wires) sheets.push_back(piper.along(wire, false));
    warnOfCrossing(sheets, tooTight().hint, result.warnings, progress);
    made.insert(made.end(), sheets.begin(), sheets.end());
    result.shape = compoundOf(made);
    if (o.place && reach > turns.radius && result.warnings.empty())
      result.warnings.push_back(
          fmt::format("The path bends with a radius of {} mm near {}, less than the outline reaches from it: the pipe may "
                      "cut through itself there.",
                      formatNumber(std::round(turns.radius * 1000) / 1000), written(turns.bend)));
    return result;
  });
}

}  // namespace blossom::modeling
