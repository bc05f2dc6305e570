#pragma once
#include <array>
#include <vector>

#include "geometry/planar/planar.h"
#include "parameter/value.h"

namespace blossom {

/// Where a segment of a drawing lies.
struct SegmentPlace {
  std::size_t form = 0;
  std::array<Vec2, 3> points;  ///< its start, a point that its bulge moves, its end

  [[nodiscard]] bool isAt(const SegmentPlace&, double tolerance) const;
};

/// A loop of a drawing as the places of its segments.
struct PlacedLoop {
  std::vector<SegmentPlace> segments;
  bool closed = false;
  int first = 0;  ///< number of its first segment

  [[nodiscard]] int size() const { return static_cast<int>(segments.size()); }
  /// nullptr beyond the ends of an open one.
  [[nodiscard]] const SegmentPlace* at(int k) const;
};

std::vector<PlacedLoop> placedLoopsOf(const std::vector<Path>&);

Value toJson(const SegmentPlace*);  ///< nullptr: null
/// @throws nlohmann::json::exception for values of another form.
SegmentPlace segmentPlaceFrom(const Value&);

}  // namespace blossom
