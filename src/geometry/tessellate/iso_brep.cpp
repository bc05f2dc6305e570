// Curves of constant parameter on faces, cut off at their edges.
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "geometry/numeric/boxes.h"
#include "geometry/occt/occt_vector.h"
#include "geometry/tessellate/iso_curve_parts.h"

namespace blossom {
namespace {

/// An edge in the parameter plane of its face: the curve, and places on it close enough to tell where it is crossed.
struct BorderCurve {
  Handle(Geom2d_Curve) curve;
  std::vector<double> t;
  std::vector<Vec2> points;
};

class FaceLoops {
 public:
  explicit FaceLoops(const TopoDS_Face& face) {
    // Forward, so that the two uses of a seam tell their two curves apart.
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer edge(forward, TopAbs_EDGE); edge.More() && usable_; edge.Next())
      add(TopoDS::Edge(edge.Current()), forward);
    usable_ = usable_ && !borders_.empty();
  }

  [[nodiscard]] bool usable() const { return usable_; }
  [[nodiscard]] const Box2& box() const { return box_; }

  /// Where the line on which coordinate `axis` has a value is inside: pairs of the other coordinate. A line that meets a
  /// corner within rounding may count a border twice or not at all: then one beside it is taken.
  [[nodiscard]] std::vector<std::pair<double, double>> inside(int axis, double& value) const {
    const double step = 1e-7 * (box_.max()[axis] - box_.min()[axis]);
    for (const int aside : {0, 1, -1, 7, -7}) {
      const double tried = value + aside * step;
      std::vector<double> met = crossings(axis, tried);
      if (met.size() % 2 != 0) continue;
      std::sort(met.begin(), met.end());
      value = tried;
      std::vector<std::pair<double, double>> pieces;
      const double nothing = 1e-9 * (box_.max()[1 - axis] - box_.min()[1 - axis]);
      for (std::size_t i = 0; i + 1 < met.size(); i += 2)
        if (met[i + 1] - met[i] > nothing) pieces.emplace_back(met[i], met[i + 1]);
      return pieces;
    }
    return {};
  }

 private:
  void add(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    if (edge.Orientation() == TopAbs_INTERNAL || edge.Orientation() == TopAbs_EXTERNAL) return;
    BorderCurve border;
    double first = 0, last = 0;
    border.curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (border.curve.IsNull() || Precision::IsInfinite(first) || Precision::IsInfinite(last)) {
      usable_ = false;
      return;
    }
    const Geom2dAdaptor_Curve adaptor(border.curve, first, last);
    const int steps = adaptor.GetType() == GeomAbs_Line ? 1 : 32 * std::max(1, adaptor.NbIntervals(GeomAbs_C1));
    for (int k = 0; k <= steps; ++k) {
      border.t.push_back(k == steps ? last : first + (last - first) * k / steps);
      const gp_Pnt2d p = border.curve->Value(border.t.back());
      border.points.emplace_back(p.X(), p.Y());
      box_.extend(border.points.back());
    }
    borders_.push_back(std::move(border));
  }

  [[nodiscard]] std::vector<double> crossings(int axis, double value) const {
    std::vector<double> met;
    for (const BorderCurve& border : borders_)
      for (std::size_t k = 0; k + 1 < border.points.size(); ++k) {
        const bool from = border.points[k][axis] > value, to = border.points[k + 1][axis] > value;
        if (from != to) met.push_back(crossing(border, axis, value, border.t[k], border.t[k + 1], from));
      }
    return met;
  }

  /// By halving: a few rounding errors of the parameter remain.
  static double crossing(const BorderCurve& border, int axis, double value, double a, double b, bool above) {
    for (int round = 0; round < 52; ++round) {
      const double middle = (a + b) / 2;
      if (middle <= std::min(a, b) || middle >= std::max(a, b)) break;
      ((border.curve->Value(middle).Coord(axis + 1) > value) == above ? a : b) = middle;
    }
    return border.curve->Value((a + b) / 2).Coord(2 - axis);
  }

  std::vector<BorderCurve> borders_;
  Box2 box_;
  bool usable_ = true;
};

bool fillsPeriod(const BRepAdaptor_Surface& surface, int axis, double span) {
  const bool periodic = axis == 0 ? surface.IsUPeriodic() : surface.IsVPeriodic();
  if (!periodic) return false;
  return span > (1 - 1e-6) * (axis == 0 ? surface.UPeriod() : surface.VPeriod());
}

std::vector<IsoCurve> isoCurvesOfFace(const TopoDS_Face& face, int number, const IsoCurveOptions& options,
                                      const Progress& progress) {
  const BRepAdaptor_Surface surface(face, Standard_False);
  const FaceLoops loops(face);
  std::vector<IsoCurve> curves;
  if (!loops.usable()) return curves;
  for (const int axis : {0, 1}) {
    const double from = loops.box().min()[axis], to = loops.box().max()[axis];
    for (double value : isoParameters(from, to, options.count, fillsPeriod(surface, axis, to - from))) {
      progress.check();
      for (const auto& [a, b] : loops.inside(axis, value)) {
        const auto at = [&](double t) {
          return toVec((axis == 0 ? surface.Value(value, t) : surface.Value(t, value)).XYZ());
        };
        curves.push_back({chordPolyline(at, a, b, options.chord), number, axis == 0, value});
      }
    }
  }
  return curves;
}

}  // namespace

std::vector<IsoCurve> isoCurvesOfFaces(const Brep& brep, const IsoCurveOptions& options, const Progress& progress) {
  TopTools_IndexedMapOfShape faces;
  if (!brep.shape().IsNull()) TopExp::MapShapes(brep.shape(), TopAbs_FACE, faces);
  std::vector<std::vector<IsoCurve>> found(static_cast<std::size_t>(faces.Extent()));
  parallelFor(found.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      try {
        found[f] = isoCurvesOfFace(TopoDS::Face(faces(static_cast<int>(f) + 1)), static_cast<int>(f), options, progress);
      } catch (const Standard_Failure&) {
        found[f].clear();  // a face that OCCT cannot evaluate is drawn without them
      }
    }
  });
  std::vector<IsoCurve> curves;
  for (auto& ofFace : found) std::move(ofFace.begin(), ofFace.end(), std::back_inserter(curves));
  return curves;
}

}  // namespace blossom
