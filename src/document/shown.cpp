#include "document/shown.h"

#include "feature/acceptance.h"
#include "feature/registry.h"

namespace blossom {

namespace {

bool hasShape(const Shape* shape) { return shape && !shape->empty(); }

}  // namespace

InputsByUse inputsByUse(const Feature& feature, const Registry& registry, const ShapeOf& shapeOf) {
  InputsByUse found;
  const auto type = registry.find(feature.type);
  if (feature.suppressed || !type || type->inputs.empty() || !hasShape(shapeOf(feature.id))) return found;
  const auto counts = inputCounts(*type, feature.inputs.size(), [&](std::size_t spec, std::size_t input) {
    const Shape* shape = shapeOf(feature.inputs[input]);
    return !hasShape(shape) || accepts(type->inputs[spec], *shape);
  });
  std::size_t next = 0;
  for (std::size_t k = 0; k < counts.size(); ++k)
    for (const std::size_t end = next + counts[k]; next < end; ++next) {
      const FeatureId& input = feature.inputs[next];
      const Shape* shape = shapeOf(input);
      if (type->inputs[k].use == InputUse::Control) found.controls.push_back(input);
      if (hasShape(shape) && consumes(type->inputs[k], *shape)) found.consumed.push_back(input);
    }
  return found;
}

std::set<FeatureId> usedUp(const Document& document, const Registry& registry, const ShapeOf& shapeOf) {
  std::set<FeatureId> used;
  const auto features = document.features();
  for (auto it = features.rbegin(); it != features.rend(); ++it) {  // users before what they use
    const Feature& feature = **it;
    const auto inputs = inputsByUse(feature, registry, shapeOf).consumed;
    used.insert(inputs.begin(), inputs.end());
    // One that is suppressed passes the shape of its first input on.
    if (feature.suppressed && !feature.inputs.empty() && used.contains(feature.id)) used.insert(feature.inputs.front());
  }
  return used;
}

std::vector<FeatureId> shownFeatures(const Document& document, const Registry& registry, const ShapeOf& shapeOf) {
  const std::set<FeatureId> used = usedUp(document, registry, shapeOf);
  std::vector<FeatureId> shown;
  for (const auto& feature : document.features())
    if (feature->visible && !feature->suppressed && !used.contains(feature->id) && hasShape(shapeOf(feature->id)))
      shown.push_back(feature->id);
  return shown;
}

}  // namespace blossom
