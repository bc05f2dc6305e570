#include "kernel/cubic_approximation.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/bspline/product.h"
#include "kernel/cubic_spline.h"
#include "kernel/edit/seam_v.h"
#include "kernel/grid/motion_grid.h"
#include "kernel/grid/motion_point.h"
#include "kernel/surface_grid.h"
#include "kernel/vanishing.h"

namespace blossom::sweep {

namespace {

/// Share of the mean span below which two breaks are knots that are meant to be the same, in factors whose numbers differ in
/// their last digits. Between two such breaks a C2 spline is hardly determined; without one of them it is as near, up to
/// their distance.
constexpr double sameBreak = 1e-6;

/// Without breaks right beside another, ends aside. Breaks at which less than the third derivative jumps all stay: they part
/// what is interpolated, and each has slopes of its own.
CubicBreaks apart(const CubicBreaks& breaks) {
  const double least = sameBreak * (breaks.at.back() - breaks.at.front()) / static_cast<double>(breaks.at.size() - 1);
  const std::size_t last = breaks.at.size() - 1;
  CubicBreaks result;
  for (std::size_t i = 0; i <= last; ++i) {
    const auto fixed = [&](std::size_t k) { return k == 0 || k == last || breaks.multiplicity[k] > 1; };
    const bool closeBefore = i > 0 && breaks.at[i] - result.at.back() < least,
               closeAfter = i < last && breaks.at[i + 1] - breaks.at[i] < least && fixed(i + 1);
    if (!fixed(i) && (closeBefore || closeAfter)) continue;
    result.at.push_back(breaks.at[i]);
    result.multiplicity.push_back(breaks.multiplicity[i]);
  }
  return result;
}

/// Distinct knots of all factors in one direction, with the multiplicity that a cubic needs for the same smoothness.
CubicBreaks motionBreaks(std::span<const ProductFactor> factors, bool closed) {
  const ProductBreaks product = productBreaks(factors);  // which is never formed, so that any degree is allowed
  CubicBreaks breaks;
  breaks.at = product.at;
  for (const int smoothness : product.continuity) breaks.multiplicity.push_back(std::clamp(3 - smoothness, 1, 3));
  breaks = apart(breaks);
  breaks.multiplicity.front() = breaks.multiplicity.back() = 1;
  breaks.periodic =
      closed && std::all_of(breaks.multiplicity.begin(), breaks.multiplicity.end(), [](int m) { return m == 1; });
  return breaks;
}

/// The knot at the seam of a closed factor leaves it C2 there.
bool seamIsSmooth(const Surface& factor) {
  const double seam = factor.domainU().first;
  return factor.degreeU - std::count(factor.knotsU.begin(), factor.knotsU.end(), seam) >= 2;
}

CubicBreaks breaksU(const Motion& motion) {
  const Surface &r = motion.orientation, &s = motion.scaling;
  return motionBreaks(std::vector<ProductFactor>{{r.degreeU, 2, r.knotsU}, {s.degreeU, 1, s.knotsU}},
                      motion.closedU != ClosedU::No && seamIsSmooth(r) && seamIsSmooth(s));
}

/// The motion closes in v, and is C2 there.
bool isSmoothRing(const Motion& motion) {
  const auto joined = joinedInV(motion);
  return joined &&
         std::min({joined->trajectory.continuity, joined->orientation.continuity, joined->scaling.continuity}) >= 2;
}

CubicBreaks breaksV(const Motion& motion) {
  const Surface &r = motion.orientation, &s = motion.scaling;
  const Curve& t = motion.trajectory;
  return motionBreaks(std::vector<ProductFactor>{{t.degree, 1, t.knots}, {r.degreeV, 2, r.knotsV}, {s.degreeV, 1, s.knotsV}},
                      isSmoothRing(motion));
}

CubicBreaks halved(const CubicBreaks& breaks, std::size_t maximumSpans) {
  const std::size_t spans = breaks.at.size() - 1;
  if (2 * spans > maximumSpans) return breaks;
  CubicBreaks result;
  result.periodic = breaks.periodic;
  for (std::size_t i = 0; i < spans; ++i) {
    result.at.insert(result.at.end(), {breaks.at[i], (breaks.at[i] + breaks.at[i + 1]) / 2});
    result.multiplicity.insert(result.multiplicity.end(), {breaks.multiplicity[i], 1});
  }
  result.at.push_back(breaks.at.back());
  result.multiplicity.push_back(1);
  return result;
}

void put(Rows& rows, std::size_t i, std::size_t column, const Vec3& value) {
  rows.block<1, 3>(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(3 * column)) = value.transpose();
}

Rows makeRows(std::size_t rows, std::size_t points) {
  return Rows(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(3 * points));
}

/// Points in rows of v become points in rows of u.
Rows transposedPoints(const Rows& rows) {
  const Eigen::Index points = rows.cols() / 3;
  Rows result(points, 3 * rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (Eigen::Index j = 0; j < points; ++j) result.block<1, 3>(j, 3 * i) = rows.block<1, 3>(i, 3 * j);
  return result;
}

/// A parameter where a slope is needed, and the side it is taken from.
struct SlopePlace {
  double at;
  KnotSide side;
};
std::vector<SlopePlace> slopePlaces(const CubicBreaks& breaks) {
  std::vector<SlopePlace> places;
  for (const auto& [from, to] : breaks.segments()) {
    places.push_back({breaks.at[from], KnotSide::Right});
    places.push_back({breaks.at[to], KnotSide::Left});
  }
  return places;
}

Rows pointsAtBreaks(const Motion& motion, const CubicBreaks& u, const CubicBreaks& v, const Progress& progress) {
  MotionGrid grid;
  evaluateGrid(motion, u.at, v.at, grid, GridDerivatives::No, progress);
  Rows values = makeRows(grid.countU, grid.countV);
  for (std::size_t i = 0; i < grid.countU; ++i)
    for (std::size_t j = 0; j < grid.countV; ++j) put(values, i, j, grid.pointAt(i, j));
  // Both sides of a seam are bitwise equal.
  if (motion.closedU != ClosedU::No) values.row(values.rows() - 1) = values.row(0);
  if (v.periodic) values.rightCols<3>() = values.leftCols<3>().eval();
  return values;
}

Surface interpolate(const Motion& motion, const CubicBreaks& u, const CubicBreaks& v, const Progress& progress) {
  const auto placesU = slopePlaces(u), placesV = slopePlaces(v);
  const Rows values = pointsAtBreaks(motion, u, v, progress);
  Rows slopesU = makeRows(placesU.size(), v.at.size()), slopesV = makeRows(u.at.size(), placesV.size()),
       twists = makeRows(placesU.size(), placesV.size());
  for (std::size_t i = 0; i < placesU.size(); ++i) {
    progress.check();
    for (std::size_t j = 0; j < v.at.size(); ++j)
      put(slopesU, i, j, evaluate(motion, placesU[i].at, v.at[j], placesU[i].side).du);
    for (std::size_t j = 0; j < placesV.size(); ++j)
      put(twists, i, j, evaluate(motion, placesU[i].at, placesV[j].at, placesU[i].side, placesV[j].side).duv);
  }
  for (std::size_t i = 0; i < u.at.size(); ++i) {
    progress.check();
    for (std::size_t j = 0; j < placesV.size(); ++j)
      put(slopesV, i, j, evaluate(motion, u.at[i], placesV[j].at, KnotSide::Right, placesV[j].side).dv);
  }
  if (motion.closedU != ClosedU::No) slopesV.row(slopesV.rows() - 1) = slopesV.row(0);

  const Rows along = transposedPoints(interpolateCubic(u, values, slopesU)),
             slopesAlong = placesV.empty() ? Rows(0, along.cols()) : transposedPoints(interpolateCubic(u, slopesV, twists));
  const Rows poles = interpolateCubic(v, along, slopesAlong);
  Surface surface{3, 3, u.knots(), v.knots(), {}};
  surface.poles.reserve(static_cast<std::size_t>(poles.size() / 3));
  for (Eigen::Index i = 0; i < poles.cols() / 3; ++i)
    for (Eigen::Index j = 0; j < poles.rows(); ++j)
      surface.poles.emplace_back(poles(j, 3 * i), poles(j, 3 * i + 1), poles(j, 3 * i + 2), 1.0);
  return surface;
}

/// Beginning of each of `samples` equal parts of every span, and the end: edges and middles are where errors are largest.
std::vector<double> spanSamples(int degree, const std::vector<double>& knots, int samples) {
  std::vector<double> result;
  for (std::size_t i = static_cast<std::size_t>(degree); i + static_cast<std::size_t>(degree) + 1 < knots.size(); ++i)
    for (int k = 0; k < samples && knots[i] < knots[i + 1]; ++k)
      result.push_back(knots[i] + (knots[i + 1] - knots[i]) * k / samples);
  result.push_back(knots[knots.size() - 1 - static_cast<std::size_t>(degree)]);
  return result;
}

}  // namespace

double deviation(const Motion& motion, const Surface& surface, int samples, double enough, const Progress& progress) {
  const std::vector<double> us = spanSamples(surface.degreeU, surface.knotsU, samples),
                            vs = spanSamples(surface.degreeV, surface.knotsV, samples);
  std::atomic<double> largest = 0;
  constexpr std::size_t strip = 64;
  parallelFor((us.size() + strip - 1) / strip, 1, progress, [&](std::size_t begin, std::size_t end) {
    MotionGrid wanted;
    for (std::size_t k = begin; k < end && largest <= enough; ++k) {
      const std::span<const double> part = std::span(us).subspan(k * strip, std::min(strip, us.size() - k * strip));
      evaluateGrid(motion, part, vs, wanted, GridDerivatives::No, progress);
      const auto given = evaluateGrid(surface, part, vs);
      double square = 0;
      for (std::size_t i = 0; i < given[0].size(); ++i) {
        const double dx = given[0][i] - wanted.point[0][i], dy = given[1][i] - wanted.point[1][i],
                     dz = given[2][i] - wanted.point[2][i];
        const double here = dx * dx + dy * dy + dz * dz;
        if (!std::isfinite(here))
          throw Error(ErrorCode::Degenerate, "The motion sweeps places beyond every number.",
                      "Make its factors smaller, or keep their weights away from 0.");
        square = std::max(square, here);
      }
      const double found = std::sqrt(square);
      for (double known = largest; known < found && !largest.compare_exchange_weak(known, found);) {
      }
    }
  });
  return largest;
}

CubicResult approximateCubic(const Motion& motion, const CubicOptions& options, const Progress& progress) {
  requireNonVanishing(motion.orientation, progress);
  CubicBreaks u = breaksU(motion), v = breaksV(motion);
  CubicResult result;
  while (true) {
    const std::size_t spansU = u.at.size() - 1, spansV = v.at.size() - 1;
    progress.report(0.1 + 0.8 * static_cast<double>(std::max(spansU, spansV)) / static_cast<double>(options.maximumSpans),
                    "Approximating");
    result.surface = interpolate(motion, u, v, progress);
    result.spansU = spansU, result.spansV = spansV;
    result.deviation = deviation(motion, result.surface, 8, options.tolerance, progress);
    if (result.deviation <= options.tolerance) return result;
    u = halved(u, options.maximumSpans), v = halved(v, options.maximumSpans);
    if (u.at.size() - 1 == spansU && v.at.size() - 1 == spansV)
      throw Error(
          ErrorCode::LimitExceeded,
          fmt::format("With {} x {} spans the cubic surface still deviates by {:.3g} mm or more; {:.3g} mm were asked for.",
                      spansU, spansV, result.deviation, options.tolerance),
          "Ask for a larger tolerance, or export the exact surface.");
  }
}

}  // namespace blossom::sweep
