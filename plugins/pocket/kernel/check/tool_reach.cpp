#include "kernel/check/tool_reach.h"

#include "kernel/offset/clearance_diagram.h"

namespace blossom::pocket {

ToolReach::ToolReach(const Region& part, const CoverageOptions& options, const Progress& progress)
    : radius_(options.radius), tolerance_(options.tolerance), all_(Region()) {
  const ClearanceDiagram diagram(part, {.tolerance = options.tolerance / 4}, progress);
  const auto centersAt = [&](double clearance) {
    return BoundaryTree(diagram.offset(clearance, Side::Inside, progress), progress);
  };
  all_ = centersAt(options.radius);
  if (options.leave > 0) leavingSome_ = centersAt(options.radius + options.leave);
}

MarkKind ToolReach::at(const Vec2& p) const {
  const auto isWithin = [&](const BoundaryTree& centers, double radius) {
    return centers.windingNumber(p) != 0 || centers.distanceTo(p) <= radius;
  };
  if (isWithin(leavingSome_ ? *leavingSome_ : all_, radius_ - tolerance_)) return MarkKind::Missed;
  return leavingSome_ && isWithin(all_, radius_ + tolerance_) ? MarkKind::Left : MarkKind::Unreachable;
}

}  // namespace blossom::pocket
