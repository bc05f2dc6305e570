#include "kernel/product_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/bspline/patch_polynomial.h"
#include "geometry/bspline/product.h"
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
  const PatchPolynomial rows[3][3] = {{sum(ww, xx, 1, yy, -1, zz, -1), twice(x, y, -1, w, z), twice(x, z, 1, w, y)},
                                      {twice(x, y, 1, w, z), sum(ww, xx, -1, yy, 1, zz, -1), twice(y, z, -1, w, x)},
                                      {twice(x, z, -1, w, y), twice(y, z, 1, w, x), sum(ww, xx, -1, yy, -1, zz, 1)}};
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

/// A power of two is exact: no pole changes its place.
void scaleWeights(Surface& surface) {
  double largest = 0;
  for (const Vec4& pole : surface.poles) largest = std::max(largest, std::abs(pole[3]));
  if (!(largest > 0) || !std::isfinite(largest))
    throw Error(ErrorCode::Degenerate, "The weights of the swept surface vanish or overflow.",
                "Scale the motion's quaternions to about unit length.");
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double factor = std::ldexp(1.0, -exponent);
  for (Vec4& pole : surface.poles) pole *= factor;
}

void closeSeam(Surface& surface) {
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

/// @returns false when there was nothing to mend.
bool refineWhereNegative(const Surface& surface, Motion& motion) {
  std::set<std::size_t> rows, columns;
  for (std::size_t i = 0; i < surface.countU(); ++i)
    for (std::size_t j = 0; j < surface.countV(); ++j)
      if (surface.pole(i, j)[3] <= 0) rows.insert(i), columns.insert(j);
  if (rows.empty()) return false;
  Surface& r = motion.orientation;
  r = insertKnotsU(clamped(r), middles(surface.degreeU, surface.knotsU, rows));
  r = insertKnotsV(r, middles(surface.degreeV, surface.knotsV, columns));
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

ProductResult productSurface(const Motion& motion, const ProductOptions& options, const Progress& progress) {
  const PatchGrid grid = productGrid(motion);
  requireDegree("u", grid.u(), "twice that of the orientation and that of the scaling");
  requireDegree("v", grid.v(), "that of the trajectory, twice that of the orientation and that of the scaling");
  requireNonVanishing(motion.orientation, progress);
  ProductResult result;
  Motion refined = motion;
  while (true) {
    // Most often the first round is the last.
    const double left = std::pow(0.2, result.refinements);
    const Progress round = progress.part(1 - left, 1 - 0.2 * left);
    result.surface = multiply(refined, round);
    round.report(1, sweeping);
    scaleWeights(result.surface);
    if (motion.closedU != ClosedU::No) closeSeam(result.surface);
    if (!refineWhereNegative(result.surface, refined)) break;
    if (++result.refinements > options.refinements)
      throw Error(
          ErrorCode::Degenerate,
          fmt::format("Some weights of the swept surface stay negative after {} knot insertions.", options.refinements),
          "The orientation turns too fast somewhere; give it more poles there.");
  }
  result.smallestWeight = smallestWeight(result.surface);
  return result;
}

}  // namespace blossom::sweep
