#include "document/edits.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/error.h"
#include "document/file_access.h"
#include "document/file_values.h"
#include "feature/registry.h"

namespace blossom {

namespace {

using Set = std::set<FeatureId>;

Set setOf(const std::vector<FeatureId>& ids) { return {ids.begin(), ids.end()}; }

std::size_t placeOf(const Document& document, const FeatureId& id) {
  const auto features = document.features();
  const auto found = std::find_if(features.begin(), features.end(), [&](const auto& each) { return each->id == id; });
  return static_cast<std::size_t>(found - features.begin());
}

template <class Change>
Document changed(Document document, const Set& ids, const Change& change) {
  for (const FeatureId& id : ids) {
    Feature feature = document.at(id);
    change(feature);
    if (feature != document.at(id)) document = document.with(std::move(feature));
  }
  return document;
}

// Inputs stand before their users, so one walk from the end finds them all.
Set withInputs(const Document& document, const std::vector<FeatureId>& wanted) {
  Set needed = setOf(wanted);
  const auto features = document.features();
  for (auto it = features.rbegin(); it != features.rend(); ++it)
    if (needed.contains((*it)->id)) needed.insert((*it)->inputs.begin(), (*it)->inputs.end());
  return needed;
}

std::string withoutNumber(const std::string& text, char before) {
  const std::size_t cut = text.find_last_not_of("0123456789");
  const bool numbered = cut != std::string::npos && cut + 1 < text.size() && cut > 0 && text[cut] == before;
  return numbered ? text.substr(0, cut) : text;
}

/// Whether both change a shape of one kind, as edits do.
bool editOneKind(const Registry& registry, const Feature& first, const Feature& second) {
  const auto a = registry.find(first.type), b = registry.find(second.type);
  const auto isEdit = [](const FeatureType& type) {
    return type.inputs.size() == 1 && type.inputs.front().use == InputUse::Edited &&
           type.inputs.front().kinds == type.produces;
  };
  return a && b && isEdit(*a) && isEdit(*b) && a->produces == b->produces;
}

bool isSame(const Document& into, const Feature& feature) {
  if (!into.contains(feature.id)) return false;
  const Feature& other = into.at(feature.id);
  return other.type == feature.type && other.parameters == feature.parameters && other.inputs == feature.inputs;
}

/// A file that a feature of `other` names means in `into` the same file, and may be read there only if it might before.
void settleFile(Value& file, const Document& other, Document& into) {
  const FileAccess* const access = other.access().get();
  const std::string path = file.value("path", std::string());
  if (!access || path.empty() || other.assets().contains(file.value("asset", std::string()))) return;
  const std::filesystem::path place = access->resolved(path);
  file["path"] = place.string();
  if (!access->permits(place)) {
    if (!into.access()) into = into.withAccess(FileAccess::everywhere());
    into.access()->refuse(place);
  } else if (into.access()) {
    into.access()->allow(place);
  }
}

}  // namespace

std::vector<FeatureId> dependants(const Document& document, const std::vector<FeatureId>& ids) {
  const Set own = setOf(ids);
  Set made = own;
  std::vector<FeatureId> result;
  for (const auto& feature : document.features()) {
    const auto& inputs = feature->inputs;
    if (std::none_of(inputs.begin(), inputs.end(), [&](const FeatureId& input) { return made.contains(input); })) continue;
    made.insert(feature->id);
    if (!own.contains(feature->id)) result.push_back(feature->id);
  }
  return result;
}

Document withVisible(Document document, const std::vector<FeatureId>& ids, bool visible) {
  return changed(std::move(document), setOf(ids), [&](Feature& feature) { feature.visible = visible; });
}

Document withSuppressed(Document document, const std::vector<FeatureId>& ids, bool suppressed) {
  return changed(std::move(document), setOf(ids), [&](Feature& feature) { feature.suppressed = suppressed; });
}

Document withoutAll(Document document, const std::vector<FeatureId>& ids) {
  std::vector<FeatureId> order;
  order.reserve(ids.size());
  const Set gone = setOf(ids);
  for (const auto& feature : document.features())
    if (gone.contains(feature->id)) order.push_back(feature->id);
  for (auto it = order.rbegin(); it != order.rend(); ++it) document = document.without(*it);
  return document;
}

std::optional<Document> withoutSteps(Document document, const std::vector<FeatureId>& ids) {
  for (const FeatureId& id : ids) {
    const std::vector<FeatureId> inputs = document.at(id).inputs;
    if (inputs.size() != 1) return std::nullopt;
    for (const FeatureId& of : document.usersOf(id)) {
      Feature user = document.at(of);
      if (std::find(user.inputs.begin(), user.inputs.end(), inputs.front()) != user.inputs.end()) return std::nullopt;
      std::replace(user.inputs.begin(), user.inputs.end(), id, inputs.front());
      document = document.with(std::move(user));
    }
    document = document.without(id);
  }
  return document;
}

Document withOnlyVisible(Document document, const std::vector<FeatureId>& ids) {
  const Set shown = setOf(ids);
  Set all;
  for (const auto& feature : document.features()) all.insert(feature->id);
  return changed(std::move(document), all, [&](Feature& feature) { feature.visible = shown.contains(feature.id); });
}

bool areOnlyVisible(const Document& document, const std::vector<FeatureId>& ids) {
  const Set shown = setOf(ids);
  const auto features = document.features();
  return !shown.empty() && std::all_of(features.begin(), features.end(),
                                       [&](const auto& each) { return each->visible == shown.contains(each->id); });
}

// Going down, the last one goes first, so that the ones before it do not have to pass it.
Document withMoved(const Document& document, const std::vector<FeatureId>& ids, std::size_t row) {
  const Set moving = setOf(ids);
  std::vector<FeatureId> before, after;  // the row, those nearest to it first
  const auto features = document.features();
  for (std::size_t i = 0; i < features.size(); ++i)
    if (moving.contains(features[i]->id)) (i < row ? before : after).push_back(features[i]->id);
  std::reverse(before.begin(), before.end());
  Document result = document;
  std::size_t place = row;
  for (const FeatureId& id : before) result = result.moved(id, --place);
  place = row;
  for (const FeatureId& id : after) result = result.moved(id, place++);
  return result;
}

std::optional<Document> withStepped(const Document& document, const std::vector<FeatureId>& ids, int by) {
  if (ids.empty()) return std::nullopt;
  std::size_t first = document.features().size(), last = 0;
  for (const FeatureId& id : ids)
    first = std::min(first, placeOf(document, id)), last = std::max(last, placeOf(document, id));
  if (by < 0) return first == 0 ? std::nullopt : std::optional(withMoved(document, ids, first - 1));
  return last + 1 >= document.features().size() ? std::nullopt : std::optional(withMoved(document, ids, last + 2));
}

std::optional<Document> withEditsExchanged(const Registry& registry, const Document& document, const FeatureId& id, int by) {
  const std::vector<FeatureId> beside = by < 0 ? document.at(id).inputs : document.usersOf(id);
  if (beside.size() != 1) return std::nullopt;
  Feature first = document.at(by < 0 ? beside.front() : id), second = document.at(by < 0 ? id : beside.front());
  if (first.inputs.size() != 1 || second.inputs.size() != 1 || document.usersOf(first.id).size() != 1 ||
      placeOf(document, second.id) != placeOf(document, first.id) + 1 || !editOneKind(registry, first, second))
    return std::nullopt;
  Document result = document;
  second.inputs = std::exchange(first.inputs, {second.id});
  for (const FeatureId& of : document.usersOf(second.id)) {
    Feature user = document.at(of);
    std::replace(user.inputs.begin(), user.inputs.end(), second.id, first.id);
    result = result.with(std::move(user));
  }
  return result.with(second).moved(second.id, placeOf(document, first.id)).with(first);
}

std::string freeName(const Document& document, const std::string& name) {
  std::set<std::string_view> taken;
  for (const auto& feature : document.features()) taken.insert(feature->name);
  if (!taken.contains(name)) return name;
  const std::string stem = withoutNumber(name, ' ');
  for (int n = 2;; ++n)
    if (std::string free = stem + ' ' + std::to_string(n); !taken.contains(free)) return free;
}

Feature newFeature(const Document& document, const FeatureType& type, std::vector<FeatureId> inputs) {
  Feature feature;
  feature.id = document.freshId(type.command);
  feature.type = type.id;
  feature.name = freeName(document, type.title);
  feature.inputs = std::move(inputs);
  return feature;
}

Document withCopies(const Document& into, const Document& clip, const std::vector<FeatureId>& wanted,
                    std::vector<FeatureId>& added) {
  const Set needed = withInputs(clip, wanted), copied = setOf(wanted);
  Document result = into;
  for (const auto& [hash, content] : clip.assets())
    if (!result.assets().contains(hash)) result = result.withAsset(hash, content);
  std::map<FeatureId, FeatureId> renamed;
  for (const auto& each : clip.features()) {
    if (!needed.contains(each->id)) continue;
    Feature copy = *each;
    for (FeatureId& input : copy.inputs) input = renamed.at(input);
    if (!copied.contains(each->id) && isSame(into, copy)) {
      renamed[each->id] = each->id;
      continue;
    }
    if (result.contains(copy.id)) copy.id = result.freshId(withoutNumber(copy.id, '-'));
    copy.name = freeName(result, copy.name);
    renamed[each->id] = copy.id;
    if (copied.contains(each->id)) added.push_back(copy.id);
    result = result.with(std::move(copy));
  }
  return result;
}

Document excerpt(const Document& document, const std::vector<FeatureId>& wanted) {
  const Set needed = withInputs(document, wanted);
  std::vector<Feature> features;
  for (const auto& each : document.features())
    if (needed.contains(each->id)) features.push_back(*each);
  Document result = Document::of(std::move(features));
  for (const auto& [hash, content] : document.assets()) result = result.withAsset(hash, content);
  return result;
}

Document withFeatureOf(const Registry& registry, const Document& into, const Document& other, const FeatureId& wanted,
                       FeatureId* added) {
  const Set needed = withInputs(other, {other.at(wanted).id});
  Document result = into;
  for (const auto& [hash, content] : other.assets()) result = result.withAsset(hash, content);
  std::map<FeatureId, FeatureId> renamed;
  for (const auto& each : other.features()) {
    if (!needed.contains(each->id)) continue;
    Feature copy = *each;
    const auto type = registry.find(copy.type);
    if (result.contains(copy.id))
      copy.id = result.freshId(type ? type->command : copy.type.substr(copy.type.rfind('.') + 1));
    copy.name = freeName(result, copy.name);
    renamed[each->id] = copy.id;
    for (FeatureId& input : copy.inputs) input = renamed.at(input);
    if (type) eachFile(type->parameters, copy.parameters, [&](Value& file) { settleFile(file, other, result); });
    result = result.with(std::move(copy));
  }
  if (added) *added = renamed.at(wanted);
  return result;
}

Document withInserted(Document document, const Feature& edit, const std::vector<FeatureId>& users) {
  const FeatureId source = edit.inputs.front();
  document = document.with(edit);
  for (const FeatureId& id : users) {
    Feature user = document.at(id);
    std::replace(user.inputs.begin(), user.inputs.end(), source, edit.id);
    document = document.with(std::move(user));
  }
  return document;
}

std::vector<FeatureId> usersOfEdited(const Registry& registry, const Document& document, const FeatureId& id) {
  std::vector<FeatureId> users = document.usersOf(id);
  std::erase_if(users, [&](const FeatureId& user) {
    const auto type = registry.find(document.at(user).type);
    const auto isStep = [](const InputSpec& input) { return input.use == InputUse::Step; };
    return type && std::any_of(type->inputs.begin(), type->inputs.end(), isStep);
  });
  return users;
}

const Feature& lastFeature(const Document& document) {
  const auto features = document.features();
  const auto last = std::find_if(features.rbegin(), features.rend(), [](const auto& each) { return !each->suppressed; });
  if (last == features.rend())
    throw Error(ErrorCode::InvalidInput, "The document holds no feature.", "Add one, or choose another document.");
  return **last;
}

}  // namespace blossom
