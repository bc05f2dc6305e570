#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/measure/measure_parts.h"
#include "geometry/numeric/gauss_rectangle.h"
#include "geometry/occt/occt_vector.h"

namespace blossom {
namespace {

/// Ends of the intervals on which a curve or a surface is smooth to any order, inside (low, high), with both ends.
std::vector<double> smoothBreaks(const TColStd_Array1OfReal& knots, double low, double high) {
  std::vector<double> result{low};
  for (const double knot : knots)
    if (knot > result.back() && knot < high) result.push_back(knot);
  result.push_back(high);
  return result;
}

template <class CurveAdaptor>
std::vector<double> smoothBreaks(const CurveAdaptor& curve) {
  TColStd_Array1OfReal knots(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(knots, GeomAbs_CN);
  return smoothBreaks(knots, curve.FirstParameter(), curve.LastParameter());
}

std::vector<TopoDS_Edge> boundary(const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer explorer(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); explorer.More(); explorer.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
    if (edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED) edges.push_back(edge);
  }
  return edges;
}

double direction(const TopoDS_Shape& shape) { return shape.Orientation() == TopAbs_REVERSED ? -1 : 1; }

// --- Planar faces
// -----------------------------------------------------------------------------------------------------------

/// Attainable accuracy of an integral over edges of this extent: coordinates far from the origin have larger rounding
/// errors.
double absoluteFor(const std::vector<TopoDS_Edge>& edges, const Vec3& reference) {
  double extent = 0;
  for (const TopoDS_Edge& edge : edges) {
    const BRepAdaptor_Curve curve(edge);
    for (const double t : {curve.FirstParameter(), (curve.FirstParameter() + curve.LastParameter()) / 2})
      extent = std::max(extent, (toVec(curve.Value(t).XYZ()) - reference).norm());
  }
  return (1e-12 * extent + 1e-14 * reference.norm()) * extent + 1e-300;
}

/// Half the sum of the integrals of (x - reference) x dx along the edges.
Vec3 areaInside(const std::vector<TopoDS_Edge>& edges, const Vec3& reference) {
  const double absolute = absoluteFor(edges, reference);
  Vec3 sum = Vec3::Zero();
  for (const TopoDS_Edge& edge : edges) {
    const BRepAdaptor_Curve curve(edge);
    const std::vector<double> breaks = smoothBreaks(curve);
    for (int axis = 0; axis < 3; ++axis) {
      const auto component = [&](double t) {
        gp_Pnt p;
        gp_Vec d;
        curve.D1(t, p, d);
        return (toVec(p.XYZ()) - reference).cross(toVec(d.XYZ()))[axis];
      };
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        sum[axis] += direction(edge) / 2 * integrate(component, breaks[i], breaks[i + 1], absolute);
    }
  }
  return sum;
}

FaceIntegral integratePlanar(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const Vec3& reference) {
  gp_Pnt origin;
  gp_Vec du, dv;
  surface.D1(0, 0, origin, du, dv);
  const Vec3 normal = toVec(du.Crossed(dv).XYZ()).normalized();
  std::vector<TopoDS_Edge> edges = boundary(face);
  std::erase_if(edges, [](const TopoDS_Edge& edge) { return BRep_Tool::Degenerated(edge); });
  if (edges.empty()) return {};
  const Vec3 start = toVec(BRepAdaptor_Curve(edges.front()).Value(BRepAdaptor_Curve(edges.front()).FirstParameter()).XYZ());
  const double area = areaInside(edges, start).dot(normal);
  return {std::abs(area), area * (toVec(origin.XYZ()) - reference).dot(normal) / 3 * direction(face)};
}

// --- Faces on curved surfaces
// ---------------------------------------------------------------------------------------------------

struct BoundaryCurve {
  Geom2dAdaptor_Curve curve;
  double direction;
};

std::vector<BoundaryCurve> parameterCurves(const TopoDS_Face& face) {
  std::vector<BoundaryCurve> result;
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  for (const TopoDS_Edge& edge : boundary(face)) {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, forward, first, last);
    if (!curve.IsNull() && first < last) result.push_back({Geom2dAdaptor_Curve(curve, first, last), direction(edge)});
  }
  return result;
}

constexpr int samplesPerEdge = 5;

gp_Pnt2d sample(const BoundaryCurve& boundaryCurve, int i) {
  const Geom2dAdaptor_Curve& curve = boundaryCurve.curve;
  return curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / (samplesPerEdge - 1));
}

