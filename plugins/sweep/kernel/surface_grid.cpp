#include "kernel/surface_grid.h"

#include "kernel/grid/factor_grid.h"

namespace blossom::sweep {

std::array<std::vector<double>, 3> evaluateGrid(const Surface& surface, std::span<const double> us,
                                                std::span<const double> vs) {
  const FactorGrid grid(surface, us, tabulateBasis(surface.degreeU, surface.knotsU, us),
                        tabulateBasis(surface.degreeV, surface.knotsV, vs));
  std::array<std::vector<double>, 3> points;
  for (auto& coordinate : points) coordinate.resize(us.size() * vs.size());
  std::vector<double> homogeneous(4 * vs.size());
  for (std::size_t k = 0; k < us.size(); ++k) {
    std::fill(homogeneous.begin(), homogeneous.end(), 0.0);
    for (std::size_t a = 0; a <= static_cast<std::size_t>(surface.degreeU); ++a) {
      const double* row = grid.rows(k) + a * 8 * grid.stride();
      const double n = grid.basisU(k)[a];
      for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t l = 0; l < vs.size(); ++l) homogeneous[c * vs.size() + l] += n * row[c * grid.stride() + l];
    }
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t l = 0; l < vs.size(); ++l)
        points[c][k * vs.size() + l] = homogeneous[c * vs.size() + l] / homogeneous[3 * vs.size() + l];
  }
  return points;
}

}  // namespace blossom::sweep
