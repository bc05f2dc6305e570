#pragma once
#include <cstddef>
#include <span>
#include <vector>

/// Banded matrices that turn poles into other poles; inside the geometry room only.
namespace blossom::detail {

/// New pole i = sum over k < width of weights[i * width + k] * old pole (first[i] + k). One such matrix serves a curve, and
/// a surface once in each direction.
struct PoleRows {
  std::size_t width = 0;
  std::vector<std::size_t> first;
  std::vector<double> weights;

  [[nodiscard]] std::size_t size() const { return first.size(); }
};

/// Applies the rows to items of `stride` consecutive doubles; `out` takes rows.size() * stride values.
void applyRows(const PoleRows& rows, const double* in, std::size_t stride, double* out);

/// From the knot vector `from` to `to`, which holds every knot of `from` that lies strictly inside its own range at least as
/// often. Oslo algorithm, all weights >= 0 and their sum 1. O(n p^2).
PoleRows refinementRows(int degree, std::span<const double> from, std::span<const double> to);

/// From degree `degree` over `from` to degree `degree + times` over `to`. All weights >= 0. O(n P p).
PoleRows elevationRows(int degree, std::span<const double> from, int times, std::span<const double> to);

/// From the poles of the Bezier pieces over `breaks`, one piece after the other, to the poles over `knots` (see fromBezier).
/// With `scaled` the coefficients come multiplied by binomials.
PoleRows blossomRows(int degree, std::span<const double> breaks, std::span<const double> knots, bool scaled);

/// One step of the Oslo recurrence: hands the weights of the level - 1 + 1 poles that end at `last` on to the level + 1
/// poles of `level`, for one more blossom argument. `next` is added to, times `share`.
void raiseBlossom(std::span<const double> knots, std::size_t last, int level, double argument, double share,
                  const double* weights, double* next, std::size_t stride = 1);

/// The distinct knots within the domain.
std::vector<double> distinctKnots(int degree, std::span<const double> knots);
/// Each break degree + 1 times: the knot vector of the Bezier pieces.
std::vector<double> bezierKnots(int degree, std::span<const double> breaks);
/// `knots` with those that lie within rounding of a break moved onto it.
std::vector<double> snappedKnots(std::span<const double> knots, std::span<const double> breaks);

/// Row n of Pascal's triangle.
std::vector<double> binomials(int n);

/// Index of the last knot that is not above t.
std::size_t lastKnotNotAbove(std::span<const double> knots, double t);

}  // namespace blossom::detail
