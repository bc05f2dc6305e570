#include "factor_values.h"

#include "edit_feature.h"

namespace blossom::sweep {

namespace {

constexpr const char *moved = "move", *placed = "place", *turnedBy = "turn", *multiplied = "multiply", *setTo = "set";

ParameterSpec withFallback(ParameterSpec spec, Value fallback) {
  spec.fallback = std::move(fallback);
  return spec;
}

ParameterSpec howOf(const char* relative, const char* absolute, const char* help) {
  return fieldOf("how", withFallback(choice({relative, absolute}), relative), help);
}

std::vector<ParameterSpec> poleOfNet() {
  return {fieldOf("row", count(), "Row of the pole along u, counted from 0."),
          fieldOf("column", count(), "Column of the pole along v, counted from 0.")};
}

Value listed(const Vec3& p) { return Value::array({p.x(), p.y(), p.z()}); }

Vec3 threeOf(const Value& list) { return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()}; }

FactorPole poleOf(const Value& record) {
  return {record.at("row").get<std::size_t>(), record.at("column").get<std::size_t>()};
}

Value recordOf(const FactorPole& pole, bool absolute, const char* relativeName, const char* absoluteName) {
  return Value::object({{"row", static_cast<int>(pole.row)},
                        {"column", static_cast<int>(pole.column)},
                        {"how", absolute ? absoluteName : relativeName}});
}

bool isAbsolute(const Value& record, const char* name) { return record.at("how").get_ref<const std::string&>() == name; }

template <class Change, class ToRecord>
void putList(Value& parameters, const char* name, const std::vector<Change>& changes, const ToRecord& toRecord) {
  if (changes.empty()) return;
  Value list = Value::array();
  for (const Change& change : changes) list.push_back(toRecord(change));
  parameters[name] = std::move(list);
}

}  // namespace

ParameterSpec trajectoryMoves() {
  return list(record({fieldOf("pole", count(), "Pole of the trajectory, counted from 0."),
                      howOf(moved, placed, "Moved by the vector, or placed at it."),
                      fieldOf("vector", displacement(), "How far it is moved, or where it is placed.")}));
}

ParameterSpec trajectoryWeights() {
  return list(record({fieldOf("pole", count(), "Pole of the trajectory, counted from 0."),
                      fieldOf("weight", withFallback(number(), 1.0), "Its new weight, above 0; the pole stays in place.")}));
}

ParameterSpec orientationTurns() {
  std::vector<ParameterSpec> fields = poleOfNet();
  fields.push_back(howOf(turnedBy, setTo, "Turned further, or set to that turn from the fixed axes."));
  fields.push_back(fieldOf("axis", withFallback(vector(), Value::array({0.0, 0.0, 1.0})), "Axis in space."));
  fields.push_back(fieldOf("angle", withFallback(angle(), 0.0), "Angle of the turn, at most 360 degrees."));
  return list(record(std::move(fields)));
}

ParameterSpec scalingChanges() {
  std::vector<ParameterSpec> fields = poleOfNet();
  fields.push_back(howOf(multiplied, setTo, "Multiplied by the factors, or set to them."));
  const Value ones = Value::array({1.0, 1.0, 1.0});
  fields.push_back(fieldOf("factors", withFallback(vector(), ones), "Along the axes x, y and z of the moving frame."));
  fields.push_back(fieldOf("weight", withFallback(number(), 1.0), "What the weight is multiplied by, above 0."));
  return list(record(std::move(fields)));
}

FactorChanges changesOf(const Value& parameters) {
  FactorChanges changes;
  for (const Value& each : parameters.at("trajectory"))
    changes.trajectory.push_back({each.at("pole").get<std::size_t>(), isAbsolute(each, placed), threeOf(each.at("vector"))});
  for (const Value& each : parameters.at("weights"))
    changes.weights.push_back({each.at("pole").get<std::size_t>(), each.at("weight").get<double>()});
  for (const Value& each : parameters.at("orientation"))
    changes.orientation.push_back(
        {poleOf(each), isAbsolute(each, setTo), threeOf(each.at("axis")), each.at("angle").get<double>()});
  for (const Value& each : parameters.at("scaling"))
    changes.scaling.push_back(
        {poleOf(each), isAbsolute(each, setTo), threeOf(each.at("factors")), each.at("weight").get<double>()});
  return changes;
}

Value valuesOf(const FactorChanges& changes) {
  Value parameters = Value::object();
  putList(parameters, "trajectory", changes.trajectory, [](const TrajectoryMove& each) {
    return Value::object(
        {{"pole", static_cast<int>(each.pole)}, {"how", each.absolute ? placed : moved}, {"vector", listed(each.vector)}});
  });
  putList(parameters, "weights", changes.weights, [](const TrajectoryWeight& each) {
    return Value::object({{"pole", static_cast<int>(each.pole)}, {"weight", each.weight}});
  });
  putList(parameters, "orientation", changes.orientation, [](const OrientationTurn& each) {
    Value record = recordOf(each.pole, each.absolute, turnedBy, setTo);
    record["axis"] = listed(each.axis);
    record["angle"] = each.angle;
    return record;
  });
  putList(parameters, "scaling", changes.scaling, [](const ScalingChange& each) {
    Value record = recordOf(each.pole, each.absolute, multiplied, setTo);
    record["factors"] = listed(each.factors);
    record["weight"] = each.weight;
    return record;
  });
  return parameters;
}

}  // namespace blossom::sweep
