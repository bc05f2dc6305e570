#include <fmt/format.h>

#include "cage_input.h"
#include "core/error.h"
#include "feature_types.h"
#include "geometry/shape/bounds.h"
#include "kernel/cage.h"
#include "kernel/deform.h"
#include "kernel/four_point.h"
#include "kernel/limit_surface.h"
#include "kernel/samples.h"
#include "present.h"
#include "pulls.h"

namespace blossom::subdivision {
namespace {

struct DeformParameters {
  SchemeChoice scheme = SchemeChoice::CatmullClark;
  std::string free = "support";
  double lambda = defaultLambda;
  int iterations = 20;
  int samples = 50;
  std::vector<Value> pulls;
  As as = As::Cage;
  int levels = 3;
  double tolerance = 0.01;
};

std::vector<Vec3> polesOf(const Curve& curve) {
  std::vector<Vec3> points;
  for (const Vec4& each : curve.poles) points.emplace_back(each.head<3>());
  return points;
}

void addFigures(const DeformResult& result, const Shape& cage, double lambda, Evaluated& out) {
  const auto length = [](const char* name, double value) { return Measure{name, value, MeasureUnit::Length}; };
  out.figures = {length("rms_before", result.before.rms),
                 length("rms_after", result.after.rms),
                 length("max_before", result.before.largest),
                 length("max_after", result.after.largest),
                 {"free_points", static_cast<std::int64_t>(result.freePoints.size())},
                 length("outside_change", result.outsideChange)};
  out.stats["samples"] = result.feet.size();
  out.stats["solutions"] = result.objective.size();
  if (result.beyondRange)
    out.warnings.emplace_back(
        "More than half of the distance is left: the target lies beyond the local range. A wider rule for the free points, "
        "such as rings:1, lets more of the shape follow.");
  constexpr double far = 4;  // a pull of a bicubic surface moves the vertex under it by 9/4
  if (result.farthestMove > far * result.before.largest && result.before.largest > 0)
    out.warnings.push_back(
        fmt::format("Control point {} moves by {:.3g} mm, although the target lies at most {:.3g} mm off. A larger lambda, "
                    "such as {:.1g}, keeps it nearer.",
                    result.farthestPoint + 1, result.farthestMove, result.before.largest, std::max(0.01, 10 * lambda)));
  const double size = bounds(cage).diagonal();
  if (result.before.largest > size)
    out.warnings.push_back(
        fmt::format("The target lies up to {:.3g} mm off; the cage is only {:.3g} mm large.", result.before.largest, size));
}

Evaluated deformEvaluate(const DeformParameters& p, const Inputs& inputs, const Progress& progress) {
  const Shape cage = cageOf(inputs.of(0)[0]);
  checkScheme(cage, p.scheme);
  DeformOptions options{.free = ruleOf(p.free), .lambda = p.lambda, .iterations = p.iterations, .pulls = pullsOf(p.pulls)};
  std::vector<Vec3> samples;
  for (const Shape& target : inputs.of(1)) samples = samplesOf(target, p.samples, progress);
  if (samples.empty() && options.pulls.empty())
    throw Error(ErrorCode::InvalidInput, "There is no target and nothing is pulled.",
                "Give a target curve, a cloud of points, or pull a point of the limit shape.");
  const Progress work = progress.part(0, 0.8), showing = progress.part(0.8, 1);
  const PresentOptions shown{p.scheme, p.as, 0, p.levels, p.tolerance};
  Evaluated out;
  if (const Mesh* mesh = cage.get<Mesh>()) {
    Mesh moved = closedCage(*mesh, p.scheme, out, progress);
    checkCage(moved, surfaceScheme(p.scheme), progress);
    const LimitSurface surface(moved, surfaceScheme(p.scheme), progress);
    DeformResult result = deform(surface, moved.points, samples, options, work);
    moved.points = std::move(result.points);
    addFigures(result, cage, p.lambda, out);
    present(std::move(moved), shown, out, showing);
  } else if (auto polygon = polygonOf(cage, p.scheme)) {
    tellIfPoles(cage, out);
    const CurveScheme scheme = curveScheme(p.scheme);
    DeformResult result = scheme == CurveScheme::FourPoint
                              ? deform(FourPointCurve(*polygon), polygon->points, samples, options, work)
                              : deform(LimitCurve(*polygon, scheme), polygon->points, samples, options, work);
    polygon->points = std::move(result.points);
    addFigures(result, cage, p.lambda, out);
    present(std::move(*polygon), cage, shown, out, showing);
  } else {
    Curve curve = splineOf(cage);
    const DeformResult result = deform(LimitCurve(curve), polesOf(curve), samples, options, work);
    for (std::size_t i = 0; i < curve.poles.size(); ++i) curve.poles[i].head<3>() = result.points[i];
    addFigures(result, cage, p.lambda, out);
    present(std::move(curve), shown, out, showing);
  }
  return out;
}

ParameterSpec named(ParameterSpec spec, const char* name, const char* help) {
  spec.name = name;
  spec.help = help;
  return spec;
}

ParameterSpec pullList() {
  ParameterSpec at = named(point(), "at", "A place on the limit shape, or near it, before the deformation.");
  ParameterSpec to = named(point(), "to", "Where that place is to go.");
  at.fallback = to.fallback = Value::array({0.0, 0.0, 0.0});
  return list(record({at, to}));
}

}  // namespace

FeatureType deformFeature() {
  using P = DeformParameters;
  return feature<P>("subdivision.deform", "Deform",
                    "A cage whose limit surface or curve is pulled to a target near it; parts farther away stay.")
      .command("deform")
      .icon("deform")
      .produces({ShapeKind::Mesh, ShapeKind::Curve, ShapeKind::Curves, ShapeKind::Brep})
      .input({.name = "cage",
              .help = "A mesh, with its creases, or a control polygon.",
              .kinds = cageKinds,
              .use = InputUse::Consumed,
              .asks = "a cage to pull"})
      .input({.name = "target",
              .help =
                  "Where the limit shape is to run: drawn curves, edges of a solid, a cloud of points, or the vertices of a "
                  "mesh.",
              .kinds = {ShapeKind::Mesh, ShapeKind::Curve, ShapeKind::Curves, ShapeKind::Region, ShapeKind::Brep},
              .minimum = 0,
              .use = InputUse::Control})
      .parameter("scheme", &P::scheme, schemeChoice(), kSchemeHelp)
      .parameter("free", &P::free, text(),
                 "Which control points may move: support, paper, or rings:N for the support grown by N rings.")
      .parameter("lambda", &P::lambda, number(0, 1e6),
                 "Resistance of control points to being moved, larger for those with little influence; 0 means the shortest "
                 "movement that "
                 "fits best.")
      .parameter("iterations", &P::iterations, count(1, 1000), "Largest number of searches for closest points.")
      .parameter("samples", &P::samples, count(2, 20000), "Number of points along drawn targets.")
      .parameter("pulls", &P::pulls, pullList(), "Single points of the limit shape and their targets.")
      .parameter("as", &P::as, asChoice(), kAsHelp)
      .parameter("levels", &P::levels, onlyFor(count(0, 10), "as", {"limit"}), "Refinements of a limit mesh or polygon.")
      .parameter("tolerance", &P::tolerance, onlyFor(positiveLength(), "as", {"faces"}),
                 "Distance of B-spline faces from the limit surface near extraordinary points; elsewhere they are exact.")
      .byOutput(asByOutput())
      .example("blossom deform cage.obj target.xyz -o pulled.obj --json")
      .example("blossom deform cage.obj target.dxf --free rings:1 -o pulled.stl")
      .example("blossom deform cage.obj target.xyz -o pulled.step")
      .example("blossom deform polygon.dxf target.dxf --scheme cubic --free paper -o pulled.dxf")
      .evaluate(deformEvaluate);
}

}  // namespace blossom::subdivision
