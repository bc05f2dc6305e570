#include "kernel/grid/iso_curves.h"

#include "core/error.h"
#include "kernel/grid/motion_grid.h"

namespace blossom::sweep {

IsoCurves isoCurves(const Motion& motion, std::span<const double> us, std::span<const double> vs, std::size_t samples,
                    const Progress& progress) {
  if (samples < 2) throw Error(ErrorCode::InvalidParameter, "A curve needs at least 2 points.");
  IsoCurves curves{{us.size(), std::vector<Vec3>(samples)}, {vs.size(), std::vector<Vec3>(samples)}};
  MotionGrid grid;
  evaluateGrid(motion, us, evenParameters(motion.domainV(), samples), grid, GridDerivatives::No, progress);
  for (std::size_t k = 0; k < us.size(); ++k)
    for (std::size_t l = 0; l < samples; ++l) curves.constantU[k][l] = grid.pointAt(k, l);
  evaluateGrid(motion, evenParameters(motion.domainU(), samples), vs, grid, GridDerivatives::No, progress);
  for (std::size_t l = 0; l < vs.size(); ++l)
    for (std::size_t k = 0; k < samples; ++k) curves.constantV[l][k] = grid.pointAt(k, l);
  return curves;
}

}  // namespace blossom::sweep
