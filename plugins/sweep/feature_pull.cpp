#include "edit_feature.h"
#include "feature_types.h"
#include "type_ids.h"

namespace blossom::sweep {

namespace {

struct PullParameters {
  std::vector<Value> pulls;
  double translate = 0, rotate = 1, scale = 1;
  std::vector<Value> pins;
  int fold = 1;
  bool mirror = false;
  int level = 0;
  Vec3 axis = Vec3::Zero();
};

Evaluated pullEvaluate(const PullParameters& p, const Inputs& inputs, const Progress& progress) {
  MotionPull edit;
  edit.at = placesOf(p.pulls);
  for (const Value& each : p.pulls) {
    const Value& to = each.at("to");
    edit.to.emplace_back(to.at(0).get<double>(), to.at(1).get<double>(), to.at(2).get<double>());
  }
  edit.weights = {p.translate, p.rotate, p.scale};
  edit.axis = p.axis;
  edit.pins = placesOf(p.pins);
  edit.symmetry = {p.fold, p.mirror};
  edit.level = p.level;
  return evaluatedEdit(inputs, edit, progress);
}

ParameterSpec pullList() {
  ParameterSpec pull = placeRecord();
  pull.fields.push_back(fieldOf("to", pointInSpace(), "Where that place is to go."));
  return list(pull);
}

}  // namespace

FeatureType pullFeature() {
  using P = PullParameters;
  return feature<P>(pullType, "Pull", "A motion whose swept surface is pulled to targets, by moving, turning and scaling.")
      .command("sweep-pull")
      .icon("pull")
      .produces({ShapeKind::Motion})
      .input(motionToEdit())
      .parameter("pulls", &P::pulls, pullList(), "Places on the surface and their targets.")
      .parameter("translate", &P::translate, ratio(),
                 "Share of the way that the trajectory goes; sections at that height go with it.")
      .parameter("rotate", &P::rotate, ratio(),
                 "Share of the angle left, seen from the trajectory, by which the frame turns.")
      .parameter("scale", &P::scale, ratio(),
                 "Share of the way left that scaling goes. The last of the three above 0 counts as 1.")
      .parameter("pins", &P::pins, list(placeRecord()), "Places that stay where they are.")
      .parameter("fold", &P::fold, count(1, 360), "How many times the pull is repeated around the motion.")
      .parameter("mirror", &P::mirror, flag(), "Repeat it mirrored, with u reversed.")
      .parameter("level", &P::level, editLevel(), editLevelHelp)
      .parameter("axis", &P::axis, vector(), "Axis for a turn to the opposite side; 0,0,0 for none.")
      .example(R"(blossom sweep-pull cylinder.json --pulls '[{"u": 0.125, "v": 0.5, "to": [30, 30, 20]}]' -o pulled.json)")
      .example(
          R"(blossom sweep-pull cylinder.json --pulls '[{"u": 0.125, "v": 0.5, "to": [30, 30, 20]}]' --fold 4 -o blades.json)")
      .example(
          R"(blossom sweep-pull cylinder.json --pulls '[{"u": 0.125, "v": 0.5, "to": [14, 14, 20]}]' --level 2 -o spike.json)")
      .evaluate(pullEvaluate);
}

}  // namespace blossom::sweep
