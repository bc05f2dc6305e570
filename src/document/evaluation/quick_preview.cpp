#include "document/evaluation/quick_preview.h"

#include <algorithm>
#include <set>

namespace blossom {

namespace {

constexpr const char* parameter = "preview";
constexpr int cells = 32;

bool canBePreviewed(const Feature& feature, const Registry& registry) {
  const auto type = registry.find(feature.type);
  if (!type || feature.suppressed || feature.parameters.value(parameter, Value(0)) != 0) return false;
  const Value frames = feature.parameters.value(type->playedBy.parameter, Value(0));
  if (frames.is_number() && frames.get<double>() > 0) return false;  // a sequence is not previewed
  return std::any_of(type->parameters.begin(), type->parameters.end(),
                     [](const ParameterSpec& spec) { return spec.name == parameter && spec.kind == ParameterKind::Count; });
}

}  // namespace

std::optional<QuickPreview> quickPreview(const Document& document, const Registry& registry, const FeatureId& changed) {
  std::set<FeatureId> made{changed};
  QuickPreview quick{document, {}};
  for (const auto& feature : document.features()) {
    const auto& inputs = feature->inputs;
    if (std::any_of(inputs.begin(), inputs.end(), [&](const FeatureId& input) { return made.contains(input); }))
      made.insert(feature->id);
    if (!made.contains(feature->id) || !canBePreviewed(*feature, registry)) continue;
    Feature preview = *feature;
    preview.parameters[parameter] = cells;
    quick.document = quick.document.with(std::move(preview));
    quick.last = feature->id;
  }
  if (quick.last.empty()) return std::nullopt;
  return quick;
}

}  // namespace blossom
