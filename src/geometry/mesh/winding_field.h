#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// The winding number of closed triangles (see windingNumber) at many places, also where surfaces meet: its integral is the
/// volume that they enclose together, counted as often as they enclose it.
class WindingField {
 public:
  /// Lowest and highest.
  using Range = std::pair<int, int>;

  /// O(n log n). @throws Error Cancelled.
  explicit WindingField(std::vector<Triangle3>, const Progress& = Progress::none());

  /// At a point off the triangles, by the crossings of rays along two axes or, where these disagree because one meets an
  /// edge, three. About O(log n).
  [[nodiscard]] int at(const Vec3&) const;

  /// Its values in the sectors that the triangles cut out of space around a place where two of them meet. Nothing where they
  /// meet in a point alone: surfaces that intersect there do so along a line, too, where others of their triangles meet. In
  /// doubles, away from that place by a small share of what is common to both. About O(log n).
  [[nodiscard]] std::optional<Range> whereTheyMeet(const Triangle3&, const Triangle3&) const;

 private:
  struct Ring;
  [[nodiscard]] Range around(const Ring&) const;
  [[nodiscard]] int risenBetween(const Vec3& from, const Vec3& to) const;

  std::vector<Triangle3> triangles_;
  BoxTree<3> tree_;
};

}  // namespace blossom
