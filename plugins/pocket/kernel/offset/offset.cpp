#include "kernel/offset/offset.h"

namespace blossom::pocket {

OffsetResult offset(const Region& region, const OffsetOptions& options, const Progress& progress) {
  const ClearanceDiagram diagram(region, {.tolerance = options.tolerance}, progress.part(0, 0.8));
  return {diagram.offset(options.distance, options.side, progress.part(0.8, 1)), diagram.largestClearance()};
}

}  // namespace blossom::pocket
