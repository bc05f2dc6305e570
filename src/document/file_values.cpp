#include "document/file_values.h"

#include <algorithm>

namespace blossom {
namespace {

bool isText(const Value& value, const char* key) { return !value.contains(key) || value.at(key).is_string(); }

}  // namespace

bool hasFileParameter(const std::vector<ParameterSpec>& specs) {
  return std::any_of(specs.begin(), specs.end(), [](const ParameterSpec& spec) {
    return spec.kind == ParameterKind::File || hasFileParameter(spec.fields);
  });
}

void eachFile(const ParameterSpec& spec, Value& value, const std::function<void(Value& file)>& visit) {
  if (spec.kind == ParameterKind::List && value.is_array() && !spec.fields.empty()) {
    for (Value& element : value) eachFile(spec.fields.front(), element, visit);
  } else if (spec.kind == ParameterKind::Record && value.is_object()) {
    eachFile(spec.fields, value, visit);
  } else if (spec.kind == ParameterKind::File) {
    if (value.is_string()) value = Value{{"path", value}, {"asset", ""}};
    if (value.is_object() && isText(value, "path") && isText(value, "asset")) visit(value);
  }
}

void eachFile(const std::vector<ParameterSpec>& specs, Value& parameters, const std::function<void(Value& file)>& visit) {
  for (const ParameterSpec& spec : specs)
    if (const auto found = parameters.find(spec.name); found != parameters.end()) eachFile(spec, *found, visit);
}

}  // namespace blossom
