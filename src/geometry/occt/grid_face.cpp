#include "geometry/occt/grid_face.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/bspline/bspline.h"
#include "geometry/occt/occt.h"

namespace blossom {
namespace {

constexpr double same = 1e-6;  ///< of the rectangle's size
constexpr int probes = 8;      ///< intervals between the samples of a parameter curve

/// An edge in the parameters of its face.
struct Trace {
  TopoDS_Edge edge;
  double first = 0, last = 0;
  std::array<Vec2, probes + 1> places;
};

struct Rectangle2 {
  Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
  [[nodiscard]] Vec2 size() const { return high - low; }
};

std::optional<Trace> trace(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) return std::nullopt;
  if (!BRep_Tool::Degenerated(edge) && !(BRep_Tool::SameRange(edge) && BRep_Tool::SameParameter(edge))) return std::nullopt;
  Trace result{edge, 0, 0, {}};
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, result.first, result.last);
  if (curve.IsNull() || !(result.last > result.first)) return std::nullopt;
  for (int i = 0; i <= probes; ++i) {
    const gp_Pnt2d p = curve->Value(result.first + (result.last - result.first) * i / probes);
    result.places[static_cast<std::size_t>(i)] = {p.X(), p.Y()};
  }
  return result;
}

/// The edges of the only wire.
std::vector<Trace> traces(const TopoDS_Face& face) {
  TopExp_Explorer wires(face, TopAbs_WIRE);
  if (!wires.More()) return {};
  std::vector<Trace> result;
  for (TopExp_Explorer edges(wires.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
    const auto next = trace(TopoDS::Edge(edges.Current()), face);
    if (!next) return {};
    result.push_back(*next);
  }
  wires.Next();
  return wires.More() ? std::vector<Trace>() : result;
}

Handle(Geom_BSplineSurface) splineOf(const TopoDS_Face& face) {
  TopLoc_Location location;
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) surface = trimmed->BasisSurface();
  return Handle(Geom_BSplineSurface)::DownCast(surface);
}

/// The surface over the rectangle alone.
std::optional<Surface> cut(Handle(Geom_BSplineSurface) spline, const Rectangle2& r) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  spline->Bounds(u0, u1, v0, v1);
  const Vec2 slack = same * r.size();
  const bool whole = std::abs(r.low.x() - u0) <= slack.x() && std::abs(r.high.x() - u1) <= slack.x() &&
                     std::abs(r.low.y() - v0) <= slack.y() && std::abs(r.high.y() - v1) <= slack.y();
  if (!whole) {
    try {
      spline = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
      spline->Segment(r.low.x(), r.high.x(), r.low.y(), r.high.y());
    } catch (const Standard_Failure&) {
      return std::nullopt;  // reaches beyond the surface: the general mesher knows what to do
    }
  }
  Surface surface = fromOcct(spline);
  const auto [a, b] = surface.domainU();
  const auto [c, d] = surface.domainV();
  const Vec2 off = (Vec2(b - a, d - c) - r.size()).cwiseAbs();
  if (off.x() > slack.x() || off.y() > slack.y() || !(smallestWeight(surface) > 0)) return std::nullopt;
  return surface;
}

/// On which side the edge lies and how it runs there; nothing when it leaves the sides.
std::optional<std::pair<GridSide, SideEdge>> onSide(const Trace& trace, const Rectangle2& r, const Vec2& shift) {
  const Vec2 slack = same * r.size();
  const auto stays = [&](int axis, double value) {
    return std::all_of(trace.places.begin(), trace.places.end(),
                       [&](const Vec2& p) { return std::abs(p[axis] - value) <= slack[axis]; });
  };
  std::optional<GridSide> side;
  if (stays(1, r.low.y())) side = GridSide::V0;
  if (stays(1, r.high.y())) side = GridSide::V1;
  if (stays(0, r.low.x())) side = GridSide::U0;
  if (stays(0, r.high.x())) side = GridSide::U1;
  if (!side) return std::nullopt;
  const int axis = *side == GridSide::V0 || *side == GridSide::V1 ? 0 : 1;
  const double from = trace.places.front()[axis], to = trace.places.back()[axis];
  for (int i = 0; i <= probes; ++i)
    if (std::abs(trace.places[static_cast<std::size_t>(i)][axis] - (from + (to - from) * i / probes)) > slack[axis])
      return std::nullopt;
  if (!(std::abs(to - from) > 10 * slack[axis])) return std::nullopt;
  return std::pair(*side, SideEdge{trace.edge, trace.first, trace.last, from - shift[axis], to - shift[axis],
                                   BRep_Tool::Degenerated(trace.edge) == Standard_True});
}

/// Edge after edge from end to end? Rounding is taken out of their ends.
bool fills(std::vector<SideEdge>& edges, double low, double high) {
  const double slack = 2 * same * (high - low);
  std::sort(edges.begin(), edges.end(), [](const SideEdge& a, const SideEdge& b) { return a.low() < b.low(); });
  double at = low;
  for (SideEdge& edge : edges) {
    if (std::abs(edge.low() - at) > slack) return false;
    (edge.from < edge.to ? edge.from : edge.to) = at;
    at = edge.high();
  }
  if (edges.empty() || std::abs(at - high) > slack) return false;
  (edges.back().from < edges.back().to ? edges.back().to : edges.back().from) = high;
  return true;
}

}  // namespace

std::optional<GridFace> gridFace(const TopoDS_Face& given) {
  const TopoDS_Face face = TopoDS::Face(given.Oriented(TopAbs_FORWARD));
  const Handle(Geom_BSplineSurface) spline = splineOf(face);
  if (spline.IsNull()) return std::nullopt;
  const std::vector<Trace> edges = traces(face);
  Rectangle2 r;
  for (const Trace& edge : edges)
    for (const Vec2& p : edge.places) r.low = r.low.cwiseMin(p), r.high = r.high.cwiseMax(p);
  if (edges.empty() || !(r.size().minCoeff() > 0)) return std::nullopt;
  auto surface = cut(spline, r);
  if (!surface) return std::nullopt;
  GridFace result{given, std::move(*surface), Vec2::Zero(), {}};
  const auto [u0, u1] = result.surface.domainU();
  const auto [v0, v1] = result.surface.domainV();
  result.shift = r.low - Vec2(u0, v0);
  for (const Trace& edge : edges) {
    const auto found = onSide(edge, r, result.shift);
    if (!found) return std::nullopt;
    result.sides[static_cast<std::size_t>(found->first)].push_back(found->second);
  }
  if (std::any_of(result.sides.begin(), result.sides.end(), [](const auto& side) {
        return side.size() > 1 && std::any_of(side.begin(), side.end(), [](const auto& e) { return e.degenerated; });
      }))
    return std::nullopt;
  const auto filled = [&](GridSide side, double low, double high) {
    return fills(result.sides[static_cast<std::size_t>(side)], low, high);
  };
  if (!filled(GridSide::V0, u0, u1) || !filled(GridSide::V1, u0, u1) || !filled(GridSide::U0, v0, v1) ||
      !filled(GridSide::U1, v0, v1))
    return std::nullopt;
  return result;
}

}  // namespace blossom
