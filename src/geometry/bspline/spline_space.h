#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geometry/bspline/curve.h"
#include "geometry/bspline/surface.h"

/// Spaces of B-splines in one direction, finer and coarser ones of them, and how one lies in another. Knots of two levels
/// that stand for the same value are the same double, so that nothing is compared with a tolerance.
namespace blossom {

/// All splines of one degree over one knot vector.
struct SplineSpace {
  int degree = 1;
  std::vector<double> knots;  ///< full vector; of a closed space unwrapped, as in `unwrappedKnots`
  double closure = 0;         ///< 0: open; otherwise values after one period are so many times those before it, as 1, -1

  /// Basis functions; of a closed space those of one period, each with all its copies.
  [[nodiscard]] std::size_t size() const {
    return knots.size() - (closure == 0 ? 1 : 2) * static_cast<std::size_t>(degree) - 1;
  }
  [[nodiscard]] std::pair<double, double> domain() const {
    const auto p = static_cast<std::size_t>(degree);
    return {knots[p], knots[knots.size() - p - 1]};
  }
  friend bool operator==(const SplineSpace&, const SplineSpace&) = default;
};

SplineSpace spaceOf(const Curve&);
/// @param closure of the surface in u
SplineSpace spaceInU(const Surface&, double closure);
SplineSpace spaceInV(const Surface&);

/// Full knot vector of a periodic spline from its knots over one period, u0..un, continued periodically by `degree` knots on
/// both sides.
std::vector<double> unwrappedKnots(int degree, const std::vector<double>& period);

/// The knots strictly inside the domain, and the space that has those of `inner` (sorted) instead. Ends and seam stay.
std::vector<double> innerKnots(const SplineSpace&);
SplineSpace withInnerKnots(const SplineSpace&, std::span<const double> inner);
/// Both lists; of a knot in both as many as the list with more of it has.
std::vector<double> unitedKnots(std::span<const double> a, std::span<const double> b);

/// Every span halved `times` times (dyadic levels). O(spans 2^times).
SplineSpace halved(const SplineSpace&, int times);
/// Every second distinct knot left out, `times` times, or until nothing can be left out. Counted from both ends of each of
/// `parts` equal numbers of spans, so that what repeats `parts` times, or reads the same backwards, goes on doing so. Of a
/// closed space at least degree + 1 functions stay; with fewer, functions would overlap copies of themselves.
/// @param parts 1 where it does not divide the spans
SplineSpace coarsened(const SplineSpace&, int times, std::size_t parts = 1);

/// What values of a closed space are multiplied by after some periods; before it, when there are fewer than 0.
double afterPeriods(double closure, long turns);

/// The functions that are not 0 at t, by increasing index, and their values there. Of a closed space with few functions the
/// copies of one add up, and may cancel each other. @param t inside the domain  O(degree^2).
struct FunctionValue {
  std::size_t function;
  double value;
};
std::vector<FunctionValue> functionsAt(const SplineSpace&, double t);

/// A sparse matrix that takes the coefficients of a space to those of the same spline in a finer one (two-scale relation):
/// row i, entries begin[i] .. begin[i + 1], says how much of each coarse coefficient fine coefficient i is.
struct SpaceMap {
  std::size_t columns = 0;  ///< functions of the coarse space
  std::vector<std::size_t> begin = {0};
  std::vector<std::size_t> coarse = {};
  std::vector<double> weight = {};

  [[nodiscard]] std::size_t rows() const { return begin.size() - 1; }
};
/// Oslo algorithm (Cohen, Lyche & Riesenfeld 1980): weights are >= 0 in an open or periodic space and sum to 1, and a fine
/// function whose knots are those of a coarse one has that coefficient, bit for bit. O(functions degree^2).
/// @throws Error InvalidInput when the fine space does not hold the coarse one.
SpaceMap embedding(const SplineSpace& coarse, const SplineSpace& fine);

/// One map after the other, the columns of the second being the rows of the first. O(entries).
SpaceMap composed(const SpaceMap& first, const SpaceMap& second);

/// Coefficients of a curve, and of a tensor product (u-major), in the finer spaces.
std::vector<Vec4> mapped(const SpaceMap&, const std::vector<Vec4>& coefficients);
std::vector<Vec4> mapped(const SpaceMap& u, const SpaceMap& v, const std::vector<Vec4>& coefficients);

}  // namespace blossom
