#include "geometry/measure/measure.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/measure/measure_parts.h"
#include "geometry/numeric/gauss.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"

namespace blossom {
namespace {

Measures measureRegion(const Region& region, const Progress& progress) {
  std::size_t outer = 0, lines = 0, arcs = 0, splines = 0;
  double perimeter = 0;
  double total = 0;
  for (const Path& loop : region.loops) {
    progress.check();
    const double loopArea = signedArea(loop);
    total += loopArea;
    outer += loopArea > 0 ? 1 : 0;
    perimeter += length(loop);
    for (const Segment& segment : loop.segments)
      ++(std::holds_alternative<Line2>(segment) ? lines : std::holds_alternative<Arc2>(segment) ? arcs : splines);
  }
  return {"region",
          {{"area", total, MeasureUnit::Area},
           {"perimeter", perimeter, MeasureUnit::Length},
           countMeasure("loops", region.loops.size()),
           countMeasure("holes", region.loops.size() - outer),
           countMeasure("components", outer),
           countMeasure("vertices", lines + arcs + splines),  // as many as segments, in closed loops
           countMeasure("lines", lines),
           countMeasure("arcs", arcs),
           countMeasure("splines", splines)}};
}

Measures measureCurves(const Curves& curves, const Progress& progress) {
  double sum = 0;
  std::size_t closed = 0;
  for (const Path& path : curves.paths) {
    progress.check();
    sum += length(path);
    closed += path.closed ? 1 : 0;
  }
  return {"curves",
          {countMeasure("curves", curves.paths.size()),
           {"length", sum, MeasureUnit::Length},
           countMeasure("open", curves.paths.size() - closed),
           countMeasure("closed", closed)}};
}

bool hasPositiveWeights(const Curve& curve) {
  return std::all_of(curve.poles.begin(), curve.poles.end(), [](const Vec4& pole) { return pole.w() > 0; });
}

double curveLength(const Curve& curve, const Progress& progress) {
  const auto speed = [&](double t) {
    progress.check();
    const std::vector<Vec4> d = derivatives(curve, t, 1);
    const Vec3 point = d[0].head<3>() / d[0].w();
    return ((d[1].head<3>() - d[1].w() * point) / d[0].w()).norm();
  };
  const std::vector<double> breaks = toBezier(curve).breaks;
  double polygon = 0;
  for (std::size_t i = 1; i < curve.poles.size(); ++i)
    polygon +=
        (curve.poles[i].head<3>() / curve.poles[i].w() - curve.poles[i - 1].head<3>() / curve.poles[i - 1].w()).norm();
  double sum = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) sum += integrate(speed, breaks[i], breaks[i + 1], 1e-12 * polygon);
  return sum;
}

Measures measureCurve(const Curve& curve, const Progress& progress) {
  Measures measures{"curve", {{"degree", std::int64_t{curve.degree}}, countMeasure("poles", curve.poles.size())}};
  if (hasPositiveWeights(curve)) measures.values.push_back({"length", curveLength(curve, progress), MeasureUnit::Length});
  return measures;
}

std::string closedName(ClosedU closed) {
  switch (closed) {
    case ClosedU::No:
      return "no";
    case ClosedU::Periodic:
      return "periodic";
    case ClosedU::AntiPeriodic:
      return "anti-periodic";
  }
  return "no";
}

Measures measureMotion(const Motion& motion) {
  Measures measures{"motion",
                    {{"trajectory_degree", std::int64_t{motion.trajectory.degree}},
                     countMeasure("trajectory_poles", motion.trajectory.poles.size())}};
  const auto add = [&](const std::string& name, const Surface& surface) {
    measures.values.push_back({name + "_degree_u", std::int64_t{surface.degreeU}});
    measures.values.push_back({name + "_degree_v", std::int64_t{surface.degreeV}});
    measures.values.push_back(countMeasure(name + "_poles_u", surface.countU()));
    measures.values.push_back(countMeasure(name + "_poles_v", surface.countV()));
  };
  add("orientation", motion.orientation);
  add("scaling", motion.scaling);
  measures.values.push_back({"closed_u", closedName(motion.closedU)});
  measures.values.push_back(countMeasure("edits", motion.edits.size()));
  return measures;
}

Measures measureSequence(const Sequence& sequence) {
  Measures measures{"sequence", {countMeasure("frames", sequence.frames.size())}};
  if (!sequence.times.empty()) {
    measures.values.push_back({"start", sequence.times.front(), MeasureUnit::None});
    measures.values.push_back({"end", sequence.times.back(), MeasureUnit::None});
  }
  return measures;
}

Measures measureMedialAxis(const MedialAxis& axis) {
  const auto certified = static_cast<std::size_t>(
      std::count_if(axis.vertices.begin(), axis.vertices.end(), [](const MedialVertex& v) { return v.certified; }));
  return {"medial axis",
          {countMeasure("edges", axis.edges.size()),
           countMeasure("vertices", axis.vertices.size()),
           countMeasure("certified", certified),
           countMeasure("uncertified", axis.vertices.size() - certified),
           {"length", lengthOf(axis), MeasureUnit::Length}}};
}

/// Figures that are not known are left out: the time where a cut has no feed, and what was not simulated.
Measures measureToolpath(const Toolpath& path) {
  Measures measures{"toolpath", {{"length_mm", lengthOf(path), MeasureUnit::Length}}};
  if (const auto seconds = secondsOf(path)) measures.values.push_back({"time_s", *seconds, MeasureUnit::Time});
  if (path.gouge) measures.values.push_back({"gouge_mm", *path.gouge, MeasureUnit::Length});
  if (path.residue) measures.values.push_back({"residue_mm2", *path.residue, MeasureUnit::Area});
  measures.values.push_back(countMeasure("passes", path.passes));
  return measures;
}

Measures measureSetup(const Setup& setup) {
  Bounds box;
  for (const Shape& stock : setup.stock) box.add(bounds(stock));
  const Vec3 size = box.high - box.low;
  return {"setup",
          {{"stock_x", size.x(), MeasureUnit::Length},
           {"stock_y", size.y(), MeasureUnit::Length},
           {"stock_z", size.z(), MeasureUnit::Length},
           countMeasure("clamps", setup.clamps.size())}};
}

struct MeasuringVisitor {
  const Progress& progress;
  Measures operator()(std::monostate) const { return {"nothing", {}}; }
  Measures operator()(const Region& region) const { return measureRegion(region, progress); }
  Measures operator()(const Curves& curves) const { return measureCurves(curves, progress); }
  Measures operator()(const Curve& curve) const { return measureCurve(curve, progress); }
  Measures operator()(const Surface& surface) const { return measureSurface(surface, progress); }
  Measures operator()(const Brep& brep) const { return measureBrep(brep, progress); }
  Measures operator()(const Mesh& mesh) const { return measureMesh(mesh, progress); }
  Measures operator()(const Motion& motion) const { return measureMotion(motion); }
  Measures operator()(const Sequence& sequence) const { return measureSequence(sequence); }
  Measures operator()(const MedialAxis& axis) const { return measureMedialAxis(axis); }
  Measures operator()(const Toolpath& path) const { return measureToolpath(path); }
  Measures operator()(const Setup& setup) const { return measureSetup(setup); }
};

/// JSON would print a figure that is not finite as null.
void refuseInfinite(const Measures& measures) {
  for (const Measure& each : measures.values) {
    const double* value = std::get_if<double>(&each.value);
    if (!value || std::isfinite(*value)) continue;
    std::string name = each.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    throw Error(
        ErrorCode::LimitExceeded, "The " + name + " of the " + measures.kind + " is beyond all numbers.",
        "Its coordinates are too large, or not those that were meant: look for exponents such as e308, or scale it.");
  }
}

}  // namespace

Measures measure(const Shape& shape, const Progress& progress) {
  progress.check();
  Measures measures = shape.visit(MeasuringVisitor{progress});
  refuseInfinite(measures);
  return measures;
}

}  // namespace blossom
