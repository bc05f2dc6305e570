#include "document/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "core/error.h"
#include "parameter/parameter.h"

namespace blossom {
std::string shownName(const Feature& feature) { return feature.name.empty() ? feature.id : feature.name; }

namespace {

using Pointer = std::shared_ptr<const Feature>;
using List = std::vector<Pointer>;

auto position(const List& features, const FeatureId& id) {
  return std::find_if(features.begin(), features.end(), [&](const Pointer& f) { return f->id == id; });
}

[[noreturn]] void throwNotFound(const List& features, const FeatureId& id) {
  std::vector<std::string> known;
  for (const auto& f : features) known.push_back(f->id);
  const std::string near = nearestName(id, known);
  throw Error(ErrorCode::NotFound, fmt::format("The document has no feature \"{}\".", id),
              near.empty() ? std::string() : fmt::format("Did you mean {}?", near));
}

[[noreturn]] void throwCycle(const Feature& feature) {
  throw Error(ErrorCode::CycleFound, fmt::format("\"{}\" would depend on itself.", shownName(feature)),
              "Choose an input that is not made from this feature.");
}

bool hasInput(const Feature& feature, const FeatureId& id) {
  return std::find(feature.inputs.begin(), feature.inputs.end(), id) != feature.inputs.end();
}

/// The features with every input before its users, otherwise in the order given: depth-first, with a stack of its own, for a
/// file may hold a chain of any length. O(features + inputs).
List sorted(const List& features) {
  enum class Mark { New, Open, Done };
  std::unordered_map<FeatureId, std::pair<const Pointer*, Mark>> byId;
  for (const auto& f : features) byId.emplace(f->id, std::pair{&f, Mark::New});
  List order;
  order.reserve(features.size());
  struct Visit {
    std::pair<const Pointer*, Mark>* node;
    std::size_t nextInput;
  };
  std::vector<Visit> stack;
  const auto enter = [&](std::pair<const Pointer*, Mark>& node) {
    if (node.second == Mark::Open) throwCycle(**node.first);
    if (node.second == Mark::New) node.second = Mark::Open, stack.push_back({&node, 0});
  };
  for (const auto& f : features) {
    enter(byId.at(f->id));
    while (!stack.empty()) {
      Visit& top = stack.back();
      const Feature& feature = **top.node->first;
      if (top.nextInput < feature.inputs.size()) {
        const auto input = byId.find(feature.inputs[top.nextInput++]);
        if (input == byId.end()) throwNotFound(features, feature.inputs[top.nextInput - 1]);
        enter(input->second);
      } else {
        order.push_back(*top.node->first);
        top.node->second = Mark::Done;
        stack.pop_back();
      }
    }
  }
  return order;
}

}  // namespace

Document Document::of(std::vector<Feature> features) {
  std::set<FeatureId> ids;
  Document document;
  for (auto& feature : features) {
    if (feature.id.empty() || !ids.insert(feature.id).second)
      throw Error(ErrorCode::InvalidInput, fmt::format("Two features have the id \"{}\".", feature.id));
    document.features_.push_back(std::make_shared<const Feature>(std::move(feature)));
  }
  document.features_ = sorted(document.features_);
  return document;
}

Document Document::with(Feature feature) const {
  if (feature.id.empty()) throw Error(ErrorCode::InvalidInput, "A feature must have an id.");
  const auto place = static_cast<std::size_t>(position(features_, feature.id) - features_.begin());
  bool ordered = true;
  for (const auto& input : feature.inputs) {
    if (input == feature.id) throwCycle(feature);
    const auto found = position(features_, input);
    if (found == features_.end()) throwNotFound(features_, input);
    ordered = ordered && static_cast<std::size_t>(found - features_.begin()) < place;
  }
  Document result = *this;
  auto pointer = std::make_shared<const Feature>(std::move(feature));
  if (place < features_.size())
    result.features_[place] = std::move(pointer);
  else
    result.features_.push_back(std::move(pointer));
  if (!ordered) result.features_ = sorted(result.features_);
  return result;
}

Document Document::without(const FeatureId& id) const {
  const auto found = position(features_, id);
  if (found == features_.end()) throwNotFound(features_, id);
  if (const auto users = usersOf(id); !users.empty()) {
    std::string names;
    for (const auto& user : users) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", shownName(at(user)));
    throw Error(ErrorCode::InUse, fmt::format("\"{}\" is used by {}.", shownName(**found), names),
                "Delete what uses it first, or give that another input.");
  }
  Document result = *this;
  result.features_.erase(result.features_.begin() + (found - features_.begin()));
  return result;
}

Document Document::moved(const FeatureId& id, std::size_t place) const {
  const auto found = position(features_, id);
  if (found == features_.end()) throwNotFound(features_, id);
  if (place >= features_.size())
    throw Error(ErrorCode::InvalidInput, fmt::format("There is no place {} among {} features.", place, features_.size()));
  Document result = *this;
  const auto from = result.features_.begin() + (found - features_.begin());
  const auto to = result.features_.begin() + static_cast<std::ptrdiff_t>(place);
  if (from < to)
    std::rotate(from, from + 1, to + 1);
  else
    std::rotate(to, from, from + 1);
  const Feature& feature = *result.features_[place];
  for (std::size_t i = 0; i < result.features_.size(); ++i) {
    const Feature& other = *result.features_[i];
    if (i > place && hasInput(feature, other.id))
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("\"{}\" cannot stand before its input \"{}\".", shownName(feature), shownName(other)));
    if (i < place && hasInput(other, id))
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("\"{}\" cannot stand after \"{}\", which uses it.", shownName(feature), shownName(other)));
  }
  return result;
}

Document Document::withAsset(std::string hash, std::shared_ptr<const std::string> content) const {
  Document result = *this;
  result.assets_[std::move(hash)] = std::move(content);
  return result;
}

Document Document::withExtra(Value extra) const {
  Document result = *this;
  result.extra_ = std::move(extra);
  return result;
}

Document Document::withAccess(std::shared_ptr<FileAccess> access) const {
  Document result = *this;
  result.access_ = std::move(access);
  return result;
}

const Feature& Document::at(const FeatureId& id) const {
  const auto found = position(features_, id);
  if (found == features_.end()) throwNotFound(features_, id);
  return **found;
}

bool Document::contains(const FeatureId& id) const { return position(features_, id) != features_.end(); }

std::vector<FeatureId> Document::usersOf(const FeatureId& id) const {
  std::vector<FeatureId> users;
  for (const auto& feature : features_)
    if (hasInput(*feature, id)) users.push_back(feature->id);
  return users;
}

FeatureId Document::freshId(const std::string& command) const {
  std::set<std::string_view> taken;
  for (const auto& feature : features_) taken.insert(feature->id);
  for (std::size_t n = 1;; ++n)
    if (FeatureId id = fmt::format("{}-{}", command, n); !taken.contains(id)) return id;
}

}  // namespace blossom
