#include "ui/panel/input_slots.h"

#include <algorithm>
#include <set>
#include <utility>

#include "document/edits.h"
#include "feature/acceptance.h"
#include "feature/input_items.h"
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

Feature InputSlots::with(std::size_t spec, const std::vector<FeatureId>& inputs) const {
  Feature changed = feature_;
  changed.inputs.clear();
  for (std::size_t k = 0; k < taken_.size(); ++k) {
    const auto& part = k == spec ? inputs : taken_[k];
    changed.inputs.insert(changed.inputs.end(), part.begin(), part.end());
  }
  const std::vector<FeatureId>& before = taken_.at(spec);
  changed.parameters = withItemsOfShapes(type_, std::move(changed.parameters), type_.inputs.at(spec).name,
                                         formerPlaces(before, inputs), before.size());
  return changed;
}

namespace {

/// Nothing where it needs one of them.
std::optional<Feature> withoutThem(const Session& session, Feature feature, const std::vector<FeatureId>& ids) {
  const auto type = session.app().registry->find(feature.type);
  if (!type) return std::nullopt;
  for (std::size_t spec = 0; spec < type->inputs.size(); ++spec) {
    const InputSlots now(session, feature, *type);
    std::vector<FeatureId> stay = now.of(spec);
    const auto gone =
        std::erase_if(stay, [&](const FeatureId& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); });
    if (gone == 0) continue;
    if (stay.size() < type->inputs[spec].minimum) return std::nullopt;
    feature = now.with(spec, stay);
  }
  return feature;
}

}  // namespace

std::optional<Document> withoutInputs(const Session& session, const std::vector<FeatureId>& ids) {
  Document document = session.document();
  std::set<FeatureId> users;
  for (const FeatureId& id : ids)
    for (const FeatureId& user : document.usersOf(id))
      if (std::find(ids.begin(), ids.end(), user) == ids.end()) users.insert(user);
  for (const FeatureId& user : users) {
    const auto changed = withoutThem(session, document.at(user), ids);
    if (!changed) return std::nullopt;
    document = document.with(*changed);
  }
  return withoutAll(std::move(document), ids);
}

}  // namespace blossom::ui
