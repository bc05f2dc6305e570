#include "edit_values.h"

#include "edit_feature.h"
#include "type_ids.h"

namespace blossom::sweep {

namespace {

Vec3 vectorOf(const Value& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

Value arrayOf(const Vec3& p) { return Value::array({p.x(), p.y(), p.z()}); }

std::vector<MotionPlace> placesIn(const Value& parameters, const char* name) {
  return placesOf(parameters.at(name).get<std::vector<Value>>());
}

Value recordsOf(const std::vector<MotionPlace>& places) {
  Value records = Value::array();
  for (const MotionPlace& at : places) records.push_back(Value::object({{"u", at.u}, {"v", at.v}}));
  return records;
}

EditSymmetry symmetryOf(const Value& parameters) {
  return {parameters.at("fold").get<int>(), parameters.at("mirror").get<bool>()};
}

int levelOf(const Value& parameters) { return parameters.at("level").get<int>(); }

}  // namespace

MotionPull pullOf(const Value& parameters) {
  MotionPull edit;
  edit.at = placesIn(parameters, "pulls");
  for (const Value& each : parameters.at("pulls")) edit.to.push_back(vectorOf(each.at("to")));
  edit.weights = {parameters.at("translate").get<double>(), parameters.at("rotate").get<double>(),
                  parameters.at("scale").get<double>()};
  edit.axis = vectorOf(parameters.at("axis"));
  edit.pins = placesIn(parameters, "pins");
  edit.symmetry = symmetryOf(parameters);
  edit.level = levelOf(parameters);
  return edit;
}

MotionTwist twistOf(const Value& parameters) {
  return {placesIn(parameters, "places"), vectorOf(parameters.at("axis")), parameters.at("angle").get<double>(),
          placesIn(parameters, "pins"),   symmetryOf(parameters),          levelOf(parameters)};
}

Value parametersOf(const MotionPull& edit) {
  Value pulls = Value::array();
  for (std::size_t k = 0; k < edit.at.size(); ++k)
    pulls.push_back(Value::object({{"u", edit.at[k].u}, {"v", edit.at[k].v}, {"to", arrayOf(edit.to[k])}}));
  return Value::object({{"pulls", pulls},
                        {"translate", edit.weights.translate},
                        {"rotate", edit.weights.rotate},
                        {"scale", edit.weights.scale},
                        {"fold", edit.symmetry.fold},
                        {"mirror", edit.symmetry.mirror},
                        {"level", edit.level}});
}

Value parametersOf(const MotionTwist& edit) {
  return Value::object({{"places", recordsOf(edit.at)},
                        {"axis", arrayOf(edit.axis)},
                        {"angle", edit.angle},
                        {"fold", edit.symmetry.fold},
                        {"mirror", edit.symmetry.mirror},
                        {"level", edit.level}});
}

Value pinsOf(const MotionEdit& edit) {
  return std::visit([](const auto& each) { return recordsOf(each.pins); }, edit);
}

TakenApart::Step stepOf(const MotionEdit& edit) {
  TakenApart::Step step{twistType, std::visit([](const auto& each) { return parametersOf(each); }, edit)};
  if (const auto* pull = std::get_if<MotionPull>(&edit)) {
    step.type = pullType;
    step.parameters["axis"] = arrayOf(pull->axis);
  }
  step.parameters["pins"] = pinsOf(edit);
  return step;
}

}  // namespace blossom::sweep
