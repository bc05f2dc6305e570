#include "kernel/product_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/bspline/patch_polynomial.h"
#include "geometry/bspline/product.h"
#include "kernel/greville.h"
#include "kernel/vanishing.h"

namespace blossom::sweep {

namespace {

constexpr const char* sweeping = "Sweeping";  // the stage, as users read it
constexpr int highestDegree = 25;             // of B-splines in OCCT, STEP and IGES readers
/// Of all patches together; 2.5 GB while they are multiplied. 256 x 256 spans of cubic factors have half as many.
constexpr std::size_t mostCoefficients = std::size_t{1} << 24;

PatchGrid withinMemory(PatchGrid grid) {
  const std::size_t ofPatch = static_cast<std::size_t>(grid.u().degree + 1) * static_cast<std::size_t>(grid.v().degree + 1);
  if (grid.patches() <= mostCoefficients / ofPatch) return grid;
  throw Error(
      ErrorCode::LimitExceeded,
      fmt::format("The rational surface of this motion would have {} x {} patches of degrees {} and {}; at most {} patches "
                  "of these degrees can be made.",
                  grid.spansU(), grid.spansV(), grid.u().degree, grid.v().degree, mostCoefficients / ofPatch),
      "Take the cubic mode, or edit the motion at coarser levels or fewer places.");
}

void requireDegree(const char* direction, const ProductKnots& product, const char* sum) {
  if (product.degree > highestDegree)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The swept surface would have degree {} in {} ({}); the highest that can be used is {}.",
                            product.degree, direction, sum, highestDegree),
                "Lower the degrees of the motion's factors, or take the cubic mode.");
}

/// Fractions reported are those of the time that cubic factors take.
Surface multiply(const Motion& motion, const Progress& progress) {
  const PatchGrid grid = productGrid(motion);
  const auto [w, x, y, z] = patchPolynomials(motion.orientation, grid, progress);
  const auto [sx, sy, sz, sw] = patchPolynomials(motion.scaling, grid, progress);
  const auto t = patchPolynomialsInV(motion.trajectory, grid, progress);
  progress.report(0.1, sweeping);
  const auto multiplied = [&](const PatchPolynomial& a, const PatchPolynomial& b, double factor = 1) {
    return product(a, b, factor, progress);
  };
  const auto ww = multiplied(w, w), xx = multiplied(x, x), yy = multiplied(y, y), zz = multiplied(z, z);
  const auto sum = [](PatchPolynomial a, const PatchPolynomial& b, double kb, const PatchPolynomial& c, double kc,
                      const PatchPolynomial& d, double kd) { return std::move(a.add(b, kb).add(c, kc).add(d, kd)); };
  const auto twice = [&](const PatchPolynomial& a, const PatchPolynomial& b, double sign, const PatchPolynomial& c,
                         const PatchPolynomial& d) {
    PatchPolynomial result = multiplied(a, b, 2);
    return std::move(result.addProduct(c, d, 2 * sign, progress));
  };
  // Made one by one: GCC 12 destroys parts of a braced list of arrays twice when one of them throws, as cancelling does.
  const auto row = [](PatchPolynomial first, PatchPolynomial second, PatchPolynomial third) {
    std::vector<PatchPolynomial> all;
    all.reserve(3);
    all.push_back(std::move(first));
    all.push_back(std::move(second));
    all.push_back(std::move(third));
    return all;
  };
  std::vector<std::vector<PatchPolynomial>> rows;
  rows.push_back(row(sum(ww, xx, 1, yy, -1, zz, -1), twice(x, y, -1, w, z), twice(x, z, 1, w, y)));
  rows.push_back(row(twice(x, y, 1, w, z), sum(ww, xx, -1, yy, 1, zz, -1), twice(y, z, -1, w, x)));
  rows.push_back(row(twice(x, z, -1, w, y), twice(y, z, 1, w, x), sum(ww, xx, -1, yy, -1, zz, 1)));
  const PatchPolynomial dsw = multiplied(sum(ww, xx, 1, yy, 1, zz, 1), sw);
  progress.report(0.35, sweeping);
  const PatchPolynomial* const scales[3] = {&sx, &sy, &sz};
  const auto coordinate = [&](std::size_t k) {
    // Components of p that are zero contribute nothing.
    PatchPolynomial turned(dsw.patches(), dsw.degreeU(), dsw.degreeV());
    for (std::size_t c = 0; c < 3; ++c)
      if (const double p = motion.point[static_cast<Eigen::Index>(c)]; p != 0)
        turned.addProduct(rows[k][c], *scales[c], p, progress);
    PatchPolynomial result = multiplied(t[3], turned);
    result.addProduct(t[k], dsw, 1, progress);
    progress.report(0.45 + 0.1 * static_cast<double>(k), sweeping);
    return result;
  };
  return assemble({coordinate(0), coordinate(1), coordinate(2), multiplied(t[3], dsw)}, grid, progress);
}

