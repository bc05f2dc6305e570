#include "kernel/solid.h"

#include <fmt/format.h>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "core/place_text.h"
#include "geometry/bspline/bspline.h"
#include "geometry/crossing/self_crossing.h"
#include "geometry/crossing/sheet_mesh.h"
#include "geometry/occt/occt.h"
#include "kernel/end_caps.h"
#include "kernel/end_poles.h"
#include "kernel/sharp_end.h"

namespace blossom::sweep {

namespace {

constexpr double same = 1e-9;            // of the size
constexpr double sameFarAway = 1.5e-14;  // of the coordinates, which have no finer steps after the product is formed

/// How far apart points may lie that are the same one: the size is that of the surface, as poles of small weights lie
/// anywhere.
double nearOf(const Box3& box) {
  return std::max(same * box.diagonal().norm(), sameFarAway * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm());
}

/// Copies line `from` of poles to line `to` when they represent the same curve: the same points, weights in a fixed ratio.
/// @param step,lines stride inside a line and between positions, as indices into the pole array
bool mergeLines(Surface& surface, std::size_t from, std::size_t to, std::size_t step, std::size_t count, double near) {
  const double ratio = surface.poles[to][3] / surface.poles[from][3];
  for (std::size_t i = 0; i < count; ++i) {
    const Vec4 &a = surface.poles[from + i * step], &b = surface.poles[to + i * step];
    if ((euclidean(a) - euclidean(b)).norm() > nearAt(a, near) || std::abs(b[3] - ratio * a[3]) > same * std::abs(b[3]))
      return false;
  }
  // Quaternions of another length at one end leave their weights in a ratio: the curve is the same, and keeps its ratio.
  const double kept = std::abs(ratio - 1) > same ? ratio : 1.0;
  for (std::size_t i = 0; i < count; ++i) surface.poles[to + i * step] = kept * surface.poles[from + i * step];
  return true;
}

/// Makes an end that is a point within `near` exactly one; what is left of it would be an edge without a face beside it.
void gatherPoint(Surface& surface, bool atEnd, double near) {
  const std::vector<Vec4> poles = endPoles(surface, atEnd);
  const Vec3 middle = middleOf(poles);
  if (!isPoint(poles, middle, near)) return;
  for (std::size_t i = 0; i < surface.countU(); ++i) {
    Vec4& pole = surface.pole(i, atEnd ? surface.countV() - 1 : 0);
    pole.head<3>() = pole[3] * middle;
  }
}

/// How the sections at the start and at the end lie on each other.
struct EndsMeet {
  double turn = 0;  ///< where on the end section the start section begins, as a share of the way round: -1/2 to 1/2
  double gap = 0;   ///< the largest distance found, mm
};

/// Compares the section at the start with the one at the end, which may begin elsewhere along the same curve.
/// @returns nothing where a place of the first is off the other by more than 1e-4 of it
std::optional<EndsMeet> whereEndsMeet(const Surface& surface, const Progress& progress) {
  constexpr int coarse = 32, fine = 1024;
  constexpr double nearby = 1e-4;  // of the section
  const auto [first, last] = surface.domainV();
  const auto at = [&surface, u = surface.domainU()](int k, int of, double v) -> Vec3 {
    return euclidean(evaluate(surface, u.first + (u.second - u.first) * k / of, v));
  };
  std::vector<Vec3> end;
  Box3 box;
  for (int k = 0; k < fine; ++k) box.extend(end.emplace_back(at(k, fine, last)));
  const double near = nearby * box.diagonal().norm();
  EndsMeet meet;
  for (int k = 0; k < coarse; ++k) {
    progress.check();
    const Vec3 p = at(k, coarse, first);
    double least = std::numeric_limits<double>::infinity(), place = 0;
    for (int i = 0; i < fine; ++i) {
      const Vec3 &a = end[static_cast<std::size_t>(i)], along = end[static_cast<std::size_t>((i + 1) % fine)] - a;
      const double t = along.isZero(0) ? 0 : std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      if (const double distance = (p - a - t * along).norm(); distance < least) least = distance, place = i + t;
    }
    if (least > near) return std::nullopt;
    if (k == 0) meet.turn = place / fine - std::round(place / fine);
    meet.gap = std::max(meet.gap, least);
  }
  return meet;
}

/// Ends that are one and the same point need no walls, but the body would touch itself there.
void refusePinchedRing(const Surface& surface, double near) {
  const std::vector<Vec4> start = endPoles(surface, false), end = endPoles(surface, true);
  const Vec3 place = middleOf(start);
  if (!isPoint(start, place, near) || !isPoint(end, place, near)) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("Both ends of the sweep run into the point {}: the ring would be pinched there, and touch itself.",
                          placeText(place)),
              "Keep the section wider than a point and close the motion, move the ends apart, or leave out --solid.");
}

/// Two caps in one place would be a wall inside of the ring.
void refuseTurnedRing(const Surface& surface, const Progress& progress) {
  const std::optional<EndsMeet> meet = whereEndsMeet(surface, progress);
  if (!meet) return;
  constexpr double unturned = 1e-3;
  if (std::abs(meet->turn) < unturned)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The ends of the sweep lie on each other at {}, but for {:.2g} mm: two walls would stay inside "
                            "of the ring.",
                            placeText(euclidean(surface.pole(0, 0))), meet->gap),
                "Close the trajectory, move the ends apart, or leave out --solid.");
  throw Error(ErrorCode::InvalidInput,
              fmt::format("The ends of the sweep meet at {}, but turned by {:.3g} of the way round: a wall would stay "
                          "inside of the ring.",
                          placeText(euclidean(surface.pole(0, 0))), std::abs(meet->turn)),
              "Turn the motion back by as much on the way along v, or leave out --solid.");
}

