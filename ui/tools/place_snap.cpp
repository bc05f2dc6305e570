#include "ui/tools/place_snap.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <QCoreApplication>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "geometry/planar/planar.h"
#include "ui/tools/view_props.h"

namespace blossom::ui {

namespace {

using Kind = SnapPlace::Kind;

/// Only here so that lupdate, too, sees the context of these texts.
struct SnapPlaceTexts {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::SnapPlace)
};

constexpr std::size_t maximumPlaces = 100000;

Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
Vec3 inSpace(const Vec2& p) { return {p.x(), p.y(), 0}; }

class Places {
 public:
  void add(const Brep& brep) {
    TopTools_IndexedMapOfShape vertices, edges;
    TopExp::MapShapes(brep.shape(), TopAbs_VERTEX, vertices);
    TopExp::MapShapes(brep.shape(), TopAbs_EDGE, edges);
    for (int k = 1; k <= vertices.Extent() && !full(); ++k)
      add(vec(BRep_Tool::Pnt(TopoDS::Vertex(vertices(k)))), Kind::Point);
    for (int k = 1; k <= edges.Extent() && !full(); ++k) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges(k));
      if (BRep_Tool::Degenerated(edge)) continue;
      try {
        addEdge(edge);
      } catch (const Standard_Failure&) {
        continue;  // an edge without a usable curve has its ends
      }
    }
  }
  void add(const std::vector<Path>& paths) {
    for (const Path& path : paths)
      for (const Segment& segment : path.segments) {
        if (full()) return;
        add(inSpace(startPoint(segment)), Kind::Point);
        add(inSpace(endPoint(segment)), Kind::Point);
        if (const auto* line = std::get_if<Line2>(&segment)) add(inSpace((line->from + line->to) / 2), Kind::Midpoint);
        if (const auto* arc = std::get_if<Arc2>(&segment)) add(inSpace(arc->center), Kind::Centre);
      }
  }
  void add(const std::vector<Vec3>& points) {
    for (const Vec3& p : points) {
      if (full()) return;
      add(p, Kind::Point);
    }
  }
  std::vector<SnapPlace> take() { return std::move(places_); }

 private:
  [[nodiscard]] bool full() const { return places_.size() >= maximumPlaces; }
  void add(const Vec3& at, Kind kind) { places_.push_back({at, kind}); }
  void addEdge(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    const bool round = curve.GetType() == GeomAbs_Circle || curve.GetType() == GeomAbs_Ellipse;
    if (curve.GetType() == GeomAbs_Circle) add(vec(curve.Circle().Location()), Kind::Centre);
    if (curve.GetType() == GeomAbs_Ellipse) add(vec(curve.Ellipse().Location()), Kind::Centre);
    if (round && curve.Value(first).Distance(curve.Value(last)) <= BRep_Tool::Tolerance(edge)) return;  // no middle
    double middle = (first + last) / 2;
    if (curve.GetType() != GeomAbs_Line && curve.GetType() != GeomAbs_Circle)
      middle = GCPnts_AbscissaPoint(curve, GCPnts_AbscissaPoint::Length(curve) / 2, first).Parameter();
    add(vec(curve.Value(middle)), Kind::Midpoint);
  }
  std::vector<SnapPlace> places_;
};

/// The place in reach that lies nearest to the ray; of several at one place the strongest, such as a corner on a centre.
std::optional<SnapPlace> nearest(const std::vector<SnapPlace>& places, const SnapAim& aim) {
  // A face that is seen at an angle comes nearer within the reach of the mouse.
  constexpr double slope = 4, same = 1e-3;
  const double deepest = aim.hit ? aim.hit->distance + slope * aim.reach : std::numeric_limits<double>::infinity();
  std::optional<SnapPlace> best;
  double closest = aim.reach;
  for (const SnapPlace& place : places) {
    const Vec3 from = place.at - aim.ray.origin;
    const double depth = from.dot(aim.ray.direction);
    const double distance = (from - depth * aim.ray.direction).norm();
    if (depth <= 0 || depth > deepest || distance > closest + same * aim.reach) continue;
    if (best && distance > closest - same * aim.reach && place.kind <= best->kind) continue;
    closest = std::min(closest, distance);
    best = place;
  }
  return best;
}

}  // namespace

std::vector<SnapPlace> snapPlaces(const Shape& shape) {
  Places places;
  if (const auto* brep = shape.get<Brep>()) places.add(*brep);
  if (const auto* region = shape.get<Region>()) places.add(region->loops);
  if (const auto* curves = shape.get<Curves>()) places.add(curves->paths);
  if (const auto* mesh = shape.get<Mesh>()) places.add(mesh->points);
  return places.take();
}

std::optional<SnapPlace> snappedPlace(const std::vector<SnapPlace>& places, const SnapAim& aim) {
  if (aim.reach > 0)
    if (auto found = nearest(places, aim)) return found;
  if (aim.hit) return SnapPlace{aim.hit->point, aim.hit->kind == SubShapeKind::Edge ? Kind::Edge : Kind::Face};
  const auto ground = inGround(aim.ray);
  if (!ground) return std::nullopt;
  if (aim.grid > 0) {
    const Vec2 crossing(std::round(ground->x() / aim.grid) * aim.grid, std::round(ground->y() / aim.grid) * aim.grid);
    if ((crossing - *ground).norm() <= aim.reach) return SnapPlace{inSpace(crossing), Kind::Grid};
  }
  return SnapPlace{inSpace(*ground), Kind::Ground};
}

QString snapPlaceName(SnapPlace::Kind kind) {
  switch (kind) {
    case Kind::Ground:
    case Kind::Face:
      return {};
    case Kind::Grid:
      return SnapPlaceTexts::tr("grid");
    case Kind::Edge:
      return SnapPlaceTexts::tr("on the edge");
    case Kind::Midpoint:
      return SnapPlaceTexts::tr("midpoint");
    case Kind::Centre:
      return SnapPlaceTexts::tr("centre");
    case Kind::Point:
      return SnapPlaceTexts::tr("point");
  }
  return {};
}

}  // namespace blossom::ui
