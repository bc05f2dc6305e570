#include "geometry/bspline/patch_polynomial.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline_rows.h"

namespace blossom {

PatchGrid::PatchGrid(ProductKnots u, ProductKnots v)
    : u_(std::move(u)),
      v_(std::move(v)),
      breaksU_(detail::distinctKnots(u_.degree, u_.knots)),
      breaksV_(detail::distinctKnots(v_.degree, v_.knots)) {}

namespace {

using Lanes = Eigen::Array<double, PatchPolynomial::kLanes, 1>;
constexpr std::size_t kLanes = PatchPolynomial::kLanes;

std::size_t order(int degree) { return static_cast<std::size_t>(degree) + 1; }

void require(bool holds, const char* what) {
  if (!holds) throw Error(ErrorCode::Internal, what);
}

/// One block of patches: out[i + k][j + l] += factor * a[i][j] * b[k][l] in every lane. Runs over the coefficients of the
/// result, so that each sum stays in registers.
void convolve(const double* a, std::size_t au, std::size_t av, const double* b, std::size_t bu, std::size_t bv,
              double factor, double* out) {
  const std::size_t cu = au + bu - 1, cv = av + bv - 1;
  for (std::size_t i = 0; i < cu; ++i) {
    const std::size_t iFrom = i < bu ? 0 : i - bu + 1, iTo = std::min(i + 1, au);
    for (std::size_t j = 0; j < cv; ++j) {
      const std::size_t jFrom = j < bv ? 0 : j - bv + 1, jTo = std::min(j + 1, av);
      Lanes sum = Lanes::Zero();
      for (std::size_t k = iFrom; k < iTo; ++k) {
        const double* x = a + (k * av + jFrom) * kLanes;
        const double* y = b + ((i - k) * bv + (j - jFrom)) * kLanes;
        for (std::size_t l = jFrom; l < jTo; ++l, x += kLanes, y -= kLanes)
          sum += Eigen::Map<const Lanes>(x) * Eigen::Map<const Lanes>(y);
      }
      Eigen::Map<Lanes>(out + (i * cv + j) * kLanes) += factor * sum;
    }
  }
}

}  // namespace

PatchPolynomial::PatchPolynomial(std::size_t patches, int degreeU, int degreeV)
    : patches_(patches),
      degreeU_(degreeU),
      degreeV_(degreeV),
      coefficients_((patches + kLanes - 1) / kLanes * kLanes * blockSize()) {}

PatchPolynomial& PatchPolynomial::addProduct(const PatchPolynomial& a, const PatchPolynomial& b, double factor,
                                             const Progress& progress) {
  require(a.patches_ == patches_ && b.patches_ == patches_ && a.degreeU_ + b.degreeU_ == degreeU_ &&
              a.degreeV_ + b.degreeV_ == degreeV_,
          "A product of patch polynomials was added to one of other size.");
  const std::size_t blocks = (patches_ + kLanes - 1) / kLanes;
  for (std::size_t block = 0; block < blocks; ++block) {
    progress.check();
    convolve(&a.coefficients_[block * a.blockSize() * kLanes], order(a.degreeU_), order(a.degreeV_),
             &b.coefficients_[block * b.blockSize() * kLanes], order(b.degreeU_), order(b.degreeV_), factor,
             &coefficients_[block * blockSize() * kLanes]);
  }
  return *this;
}

PatchPolynomial& PatchPolynomial::add(const PatchPolynomial& a, double factor) {
  require(a.patches_ == patches_ && a.degreeU_ == degreeU_ && a.degreeV_ == degreeV_,
          "A patch polynomial was added to one of other size.");
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i] += factor * a.coefficients_[i];
  return *this;
}

PatchPolynomial product(const PatchPolynomial& a, const PatchPolynomial& b, double factor, const Progress& progress) {
  PatchPolynomial result(a.patches(), a.degreeU() + b.degreeU(), a.degreeV() + b.degreeV());
  result.addProduct(a, b, factor, progress);
  return result;
}

namespace {

/// Rows from B-spline poles to scaled Bernstein coefficients on the grid's spans.
detail::PoleRows scaledBezierRows(int degree, std::span<const double> knots, const std::vector<double>& breaks) {
  detail::PoleRows rows =
      detail::refinementRows(degree, detail::snappedKnots(knots, breaks), detail::bezierKnots(degree, breaks));
  const std::vector<double> binomial = detail::binomials(degree);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows.width; ++k) rows.weights[i * rows.width + k] *= binomial[i % binomial.size()];
  return rows;
}

