#include "edit_feature.h"

#include "kernel/edit/apply_edits.h"

namespace blossom::sweep {

InputSpec motionToEdit() {
  return {.name = "motion",
          .help = "The motion to edit; edits of its file are applied first.",
          .kinds = {ShapeKind::Motion},
          .use = InputUse::Edited,
          .asks = "a motion to edit"};
}

ParameterSpec fieldOf(const char* name, ParameterSpec spec, const char* help) {
  spec.name = name;
  spec.help = help;
  return spec;
}

ParameterSpec editLevel() { return count(coarsestLevel, finestLevel); }

ParameterSpec placeRecord() {
  return record({fieldOf("u", number(), "Parameter around the surface."), fieldOf("v", number(), "Parameter along it.")});
}

std::vector<MotionPlace> placesOf(const std::vector<Value>& records) {
  std::vector<MotionPlace> places;
  places.reserve(records.size());
  for (const Value& each : records) places.push_back({each.at("u").get<double>(), each.at("v").get<double>()});
  return places;
}

Evaluated evaluatedEdit(const Inputs& inputs, const MotionEdit& edit, const Progress& progress) {
  const Motion& given = inputs.get<Motion>();
  validate(given);
  Evaluated out;
  if (!given.edits.empty()) out.stats["edits"] = given.edits.size();
  Motion before = withEditsApplied(given, progress);
  if (std::visit([](const auto& each) { return each.at.empty(); }, edit)) {
    out.warnings.emplace_back("Nothing is edited yet: there is no place.");
    out.shape = std::move(before);
    return out;
  }
  EditResult result = edited(before, edit, progress);
  out.stats["remainder"] = result.remainder;
  out.stats["moved_poles"] = result.movedPoles;
  const auto warn = [&](const Explanation& reason) { out.warnings.push_back(reason.what + " " + reason.remedy); };
  for (const Obstacle& obstacle : result.obstacles) warn(explain(obstacle));
  if (result.swing > wildSwing) warn(explainSwing(result.swing));
  out.shape = std::move(result.motion);
  return out;
}

}  // namespace blossom::sweep