/// Joins the faces to one closed shell. Planar caps share the edges of the side already; cones are joined by sewing.
TopoDS_Shell sew(const std::vector<TopoDS_Face>& faces, double size) {
  BRepBuilderAPI_Sewing sewing(std::max(1e-7, same * size));
  for (const TopoDS_Face& face : faces) sewing.Add(face);
  sewing.Perform();
  const TopoDS_Shape sewed = sewing.SewedShape();
  if (!sewed.IsNull() && sewed.ShapeType() == TopAbs_SHELL) return TopoDS::Shell(sewed);
  TopoDS_Shell shell;
  BRep_Builder builder;
  builder.MakeShell(shell);
  if (!sewed.IsNull())
    for (TopExp_Explorer explorer(sewed, TopAbs_FACE); explorer.More(); explorer.Next())
      builder.Add(shell, explorer.Current());
  return shell;
}

TopoDS_Solid outwardSolid(const TopoDS_Shell& shell) {
  BRepBuilderAPI_MakeSolid maker(shell);
  if (!maker.IsDone())
    throw Error(ErrorCode::Degenerate, "The faces of the sweep do not enclose a body.",
                "Look at the surface without --solid: it may cross itself or fold over at an end.");
  TopoDS_Solid solid = maker.Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

/// OCCT takes parameters within 1e-9 for the same: a short domain is moved to 0 and lengthened. Points stay what they are,
/// but for the rounding of knots where the domain held 0 inside.
void lengthenIfShort(std::vector<double>& knots) {
  constexpr double shortest = 1e-4;
  const double first = knots.front(), length = knots.back() - first;
  if (!(length < shortest)) return;
  const double factor = std::ldexp(1.0, -std::ilogb(length));
  for (double& knot : knots) knot = (knot - first) * factor;
}

/// Where coordinates leave too few digits to the shape, whatever goes wrong is their doing.
void refuseFarAway(const Box3& box) {
  constexpr double digits = 3e-5;
  const double size = box.diagonal().norm();
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (size >= digits * reach) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("The sweep lies too far from the origin for a solid of its size: {:.3g} mm away, {:.3g} mm large.",
                          reach, size),
              "Move it nearer to the origin.");
}

/// OCCT's tolerances are lengths: beside coordinates this large, the rounding of its own arithmetic exceeds them.
void refuseTooLarge(double size) {
  constexpr double largest = 1e8;
  if (size <= largest) return;
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("The sweep is too large for a solid: {:.3g} mm across. Beyond about {:.3g} mm, rounding exceeds the "
                  "tolerance within which faces are joined.",
                  size, largest),
      "Scale the motion down, or leave out --solid.");
}

[[noreturn]] void refuseSharpEnds() {
  throw Error(ErrorCode::Degenerate, "The sweep ends in a straight edge, along which its side could not be closed.",
              "Keep the section there a little wider, scale it down to a point, or leave out --solid.");
}

