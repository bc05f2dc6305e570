#include "geometry/planar/booleans/boolean_check.h"

#include "geometry/planar/boundary_tree.h"
#include "geometry/planar/planar.h"

namespace blossom::planar {
namespace {

bool shouldBound(BooleanOperation operation, bool isOfFirst, bool inOther) {
  if (operation == BooleanOperation::Union) return !inOther;
  if (operation == BooleanOperation::Intersection) return inOther;
  return isOfFirst ? !inOther : inOther;
}

}  // namespace

bool boundsAsItShould(const Region& result, const BooleanOperands& operands, BooleanOperation operation, double within,
                      const Progress& progress) {
  const BoundaryTree made(result, progress);
  for (const bool isOfFirst : {true, false}) {
    const BoundaryTree other(isOfFirst ? operands.second : operands.first, progress);
    for (const CutSegment& each : isOfFirst ? operands.cut.first : operands.cut.second)
      for (std::size_t k = 0; k < each.pieces(); ++k)
        for (const double share : {0.5, 0.29, 0.73}) {  // corners of the other one lie in the middle as a rule, if any
          progress.check();
          const Vec2 p = each.pointOf(k, share);
          if (other.distanceTo(p) <= 8 * within) continue;  // both bound, or it is too near to tell
          const double distance = made.distanceTo(p);
          const bool bounds = shouldBound(operation, isOfFirst, other.windingNumber(p) > 0);
          if (bounds ? distance > 4 * within : distance <= within / 4) return false;
        }
  }
  return true;
}

bool isWellJoined(const Region& region, double gap, double shortest) {
  for (const Path& loop : region.loops)
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
      const Segment &segment = loop.segments[i], &next = loop.segments[(i + 1) % loop.segments.size()];
      if (!((endPoint(segment) - startPoint(next)).norm() <= gap) || !(length(segment) > shortest)) return false;
    }
  return true;
}

}  // namespace blossom::planar