/// Coefficients of W as they were if nothing cancelled in them: those of the factors without the signs of their poles. The
/// rounding errors of W are a share of these, and a coefficient that is far below its own belongs to quaternions that nearly
/// cancel, not to short ones.
Surface uncancelledWeights(Motion motion, const Progress& progress) {
  for (Vec4& pole : motion.orientation.poles) pole = pole.cwiseAbs();
  return weightCoefficients(motion, progress);
}

/// A power of two is exact: no pole changes its place. @returns it
double scaleWeights(Surface& surface) {
  double largest = 0;
  for (const Vec4& pole : surface.poles) largest = std::max(largest, std::abs(pole[3]));
  if (!(largest > 0) || !std::isfinite(largest))
    throw Error(ErrorCode::Degenerate, "The weights of the swept surface vanish or overflow.",
                "Scale the motion's quaternions to about unit length.");
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double factor = std::ldexp(1.0, -exponent);
  for (Vec4& pole : surface.poles) pole *= factor;
  return factor;
}

/// The last row becomes the first, bit for bit.
void closeSeam(Surface& surface) {
  constexpr double rounding = 1e-6;  // of the largest component, for any degree and knots
  double largest = 0, apart = 0;
  for (const Vec4& pole : surface.poles) largest = std::max(largest, pole.cwiseAbs().maxCoeff());
  for (std::size_t j = 0; j < surface.countV(); ++j)
    apart = std::max(apart, (surface.pole(surface.countU() - 1, j) - surface.pole(0, j)).norm());
  if (!(apart <= rounding * largest))
    throw Error(ErrorCode::Internal, "The swept surface of a closed motion does not close at its seam.");
  for (std::size_t j = 0; j < surface.countV(); ++j) surface.pole(surface.countU() - 1, j) = surface.pole(0, j);
}

/// Middles of the spans that the poles `bad` depend on.
std::vector<double> middles(int degree, const std::vector<double>& knots, const std::set<std::size_t>& bad) {
  std::set<double> result;
  for (const std::size_t i : bad)
    for (std::size_t k = i; k < i + static_cast<std::size_t>(degree) + 1; ++k)
      if (knots[k] < knots[k + 1]) result.insert((knots[k] + knots[k + 1]) / 2);
  return {result.begin(), result.end()};
}

/// Poles whose weights are zero, negative or small because quaternions nearly cancel in them.
struct WeakPoles {
  std::set<std::size_t> rows, columns;
  bool usable = true;  ///< every weight is positive, and not by an error of rounding
};

/// @param factor that of scaleWeights
WeakPoles weakPoles(const Surface& surface, const Motion& motion, double factor, const Progress& progress) {
  constexpr double clear = 1e-2;      // of the largest: a pole lies within some 100 times the size, and has 14 digits
  constexpr double rounding = 1e-13;  // of what would be there if nothing cancelled; some 100 times what was seen
  WeakPoles weak;
  double largest = 0;
  for (const Vec4& pole : surface.poles) largest = std::max(largest, pole[3]);
  if (std::all_of(surface.poles.begin(), surface.poles.end(), [&](const Vec4& pole) { return pole[3] >= clear * largest; }))
    return weak;
  const Surface whole = uncancelledWeights(motion, progress);
  for (std::size_t k = 0; k < surface.poles.size(); ++k) {
    const double weight = surface.poles[k][3], uncancelled = factor * whole.poles[k][3];
    if (weight > 0 && weight >= clear * std::min(largest, uncancelled)) continue;
    weak.rows.insert(k / surface.countV());
    weak.columns.insert(k % surface.countV());
    if (!(weight > rounding * uncancelled)) weak.usable = false;
  }
  return weak;
}