std::array<PatchPolynomial, 4> zeroComponents(const PatchGrid& grid, int degreeU, int degreeV) {
  const PatchPolynomial zero(grid.patches(), degreeU, degreeV);
  return {zero, zero, zero, zero};
}

}  // namespace

std::array<PatchPolynomial, 4> patchPolynomials(const Surface& surface, const PatchGrid& grid, const Progress& progress) {
  const detail::PoleRows rowsU = scaledBezierRows(surface.degreeU, surface.knotsU, grid.breaksU());
  const detail::PoleRows rowsV = scaledBezierRows(surface.degreeV, surface.knotsV, grid.breaksV());
  const std::size_t orderU = order(surface.degreeU), orderV = order(surface.degreeV), nv = surface.countV();
  std::vector<Vec4> half(rowsU.size() * nv), row(rowsV.size());
  detail::applyRows(rowsU, surface.poles.front().data(), nv * 4, half.front().data(), progress);

  auto result = zeroComponents(grid, surface.degreeU, surface.degreeV);
  for (std::size_t i = 0; i < rowsU.size(); ++i) {
    progress.check();
    detail::applyRows(rowsV, half[i * nv].data(), 4, row.front().data());
    for (std::size_t j = 0; j < row.size(); ++j)
      for (std::size_t c = 0; c < 4; ++c)
        result[c].at(i / orderU * grid.spansV() + j / orderV, i % orderU, j % orderV) = row[j][static_cast<Eigen::Index>(c)];
  }
  return result;
}

std::array<PatchPolynomial, 4> patchPolynomialsInV(const Curve& curve, const PatchGrid& grid, const Progress& progress) {
  const detail::PoleRows rows = scaledBezierRows(curve.degree, curve.knots, grid.breaksV());
  const std::size_t orderV = order(curve.degree);
  std::vector<Vec4> row(rows.size());
  detail::applyRows(rows, curve.poles.front().data(), 4, row.front().data());

  auto result = zeroComponents(grid, 0, curve.degree);
  for (std::size_t a = 0; a < grid.spansU(); ++a) {
    progress.check();
    for (std::size_t j = 0; j < row.size(); ++j)
      for (std::size_t c = 0; c < 4; ++c)
        result[c].at(a * grid.spansV() + j / orderV, 0, j % orderV) = row[j][static_cast<Eigen::Index>(c)];
  }
  return result;
}

Surface assemble(const std::array<PatchPolynomial, 4>& components, const PatchGrid& grid, const Progress& progress) {
  const int degreeU = grid.u().degree, degreeV = grid.v().degree;
  for (const PatchPolynomial& component : components)
    require(component.patches() == grid.patches() && component.degreeU() == degreeU && component.degreeV() == degreeV,
            "A component of a product surface does not have the degrees of its knots.");
  const std::size_t orderU = order(degreeU), orderV = order(degreeV);
  const std::size_t nu = grid.spansU() * orderU, nv = grid.spansV() * orderV;
  const detail::PoleRows rowsU = detail::blossomRows(degreeU, grid.breaksU(), grid.u().knots, true);
  const detail::PoleRows rowsV = detail::blossomRows(degreeV, grid.breaksV(), grid.v().knots, true);

  std::vector<Vec4> pieces(nu * nv), half(rowsU.size() * nv);
  for (std::size_t i = 0; i < nu; ++i) {
    progress.check();
    for (std::size_t j = 0; j < nv; ++j) {
      const std::size_t patch = i / orderU * grid.spansV() + j / orderV;
      for (std::size_t c = 0; c < 4; ++c)
        pieces[i * nv + j][static_cast<Eigen::Index>(c)] = components[c].at(patch, i % orderU, j % orderV);
    }
  }
  detail::applyRows(rowsU, pieces.front().data(), nv * 4, half.front().data(), progress);
  Surface result{degreeU, degreeV, grid.u().knots, grid.v().knots, std::vector<Vec4>(rowsU.size() * rowsV.size())};
  for (std::size_t i = 0; i < rowsU.size(); ++i) {
    progress.check();
    detail::applyRows(rowsV, half[i * nv].data(), 4, result.poles[i * rowsV.size()].data());
  }
  return result;
}

}  // namespace blossom
