#include "manipulators/insert_edit.h"

#include <algorithm>

#include "core/error.h"
#include "document/edits.h"
#include "edit_values.h"
#include "type_ids.h"
#include "ui/look/registry_text.h"

namespace blossom::sweep {

namespace {

bool isDirect(const Feature& feature) { return feature.type == pullType || feature.type == twistType; }

/// Makes another motion of one motion: what is seen of it is its last edit.
bool isEdit(const Feature& feature) {
  return isDirect(feature) || feature.type == factorsType || feature.type == refineType;
}

const Motion* motionOf(const ui::ToolHost& host, const FeatureId& id) {
  const auto result = host.result(id);
  return result && !result->error ? result->evaluated.shape.get<Motion>() : nullptr;
}

/// The last of the edits that follow one another; where they branch, the branching one. A growth only watches them.
FeatureId lastOf(const Document& document, FeatureId id) {
  for (;;) {
    std::vector<FeatureId> users = document.usersOf(id);
    std::erase_if(users, [&](const FeatureId& user) { return document.at(user).type == growthType; });
    if (users.size() != 1 || !isEdit(document.at(users.front()))) return id;
    id = users.front();
  }
}

/// As the menu adds it: nothing of it was decided, and nothing is changed by it.
bool isBegun(const Feature& feature, const FeatureType& type) {
  if (feature.type != type.id || feature.suppressed) return false;
  try {
    return completed(type.parameters, feature.parameters) == completed(type.parameters, Value::object());
  } catch (const Error&) {
    return false;
  }
}

Value parametersOf(const MotionEdit& edit, const std::optional<TypedGoal>& typed) {
  Value parameters = std::visit([](const auto& each) { return blossom::sweep::parametersOf(each); }, edit);
  if (typed && std::holds_alternative<MotionPull>(edit)) parameters["pulls"][typed->place]["to"] = typed->written;
  if (typed && std::holds_alternative<MotionTwist>(edit)) parameters["angle"] = typed->written;
  return parameters;
}

std::optional<ChangeableEdit> changeable(const ui::ToolHost& host, const FeatureId& id) {
  const Feature& feature = host.document().at(id);
  if (!isDirect(feature) || feature.suppressed || feature.inputs.size() != 1 || !motionOf(host, id) ||
      !motionOf(host, feature.inputs.front()))
    return std::nullopt;
  ChangeableEdit made{id, {}, host.result(feature.inputs.front())->evaluated.shape, host.result(id)->evaluated.shape};
  try {
    const Value parameters = completed(host.registry().at(feature.type)->parameters, feature.parameters);
    if (feature.type == pullType)
      made.edit = pullOf(parameters);
    else
      made.edit = twistOf(parameters);
  } catch (const std::exception&) {
    return std::nullopt;  // the feature itself says what is wrong with it, or depends on named numbers
  }
  const bool any = std::visit([](const auto& each) { return !each.at.empty(); }, made.edit);
  return any ? std::optional(made) : std::nullopt;
}

}  // namespace

std::optional<EditPlacement> editPlacement(const ui::ToolHost& host, const FeatureId& selected) {
  const Document& document = host.document();
  if (selected.empty() || !document.contains(selected)) return std::nullopt;
  const Feature& feature = document.at(selected);
  EditPlacement placement;
  if (feature.type == sweepType && feature.inputs.size() == 1) {
    placement = {feature.inputs.front(), {selected}};
  } else if (isEdit(feature)) {
    placement.source = lastOf(document, selected);
    for (const FeatureId& user : document.usersOf(placement.source))
      if (document.at(user).type == sweepType) placement.users.push_back(user);
  }
  if (placement.source.empty() || !motionOf(host, placement.source)) return std::nullopt;
  return placement;
}

bool makesSolid(const ui::ToolHost& host, const EditPlacement& placement) {
  if (placement.users.empty()) return false;
  const Value& parameters = host.document().at(placement.users.front()).parameters;
  const auto found = parameters.find("solid");
  return found != parameters.end() && found->is_boolean() && found->get<bool>();
}

std::vector<ChangeableEdit> changeableEdits(const ui::ToolHost& host, const EditPlacement& placement,
                                            const FeatureId& selected) {
  std::vector<ChangeableEdit> edits;
  if (selected != placement.source)
    if (auto earlier = changeable(host, selected)) {
      earlier->isFollowed = true;
      edits.push_back(std::move(*earlier));
    }
  if (auto last = changeable(host, placement.source)) edits.push_back(std::move(*last));
  return edits;
}

Document withEdit(const ui::ToolHost& host, const EditPlacement& placement, const MotionEdit& edit,
                  const std::optional<TypedGoal>& typed) {
  const Document& document = host.document();
  const auto type = host.registry().at(std::holds_alternative<MotionPull>(edit) ? pullType : twistType);
  const bool begun = isBegun(document.at(placement.source), *type);
  Feature feature = begun ? document.at(placement.source) : ui::namedFeature(document, *type, {placement.source});
  feature.parameters = parametersOf(edit, typed);
  if (const Value pins = pinsOf(edit); !pins.empty()) feature.parameters["pins"] = pins;
  if (begun) return document.with(std::move(feature));
  feature.visible = document.at(placement.source).visible;
  return withInserted(document, feature, placement.users);
}

Document withChangedEdit(const ui::ToolHost& host, const FeatureId& id, const MotionEdit& edit,
                         const std::optional<TypedGoal>& typed) {
  Feature feature = host.document().at(id);
  const Value decided = parametersOf(edit, typed);
  for (const auto& [name, value] : decided.items()) feature.parameters[name] = value;
  return host.document().with(std::move(feature));
}

}  // namespace blossom::sweep
