#include <algorithm>

#include "ui/fields/color_field.h"
#include "ui/fields/curve_field.h"
#include "ui/fields/file_field.h"
#include "ui/fields/list_field.h"
#include "ui/fields/number_field.h"
#include "ui/fields/parameter_field.h"
#include "ui/fields/record_field.h"
#include "ui/fields/simple_fields.h"
#include "ui/fields/sub_shape_field.h"
#include "ui/fields/vector_field.h"

namespace blossom::ui {

namespace {

bool holdsSubShapes(const ParameterSpec& list) { return list.fields.at(0).kind == ParameterKind::SubShape; }

double startNumber(const ParameterSpec& spec) {
  const double minimum = spec.minimum.value_or(-1e300), maximum = spec.maximum.value_or(1e300);
  const double start = std::clamp(0.0, std::min(minimum, maximum), maximum);
  if (!spec.aboveMinimum || start > minimum) return start;
  return spec.maximum ? (minimum + maximum) / 2 : minimum + 1;
}

}  // namespace

ParameterField* ParameterField::make(const ParameterSpec& spec, QWidget* parent, const Context& context) {
  using enum ParameterKind;
  switch (spec.kind) {
    case Flag:
      return new FlagField(spec, context, parent);
    case Count:
    case Number:
    case Length:
    case Angle:
      return new NumberField(spec, context, parent);
    case Ratio:
      return new RatioField(spec, context, parent);
    case Choice:
      return new ChoiceField(spec, context, parent);
    case Text:
      return new TextField(spec, context, parent);
    case Color:
      return new ColorField(spec, context, parent);
    case Point:
    case Vector:
    case Displacement:
      return new VectorField(spec, context, parent);
    case File:
      return new FileField(spec, context, parent);
    case Curve:
      return new CurveField(spec, context, parent);
    case SubShape:
      return new SubShapeField(spec, context, parent);
    case List:
      if (holdsSubShapes(spec)) return new SubShapeField(spec, context, parent);
      return new ListField(spec, context, parent);
    case Record:
      return new RecordField(spec, context, parent);
  }
  return new TextField(spec, context, parent);
}

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

}  // namespace blossom::ui
