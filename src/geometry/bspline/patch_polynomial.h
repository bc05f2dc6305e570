#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/bspline/product.h"

/// Algebra of scalar functions that are polynomials on every patch of a grid: the fast way to sums of products of many
/// B-spline components, because only the result is converted to a B-spline. For a motion X = tw y + tx d sw, for example:
///
///     const PatchGrid grid(knotsU, knotsV);                        // knotsU, knotsV = productKnots(factors..)
///     const auto r = patchPolynomials(orientation, grid), t = patchPolynomialsInV(trajectory, grid);
///     PatchPolynomial d = product(r[0], r[0]);
///     d.addProduct(r[1], r[1]);                                    // ...
///     const Surface surface = assemble({x, y, z, w}, grid);
///
/// Coefficients are scaled Bernstein coefficients c_ij * binomial(p, i) * binomial(q, j), for which a product is a plain
/// convolution (Farouki & Rajan, "Algorithms for polynomials in Bernstein form", 1988). Loops over patches poll Progress:
/// all with one as a parameter throw Error Cancelled.
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

/// One scalar function on all patches. Combining functions with different patch counts is a programming error (Internal).
class PatchPolynomial {
 public:
  /// Number of patches processed together, one per SIMD lane.
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

  /// Adds factor * a * b. The degrees of a and b must add up to the degrees of this function.
  PatchPolynomial& addProduct(const PatchPolynomial& a, const PatchPolynomial& b, double factor = 1,
                              const Progress& = Progress::none());
  /// Adds factor * a; a has the degrees of this function.
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

PatchPolynomial product(const PatchPolynomial& a, const PatchPolynomial& b, double factor = 1,
                        const Progress& = Progress::none());

/// The four components of a surface on the grid. Its knots must be among the breaks of the grid.
std::array<PatchPolynomial, 4> patchPolynomials(const Surface&, const PatchGrid&, const Progress& = Progress::none());
/// The four components of a curve in v, constant (degree 0) in u.
std::array<PatchPolynomial, 4> patchPolynomialsInV(const Curve&, const PatchGrid&, const Progress& = Progress::none());

/// The surface with these homogeneous components, over the product knots of the grid.
/// @throws Error Internal when the degrees differ from those of the grid's product knots.
Surface assemble(const std::array<PatchPolynomial, 4>& components, const PatchGrid&, const Progress& = Progress::none());

}  // namespace blossom