Rectangle box(const std::vector<BoundaryCurve>& curves) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Rectangle result{infinite, -infinite, infinite, -infinite};
  for (const BoundaryCurve& curve : curves) {
    for (int i = 0; i < samplesPerEdge; ++i) {
      const gp_Pnt2d p = sample(curve, i);
      result = {std::min(result.u0, p.X()), std::max(result.u1, p.X()), std::min(result.v0, p.Y()),
                std::max(result.v1, p.Y())};
    }
  }
  return result;
}

/// All boundary curves run along the sides of the box, and there is only one loop of them.
bool fillsBox(const TopoDS_Face& face, const std::vector<BoundaryCurve>& curves, const Rectangle& r) {
  int wires = 0;
  for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) ++wires;
  if (wires != 1) return false;
  const double nearU = 1e-7 * (r.u1 - r.u0);
  const double nearV = 1e-7 * (r.v1 - r.v0);
  const auto along = [&](const BoundaryCurve& curve, const auto& onSide) {
    for (int i = 0; i < samplesPerEdge; ++i)
      if (!onSide(sample(curve, i))) return false;
    return true;
  };
  return std::all_of(curves.begin(), curves.end(), [&](const BoundaryCurve& c) {
    return along(c, [&](const gp_Pnt2d& p) { return std::abs(p.X() - r.u0) <= nearU; }) ||
           along(c, [&](const gp_Pnt2d& p) { return std::abs(p.X() - r.u1) <= nearU; }) ||
           along(c, [&](const gp_Pnt2d& p) { return std::abs(p.Y() - r.v0) <= nearV; }) ||
           along(c, [&](const gp_Pnt2d& p) { return std::abs(p.Y() - r.v1) <= nearV; });
  });
}

/// Area element and volume of the cone over it, per du dv.
class Element {
 public:
  Element(const BRepAdaptor_Surface& surface, const Vec3& reference, const Progress& progress)
      : surface_(surface), reference_(reference), progress_(progress) {}

  TwoIntegrals operator()(double u, double v) const {
    gp_Pnt p;
    gp_Vec du, dv;
    progress_.check();
    surface_.D1(u, v, p, du, dv);
    const Vec3 normal = toVec(du.XYZ()).cross(toVec(dv.XYZ()));
    return {normal.norm(), (toVec(p.XYZ()) - reference_).dot(normal) / 3};
  }

  [[nodiscard]] double distance(const Rectangle& r) const {
    double farthest = 0;
    for (const double u : {r.u0, r.u1})
      for (const double v : {r.v0, r.v1})
        farthest = std::max(farthest, (toVec(surface_.Value(u, v).XYZ()) - reference_).norm());
    return farthest;
  }

 private:
  const BRepAdaptor_Surface& surface_;
  Vec3 reference_;
  const Progress& progress_;
};

struct Breaks {
  std::vector<double> u, v;
};

Breaks surfaceBreaks(const BRepAdaptor_Surface& surface, const Rectangle& r) {
  TColStd_Array1OfReal u(1, surface.NbUIntervals(GeomAbs_CN) + 1);
  TColStd_Array1OfReal v(1, surface.NbVIntervals(GeomAbs_CN) + 1);
  surface.UIntervals(u, GeomAbs_CN);
  surface.VIntervals(v, GeomAbs_CN);
  return {smoothBreaks(u, r.u0, r.u1), smoothBreaks(v, r.v0, r.v1)};
}

