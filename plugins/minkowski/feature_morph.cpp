#include <fmt/format.h>

#include <algorithm>

#include "control_shapes.h"
#include "core/error.h"
#include "feature/frame_keys.h"
#include "feature/registry.h"
#include "feature_types.h"
#include "kernel/morph/blossom_path.h"
#include "kernel/morph/control_placement.h"
#include "kernel/morph/morph.h"
#include "morph_control.h"
#include "region_inputs.h"
#include "sector_values.h"

namespace blossom::minkowski {
namespace {

struct MorphParameters {
  double t = 0.5;
  int frames = 0;
  std::vector<Value> keys;
  std::vector<double> blossom;
  std::vector<Arguments> path;
  EvaluationOrder evaluation = EvaluationOrder::Automatic;
  bool degreeElevate = false;
  bool areaPreserving = false;
  std::vector<Vec3> offsets;
  std::vector<double> scales, turns;
  Value tolerance;  ///< null: follows the shapes' sizes
  int degree = 0;   ///< 0: one less than the number of shapes
  std::vector<double> knots;
  std::vector<Value> sectors;
};

void refuseTooMany(const char* what, std::size_t given, std::size_t shapes) {
  if (given > shapes)
    throw Error(ErrorCode::InvalidParameter, fmt::format("{} {} are given for {} control shapes.", given, what, shapes),
                "Leave out those too many.");
}

/// Where the control shapes were dragged to, as they were scaled and turned there.
void placeShapes(std::vector<Region>& shapes, const MorphParameters& p) {
  refuseTooMany("offsets", p.offsets.size(), shapes.size());
  refuseTooMany("scales", p.scales.size(), shapes.size());
  refuseTooMany("turns", p.turns.size(), shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Placement placement;
    if (i < p.scales.size()) placement.scale = p.scales[i];
    if (i < p.turns.size()) placement.turn = p.turns[i];
    if (i < p.offsets.size()) placement.offset = p.offsets[i].head<2>();
    if (i < p.offsets.size() && p.offsets[i].z() != 0)
      throw Error(ErrorCode::InvalidParameter, fmt::format("Offset {} leaves the plane of the shapes.", i + 1),
                  "Give 0 for its z.");
    shapes[i] = placed(shapes[i], placement);
  }
}

/// In the order of EvaluationOrder.
std::vector<std::string> evaluationNames() { return {"automatic", "recursive", "bottom-up", "explicit", "convex"}; }

constexpr const char* toleranceHelp =
    "Largest distance between curves and the polygons that stand for them, and by which more than two terms may fill dents.";

/// Of which a slider shows 0 to 1.
ParameterSpec ratioAndBeyond() {
  constexpr double far = 10;
  ParameterSpec spec = ratio();
  spec.minimum = -far;
  spec.maximum = far;
  return spec;
}

void refuseTogether(const MorphParameters& p) {
  if (p.frames > 0 && !p.blossom.empty())
    throw Error(ErrorCode::InvalidParameter, "Blossom parameters give one shape, not a sequence of frames.",
                "Leave out the frames or the blossom parameters, or let a path lead through them.");
  if (!p.path.empty() && !p.blossom.empty())
    throw Error(ErrorCode::InvalidParameter, "Both a path and blossom parameters are given.", "Leave out one of them.");
}

bool isPiecewise(const MorphParameters& p, std::size_t shapes) {
  return !p.knots.empty() || (p.degree > 0 && static_cast<std::size_t>(p.degree) + 1 != shapes);
}

/// When each frame is seen: evenly from 0 to 1; at 0 frames the one in-between.
std::vector<double> placesOf(const MorphParameters& p) {
  if (p.frames < 2) return {p.t};
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(p.frames));
  for (int k = 0; k < p.frames; ++k) places.push_back(static_cast<double>(k) / (p.frames - 1));
  return places;
}

/// t of each frame, which keys may tell.
std::vector<double> timesOf(const MorphParameters& p, const std::vector<double>& places) {
  if (p.frames == 0 || p.keys.empty()) return places;
  const std::vector<FrameKey> keys = frameKeysOf(p.keys);
  if (p.frames == 1) return {keyedTime(keys, 0, 1)};
  std::vector<double> times;
  times.reserve(places.size());
  for (const double place : places) times.push_back(keyedTime(keys, place, p.frames));
  return times;
}

Arguments argumentsAt(const MorphParameters& p, std::size_t degree, double t) {
  if (!p.path.empty()) return pointOfPath(p.path, t);
  return p.blossom.empty() ? diagonal(degree, t) : p.blossom;
}

std::size_t splineShapes(const std::vector<Region>& shapes) {
  return static_cast<std::size_t>(
      std::count_if(shapes.begin(), shapes.end(), [](const Region& r) { return hasSplines(r); }));
}

void tellUnused(const MorphParameters& p, Evaluated& out) {
  const auto isOther = [&](double number) { return number != p.t; };
  if (p.frames == 0 && p.t != MorphParameters{}.t && std::any_of(p.blossom.begin(), p.blossom.end(), isOther))
    out.warnings.push_back("t has no effect beside blossom parameters, which say which shape is made.");
  if (p.keys.empty()) return;
  if (p.frames > 0) {
    const std::vector<FrameKey> keys = frameKeysOf(p.keys);
    const auto after = std::count_if(keys.begin(), keys.end(), [&](const FrameKey& key) { return key.frame > p.frames; });
    if (after > 0)
      out.warnings.push_back(fmt::format("{} key{} after the last frame, {}: what leads there breaks off.", after,
                                         after == 1 ? " lies" : "s lie", p.frames));
    return;
  }
  out.warnings.push_back(p.blossom.empty() ? "The keys have no effect on the one shape at t: give a number of frames."
                                           : "The keys have no effect beside blossom parameters, which give one shape.");
}

Evaluated morphed(const MorphParameters& p, std::size_t maximumWork, const Inputs& inputs, const Progress& progress) {
  refuseTogether(p);
  std::vector<Region> shapes = controlShapesOf(inputs);
  placeShapes(shapes, p);
  const std::size_t freeForm = splineShapes(shapes);
  faceSectors(shapes, sectorsIn(p.sectors), toleranceOf(p.tolerance), progress);
  const bool sectorsOfLines = splineShapes(shapes) < freeForm;
  const std::vector<double> places = placesOf(p), times = timesOf(p, places);
  if (isPiecewise(p, shapes.size())) {
    refuseBesidesKnots(!p.blossom.empty() || !p.path.empty(), p.degreeElevate);
    Evaluated out = morphedBySpline(
        shapes, knotsFor(shapes.size(), p.degree, p.knots), times, p.frames > 0 ? places : std::vector<double>(),
        {.areaPreserving = p.areaPreserving, .tolerance = toleranceOf(p.tolerance), .maximumWork = maximumWork}, progress);
    tellUnused(p, out);
    return out;
  }
  checkPath(p.path, shapes.size());
  const std::size_t degree = shapes.size() - 1;
  std::vector<Arguments> arguments;
  arguments.reserve(times.size());
  for (const double t : times) arguments.push_back(argumentsAt(p, degree, t));
  MorphResult result = morph(shapes, arguments,
                             {.evaluation = p.evaluation,
                              .degreeElevate = p.degreeElevate,
                              .areaPreserving = p.areaPreserving,
                              .tolerance = toleranceOf(p.tolerance),
                              .maximumWork = maximumWork},
                             progress);
  Evaluated out;
  out.stats["sums"] = result.sums;
  if (result.evaluation) out.stats["evaluation"] = evaluationNames()[static_cast<std::size_t>(*result.evaluation)];
  if (result.deviation > 0) out.stats["deviation"] = result.deviation;
  out.stats["degree"] = degree + (p.degreeElevate ? 1 : 0);
  out.warnings = std::move(result.warnings);
  if (sectorsOfLines)
    out.warnings.push_back(
        "What faces the sector of a free-form shape is made of straight lines, within the tolerance; a smaller one makes "
        "them finer.");
  tellUnused(p, out);
  if (p.frames == 0) {
    out.stats["influences"] = sharesOf(arguments.front());
    out.shape = shapeOfControl(std::move(result.regions.front()));
    return out;
  }
  out.shape = sequenceOf(std::move(result.regions), places);
  return out;
}

using Builder = FeatureBuilder<MorphParameters>;

/// Where the handles of control shapes take them.
Builder& addPlacements(Builder& builder) {
  using P = MorphParameters;
  return builder
      .parameter("offsets", &P::offsets, onePer(list(displacement()), "shape"),
                 "Displacement of each control shape from its drawn position, first to last; others stay.")
      .parameter("scales", &P::scales, onePer(list(positiveNumber()), "shape"),
                 "How many times as large each control shape is as drawn, about its centre, first to last; others stay.")
      .parameter("turns", &P::turns, onePer(list(angle()), "shape"),
                 "Rotation of each control shape about its centre, counter-clockwise, first to last; others stay.");
}

}  // namespace

