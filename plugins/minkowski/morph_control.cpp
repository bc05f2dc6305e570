#include "morph_control.h"

#include <fmt/format.h>

#include <numbers>

#include "core/error.h"
#include "kernel/flattening.h"
#include "kernel/morph/sector_shape.h"

namespace blossom::minkowski {
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

void refuseBesidesKnots(bool blossom, bool degreeElevate, bool areaPreserving) {
  if (!blossom && !degreeElevate && !areaPreserving) return;
  throw Error(ErrorCode::InvalidParameter,
              "A B-spline of shapes takes no blossom parameters, degree elevation or preserved areas.",
              "Leave them out, or the degree and the knots.");
}

Evaluated morphedBySpline(const std::vector<Region>& shapes, const ShapeKnots& spline, int frames, double t,
                          const MorphOptions& options, const Progress& progress) {
  Sequence sequence;
  for (int k = 0; k < frames; ++k) sequence.times.push_back(frames == 1 ? t : static_cast<double>(k) / (frames - 1));
  const std::vector<double> times = frames == 0 ? std::vector{t} : sequence.times;
  MorphResult result = splineMorph(shapes, spline, times, options, progress);
  Evaluated out;
  out.stats["sums"] = result.sums;
  out.stats["degree"] = spline.degree;
  if (const auto continuity = continuityOf(spline)) out.stats["continuity"] = *continuity;
  if (frames == 0) {
    out.stats["influences"] = influences(spline, t);
    out.shape = std::move(result.regions.front());
    return out;
  }
  for (Region& region : result.regions) sequence.frames.emplace_back(std::move(region));
  out.shape = std::move(sequence);
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
