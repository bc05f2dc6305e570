#include "ui/panel/shown_parameters.h"

#include "app/import_feature.h"
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

namespace {

/// Beside a list that says which one shape is made, neither t nor its keys count. One that the document holds all the same
/// can still be taken back: a warning may tell of it.
bool hasTime(const ParameterSpec& spec, const FeatureType& type, const Feature& feature) {
  const PlayedBy& played = type.playedBy;
  if (played.excludedBy.empty() || (spec.name != "t" && spec.name != played.keys)) return true;
  const auto list = feature.parameters.find(played.excludedBy), own = feature.parameters.find(spec.name);
  const bool excluded = list != feature.parameters.end() && !list->empty();
  return !excluded || (own != feature.parameters.end() && *own != spec.fallback);
}

}  // namespace

// An import shows the options of the format that its file has, and not those of the others.
bool saysAnything(const ParameterSpec& spec, const FeatureType& type, const Feature& feature, const FormatRegistry& formats,
                  const std::function<bool(const std::string& input)>& isGiven) {
  const InputCondition& beside = spec.inputCondition;
  if (!beside.input.empty() && isGiven(beside.input) != beside.given) return false;
  if (!applies(spec, type.parameters, feature.parameters) || !hasTime(spec, type, feature)) return false;
  if (feature.type != "exchange.import") return true;
  const auto file = feature.parameters.find("file");
  const bool named = file != feature.parameters.end() && file->is_object();
  return importUses(formats, spec.name, named ? file->value("path", std::string()) : std::string());
}

}  // namespace blossom::ui
