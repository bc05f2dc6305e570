#include "geometry/bspline/product.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline_rows.h"

namespace blossom {

namespace {

constexpr double kSameKnot = 1e-12;  ///< of the domain's length

std::pair<double, double> domainOf(int degree, std::span<const double> knots) {
  return {knots[static_cast<std::size_t>(degree)], knots[knots.size() - static_cast<std::size_t>(degree) - 1]};
}

void requireSameDomain(std::span<const ProductFactor> factors) {
  if (factors.empty()) throw Error(ErrorCode::InvalidInput, "A product needs at least one factor.");
  const auto [from, to] = domainOf(factors[0].degree, factors[0].knots);
  const double tolerance = kSameKnot * (to - from);
  for (const ProductFactor& factor : factors) {
    const auto [a, b] = domainOf(factor.degree, factor.knots);
    if (!(std::abs(a - from) <= tolerance && std::abs(b - to) <= tolerance))
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("The factors have different domains, {} to {} and {} to {}.", from, to, a, b),
                  "Give all factors the same parameter range.");
  }
}

/// Distinct knots of all factors, those within rounding of each other (or of an end) merged.
std::vector<double> commonBreaks(std::span<const ProductFactor> factors) {
  const auto domain = domainOf(factors[0].degree, factors[0].knots);
  const double from = domain.first, to = domain.second, tolerance = kSameKnot * (to - from);
  std::vector<double> inner;
  for (const ProductFactor& factor : factors)
    std::copy_if(factor.knots.begin(), factor.knots.end(), std::back_inserter(inner),
                 [&](double knot) { return knot > from + tolerance && knot < to - tolerance; });
  std::sort(inner.begin(), inner.end());
  std::vector<double> breaks{from};
  for (const double knot : inner)
    if (knot > breaks.back() + tolerance) breaks.push_back(knot);
  breaks.push_back(to);
  return breaks;
}

/// Knots are sorted.
int multiplicity(const ProductFactor& factor, double at, double tolerance) {
  const auto first = std::lower_bound(factor.knots.begin(), factor.knots.end(), at);
  return static_cast<int>(std::upper_bound(first, factor.knots.end(), at + tolerance) - first);
}

}  // namespace

ProductBreaks productBreaks(std::span<const ProductFactor> factors) {
  requireSameDomain(factors);
  ProductBreaks result;
  for (const ProductFactor& factor : factors) result.degree += factor.times * factor.degree;
  result.at = commonBreaks(factors);
  const double tolerance = kSameKnot * (result.at.back() - result.at.front());
  for (std::size_t i = 0; i < result.at.size(); ++i) {
    int continuity = -1;
    if (i > 0 && i + 1 < result.at.size()) {
      continuity = result.degree;
      for (const ProductFactor& factor : factors)
        if (const int m = multiplicity(factor, result.at[i], tolerance); m > 0)
          continuity = std::min(continuity, factor.degree - m);
      continuity = std::max(continuity, -1);
    }
    result.continuity.push_back(continuity);
  }
  return result;
}

ProductKnots productKnots(std::span<const ProductFactor> factors) {
  requireSameDomain(factors);
  ProductKnots result;
  for (const ProductFactor& factor : factors) result.degree += factor.times * factor.degree;
  if (result.degree > kMaximumDegree)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The product has degree {}; the highest possible is {}.", result.degree, kMaximumDegree));
  const ProductBreaks breaks = productBreaks(factors);
  for (std::size_t i = 0; i < breaks.at.size(); ++i)
    result.knots.insert(result.knots.end(), static_cast<std::size_t>(result.degree - breaks.continuity[i]), breaks.at[i]);
  return result;
}

namespace detail {

std::vector<double> snappedKnots(std::span<const double> knots, std::span<const double> breaks) {
  const double tolerance = kSameKnot * (breaks.back() - breaks.front());
  std::vector<double> result(knots.begin(), knots.end());
  for (double& knot : result) {
    const auto above = std::lower_bound(breaks.begin(), breaks.end(), knot - tolerance);
    if (above != breaks.end() && *above <= knot + tolerance) knot = *above;
  }
  return result;
}

}  // namespace detail

namespace {

using detail::raiseBlossom;

/// Pole k of the product = sum of weights[k][i][j] * (pole firstA[k] + i of A) * (pole firstB[k] + j of B).
struct ProductRows {
  std::size_t widthA, widthB;
  std::vector<std::size_t> firstA, firstB;
  std::vector<double> weights;
  std::vector<double> knots;

  [[nodiscard]] std::size_t size() const { return firstA.size(); }
  [[nodiscard]] const double* row(std::size_t k) const { return &weights[k * widthA * widthB]; }
};

/// The blossom of a product averages F(x_I) G(x_J) over all ways to split the P arguments into p for F and q for G. Taking
/// one argument after the other, only the number given to F matters: `states_[a]` averages the weights over all ways to give
/// it a of the m arguments seen so far, as a tensor over the poles of F and G involved.
class ProductBlossom {
 public:
  ProductBlossom(int p, std::span<const double> knotsA, int q, std::span<const double> knotsB)
      : p_(p),
        q_(q),
        knotsA_(knotsA),
        knotsB_(knotsB),
        width_(static_cast<std::size_t>(q) + 1),
        states_(static_cast<std::size_t>(p) + 1, std::vector<double>((static_cast<std::size_t>(p) + 1) * width_)),
        next_(states_) {}

