#include "kernel/solid.h"

#include <fmt/format.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
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
#include <gp_Pln.hxx>

#include <Eigen/Eigenvalues>
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
#include "kernel/end_outline.h"

namespace blossom::sweep {

namespace {

constexpr double same = 1e-9;            // of the size
constexpr double sameFarAway = 1.5e-14;  // of the coordinates, which have no finer steps after the product is formed

Vec3 euclidean(const Vec4& pole) { return pole.head<3>() / pole[3]; }

/// How far apart points may lie that are the same one: the size is that of the surface, as poles of small weights lie
/// anywhere.
double nearOf(const Box3& box) {
  return std::max(same * box.diagonal().norm(), sameFarAway * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm());
}

/// The same beside a pole, which may lie far beyond the surface and has no finer steps there.
double nearAt(const Vec4& pole, double near) { return std::max(near, sameFarAway * euclidean(pole).norm()); }

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

/// The row of poles at an end in v.
std::vector<Vec4> endPoles(const Surface& surface, bool atEnd) {
  std::vector<Vec4> poles;
  for (std::size_t i = 0; i < surface.countU(); ++i) poles.push_back(surface.pole(i, atEnd ? surface.countV() - 1 : 0));
  return poles;
}

Vec3 centre(const std::vector<Vec4>& poles) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i + 1 < poles.size(); ++i) sum += euclidean(poles[i]);
  return sum / static_cast<double>(poles.size() - 1);
}

bool isPoint(const std::vector<Vec4>& poles, const Vec3& middle, double near) {
  return std::all_of(poles.begin(), poles.end(),
                     [&](const Vec4& pole) { return (euclidean(pole) - middle).norm() <= near; });
}

/// Makes an end that is a point within `near` exactly one; what is left of it would be an edge without a face beside it.
void gatherPoint(Surface& surface, bool atEnd, double near) {
  const std::vector<Vec4> poles = endPoles(surface, atEnd);
  const Vec3 middle = centre(poles);
  if (!isPoint(poles, middle, near)) return;
  for (std::size_t i = 0; i < surface.countU(); ++i) {
    Vec4& pole = surface.pole(i, atEnd ? surface.countV() - 1 : 0);
    pole.head<3>() = pole[3] * middle;
  }
}

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

/// The boundary edge of the side face that runs along an end.
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
Surface cone(const Surface& surface, const std::vector<Vec4>& poles, const Vec3& apex) {
  Surface result{surface.degreeU, 1, surface.knotsU, {0, 0, 1, 1}, {}};
  for (const Vec4& pole : poles) {
    result.poles.push_back(pole);
    result.poles.emplace_back(pole[3] * apex.x(), pole[3] * apex.y(), pole[3] * apex.z(), pole[3]);
  }
  return result;
}

struct Cap {
  EndCap kind = EndCap::None;
  TopoDS_Face face;
};

/// @param why follows the place: "."
Error crossingAt(const Vec3& at, double size, const std::string& why, const char* remedy) {
  return Error(ErrorCode::Degenerate, fmt::format("The swept solid crosses itself near {}{}", placeText(at, size, 4), why),
               remedy);
}

/// @param near points of the ends closer to each other than this are one  @param size of the surface
Cap makeCap(const Surface& surface, const TopoDS_Face& side, bool atEnd, double near, double size,
            const Progress& progress) {
  const std::vector<Vec4> poles = endPoles(surface, atEnd);
  const Vec3 origin = centre(poles);
  if (isPoint(poles, origin, near)) return {EndCap::Point, {}};
  const auto [first, last] = surface.domainV();
  if (const auto normal = planeNormal(poles, origin, std::max(near, 1e-9))) {
    // OCCT neither refuses such an outline nor ends when it is to triangulate one that is run through twice.
    if (const auto crossing = outlineCrossing(surface, atEnd, *normal, progress))
      throw crossingAt(
          *crossing, size,
          fmt::format(": its section at the {}, v = {:.4g}, does.", atEnd ? "end" : "start", atEnd ? last : first),
          "Even out the scaling and rotation along u there, or leave out --solid: the surface alone may cross "
          "itself.");
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(endEdge(side, atEnd ? last : first, 1e-9 * (last - first))).Wire();
    BRepBuilderAPI_MakeFace maker(gp_Pln(toPoint(origin), gp_Dir(normal->x(), normal->y(), normal->z())), wire,
                                  Standard_True);
    if (!maker.IsDone())
      throw Error(ErrorCode::Degenerate, "An end of the sweep could not be closed by a plane.",
                  "Look at the surface without --solid: its end may cross itself.");
    return {EndCap::Planar, maker.Face()};
  }
  return {EndCap::Cone, toFace(cone(surface, poles, origin))};
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

SolidResult build(Surface surface, const Progress& progress) {
  lengthenIfShort(surface.knotsU);
  lengthenIfShort(surface.knotsV);
  const Box3 box = sampledBox(surface, progress);
  const double size = box.diagonal().norm(), near = nearOf(box);
  const std::size_t nu = surface.countU(), nv = surface.countV();
  if (!mergeLines(surface, 0, (nu - 1) * nv, 1, nv, near))
    throw Error(ErrorCode::InvalidInput, "This motion is not closed in u, so the surface encloses no body.",
                "Leave out --solid, or close the orientation with \"closed_u\".");
  const bool ring = mergeLines(surface, 0, nv - 1, nv, nu, near);
  if (!ring)
    for (const bool atEnd : {false, true}) gatherPoint(surface, atEnd, near);
  SolidResult result;
  std::vector<TopoDS_Face> faces{toFace(surface)};
  if (!ring) {
    refuseTurnedRing(surface, progress);
    const Cap start = makeCap(surface, faces[0], false, near, size, progress),
              end = makeCap(surface, faces[0], true, near, size, progress);
    result.start = start.kind, result.end = end.kind;
    for (const Cap& cap : {start, end})
      if (!cap.face.IsNull()) faces.push_back(cap.face);
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

}  // namespace

SolidResult makeSolid(const Surface& surface, const Progress& progress) {
  try {
    return build(surface, progress);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The solid could not be built: ") + failure.GetMessageString() + ".");
  }
}

}  // namespace blossom::sweep
