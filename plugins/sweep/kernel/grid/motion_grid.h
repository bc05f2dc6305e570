#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Points of a swept surface over a grid of parameters, one array per coordinate. Entry (k, l) has index k * countV + l.
struct MotionGrid {
  std::size_t countU = 0, countV = 0;
  std::array<std::vector<double>, 3> point;
  std::array<std::vector<double>, 3> normal;  ///< x_u cross x_v, unit length; zero where that vanishes
  std::array<std::vector<double>, 3> du, dv;  ///< only with GridDerivatives::Yes
  [[nodiscard]] Vec3 pointAt(std::size_t k, std::size_t l) const { return at(point, k, l); }
  [[nodiscard]] Vec3 normalAt(std::size_t k, std::size_t l) const { return at(normal, k, l); }
  [[nodiscard]] Vec3 duAt(std::size_t k, std::size_t l) const { return at(du, k, l); }
  [[nodiscard]] Vec3 dvAt(std::size_t k, std::size_t l) const { return at(dv, k, l); }

 private:
  [[nodiscard]] Vec3 at(const std::array<std::vector<double>, 3>& a, std::size_t k, std::size_t l) const {
    const std::size_t i = k * countV + l;
    return {a[0][i], a[1][i], a[2][i]};
  }
};

enum class GridDerivatives { No, Yes };

/// Evaluates the motion by its factors at all pairs of the parameters, without forming the product surface. Basis functions
/// are tabulated once for each u and v and the factors are summed in two stages (kernel/grid/grid_rows.h). Reuses the memory
/// of `grid`. Single-threaded; about 15 ns per point, 6 ns with wide vector units.
/// @throws Error Cancelled.
void evaluateGrid(const Motion&, std::span<const double> us, std::span<const double> vs, MotionGrid& grid,
                  GridDerivatives = GridDerivatives::No, const Progress& = Progress::none());

/// `count` equally spaced parameters, both ends of the domain included.
std::vector<double> evenParameters(std::pair<double, double> domain, std::size_t count);

}  // namespace blossom::sweep
