#include "manipulators/factors/factor_place.h"

#include <algorithm>

#include "core/error.h"
#include "document/edits.h"
#include "factor_values.h"
#include "type_ids.h"
#include "ui/look/registry_text.h"

namespace blossom::sweep {

namespace {

bool isMotion(const ui::ToolHost& host, const FeatureId& id) {
  const auto result = host.result(id);
  return result && !result->error && result->evaluated.shape.kind() == ShapeKind::Motion;
}

bool changesMotion(const Feature& feature) {
  return feature.type == pullType || feature.type == twistType || feature.type == factorsType || feature.type == refineType;
}

/// A new feature between the motion and its sweeps.
Document inserted(const ui::ToolHost& host, const EditPlacement& placement, const char* typeId, Value parameters) {
  const Document& document = host.document();
  Feature feature = ui::namedFeature(document, *host.registry().at(typeId), {placement.source});
  feature.parameters = std::move(parameters);
  feature.visible = document.at(placement.source).visible;
  return withInserted(document, feature, placement.users);
}

/// Numbers that depend on named ones, and whatever else only its user can change.
bool hasExpressions(const Value& value, int depth = 0) {
  constexpr int ofRecord = 2;  // parameters, list, record
  if (value.is_object() && depth > ofRecord) return true;
  if (!value.is_structured()) return false;
  return std::any_of(value.begin(), value.end(), [&](const Value& part) { return hasExpressions(part, depth + 1); });
}

const Feature* lastWhen(const ui::ToolHost& host, const EditPlacement& placement, const char* type) {
  const Feature& feature = host.document().at(placement.source);
  return feature.type == type && !feature.suppressed && !hasExpressions(feature.parameters) ? &feature : nullptr;
}

const char* nameOfFactor(Factor factor) {
  return factor == Factor::Trajectory ? "trajectory" : factor == Factor::Orientation ? "orientation" : "scaling";
}

}  // namespace

FeatureId featureOfFactors(const ui::ToolHost& host, const FeatureId& given) {
  const std::vector<FeatureId> selected = host.selection();
  FeatureId id = !given.empty() ? given : selected.size() == 1 ? selected.front() : FeatureId();
  const bool there = !id.empty() && host.document().contains(id);
  if (there && (host.document().at(id).type == sweepType || changesMotion(host.document().at(id)) || isMotion(host, id)))
    return id;
  throw Error(ErrorCode::InvalidInput, "The factors to edit are those of a motion, and none is selected.",
              "Select a sweep, or a motion, and try again.");
}

std::optional<EditPlacement> factorPlacement(const ui::ToolHost& host, const FeatureId& selected) {
  if (auto placement = editPlacement(host, selected)) return placement;
  if (!host.document().contains(selected) || !isMotion(host, selected)) return std::nullopt;
  EditPlacement placement{selected, {}};
  const Document& document = host.document();
  for (std::vector<FeatureId> users = document.usersOf(selected);
       users.size() == 1 && changesMotion(document.at(users.front())); users = document.usersOf(placement.source))
    placement.source = users.front();
  if (!isMotion(host, placement.source)) return std::nullopt;
  for (const FeatureId& user : document.usersOf(placement.source))
    if (document.at(user).type == sweepType) placement.users.push_back(user);
  return placement;
}

Document withFactorChanges(const ui::ToolHost& host, const EditPlacement& placement, const FactorChanges& changes) {
  const Feature* const last = lastWhen(host, placement, factorsType);
  if (!last) return inserted(host, placement, factorsType, valuesOf(changes));
  Feature changed = *last;
  const Value complete = completed(host.registry().at(factorsType)->parameters, last->parameters);
  const Value joined = valuesOf(followedBy(changesOf(complete), changes));
  for (const auto& [name, value] : joined.items()) changed.parameters[name] = value;
  return host.document().with(std::move(changed));
}

Document withFactorKnot(const ui::ToolHost& host, const EditPlacement& placement, Factor factor, bool alongU, double knot) {
  const char* const direction = alongU ? "u" : "v";
  const Feature* const last = lastWhen(host, placement, refineType);
  if (!last || last->parameters.value("factors", std::string("all")) != nameOfFactor(factor))
    return inserted(host, placement, refineType,
                    Value::object({{direction, Value::array({knot})}, {"factors", nameOfFactor(factor)}}));
  Feature changed = *last;
  if (!changed.parameters.contains(direction)) changed.parameters[direction] = Value::array();
  changed.parameters[direction].push_back(knot);
  return host.document().with(std::move(changed));
}

}  // namespace blossom::sweep
