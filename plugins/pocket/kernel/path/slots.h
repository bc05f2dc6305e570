#pragma once
#include <optional>
#include <vector>

#include "kernel/offset/clearance_diagram.h"
#include "kernel/path/pass.h"

namespace blossom::pocket {

/// Finds places of a part that are just twice as wide as a distance, or next to nothing wider: bent slots and holes. An
/// offset is a line or a point there, and whether its loops show it is decided by the chords that the diagram is made of;
/// the medial axis has the clearances between the true walls.
class SlotSearch {
 public:
  explicit SlotSearch(ClearanceDiagram diagram) : diagram_(std::move(diagram)) {}

  /// Ways through such places, there and back, that the loops at this distance from the walls leave out; a way of no length
  /// where there is room for one point only. The axis is made when it is first needed. @throws Error Cancelled.
  std::vector<Pass> leftOut(const std::vector<Stroke>& loops, double distance, const Progress&);

 private:
  const MedialAxis& axis(const Progress&);

  ClearanceDiagram diagram_;
  std::optional<MedialAxis> axis_;
};

/// mm by which a place may be narrower than a pass asks for: a slot just as wide as the tool, but for rounding, is cut along
/// its middle.
double slotSlack(const ClearanceDiagram&);

}  // namespace blossom::pocket
