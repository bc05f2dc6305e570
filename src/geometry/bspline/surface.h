#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace blossom {

/// A tensor-product B-spline surface of any degree with values in R^4, read projectively as Curve is.
/// Poles are stored u-major: pole (i, j) is poles[i * countV() + j].
struct Surface {
  int degreeU = 0;
  int degreeV = 0;
  std::vector<double> knotsU;  ///< full vector, countU() + degreeU + 1 values
  std::vector<double> knotsV;  ///< full vector, countV() + degreeV + 1 values
  std::vector<Vec4> poles;

  [[nodiscard]] std::size_t countU() const { return knotsU.size() - static_cast<std::size_t>(degreeU) - 1; }
  [[nodiscard]] std::size_t countV() const { return knotsV.size() - static_cast<std::size_t>(degreeV) - 1; }
  [[nodiscard]] const Vec4& pole(std::size_t i, std::size_t j) const { return poles[i * countV() + j]; }
  [[nodiscard]] Vec4& pole(std::size_t i, std::size_t j) { return poles[i * countV() + j]; }
  [[nodiscard]] std::pair<double, double> domainU() const {
    return {knotsU[static_cast<std::size_t>(degreeU)], knotsU[countU()]};
  }
  [[nodiscard]] std::pair<double, double> domainV() const {
    return {knotsV[static_cast<std::size_t>(degreeV)], knotsV[countV()]};
  }
  friend bool operator==(const Surface&, const Surface&) = default;
};

}  // namespace blossom
