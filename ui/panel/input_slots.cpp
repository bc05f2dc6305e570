#include "ui/panel/input_slots.h"

#include <algorithm>

#include "feature/acceptance.h"
#include "ui/session/session.h"

namespace blossom::ui {

InputSlots::InputSlots(const Session& session, const Feature& feature, const FeatureType& type)
    : session_(session), feature_(feature), type_(type), taken_(type.inputs.size()) {
  const auto counts = inputCounts(type, feature.inputs.size(),
                                  [&](std::size_t spec, std::size_t input) { return accepts(spec, feature.inputs[input]); });
  auto next = feature.inputs.begin();
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const auto end = next + static_cast<std::ptrdiff_t>(counts[k]);
    taken_[k].assign(next, end);
    next = end;
  }
}

bool InputSlots::accepts(std::size_t spec, const FeatureId& id) const {
  const auto view = session_.view(id);
  if (!view || view->result->evaluated.shape.empty()) return true;
  return blossom::accepts(type_.inputs.at(spec), view->result->evaluated.shape);
}

bool InputSlots::dependsOnThis(const FeatureId& id) const {
  if (id == feature_.id) return true;
  std::vector<FeatureId> open{id}, seen;
  while (!open.empty()) {
    const FeatureId at = open.back();
    open.pop_back();
    if (std::find(seen.begin(), seen.end(), at) != seen.end() || !session_.document().contains(at)) continue;
    seen.push_back(at);
    for (const FeatureId& input : session_.document().at(at).inputs) {
      if (input == feature_.id) return true;
      open.push_back(input);
    }
  }
  return false;
}

std::vector<FeatureId> InputSlots::candidates(std::size_t spec) const {
  std::vector<FeatureId> found;
  for (const auto& other : session_.document().features()) {
    const auto& taken = taken_.at(spec);
    const bool mayBeTwice = type_.inputs.at(spec).use == InputUse::Control;
    if (!mayBeTwice && std::find(taken.begin(), taken.end(), other->id) != taken.end()) continue;
    if (accepts(spec, other->id) && !dependsOnThis(other->id)) found.push_back(other->id);
  }
  return found;
}

std::vector<FeatureId> InputSlots::with(std::size_t spec, const std::vector<FeatureId>& inputs) const {
  std::vector<FeatureId> all;
  for (std::size_t k = 0; k < taken_.size(); ++k) {
    const auto& part = k == spec ? inputs : taken_[k];
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace blossom::ui
