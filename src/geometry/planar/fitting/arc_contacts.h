#pragma once
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::planar {

/// Ends of arcs in which a smaller arc touches them from within and goes on beside them: were both cut alike, their first
/// chords would lie on each other. O(n log n) for n arcs, O(log n) a question.
class ArcContacts {
 public:
  explicit ArcContacts(const std::vector<Path>& loops);

  /// Whether the start of an arc is such an end, else its end.
  [[nodiscard]] bool beside(const Arc2&, bool start) const;
  /// Whether any arc of the loops has one.
  [[nodiscard]] bool any(const std::vector<Path>& loops) const;

 private:
  struct End {
    Vec2 at, away;  ///< the direction in which the arc leaves its end
    double radius = 0;
    bool turnsLeft = true;  ///< as it leaves its end
  };
  static End endOf(const Arc2&, bool start);

  std::vector<End> ends_;  ///< by x
};

}  // namespace blossom::planar
