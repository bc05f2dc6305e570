#include "transport/motion_edit_transport.h"

#include "transport/numbers.h"

namespace blossom {

namespace {

Value placesValue(const std::vector<MotionPlace>& places) {
  Value all = Value::array();
  for (const MotionPlace& each : places) all.push_back(Value::array({each.u, each.v}));
  return all;
}

std::vector<MotionPlace> toPlaces(const Value& all) {
  std::vector<MotionPlace> places;
  for (const Value& each : all) places.push_back({each.at(0).get<double>(), each.at(1).get<double>()});
  return places;
}

Value editValue(const MotionPull& p) {
  return {{"to", vectorsValue(p.to)},
          {"weights", {p.weights.translate, p.weights.rotate, p.weights.scale}},
          {"axis", vectorValue(p.axis)}};
}

Value editValue(const MotionTwist& t) { return {{"axis", vectorValue(t.axis)}, {"angle", t.angle}}; }

MotionEdit toMotionEdit(const Value& v) {
  const auto common = [&](auto edit) -> MotionEdit {
    edit.at = toPlaces(v.at("at"));
    edit.axis = toVector<Vec3>(v.at("axis"));
    edit.pins = toPlaces(v.at("pins"));
    edit.symmetry = {v.at("fold").get<int>(), v.at("mirror").get<bool>()};
    edit.level = v.at("level").get<int>();
    return edit;
  };
  if (v.contains("angle")) {
    MotionTwist twist;
    twist.angle = v.at("angle").get<double>();
    return common(twist);
  }
  MotionPull pull;
  pull.to = toVectors<Vec3>(v.at("to"));
  const Value& w = v.at("weights");
  pull.weights = {w.at(0).get<double>(), w.at(1).get<double>(), w.at(2).get<double>()};
  return common(pull);
}

}  // namespace

Value motionEditsValue(const std::vector<MotionEdit>& edits) {
  Value all = Value::array();
  for (const MotionEdit& each : edits)
    all.push_back(std::visit(
        [](const auto& edit) {
          Value v = editValue(edit);
          v["at"] = placesValue(edit.at);
          v["pins"] = placesValue(edit.pins);
          v["fold"] = edit.symmetry.fold;
          v["mirror"] = edit.symmetry.mirror;
          v["level"] = edit.level;
          return v;
        },
        each));
  return all;
}

std::vector<MotionEdit> toMotionEdits(const Value& all) {
  std::vector<MotionEdit> edits;
  for (const Value& each : all) edits.push_back(toMotionEdit(each));
  return edits;
}

}  // namespace blossom