/// The side, in parts where an end is an edge: the two that meet along it then share it as faces do.
std::vector<SidePart> sidesOf(const Surface& surface, bool sewn, double near) {
  std::vector<double> cuts;
  for (const bool atEnd : {false, true})
    if (sewn && isSharpEnd(surface, atEnd, near))
      for (const double u : cutsOfSharpEnd(surface, atEnd)) cuts.push_back(u);
  std::sort(cuts.begin(), cuts.end());
  std::vector<SidePart> sides;
  if (cuts.empty()) return {{surface, toFace(surface)}};
  for (Surface& part : cutAlongV(surface, cuts)) {
    const TopoDS_Face face = toFace(part);
    sides.push_back({std::move(part), face});
  }
  return sides;
}

SolidResult build(Surface surface, SharpEnds sharp, const Progress& progress) {
  lengthenIfShort(surface.knotsU);
  lengthenIfShort(surface.knotsV);
  const Box3 box = sampledBox(surface, progress);
  const double size = box.diagonal().norm(), near = nearOf(box);
  const std::size_t nu = surface.countU(), nv = surface.countV();
  if (!mergeLines(surface, 0, (nu - 1) * nv, 1, nv, near))
    throw Error(ErrorCode::InvalidInput, "This motion is not closed in u, so the surface encloses no body.",
                "Leave out --solid, or close the orientation with \"closed_u\".");
  refusePinchedRing(surface, near);
  const bool ring = mergeLines(surface, 0, nv - 1, nv, nu, near);
  if (!ring)
    for (const bool atEnd : {false, true}) gatherPoint(surface, atEnd, near);
  SolidResult result;
  const std::vector<SidePart> sides = sidesOf(surface, !ring && sharp == SharpEnds::Sewn, near);
  std::vector<TopoDS_Face> faces;
  faces.reserve(sides.size());
  for (const SidePart& side : sides) faces.push_back(side.face);
  if (!ring) {
    refuseTurnedRing(surface, progress);
    const Cap start = makeCap(surface, sides, false, sharp, near, size, progress),
              end = makeCap(surface, sides, true, sharp, near, size, progress);
    result.start = start.kind, result.end = end.kind;
    for (const Cap& cap : {start, end}) faces.insert(faces.end(), cap.faces.begin(), cap.faces.end());
  }
  progress.check();
  const TopoDS_Shell shell = sew(faces, size);
  result.solid = outwardSolid(shell);
  progress.check();
  // Its sign alone matters: inside out means that the orientation could not be settled.
  GProp_GProps properties;
  BRepGProp::VolumeProperties(result.solid, properties);
  if (!BRep_Tool::IsClosed(shell) || !BRepCheck_Analyzer(result.solid).IsValid() || !(properties.Mass() > 0)) {
    refuseFarAway(box);
    refuseTooLarge(size);
    if (result.start == EndCap::Edge || result.end == EndCap::Edge) refuseSharpEnds();
    throw Error(ErrorCode::Degenerate, "The swept surface and its caps do not make a valid solid.",
                "Look at the surface without --solid: it may cross itself or fold over at an end.");
  }
  if (const auto place = selfCrossing(result.solid, progress))
    throw crossingAt(
        *place, size, ".",
        ring ? "Make the sections smaller where the motion bends or turns, or leave out --solid: the surface alone may "
               "cross itself."
             : "Make the sections smaller where the motion bends or turns, and keep the faces that close its ends clear of "
               "the rest; or leave out --solid: the surface alone may cross itself.");
  return result;
}

bool hasSharpEnd(const Surface& surface, const Progress& progress) {
  const double near = nearOf(sampledBox(surface, progress));
  return isSharpEnd(surface, false, near) || isSharpEnd(surface, true, near);
}

/// A flat side that comes together in one end of the edge, or a very thin body, may not be sewn along it.
SolidResult builtAnyhow(const Surface& surface, const Progress& progress) {
  try {
    return build(surface, SharpEnds::Sewn, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Degenerate || !hasSharpEnd(surface, progress)) throw;
    try {
      return build(surface, SharpEnds::Capped, progress);
    } catch (const Error& other) {
      if (other.code() == ErrorCode::Cancelled) throw;
    }
    throw;
  }
}

}  // namespace

SolidResult makeSolid(const Surface& surface, const Progress& progress) {
  try {
    return builtAnyhow(surface, progress);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The solid could not be built: ") + failure.GetMessageString() + ".");
  }
}

}  // namespace blossom::sweep
