#include "edit_feature.h"
#include "factor_values.h"
#include "feature_types.h"
#include "kernel/edit/apply_edits.h"
#include "type_ids.h"

namespace blossom::sweep {

namespace {

struct FactorsParameters {
  std::vector<Value> trajectory, weights, orientation, scaling;
};

Evaluated factorsEvaluate(const FactorsParameters& p, const Inputs& inputs, const Progress& progress) {
  const FactorChanges changes = changesOf(Value::object(
      {{"trajectory", p.trajectory}, {"weights", p.weights}, {"orientation", p.orientation}, {"scaling", p.scaling}}));
  const Motion& given = inputs.get<Motion>();
  validate(given);
  Evaluated out;
  if (!given.edits.empty()) out.stats["edits"] = given.edits.size();
  FactorChangeResult result = withChangedFactors(withEditsApplied(given, progress), changes, progress);
  if (changes.empty()) out.warnings.emplace_back("Nothing is changed yet: there is no pole.");
  out.stats["moved_poles"] = result.changedPoles;
  out.shape = std::move(result.motion);
  return out;
}

}  // namespace

FeatureType factorsFeature() {
  using P = FactorsParameters;
  return feature<P>(factorsType, "Factors",
                    "A motion with single poles and weights of trajectory, orientation and scaling changed.")
      .command("sweep-factors")
      .icon("factors")
      .produces({ShapeKind::Motion})
      .input(motionToEdit())
      .parameter("trajectory", &P::trajectory, whenNone(trajectoryMoves(), "none"),
                 "Poles of the trajectory that are moved or placed.")
      .parameter("weights", &P::weights, whenNone(trajectoryWeights(), "none"), "Weights of poles of the trajectory.")
      .parameter("orientation", &P::orientation, whenNone(orientationTurns(), "none"),
                 "Poles of the orientation that are turned, or set.")
      .parameter("scaling", &P::scaling, whenNone(scalingChanges(), "none"),
                 "Poles of the scaling that are multiplied, or set.")
      .keywords({"poles", "weights", "control net", "control points"})
      .example(
          R"(blossom sweep-factors cylinder.json --scaling '[{"row": 2, "column": 3, "factors": [2, 2, 1]}]' -o bump.json)")
      .example(
          R"(blossom sweep-factors cylinder.json --trajectory '[{"pole": 1, "vector": [8, 0, 0]}]' --weights '[{"pole": 1, "weight": 2}]' -o bent.json)")
      .evaluate(factorsEvaluate);
}

}  // namespace blossom::sweep
