#include "kernel/motion_mesh.h"

#include <fmt/format.h>

#include "core/error.h"
#include "geometry/tessellate/tessellate.h"
#include "kernel/grid/motion_grid.h"
#include "kernel/grid/span_parameters.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t mostCells = std::size_t{1} << 22;

void addPoints(const MotionGrid& grid, const std::vector<double>& us, const std::vector<double>& vs, Tessellation& result) {
  result.points.reserve(us.size() * vs.size());
  for (std::size_t k = 0; k < us.size(); ++k)
    for (std::size_t l = 0; l < vs.size(); ++l) {
      result.points.push_back(grid.pointAt(k, l));
      if (!result.points.back().allFinite())
        throw Error(ErrorCode::Degenerate,
                    fmt::format("The orientation vanishes near u = {:.4g}, v = {:.4g}.", us[k], vs[l]),
                    "Turn by less there, or give the motion more poles.");
    }
}

/// Along the shorter diagonal of each cell.
void addTriangles(int countU, int countV, Tessellation& result) {
  const auto at = [&](int k) -> const Vec3& { return result.points[static_cast<std::size_t>(k)]; };
  for (int k = 0; k + 1 < countU; ++k)
    for (int l = 0; l + 1 < countV; ++l) {
      const int p00 = k * countV + l, p10 = p00 + countV, p01 = p00 + 1, p11 = p10 + 1;
      if ((at(p11) - at(p00)).squaredNorm() <= (at(p01) - at(p10)).squaredNorm()) {
        result.triangles.push_back({p00, p10, p11});
        result.triangles.push_back({p00, p11, p01});
      } else {
        result.triangles.push_back({p00, p10, p01});
        result.triangles.push_back({p10, p11, p01});
      }
    }
}

struct Parameters {
  std::vector<double> us, vs;
};

Parameters parametersOf(const Motion& motion, const MotionMeshOptions& options) {
  return {spanParameters(motion.domainU(), {&motion.orientation.knotsU, &motion.scaling.knotsU}, options.cells),
          spanParameters(motion.domainV(), {&motion.orientation.knotsV, &motion.scaling.knotsV, &motion.trajectory.knots},
                         options.cells)};
}

std::size_t cellsOf(const Parameters& at) { return (at.us.size() - 1) * (at.vs.size() - 1); }

}  // namespace

std::size_t cellsOfMesh(const Motion& motion, const MotionMeshOptions& options) {
  return cellsOf(parametersOf(motion, options));
}

Mesh motionMesh(const Motion& motion, const MotionMeshOptions& options, const Progress& progress) {
  const Parameters at = parametersOf(motion, options);
  if (cellsOf(at) > mostCells)
    throw Error(ErrorCode::LimitExceeded, "The mesh of this motion would have too many triangles.", "Ask for fewer cells.");
  MotionGrid grid;
  evaluateGrid(motion, at.us, at.vs, grid, GridDerivatives::No, progress);
  Tessellation result;
  addPoints(grid, at.us, at.vs, result);
  addTriangles(static_cast<int>(at.us.size()), static_cast<int>(at.vs.size()), result);
  progress.check();
  return toMesh(result);
}

}  // namespace blossom::sweep
