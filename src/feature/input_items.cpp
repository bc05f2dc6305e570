#include "feature/input_items.h"

#include <algorithm>
#include <utility>

#include "feature/feature_type.h"
#include "parameter/start_value.h"

namespace blossom {
namespace {

/// Items that shapes had in the order in which they are now; those between them that none was given for begin as new ones.
Value inOrderOf(const FormerPlaces& places, const Value& items, const ParameterSpec& item) {
  const auto itemOf = [&](std::size_t shape) {
    const auto& place = places[shape];
    return place && *place < items.size() ? std::optional(items[*place]) : std::nullopt;
  };
  std::size_t count = places.size();
  while (count > 0 && !itemOf(count - 1)) --count;
  Value ordered = Value::array();
  for (std::size_t shape = 0; shape < count; ++shape) ordered.push_back(itemOf(shape).value_or(startValue(item)));
  return ordered;
}

/// Without the items of shapes that are gone, the first of which have none.
Value withoutGone(const FormerPlaces& places, std::size_t before, Value items, int more) {
  for (std::size_t shape = before; shape-- > 0;) {
    if (std::find(places.begin(), places.end(), std::optional(shape)) != places.end()) continue;
    const std::size_t item = std::max(static_cast<int>(shape) + more, 0);
    if (item < items.size()) items.erase(item);
  }
  return items;
}

Value rearranged(const ParameterSpec& list, Value items, const std::string& input, const FormerPlaces& places,
                 std::size_t before) {
  if (list.kind != ParameterKind::List || !items.is_array()) return items;
  if (list.filling.input != input) {
    for (Value& item : items) item = rearranged(list.fields.at(0), std::move(item), input, places, before);
    return items;
  }
  if (list.filling.more == 0) return inOrderOf(places, items, list.fields.at(0));
  return withoutGone(places, before, std::move(items), list.filling.more);
}

}  // namespace

FormerPlaces formerPlaces(const std::vector<std::string>& before, const std::vector<std::string>& now) {
  std::vector<bool> isTaken(before.size(), false);
  FormerPlaces places(now.size());
  for (std::size_t k = 0; k < now.size(); ++k)
    for (std::size_t i = 0; i < before.size() && !places[k]; ++i)
      if (!isTaken[i] && before[i] == now[k]) {
        places[k] = i;
        isTaken[i] = true;
      }
  for (std::size_t k = 0; k < now.size() && before.size() <= now.size(); ++k)
    if (!places[k] && k < before.size() && !isTaken[k]) places[k] = k;
  return places;
}

Value withItemsOfShapes(const FeatureType& type, Value parameters, const std::string& input, const FormerPlaces& places,
                        std::size_t before) {
  for (const ParameterSpec& spec : type.parameters)
    if (parameters.contains(spec.name))
      parameters[spec.name] = rearranged(spec, std::move(parameters[spec.name]), input, places, before);
  return parameters;
}

}  // namespace blossom
