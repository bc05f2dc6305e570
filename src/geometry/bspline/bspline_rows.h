#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"

/// Banded matrices that map poles to new poles; used inside src/geometry only.
namespace blossom::detail {

/// New pole i = sum over k < width of weights[i * width + k] * old pole (first[i] + k). The same matrix serves a curve and
/// either direction of a surface.
struct PoleRows {
  std::size_t width = 0;
  std::vector<std::size_t> first;
  std::vector<double> weights;

  [[nodiscard]] std::size_t size() const { return first.size(); }
};

/// Applies the matrix to items of `stride` consecutive doubles; `out` has rows.size() * stride values.
void applyRows(const PoleRows& rows, const double* in, std::size_t stride, double* out);
/// The same where a row is long work: polls before each. @throws Error Cancelled.
void applyRows(const PoleRows& rows, const double* in, std::size_t stride, double* out, const Progress&);

/// Knot insertion from the knot vector `from` to `to`, which contains every knot of `from` inside its own range with at
/// least the same multiplicity. Oslo algorithm: all weights >= 0, sum 1. O(n p^2).
PoleRows refinementRows(int degree, std::span<const double> from, std::span<const double> to);

/// Degree elevation from `degree` over `from` to `degree + times` over `to`. All weights >= 0. O(n P p).
PoleRows elevationRows(int degree, std::span<const double> from, int times, std::span<const double> to);

/// Maps the poles of consecutive Bezier pieces over `breaks` to the poles over `knots` (see fromBezier). With `scaled` the
/// coefficients are multiplied by binomials.
PoleRows blossomRows(int degree, std::span<const double> breaks, std::span<const double> knots, bool scaled);

/// One step of the Oslo recurrence for one more blossom argument: computes the weights of the level + 1 poles of `level`
/// from those of the `level` poles of the previous level, which end at pole `last`, and adds them times `share` to `next`.
void raiseBlossom(std::span<const double> knots, std::size_t last, int level, double argument, double share,
                  const double* weights, double* next, std::size_t stride = 1);

/// The distinct knots within the domain.
std::vector<double> distinctKnots(int degree, std::span<const double> knots);
/// The knot vector of the Bezier pieces: each break degree + 1 times.
std::vector<double> bezierKnots(int degree, std::span<const double> breaks);
/// `knots`, where knots that equal a break up to rounding are replaced by it.
std::vector<double> snappedKnots(std::span<const double> knots, std::span<const double> breaks);

/// Row n of Pascal's triangle.
std::vector<double> binomials(int n);

/// Index of the last knot <= t.
std::size_t lastKnotNotAbove(std::span<const double> knots, double t);

}  // namespace blossom::detail
