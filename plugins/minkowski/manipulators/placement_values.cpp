#include "manipulators/placement_values.h"

#include <algorithm>

namespace blossom::minkowski {
namespace {

/// Calls `read` with every item that belongs to a shape.
template <class Read>
void eachItem(const Value& list, std::size_t shapes, const Read& read) {
  for (std::size_t i = 0; i < std::min(list.size(), shapes); ++i) read(i, list[i]);
}

template <class Says, class Item>
Value listOf(const std::vector<Placement>& placements, const Says& says, const Item& item) {
  std::size_t count = placements.size();
  while (count > 0 && !says(placements[count - 1])) --count;
  Value list = Value::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(item(placements[i]));
  return list;
}

}  // namespace

std::vector<Placement> placementsIn(const Value& parameters, std::size_t shapes) {
  std::vector<Placement> placements(shapes);
  eachItem(parameters.at("offsets"), shapes, [&](std::size_t i, const Value& item) {
    placements[i].offset = {item.at(0).get<double>(), item.at(1).get<double>()};
  });
  eachItem(parameters.at("scales"), shapes,
           [&](std::size_t i, const Value& item) { placements[i].scale = item.get<double>(); });
  eachItem(parameters.at("turns"), shapes,
           [&](std::size_t i, const Value& item) { placements[i].turn = item.get<double>(); });
  return placements;
}

void writePlacements(Value& parameters, const std::vector<Placement>& placements) {
  parameters["offsets"] = listOf(
      placements, [](const Placement& p) { return !p.offset.isZero(0); },
      [](const Placement& p) {
        return Value::array({p.offset.x(), p.offset.y(), 0.0});
      });
  parameters["scales"] = listOf(
      placements, [](const Placement& p) { return p.scale != 1; }, [](const Placement& p) { return Value(p.scale); });
  parameters["turns"] = listOf(
      placements, [](const Placement& p) { return p.turn != 0; }, [](const Placement& p) { return Value(p.turn); });
}

}  // namespace blossom::minkowski
