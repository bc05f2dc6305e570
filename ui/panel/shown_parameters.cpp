#include "ui/panel/shown_parameters.h"

#include "core/error.h"
#include "parameter/parameter.h"

namespace blossom::ui {

Value shownParameters(const FeatureType& type, const Feature& feature) {
  Value all = Value::object();
  for (const ParameterSpec& spec : type.parameters) {
    all[spec.name] = spec.fallback;
    const auto given = feature.parameters.find(spec.name);
    if (given == feature.parameters.end() || given->is_null()) continue;
    try {
      all[spec.name] = checked(spec, *given);
    } catch (const Error&) {
      continue;  // the field says what is wrong with it
    }
  }
  return all;
}

}  // namespace blossom::ui
