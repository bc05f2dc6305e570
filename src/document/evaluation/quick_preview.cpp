#include "document/evaluation/quick_preview.h"

#include <algorithm>
#include <set>

namespace blossom {

namespace {

constexpr int cells = 32;

/// Nothing when the feature has no previews, is one already, or makes a sequence.
std::optional<Feature> previewOf(const Feature& feature, const Registry& registry) {
  const auto type = registry.find(feature.type);
  if (!type || type->previewedBy.empty() || feature.suppressed) return std::nullopt;
  if (feature.parameters.value(type->previewedBy, Value(0)) != 0) return std::nullopt;
  const Value frames = feature.parameters.value(type->playedBy.parameter, Value(0));
  if (frames.is_number() && frames.get<double>() > 0) return std::nullopt;
  Feature preview = feature;
  preview.parameters[type->previewedBy] = cells;
  return preview;
}

}  // namespace

std::optional<QuickPreview> quickPreview(const Document& document, const Registry& registry, const FeatureId& changed) {
  std::set<FeatureId> made{changed};
  QuickPreview quick{document, {}};
  for (const auto& feature : document.features()) {
    const auto& inputs = feature->inputs;
    if (std::any_of(inputs.begin(), inputs.end(), [&](const FeatureId& input) { return made.contains(input); }))
      made.insert(feature->id);
    if (!made.contains(feature->id)) continue;
    if (auto preview = previewOf(*feature, registry)) {
      quick.document = quick.document.with(*std::move(preview));
      quick.last = feature->id;
    }
  }
  if (quick.last.empty()) return std::nullopt;
  return quick;
}

}  // namespace blossom
