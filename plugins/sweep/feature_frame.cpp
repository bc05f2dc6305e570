#include <fmt/format.h>

#include <algorithm>

#include "core/angle.h"
#include "core/error.h"
#include "core/place_text.h"
#include "core/units.h"
#include "curve_input.h"
#include "feature/picked_numbers.h"
#include "feature_types.h"
#include "geometry/bspline/bspline.h"
#include "kernel/begin/motion_from_curve.h"
#include "type_ids.h"

namespace blossom::sweep {

namespace {

enum class ProfileCentre { Centroid, Origin };

struct FrameParameters {
  std::vector<SubShapeValue> edges;
  double radius = 5;
  ProfileCentre centre = ProfileCentre::Centroid;
  double tolerance = 1e-3;
  int rows = 12, columns = 8;
  Vec3 normal{0, 0, 0};
};

/// A profile is drawn about its middle, or about the origin of the drawing.
PolarProfile profileOf(const Shape& shape, ProfileCentre centre) {
  const Curve curve = curveOf(shape, "profile");
  return centre == ProfileCentre::Origin ? PolarProfile(curve, Vec3::Zero()) : PolarProfile(curve);
}

void addFrameStats(const CurveMotionResult& made, Evaluated& out) {
  out.stats["closed"] = made.closed;
  out.stats["deviation"] = made.deviation;
  out.stats["frame_deviation"] = toDegrees(made.frameDeviation);
  out.stats["closing_angle"] = toDegrees(made.closing);
  out.stats["spans_v"] = made.frameSpans;
  out.stats["poles_u"] = made.motion.orientation.countU();
  out.stats["poles_v"] = made.motion.orientation.countV();
  if (made.smallestBend > 0) out.stats["min_bend_radius"] = made.smallestBend;  // a straight path has none
  out.stats["reach"] = made.reach;
  if (made.cornerAtEnds > 0)
    out.warnings.push_back(fmt::format(
        "The path ends where it begins, at {}, with a corner of {:.4g} degrees: the motion stays open, and its ends run "
        "into each other. Round the corner, or let the path begin and end apart.",
        placeText(point(made.motion.trajectory, 0)), toDegrees(made.cornerAtEnds)));
  if (made.smallestBend > 0 && made.smallestBend <= made.reach)
    out.warnings.push_back(
        fmt::format("The path bends to a radius of {:.4g} mm near v = {:.4g}, and the section reaches {:.4g} mm: the "
                    "surface may fold there.",
                    made.smallestBend, made.bendAt, made.reach));
}

void checkEdges(const std::vector<SubShapeValue>& edges) {
  for (const SubShapeValue& each : edges)
    if (std::count(edges.begin(), edges.end(), each) > 1)
      throw Error(ErrorCode::InvalidParameter, fmt::format("Edge {} is named twice.", each.index), "Name it once.");
  for (const SubShapeValue& each : edges)
    if (!each.input.empty() && each.input != "path")
      throw Error(ErrorCode::InvalidParameter,
                  fmt::format("Edge {} is one of the {}, not of the path.", each.index, each.input),
                  "Choose edges of the path alone.");
}

Evaluated evaluateFrame(const FrameParameters& p, const Inputs& inputs, const Progress& progress) {
  progress.report(0.02, "Following the path");
  checkEdges(p.edges);
  const Curve path = curveOf(inputs.of(0)[0], "path", numbersOf(p.edges));
  CurveMotionOptions options{.radius = p.radius,
                             .profile = {},
                             .tolerance = p.tolerance,
                             .rows = static_cast<std::size_t>(p.rows),
                             .columns = static_cast<std::size_t>(p.columns),
                             .normal = p.normal};
  if (!inputs.of(1).empty()) options.profile = profileOf(inputs.of(1)[0], p.centre);
  CurveMotionResult made = motionFromCurve(path, options, progress.part(0.05, 1));
  Evaluated out;
  addFrameStats(made, out);
  out.shape = std::move(made.motion);
  return out;
}

InputSpec pathInput() {
  return {.name = "path",
          .help = "The curve that the section follows: smooth, open or closed. Of a solid, some of its edges.",
          .kinds = curveKinds,
          .use = InputUse::Outline,
          .asks = "the curve to sweep along"};
}

InputSpec sectionInput() {
  return {.name = "profile",
          .help = "A flat, closed, star-shaped outline to be the section; without one it is round.",
          .kinds = curveKinds,
          .minimum = 0,
          .use = InputUse::Outline,
          .asks = "an outline to be the section"};
}

}  // namespace

FeatureType frameFeature() {
  using P = FrameParameters;
  return feature<P>(frameType, "Sweep along",
                    "A motion that carries a section along a curve without spinning it, ready to be pulled.")
      .command("sweep-along")
      .icon("sweep-along")
      .produces({ShapeKind::Motion})
      .input(pathInput())
      .input(sectionInput())
      .parameter(
          "edges", &P::edges, whenNone(list(subShape("edge")), "the only curve"),
          "Edges of the path that the section follows, in any order: of a solid, or of a drawing with several curves.")
      .parameter("radius", &P::radius, positiveLength(), "Radius of a round section; unused with a profile.")
      .parameter("centre", &P::centre, choice({"centroid", "origin"}),
                 "Which point of the profile follows the path: the middle of its area or the origin.")
      .parameter("tolerance", &P::tolerance, positiveLength(),
                 "Largest distance from the true tube, measured at equal parameters.")
      .parameter("rows", &P::rows, count(4, 256), "Spans of the control net around; more of them let pulls be narrower.")
      .parameter("columns", &P::columns, count(1, 256), "Spans of the control net along, at least.")
      .parameter("normal", &P::normal, blossom::vector(),
                 "Direction that the x axis of the section points to at the start; 0,0,0: up, or along x where the curve "
                 "starts upward.")
      .example("blossom sweep-along path.step --radius 4 -o tube.json")
      .example("blossom sweep-along block.step --edges path:edge:3 --radius 2 -o bead.json")
      .example("blossom sweep-along path.dxf star.svg --tolerance 0.01 -o rail.json --json")
      .evaluate(evaluateFrame);
}

}  // namespace blossom::sweep