  /// Weights of the pole whose support is `support` (P + 2 knots). The first knot chooses the spans to start from; all
  /// weights are then >= 0, because the product has each knot of a factor often enough.
  const std::vector<double>& weights(std::span<const double> support) {
    lastA_ = detail::lastKnotNotAbove(knotsA_, support[0]);
    lastB_ = detail::lastKnotNotAbove(knotsB_, support[0]);
    states_[0][0] = 1;
    for (int m = 1; m <= p_ + q_; ++m) {
      for (int a = std::max(0, m - q_); a <= std::min(m, p_); ++a) step(m, a, support[static_cast<std::size_t>(m)]);
      states_.swap(next_);
    }
    return states_[static_cast<std::size_t>(p_)];
  }
  [[nodiscard]] std::size_t firstA() const { return lastA_ - static_cast<std::size_t>(p_); }
  [[nodiscard]] std::size_t firstB() const { return lastB_ - static_cast<std::size_t>(q_); }

 private:
  void step(int m, int a, double argument) {
    const int b = m - a;
    std::vector<double>& out = next_[static_cast<std::size_t>(a)];
    std::fill(out.begin(), out.end(), 0.0);
    const double toA = static_cast<double>(a) / m, toB = static_cast<double>(b) / m;
    if (a > 0)
      for (std::size_t j = 0; j <= static_cast<std::size_t>(b); ++j)
        raiseBlossom(knotsA_, lastA_, a, argument, toA, &states_[static_cast<std::size_t>(a) - 1][j], &out[j], width_);
    if (b > 0)
      for (std::size_t i = 0; i <= static_cast<std::size_t>(a); ++i)
        raiseBlossom(knotsB_, lastB_, b, argument, toB, &states_[static_cast<std::size_t>(a)][i * width_], &out[i * width_]);
  }

  int p_, q_;
  std::span<const double> knotsA_, knotsB_;
  std::size_t width_, lastA_ = 0, lastB_ = 0;
  std::vector<std::vector<double>> states_, next_;
};

ProductRows productRows(int degreeA, const std::vector<double>& knotsA, int degreeB, const std::vector<double>& knotsB) {
  const ProductKnots target = productKnots(std::vector<ProductFactor>{{degreeA, 1, knotsA}, {degreeB, 1, knotsB}});
  const std::vector<double> breaks = detail::distinctKnots(target.degree, target.knots);
  const std::vector<double> alignedA = detail::snappedKnots(knotsA, breaks), alignedB = detail::snappedKnots(knotsB, breaks);
  ProductBlossom blossom(degreeA, alignedA, degreeB, alignedB);

  ProductRows rows{static_cast<std::size_t>(degreeA) + 1, static_cast<std::size_t>(degreeB) + 1, {}, {}, {}, target.knots};
  const std::size_t count = target.knots.size() - static_cast<std::size_t>(target.degree) - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& weights = blossom.weights(std::span(target.knots).subspan(k, static_cast<std::size_t>(target.degree) + 2));
    rows.weights.insert(rows.weights.end(), weights.begin(), weights.end());
    rows.firstA.push_back(blossom.firstA());
    rows.firstB.push_back(blossom.firstB());
  }
  return rows;
}

/// Calls body(i, j, weight) for the non-zero weights of pole k.
template <typename Body>
void forWeights(const ProductRows& rows, std::size_t k, const Body& body) {
  const double* weight = rows.row(k);
  for (std::size_t i = 0; i < rows.widthA; ++i)
    for (std::size_t j = 0; j < rows.widthB; ++j, ++weight)
      if (*weight != 0) body(rows.firstA[k] + i, rows.firstB[k] + j, *weight);
}

}  // namespace

Curve product(const Curve& a, const Curve& b) {
  const ProductRows rows = productRows(a.degree, a.knots, b.degree, b.knots);
  Curve result{a.degree + b.degree, rows.knots, std::vector<Vec4>(rows.size(), Vec4::Zero())};
  for (std::size_t k = 0; k < rows.size(); ++k)
    forWeights(rows, k,
               [&](std::size_t i, std::size_t j, double w) { result.poles[k] += w * a.poles[i].cwiseProduct(b.poles[j]); });
  return result;
}

Surface product(const Surface& a, const Surface& b) {
  const ProductRows rowsU = productRows(a.degreeU, a.knotsU, b.degreeU, b.knotsU);
  const ProductRows rowsV = productRows(a.degreeV, a.knotsV, b.degreeV, b.knotsV);
  Surface result{a.degreeU + b.degreeU, a.degreeV + b.degreeV, rowsU.knots, rowsV.knots,
                 std::vector<Vec4>(rowsU.size() * rowsV.size(), Vec4::Zero())};
  for (std::size_t k = 0; k < rowsU.size(); ++k)
    for (std::size_t l = 0; l < rowsV.size(); ++l)
      forWeights(rowsU, k, [&](std::size_t iu, std::size_t ju, double wu) {
        Vec4 sum = Vec4::Zero();
        forWeights(rowsV, l, [&](std::size_t iv, std::size_t jv, double wv) {
          sum += wv * a.pole(iu, iv).cwiseProduct(b.pole(ju, jv));
        });
        result.pole(k, l) += wu * sum;
      });
  return result;
}

}  // namespace blossom
