#include "geometry/planar/winding/corner_numbers.h"

#include <algorithm>
#include <cmath>

namespace blossom::planar {

std::size_t CornerNumbers::PointHash::operator()(const GridPoint& p) const {
  const auto h =
      static_cast<std::uint64_t>(p.x) * 0x9E3779B97F4A7C15U ^ static_cast<std::uint64_t>(p.y) * 0xC2B2AE3D27D4EB4FU;
  return static_cast<std::size_t>(h ^ (h >> 29));
}

void CornerNumbers::add(const GridPoint& at, const GridPoint& next) {
  const auto number = static_cast<std::uint32_t>(next_.size());
  const auto [place, isNew] = numbers_.try_emplace(at, number);
  if (!isNew) {
    std::vector<std::uint32_t>& equal = equal_[at];
    if (equal.empty()) equal.push_back(place->second);
    equal.push_back(number);
  }
  next_.push_back(next);
}

std::uint32_t CornerNumbers::of(const GridPoint& corner, const GridPoint& next) const {
  const auto place = numbers_.find(corner);
  if (place == numbers_.end()) return unknown;
  const auto equal = equal_.find(corner);
  if (equal == equal_.end()) return place->second;
  const auto leadsThere = [&](std::uint32_t number) { return next_[number] == next; };
  const auto& numbers = equal->second;
  const auto found = std::find_if(numbers.begin(), numbers.end(), leadsThere);
  const bool single = found != numbers.end() && std::none_of(std::next(found), numbers.end(), leadsThere);
  return single ? *found : unknown;
}

namespace {

/// Whether a corner may have been dropped from the edge: it lies beside it by no more than rounding.
bool liesAlong(const GridPoint& from, const GridPoint& to, const GridPoint& corner) {
  constexpr double beside = 16;  // units
  const GridPoint along = to - from, there = corner - from;
  const double length = std::sqrt(static_cast<double>(dot(along, along))), on = static_cast<double>(dot(along, there));
  return std::abs(static_cast<double>(cross(along, there))) <= beside * length && on >= -beside * length &&
         on <= length * (length + beside);
}

}  // namespace

std::uint32_t CornerNumbers::ofEdge(const GridPoint& from, const GridPoint& to) const {
  constexpr int mostDropped = 8;
  std::uint32_t longest = unknown;
  Wide length = -1;
  GridPoint at = from;
  for (int i = 0; i <= mostDropped; ++i) {
    const std::uint32_t number = of(at, to);
    if (number == unknown) return unknown;
    const GridPoint along = next_[number] - at;
    if (dot(along, along) > length) {
      length = dot(along, along);
      longest = number;
    }
    at = next_[number];
    if (at == to) return longest;
    if (!liesAlong(from, to, at)) return unknown;
  }
  return unknown;
}

}  // namespace blossom::planar
