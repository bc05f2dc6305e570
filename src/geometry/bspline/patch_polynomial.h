#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "geometry/bspline/product.h"

/// Algebra of scalar functions that are polynomials on every patch of a grid: the fast way to sums of products of many
/// B-spline components, of which only the result becomes a B-spline. For a motion X = tw y + tx d sw, for example:
///
///     const PatchGrid grid(knotsU, knotsV);                        // knotsU, knotsV = productKnots(factors..)
///     const auto r = patchPolynomials(orientation, grid), t = patchPolynomialsInV(trajectory, grid);
///     PatchPolynomial d = product(r[0], r[0]);
///     d.addProduct(r[1], r[1]);                                    // ...
///     const Surface surface = assemble({x, y, z, w}, grid);
///
/// Coefficients are scaled Bernstein coefficients c_ij * binomial(p, i) * binomial(q, j), for which a product is a plain
/// convolution (Farouki & Rajan, "Algorithms for polynomials in Bernstein form", 1988).
namespace blossom {

/// The patches between the distinct knots of a product.
class PatchGrid {
 public:
  PatchGrid(ProductKnots u, ProductKnots v);

  [[nodiscard]] const ProductKnots& u() const { return u_; }
  [[nodiscard]] const ProductKnots& v() const { return v_; }
  [[nodiscard]] const std::vector<double>& breaksU() const { return breaksU_; }
  [[nodiscard]] const std::vector<double>& breaksV() const { return breaksV_; }
  [[nodiscard]] std::size_t spansU() const { return breaksU_.size() - 1; }
  [[nodiscard]] std::size_t spansV() const { return breaksV_.size() - 1; }
  [[nodiscard]] std::size_t patches() const { return spansU() * spansV(); }

 private:
  ProductKnots u_, v_;
  std::vector<double> breaksU_, breaksV_;
};

/// One scalar function on all patches. Operations on functions with different patch counts are a mistake of the caller
/// (Internal).
class PatchPolynomial {
 public:
  /// Patches are worked on this many at a time, one in each lane, which is what makes products fast at every degree.
  static constexpr std::size_t kLanes = 8;

  /// The zero function.
  PatchPolynomial(std::size_t patches, int degreeU, int degreeV);

  [[nodiscard]] int degreeU() const { return degreeU_; }
  [[nodiscard]] int degreeV() const { return degreeV_; }
  [[nodiscard]] std::size_t patches() const { return patches_; }
  /// Scaled Bernstein coefficient (i, j) on one patch; patch (a, b) has number a * spansV + b.
  [[nodiscard]] double& at(std::size_t patch, std::size_t i, std::size_t j) { return coefficients_[index(patch, i, j)]; }
  [[nodiscard]] double at(std::size_t patch, std::size_t i, std::size_t j) const {
    return coefficients_[index(patch, i, j)];
  }

  /// Adds factor * a * b, whose degrees must add up to the degrees of this.
  PatchPolynomial& addProduct(const PatchPolynomial& a, const PatchPolynomial& b, double factor = 1);
  /// Adds factor * a, of the same degrees.
  PatchPolynomial& add(const PatchPolynomial& a, double factor = 1);

 private:
  [[nodiscard]] std::size_t index(std::size_t patch, std::size_t i, std::size_t j) const {
    return (patch / kLanes * blockSize() + i * (static_cast<std::size_t>(degreeV_) + 1) + j) * kLanes + patch % kLanes;
  }
  [[nodiscard]] std::size_t blockSize() const {
    return (static_cast<std::size_t>(degreeU_) + 1) * (static_cast<std::size_t>(degreeV_) + 1);
  }

  std::size_t patches_;
  int degreeU_, degreeV_;
  std::vector<double> coefficients_;  ///< [block of kLanes patches][i][j][lane]
};

PatchPolynomial product(const PatchPolynomial& a, const PatchPolynomial& b, double factor = 1);

/// The four components of a factor on the grid. Its knots must be among the grid's breaks.
std::array<PatchPolynomial, 4> patchPolynomials(const Surface&, const PatchGrid&);
/// The four components of a curve in v, constant (degree 0) in u.
std::array<PatchPolynomial, 4> patchPolynomialsInV(const Curve&, const PatchGrid&);

/// The surface whose homogeneous components these are, over the grid's product knots.
/// @throws Error Internal when the degrees are not the grid's product degrees.
Surface assemble(const std::array<PatchPolynomial, 4>& components, const PatchGrid&);

}  // namespace blossom
