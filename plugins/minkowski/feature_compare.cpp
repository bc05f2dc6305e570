#include <fmt/format.h>

#include <algorithm>

#include "feature/registry.h"
#include "feature_types.h"
#include "geometry/planar/planar.h"
#include "kernel/compare/morph_comparison.h"
#include "region_inputs.h"

namespace blossom::minkowski {
namespace {

struct ComparisonParameters {
  int steps = 7;
  int frames = 0;
  int resolution = 200;
  Value tolerance;  ///< null: follows the shapes' sizes
};

/// A row of the picture: the layer and the colour of its outlines.
struct ComparedWay {
  const char* layer;
  Color color;
  const MorphedWay* way;
};

std::vector<ComparedWay> comparedWays(const MorphComparison& comparison) {
  return {{"vertices", {0.80, 0.36, 0.14}, &comparison.vertices},
          {"distance fields", {0.16, 0.50, 0.72}, &comparison.fields},
          {"minkowski sums", {0.20, 0.52, 0.24}, &comparison.sums}};
}

void addOutlines(Curves& picture, const ComparedWay& each, std::size_t time, const Vec2& at) {
  if (time >= each.way->outlines.size()) return;
  Eigen::Matrix<double, 2, 3> move;
  move << 1, 0, at.x(), 0, 1, at.y();
  for (const Path& path : each.way->outlines[time]) {
    Path& placed = picture.paths.emplace_back(transformed(path, move));
    placed.layer = each.layer;
    placed.color = each.color;
  }
}

Curves emptyPicture() {
  Curves picture;
  picture.fillRule = FillRule::NonZero;  // what outlines that cross themselves run around twice is filled too
  return picture;
}

constexpr double pitch = 1.2;  // from one in-between to the next, in sizes of the largest

Path lineThrough(const std::vector<Vec2>& points, const char* layer, const Color& color) {
  Path line{{}, false, layer, color};
  for (std::size_t i = 1; i < points.size(); ++i) line.segments.emplace_back(Line2{points[i - 1], points[i]});
  return line;
}

/// The area of each way over t, under the columns of the table; the largest one is as high as a row.
void addAreasOverTime(Curves& picture, const MorphComparison& comparison, std::size_t times, const Vec2& step) {
  constexpr Color axes{0.45, 0.45, 0.45};
  const std::vector<ComparedWay> ways = comparedWays(comparison);
  double largest = 0;
  for (const ComparedWay& each : ways)
    for (const double area : each.way->areas) largest = std::max(largest, area);
  if (!(largest > 0) || times < 2) return;
  const double height = step.y() / pitch, lastRow = -(static_cast<double>(ways.size()) - 1) * step.y();
  const double ground = lastRow + comparison.room.min().y() - step.y();
  const auto place = [&](std::size_t k, double area) {
    return Vec2(step.x() * static_cast<double>(k), ground + height * area / largest);
  };
  picture.paths.push_back(lineThrough({place(0, largest), place(0, 0), place(times - 1, 0)}, "axes", axes));
  for (const ComparedWay& each : ways) {
    std::vector<Vec2> curve;
    for (std::size_t k = 0; k < each.way->areas.size(); ++k) curve.push_back(place(k, each.way->areas[k]));
    if (curve.size() > 1) picture.paths.push_back(lineThrough(curve, each.layer, each.color));
  }
}

/// A row for each way and a column for each time; below them the areas.
Curves comparisonTable(const MorphComparison& comparison, std::size_t times) {
  const Vec2 step = pitch * comparison.room.sizes();
  Curves picture = emptyPicture();
  double row = 0;
  for (const ComparedWay& each : comparedWays(comparison)) {
    for (std::size_t k = 0; k < times; ++k)
      addOutlines(picture, each, k, {step.x() * static_cast<double>(k), -step.y() * row});
    ++row;
  }
  addAreasOverTime(picture, comparison, times, step);
  return picture;
}

/// In each frame the three ways side by side.
Sequence comparisonFrames(const MorphComparison& comparison, const std::vector<double>& times) {
  const double step = pitch * comparison.room.sizes().x();
  Sequence sequence;
  sequence.times = times;
  for (std::size_t k = 0; k < times.size(); ++k) {
    Curves picture = emptyPicture();
    double column = 0;
    for (const ComparedWay& each : comparedWays(comparison)) addOutlines(picture, each, k, {step * column++, 0});
    sequence.frames.emplace_back(std::move(picture));
  }
  return sequence;
}

void tell(Evaluated& out, const MorphComparison& comparison, const std::vector<double>& times) {
  out.stats["times"] = times;
  out.stats["area_by_fields"] = comparison.fields.areas;
  out.stats["area_by_sums"] = comparison.sums.areas;
  out.stats["time_by_fields_ms"] = comparison.fields.milliseconds;
  out.stats["time_by_sums_ms"] = comparison.sums.milliseconds;
  out.stats["sums"] = comparison.sumCount;
  if (comparison.whyNoVertices.empty()) {
    out.stats["area_by_vertices"] = comparison.vertices.areas;
    out.stats["time_by_vertices_ms"] = comparison.vertices.milliseconds;
    out.stats["crossings_by_vertices"] = comparison.crossings;
  } else {
    out.warnings.push_back(comparison.whyNoVertices + " Its place is empty.");
  }
  const auto& areas = comparison.fields.areas;
  if (const auto gone = std::count(areas.begin(), areas.end(), 0.0); gone > 0)
    out.warnings.push_back(fmt::format(
        "Distance fields leave nothing at {} of {} times: the shapes overlap too little there.", gone, times.size()));
}

std::vector<double> evenTimes(std::size_t count) {
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k)
    times.push_back(count == 1 ? 0.5 : static_cast<double>(k) / static_cast<double>(count - 1));
  return times;
}

Evaluated compared(const ComparisonParameters& p, std::size_t maximumWork, const Inputs& inputs, const Progress& progress) {
  const std::vector<Region> shapes = regionsOf(inputs);
  const std::vector<double> times = evenTimes(static_cast<std::size_t>(p.frames > 0 ? p.frames : p.steps));
  const MorphComparison comparison = compareMorphs(shapes[0], shapes[1],
                                                   {.times = times,
                                                    .resolution = static_cast<std::size_t>(p.resolution),
                                                    .tolerance = toleranceOf(p.tolerance),
                                                    .maximumWork = maximumWork},
                                                   progress);
  Evaluated out;
  tell(out, comparison, times);
  if (p.frames > 0)
    out.shape = comparisonFrames(comparison, times);
  else
    out.shape = comparisonTable(comparison, times.size());
  return out;
}

}  // namespace

