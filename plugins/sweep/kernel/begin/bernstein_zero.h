#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/vector.h"

namespace blossom::sweep {

/// Vector polynomials on consecutive intervals in Bernstein form.
struct BernsteinPieces {
  std::size_t degree = 0;
  std::vector<double> breaks;      ///< pieces + 1, increasing
  std::vector<Vec3> coefficients;  ///< degree + 1 for each piece

  [[nodiscard]] std::size_t pieces() const { return breaks.size() - 1; }
};

/// A parameter near which the polynomial is shorter than `minimum`; none when it is proved to stay longer than that: on each
/// part, a direction exists along which every coefficient reaches `minimum`. Parts without a proof are halved, so only
/// the neighbourhood of a zero takes time. @pre minimum > 0
std::optional<double> zeroOf(const BernsteinPieces&, double minimum);

/// Coefficients of the product of two scalar polynomials in Bernstein form (Farouki & Rajan 1988, equation 44).
std::vector<double> bernsteinProduct(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace blossom::sweep
