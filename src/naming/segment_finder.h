#pragma once
#include <optional>

#include "naming/segment_place.h"

namespace blossom {

/// Looks for a segment of a drawing as it was in a loop as it is now.
class SegmentFinder {
 public:
  /// @throws nlohmann::json::exception for descriptions of another form (see describedSourcePart).
  SegmentFinder(const Value& described, double tolerance);

  /// Segments that lie where it lay.
  [[nodiscard]] std::vector<int> unmoved(const PlacedLoop&) const;
  /// In the loop that it belonged to, where it does not lie any more.
  /// @param alone the drawing has no other loops
  [[nodiscard]] std::optional<int> inItsLoop(const PlacedLoop&, bool alone) const;
  /// What begins where it began, or ends where it ended, when it was divided or joined with the next: what lies beside a
  /// neighbour that did not move, or runs along it.
  [[nodiscard]] std::vector<int> pieces(const PlacedLoop&) const;

 private:
  [[nodiscard]] std::optional<int> alongIt(const PlacedLoop&) const;
  [[nodiscard]] bool isMoved(const SegmentPlace&) const;
  [[nodiscard]] bool overlaps(const SegmentPlace&) const;
  /// The one after its neighbour before it, and the one ahead of the neighbour after it.
  [[nodiscard]] std::optional<int> after(const PlacedLoop&) const;
  [[nodiscard]] std::optional<int> ahead(const PlacedLoop&) const;

  SegmentPlace own_;
  std::optional<SegmentPlace> before_, after_;
  int place_, count_;
  double tolerance_;
};

}  // namespace blossom
