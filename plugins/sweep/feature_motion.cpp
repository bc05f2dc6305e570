#include "core/error.h"
#include "feature_types.h"
#include "kernel/begin/motion_knots.h"
#include "kernel/begin/primitive_motions.h"
#include "kernel/edit/apply_edits.h"
#include "type_ids.h"

namespace blossom::sweep {

namespace {

struct PrimitiveParameters {
  PrimitiveKind kind = PrimitiveKind::Cylinder;
  double radius = 20, profile = 6, topRadius = 10, width = 60, height = 40, angle = 120, turns = 2;
  int rows = 12, columns = 8;
};

ParameterSpec partOfATurn() {
  ParameterSpec spec = angle();
  spec.minimum = 0;
  spec.aboveMinimum = true;
  spec.maximum = 359;
  return spec;
}

void addNet(const Motion& motion, Value& stats) {
  stats["poles_u"] = motion.orientation.countU();
  stats["poles_v"] = motion.orientation.countV();
}

Evaluated evaluatePrimitive(const PrimitiveParameters& p, const Inputs&, const Progress& progress) {
  progress.check();
  // No turns are allowed by the field and refused by the kernel, for any kind: those of others than a helicoid do not count.
  PrimitiveResult made = primitiveMotion({.kind = p.kind,
                                          .radius = p.radius,
                                          .profile = p.profile,
                                          .topRadius = p.topRadius,
                                          .width = p.width,
                                          .height = p.height,
                                          .angle = p.angle,
                                          .turns = p.kind == PrimitiveKind::Helicoid ? p.turns : PrimitiveOptions().turns,
                                          .rows = static_cast<std::size_t>(p.rows),
                                          .columns = static_cast<std::size_t>(p.columns)});
  Evaluated out;
  addNet(made.motion, out.stats);
  out.stats["deviation"] = made.deviation;
  out.shape = std::move(made.motion);
  return out;
}

enum class Factors { All, Orientation, Scaling, Trajectory };

struct RefineParameters {
  std::vector<double> u = {}, v = {};
  Factors factors = Factors::All;
};

Evaluated evaluateRefine(const RefineParameters& p, const Inputs& inputs, const Progress& progress) {
  progress.check();
  const Motion& given = inputs.get<Motion>();
  validate(given);
  if (p.factors == Factors::Trajectory && !p.u.empty())
    throw Error(ErrorCode::InvalidParameter, "The trajectory has knots in v alone; knots in u are given.",
                "Leave u empty, or choose other factors.");
  // More knots are finer levels, at which the same edits would change other parts.
  const Motion motion = withEditsApplied(given, progress);
  const auto gets = [&](Factors factor) { return p.factors == Factors::All || p.factors == factor; };
  Motion fine = withKnots(motion, {.u = p.u,
                                   .v = p.v,
                                   .trajectory = gets(Factors::Trajectory),
                                   .orientation = gets(Factors::Orientation),
                                   .scaling = gets(Factors::Scaling)});
  validate(fine);
  Evaluated out;
  if (!given.edits.empty()) out.stats["edits"] = given.edits.size();
  addNet(fine, out.stats);
  out.shape = std::move(fine);
  return out;
}

}  // namespace

FeatureType primitiveFeature() {
  using P = PrimitiveParameters;
  return feature<P>(primitiveType, "Plain motion",
                    "A motion that sweeps a plain shape, with poles to pull it by: a beginning without any file.")
      .command("sweep-motion")
      .icon("motion")
      .produces({ShapeKind::Motion})
      .parameter("kind", &P::kind, choice({"cylinder", "cone", "sphere", "torus", "tube", "helicoid", "plane", "sheet"}),
                 "The shape: a tube is a bent one, a sheet an arched one.")
      .parameter("radius", &P::radius,
                 onlyFor(positiveLength(), "kind", {"cylinder", "cone", "sphere", "torus", "tube", "helicoid", "sheet"}),
                 "Radius; of a torus or a tube, that of the ring or the bend.")
      .parameter("profile", &P::profile, onlyFor(positiveLength(), "kind", {"torus", "tube"}),
                 "Radius of the section of a torus or a tube.")
      .parameter("top-radius", &P::topRadius, onlyFor(lengthFromZero(), "kind", {"cone"}),
                 "Radius of a cone at its top; 0 makes a point.")
      .parameter("width", &P::width, onlyFor(positiveLength(), "kind", {"plane"}), "Length of a plane along x.")
      .parameter("height", &P::height, onlyFor(positiveLength(), "kind", {"cylinder", "cone", "helicoid", "plane", "sheet"}),
                 "Length along the axis; of a plane, along y.")
      .parameter("angle", &P::angle, onlyFor(partOfATurn(), "kind", {"tube", "sheet"}),
                 "How far a tube bends or a sheet arches.")
      .parameter("turns", &P::turns, onlyFor(number(-100, 100), "kind", {"helicoid"}),
                 "Turns of a helicoid; below 0: clockwise.")
      .parameter("rows", &P::rows, count(1, 256),
                 "Spans of the control net in u; at least 4 around. More of them let pulls be narrower.")
      .parameter("columns", &P::columns, count(1, 256), "Spans of the control net in v.")
      .example("blossom sweep-motion --radius 10 --height 36 --rows 16 --columns 10 -o hub.json")
      .example("blossom sweep-motion --kind torus --radius 30 --profile 8 -o ring.json")
      .evaluate(evaluatePrimitive);
}

FeatureType refineFeature() {
  using P = RefineParameters;
  return feature<P>(refineType, "Refine motion", "The same motion with more poles, so that pulls move smaller parts of it.")
      .command("sweep-refine")
      .icon("refine-motion")
      .produces({ShapeKind::Motion})
      .input({.name = "motion",
              .help = "A motion: trajectory, orientation and scaling.",
              .kinds = {ShapeKind::Motion},
              .use = InputUse::Edited,
              .asks = "a motion to refine"})
      .parameter("u", &P::u, whenNone(list(number()), "none"),
                 "Knots to insert in u; one that is repeated lets a pull crease.")
      .parameter("v", &P::v, whenNone(list(number()), "none"), "Knots to insert in v.")
      .parameter("factors", &P::factors, choice({"all", "orientation", "scaling", "trajectory"}),
                 "The factors that get them; the trajectory has knots in v alone.")
      .example("blossom sweep-refine hub.json --u 0.45,0.55 --v 0.5 -o fine.json")
      .evaluate(evaluateRefine);
}

}  // namespace blossom::sweep
