#include "kernel/check/coverage.h"

#include <algorithm>

#include "kernel/check/residue.h"

namespace blossom::pocket {

Coverage coverageOf(const Region& part, const Uncut& uncut, const SimulationResult& simulated, const CoverageOptions& o,
                    const Progress& progress) {
  double reachable = simulated.reachable;
  if (o.leave > 0) {
    ResidueProblem nothingLeft;
    nothingLeft.radius = o.radius;
    nothingLeft.tolerance = o.tolerance;
    reachable = residueOf(part, nothingLeft, progress).reachable;
  }
  Coverage coverage;
  coverage.part = uncut.partArea;
  coverage.cut = uncut.partArea - uncut.area;
  coverage.unreachable = std::max(0.0, uncut.partArea - reachable);
  coverage.left = std::max(0.0, reachable - simulated.reachable);
  coverage.missed = simulated.residue.value_or(0);
  return coverage;
}

}  // namespace blossom::pocket