Motion refinedAt(const WeakPoles& weak, const Surface& surface, Motion motion) {
  Surface& r = motion.orientation;
  r = insertKnotsU(clamped(r), middles(surface.degreeU, surface.knotsU, weak.rows));
  r = insertKnotsV(r, middles(surface.degreeV, surface.knotsV, weak.columns));
  return motion;
}

bool fitsMemory(const Motion& motion) {
  try {
    productGrid(motion);
  } catch (const Error&) {
    return false;
  }
  return true;
}

}  // namespace

PatchGrid productGrid(const Motion& motion) {
  const Surface &r = motion.orientation, &s = motion.scaling;
  const Curve& t = motion.trajectory;
  return withinMemory({productKnots(std::vector<ProductFactor>{{r.degreeU, 2, r.knotsU}, {s.degreeU, 1, s.knotsU}}),
                       productKnots(std::vector<ProductFactor>{
                           {t.degree, 1, t.knots}, {r.degreeV, 2, r.knotsV}, {s.degreeV, 1, s.knotsV}})});
}

Surface weightCoefficients(const Motion& motion, const Progress& progress) {
  const PatchGrid grid = productGrid(motion);
  const auto r = patchPolynomials(motion.orientation, grid, progress);
  PatchPolynomial square = product(r[0], r[0], 1, progress);
  for (std::size_t c = 1; c < 4; ++c) square.addProduct(r[c], r[c], 1, progress);
  const PatchPolynomial scaled = product(square, patchPolynomials(motion.scaling, grid, progress)[3], 1, progress),
                        weight = product(patchPolynomialsInV(motion.trajectory, grid, progress)[3], scaled, 1, progress);
  return assemble({weight, weight, weight, weight}, grid, progress);
}

ProductResult productSurface(const Motion& motion, const ProductOptions& options, const Progress& progress) {
  const PatchGrid grid = productGrid(motion);
  requireDegree("u", grid.u(), "twice that of the orientation and that of the scaling");
  requireDegree("v", grid.v(), "that of the trajectory, twice that of the orientation and that of the scaling");
  requireNonVanishing(motion.orientation, progress);
  constexpr int mostForAccuracy = 2;  // rounds for weights that are positive already
  ProductResult result;
  Motion refined = motion;
  for (int forAccuracy = 0;;) {
    // Most often the first round is the last.
    const double left = std::pow(0.2, result.refinements);
    const Progress round = progress.part(1 - left, 1 - 0.2 * left);
    result.surface = multiply(refined, round);
    round.report(1, sweeping);
    const double factor = scaleWeights(result.surface);
    if (motion.closedU != ClosedU::No) closeSeam(result.surface);
    const WeakPoles weak = weakPoles(result.surface, refined, factor, progress);
    if (weak.rows.empty()) break;
    const bool last = result.refinements >= options.refinements;
    if (weak.usable && (last || forAccuracy == mostForAccuracy)) break;
    if (last)
      throw Error(
          ErrorCode::Degenerate,
          fmt::format(
              "Some weights of the swept surface stay negative after {} knot insertions, near u = {:.4g}, v = {:.4g}.",
              options.refinements, greville(result.surface.degreeU, result.surface.knotsU, *weak.rows.begin()),
              greville(result.surface.degreeV, result.surface.knotsV, *weak.columns.begin())),
          "The orientation turns too fast somewhere; give it more poles there.");
    Motion finer = refinedAt(weak, result.surface, refined);
    if (weak.usable && !fitsMemory(finer)) break;
    refined = std::move(finer);
    ++result.refinements;
    if (weak.usable) ++forAccuracy;
  }
  result.smallestWeight = smallestWeight(result.surface);
  return result;
}

}  // namespace blossom::sweep