template <class F>
TwoIntegrals sumOverSpans(const Breaks& breaks, const F& integral) {
  TwoIntegrals sum(0, 0);
  for (std::size_t i = 0; i + 1 < breaks.u.size(); ++i)
    for (std::size_t j = 0; j + 1 < breaks.v.size(); ++j)
      sum += integral(Rectangle{breaks.u[i], breaks.u[i + 1], breaks.v[j], breaks.v[j + 1]});
  return sum;
}

TwoIntegrals absoluteFor(const Element& element, const Breaks& breaks, const Rectangle& r) {
  const double estimate = sumOverSpans(breaks, [&](const Rectangle& span) { return gaussSum(element, span, 4, 4); })(0);
  return {1e-11 * estimate + 1e-300, 1e-11 * estimate * element.distance(r) + 1e-300};
}

TwoIntegrals overBox(const Element& element, const Breaks& breaks, const TwoIntegrals& absolute) {
  return sumOverSpans(breaks, [&](const Rectangle& span) { return integrate(element, span, absolute); });
}

/// Green's formula in the parameter plane: the integral over the face is that of F dv along its boundary, where F(u, v) is
/// the integral of the element from the left side of the box to u.
TwoIntegrals alongBoundary(const Element& element, const Breaks& breaks, const std::vector<BoundaryCurve>& curves,
                           const TwoIntegrals& absolute) {
  const GaussRule rule = gaussRule(16);
  const auto antiderivative = [&](double u, double v) {
    TwoIntegrals sum(0, 0);
    for (std::size_t k = 0; k + 1 < breaks.u.size(); ++k) {
      const double from = breaks.u[k];
      const bool last = k + 2 == breaks.u.size();
      if (k > 0 && u <= from) break;
      const double to = last ? u : std::min(u, breaks.u[k + 1]);
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        sum += rule.weights[i] * (to - from) * element(from + (to - from) * rule.nodes[i], v);
    }
    return sum;
  };
  // Parameter curves in files are only good to 1e-7 and wiggle on that scale: going on halving would chase their noise.
  constexpr Adaptivity adaptivity{.nodes = 8, .maximumDepth = 8};
  TwoIntegrals sum(0, 0);
  for (const BoundaryCurve& boundaryCurve : curves) {
    const std::vector<double> pieces = smoothBreaks(boundaryCurve.curve);
    for (int which = 0; which < 2; ++which) {
      const auto integrand = [&](double t) {
        gp_Pnt2d p;
        gp_Vec2d d;
        boundaryCurve.curve.D1(t, p, d);
        return d.Y() == 0 ? 0 : antiderivative(p.X(), p.Y())(which) * d.Y();
      };
      for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        sum(which) +=
            boundaryCurve.direction * integrate(integrand, pieces[i], pieces[i + 1], 100 * absolute(which), adaptivity);
    }
  }
  return sum;
}

}  // namespace

FaceIntegral integrateFace(const TopoDS_Face& face, const Vec3& reference, const Progress& progress) {
  const BRepAdaptor_Surface surface(face, Standard_False);
  if (surface.GetType() == GeomAbs_Plane) return integratePlanar(face, surface, reference);
  const std::vector<BoundaryCurve> curves = parameterCurves(face);
  Rectangle r = box(curves);
  const bool whole = curves.empty();
  if (whole) r = {surface.FirstUParameter(), surface.LastUParameter(), surface.FirstVParameter(), surface.LastVParameter()};
  const Element element(surface, reference, progress);
  const Breaks breaks = surfaceBreaks(surface, r);
  const TwoIntegrals absolute = absoluteFor(element, breaks, r);
  const TwoIntegrals result = whole || fillsBox(face, curves, r) ? overBox(element, breaks, absolute)
                                                                 : alongBoundary(element, breaks, curves, absolute);
  const double sign = result(0) < 0 ? -1 : 1;  // some files wind their parameter loops the other way round
  return {std::abs(result(0)), sign * direction(face) * result(1)};
}

}  // namespace blossom