FeatureType morphFeature(std::size_t maximumWork) {
  using P = MorphParameters;
  Builder builder = feature<P>("minkowski.morph", "Morph", "The in-between shapes of two or more control shapes.");
  builder.command("morph")
      .icon("morph")
      .produces({ShapeKind::Region, ShapeKind::Curves})
      .playedBy({.parameter = "frames", .keys = "keys", .excludedBy = "blossom"})
      .input({.name = "shape",
              .help = "Control shapes, first to last; single points, too, out of which shapes grow.",
              .kinds = {ShapeKind::Region},
              .minimum = 2,
              .maximum = anyNumber,
              .use = InputUse::Control,
              .points = true,
              .asks = "a shape to morph"})
      .parameter(
          "t", &P::t, ratioAndBeyond(),
          "Position along the morph, from 0 (the first shape) to 1 (the last); beyond them it goes on as far as there "
          "are shapes that lead through both.")
      .parameter("frames", &P::frames, count(0, 10000), "Number of shapes of a sequence from 0 to 1; 0 makes the one at t.")
      .parameter("keys", &P::keys, frameKeys(), "Frames at which t is given, and how it goes on from there.")
      .parameter("blossom", &P::blossom, onePer(list(ratioAndBeyond()), "shape", -1, "t"),
                 "One number for each control shape after the first, instead of t; all equal, they are t.")
      .parameter("path", &P::path, list(onePer(list(ratio()), "shape", -1, "t")),
                 "Points of blossom numbers that the morph runs through, as long from each to the next. None: t alone.")
      .parameter(
          "evaluation", &P::evaluation, choice(evaluationNames()),
          "How the in-betweens are computed; the shape is the same. Automatic chooses the fewest sums, and explicit for "
          "more than four shapes; convex requires convex control shapes between the ends.")
      .parameter("degree-elevate", &P::degreeElevate, flag(),
                 "Elevate the degree by one; the morph stays the same when all shapes are convex.")
      .parameter("area-preserving", &P::areaPreserving, flag(),
                 "Scale the result so that its area blends those of the shapes.");
  return addPlacements(builder)
      .parameter("tolerance", &P::tolerance, toleranceSpec(), toleranceHelp)
      .parameter("degree", &P::degree, count(0),
                 "Degree of a B-spline of shapes: so many shapes and one more act at a time. 0: one less than the number of "
                 "shapes, the Bezier morph, in which all act.")
      .parameter("knots", &P::knots, list(number()),
                 "Knots of the B-spline, as many as shapes and the degree and one more, the first and last as often as the "
                 "degree and once more. None: evenly spaced.")
      .parameter(
          "sectors", &P::sectors, onePer(sectorsSpec(), "shape"),
          "Directions in which each control shape acts, first to last; from equal to to, or a whole turn: all around.")
      .example("blossom morph star:5:20:8 circle:15 --t 0.3 -o between.svg")
      .example("blossom morph cat.svg dog.svg --frames 25 -o frame.svg")
      .example("blossom morph cat.svg dog.svg --frames 49 --svg.animate -o walk.svg")
      .example(
          "blossom morph cat.svg dog.svg --frames 49 --keys '[{\"frame\": 1, \"t\": 0, \"ease\": \"in-out\"}, {\"frame\": "
          "25, "
          "\"t\": 1}, {\"frame\": 49, \"t\": 0}]' -o there-and-back.ogv")
      .example("blossom morph cat.svg dog.svg --offsets \"-40,0,0; 40,0,0\" --t 0.5 -o moved.dxf")
      .example("blossom morph cat.svg dog.svg --scales 1,1.5 --turns 0,90 --t 0.5 -o turned.dxf")
      .example("blossom morph a.svg b.svg c.svg --blossom 0.2,0.7 --json")
      .example("blossom morph a.svg b.svg c.svg --path \"0,0; 0.2,0.9; 1,1\" --frames 25 -o path.svg")
      .example("blossom morph a.svg b.svg c.svg d.svg --degree 2 --frames 31 -o pieces.svg")
      .evaluate([maximumWork](const P& p, const Inputs& inputs, const Progress& progress) {
        return morphed(p, maximumWork, inputs, progress);
      });
}

}  // namespace blossom::minkowski
