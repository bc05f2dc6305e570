#include "morph_control.h"

#include <fmt/format.h>

#include <numbers>

#include "core/error.h"
#include "geometry/planar/sums/flattening.h"
#include "kernel/morph/sector_shape.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

ParameterSpec angleNamed(std::string name, std::string help) {
  ParameterSpec spec = angle();
  spec.name = std::move(name);
  spec.help = std::move(help);
  spec.fallback = 0.0;
  return spec;
}

double radiansOf(const Value& sector, const char* name) { return sector.value(name, 0.0) * std::numbers::pi / 180; }

}  // namespace

void refuseBesidesKnots(bool blossomOrPath, bool degreeElevate, bool areaPreserving) {
  if (!blossomOrPath && !degreeElevate && !areaPreserving) return;
  throw Error(ErrorCode::InvalidParameter,
              "A B-spline of shapes takes no blossom parameters, path, degree elevation or preserved areas.",
              "Leave them out, or the degree and the knots.");
}

Shape sequenceOf(std::vector<Region> regions, std::vector<double> places) {
  Sequence sequence;
  sequence.times = std::move(places);
  for (Region& region : regions) sequence.frames.emplace_back(std::move(region));
  return Shape(std::move(sequence));
}

Evaluated morphedBySpline(const std::vector<Region>& shapes, const ShapeKnots& spline, const std::vector<double>& times,
                          const std::vector<double>& places, const MorphOptions& options, const Progress& progress) {
  MorphResult result = splineMorph(shapes, spline, times, options, progress);
  Evaluated out;
  out.stats["sums"] = result.sums;
  out.stats["degree"] = spline.degree;
  if (const auto continuity = continuityOf(spline)) out.stats["continuity"] = *continuity;
  if (places.empty()) out.stats["influences"] = influences(spline, times.front());
  out.shape = places.empty() ? Shape(std::move(result.regions.front())) : sequenceOf(std::move(result.regions), places);
  return out;
}

ParameterSpec sectorsSpec() {
  return list(record({angleNamed("from", "First direction of the sector, counter-clockwise from +x."),
                      angleNamed("to", "Last direction.")}));
}

void faceSectors(std::vector<Region>& shapes, const std::vector<Value>& sectors, const std::optional<double>& tolerance,
                 const Progress& progress) {
  if (sectors.size() > shapes.size())
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("{} sectors are given for {} control shapes.", sectors.size(), shapes.size()),
                "Leave out those too many.");
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    const Sector sector{radiansOf(sectors[i], "from"), radiansOf(sectors[i], "to")};
    if (sector.from == sector.to) continue;
    const std::string name = fmt::format("control shape {}", i + 1);
    shapes[i] = facing(soundRegion(shapes[i], {.tolerance = tolerance}, name, progress), sector, name, progress).region;
  }
}

}  // namespace blossom::minkowski
