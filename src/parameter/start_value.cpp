#include "parameter/start_value.h"

#include <algorithm>

namespace blossom {
namespace {

double startNumber(const ParameterSpec& spec) {
  const double minimum = spec.minimum.value_or(-1e300), maximum = spec.maximum.value_or(1e300);
  const double start = std::clamp(0.0, std::min(minimum, maximum), maximum);
  if (!spec.aboveMinimum || start > minimum) return start;
  return spec.maximum ? (minimum + maximum) / 2 : minimum + 1;
}

}  // namespace

Value startValue(const ParameterSpec& spec) {
  using enum ParameterKind;
  if (!spec.fallback.is_null()) return spec.fallback;
  switch (spec.kind) {
    case Flag:
      return false;
    case Count:
      return static_cast<std::int64_t>(startNumber(spec));
    case Number:
    case Length:
    case Angle:
      return startNumber(spec);
    case Ratio:
      return std::clamp(0.5, spec.minimum.value_or(0), spec.maximum.value_or(1));
    case Choice:
      return spec.choices.empty() ? Value() : Value(spec.choices.front());
    case Text:
      return "";
    case Color:
      return "#f2a65a";
    case Point:
    case Displacement:
      return Value::array({0.0, 0.0, 0.0});
    case Vector:
      return Value::array({0.0, 0.0, 1.0});
    case Curve:
      return Value::parse("[[0.0, 0.0], [1.0, 1.0]]");
    case List:
      return Value::array();
    case Record: {
      Value record = Value::object();
      for (const ParameterSpec& field : spec.fields)
        record[field.name] = field.mayBeAbsent ? field.fallback : startValue(field);
      return record;
    }
    case File:
    case SubShape:
      return {};
  }
  return {};
}

}  // namespace blossom
