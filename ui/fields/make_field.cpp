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

}  // namespace blossom::ui
