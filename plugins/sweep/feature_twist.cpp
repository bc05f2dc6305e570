#include "edit_feature.h"
#include "feature_types.h"
#include "type_ids.h"

namespace blossom::sweep {

namespace {

struct TwistParameters {
  std::vector<Value> places;
  Vec3 axis = Vec3::UnitZ();
  double angle = 30;
  std::vector<Value> pins;
  int fold = 1;
  bool mirror = false;
  int level = 0;
};

Evaluated twistEvaluate(const TwistParameters& p, const Inputs& inputs, const Progress& progress) {
  const MotionTwist edit{placesOf(p.places), p.axis, p.angle, placesOf(p.pins), {p.fold, p.mirror}, p.level};
  return evaluatedEdit(inputs, edit, progress);
}

}  // namespace

FeatureType twistFeature() {
  using P = TwistParameters;
  return feature<P>(twistType, "Twist", "A motion whose frame is turned about an axis at some places.")
      .command("sweep-twist")
      .icon("twist")
      .produces({ShapeKind::Motion})
      .input(motionToEdit())
      .parameter("places", &P::places, list(placeRecord()), "Places on the surface at which the frame turns.")
      .parameter("axis", &P::axis, vector(), "Axis in space, through the trajectory.")
      .parameter("angle", &P::angle, angle(), "Angle of the turn, at most 360 degrees.")
      .parameter("pins", &P::pins, list(placeRecord()), "Places that stay as they are.")
      .parameter("fold", &P::fold, count(1, 360), "How many times the twist is repeated around the motion.")
      .parameter("mirror", &P::mirror, flag(), "Repeat it mirrored, with u reversed.")
      .parameter("level", &P::level, editLevel(), editLevelHelp)
      .example(
          R"(blossom sweep-twist cylinder.json --places '[{"u": 0.125, "v": 0.5}]' --axis 1,1,0 --angle 40 -o twisted.json)")
      .evaluate(twistEvaluate);
}

}  // namespace blossom::sweep
