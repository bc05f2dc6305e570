#include "kernel/grid/motion_grid.h"

#include "kernel/grid/grid_rows.h"

namespace blossom::sweep {

void evaluateGrid(const Motion& motion, std::span<const double> us, std::span<const double> vs, MotionGrid& grid,
                  GridDerivatives wanted, const Progress& progress) {
  constexpr std::size_t rowsBetweenChecks = 64;
  const bool derivatives = wanted == GridDerivatives::Yes;
  grid.countU = us.size(), grid.countV = vs.size();
  const std::size_t total = us.size() * vs.size();
  for (std::size_t c = 0; c < 3; ++c) {
    grid.point[c].resize(total), grid.normal[c].resize(total);
    grid.du[c].resize(derivatives ? total : 0), grid.dv[c].resize(derivatives ? total : 0);
  }
  const GridFactors factors = tabulateFactors(motion, us, vs);
  for (std::size_t k = 0; k < us.size(); k += rowsBetweenChecks) {
    progress.check();
    evaluateRows(factors, {{k, std::min(k + rowsBetweenChecks, us.size())}, {0, vs.size()}}, grid);
  }
}

std::vector<double> evenParameters(std::pair<double, double> domain, std::size_t count) {
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = i + 1 == count ? domain.second
                               : domain.first + (domain.second - domain.first) * static_cast<double>(i) /
                                                    static_cast<double>(count - 1);
  return result;
}

}  // namespace blossom::sweep