FeatureType comparisonFeature(std::size_t maximumWork) {
  using P = ComparisonParameters;
  return feature<P>(
             "minkowski.morph-compare", "Morphs compared",
             "Two shapes morphed by matched vertices, by distance fields and by Minkowski sums, one beside the other.")
      .command("morph-compare")
      .icon("morph")
      .produces({ShapeKind::Curves})
      .playedBy({.parameter = "frames"})
      .input({.name = "shape",
              .help = "The first shape and the last.",
              .kinds = {ShapeKind::Region},
              .minimum = 2,
              .maximum = 2,
              .use = InputUse::Control,
              .asks = "a shape to morph"})
      .parameter("steps", &P::steps, count(2, 100), "How many in-betweens of each way are in the picture, from t = 0 to 1.")
      .parameter("frames", &P::frames, count(0, 1000),
                 "Number of frames of a sequence, each with the three ways side by side; 0 makes one picture with a row "
                 "for each way and their areas over t.")
      .parameter("resolution", &P::resolution, count(8, 1000),
                 "Cells of the distance fields along the longer side of the shapes.")
      .parameter("tolerance", &P::tolerance, toleranceSpec(),
                 "Largest distance between curves and the polygons that stand for them.")
      .keywords({"benchmark", "distance field", "marching squares"})
      .example("blossom morph-compare cat.svg dog.svg -o compared.svg --json")
      .example("blossom morph-compare star:5:20:8 circle:15 --frames 25 -o compared.svg --svg.animate")
      .evaluate([maximumWork](const P& p, const Inputs& inputs, const Progress& progress) {
        return compared(p, maximumWork, inputs, progress);
      });
}

}  // namespace blossom::minkowski
