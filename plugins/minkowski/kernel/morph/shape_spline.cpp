#include "kernel/morph/shape_spline.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/planar/sums/flattening.h"
#include "kernel/morph/blended_area.h"
#include "kernel/morph/evaluation_order.h"
#include "kernel/morph/point_shape.h"
#include "kernel/morph/repetition.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

/// Where the knots begin and end to count.
double firstOf(const ShapeKnots& spline) { return spline.knots[static_cast<std::size_t>(spline.degree)]; }
double lastOf(const ShapeKnots& spline) {
  return spline.knots[spline.knots.size() - 1 - static_cast<std::size_t>(spline.degree)];
}

std::size_t shapesOf(const ShapeKnots& spline) { return spline.knots.size() - static_cast<std::size_t>(spline.degree) - 1; }

/// The place of t among the knots, and the number of the last shape that has a share there.
struct KnotSpan {
  double u;
  std::size_t last;
};

KnotSpan spanOf(const ShapeKnots& spline, double t) {
  const double u = firstOf(spline) + t * (lastOf(spline) - firstOf(spline));
  const auto begin = spline.knots.begin() + spline.degree, end = spline.knots.end() - spline.degree - 1;
  auto after = std::upper_bound(begin, end, u);
  if (u >= lastOf(spline)) after = std::lower_bound(begin, end, lastOf(spline));  // the end belongs to the last span
  return {std::min(u, lastOf(spline)), static_cast<std::size_t>(after - spline.knots.begin()) - 1};
}

/// The share of shape i in its blend with the one before it, `level` from 1 on.
double shareOf(const ShapeKnots& spline, double u, std::size_t i, std::size_t level) {
  const double from = spline.knots[i], to = spline.knots[i + static_cast<std::size_t>(spline.degree) - level + 1];
  return (u - from) / (to - from);
}

[[noreturn]] void refuseKnots(const std::string& what, const std::string& remedy) {
  throw Error(ErrorCode::InvalidParameter, what, remedy);
}

class SplineMorph {
 public:
  SplineMorph(std::span<const Region> regions, const ShapeKnots& spline, const MorphOptions& options,
              const Progress& progress)
      : regions_(regions), points_(regions), spline_(spline), add_(options.maximumWork) {
    for (std::size_t i = 0; i < regions.size(); ++i) {
      shapes_.push_back(soundControl(regions[i], {.tolerance = options.tolerance, .effort = &add_.effort()},
                                     fmt::format("control shape {}", i + 1), progress));
      convex_.push_back(repeatsAsMultiple(shapes_.back()));
    }
    if (options.areaPreserving) area_.emplace(shapes_);
  }

  void plan(std::size_t frames) {
    const auto degree = static_cast<std::size_t>(spline_.degree);
    const bool all = std::all_of(convex_.begin(), convex_.end(), [](bool each) { return each; });
    add_.plan(frames * (all ? degree : degree * (degree + 1) / 2));
  }

  Region at(double t, const Progress& progress) {
    const auto shares = influences(spline_, t);
    const auto whole = std::find(shares.begin(), shares.end(), 1.0);
    if (whole != shares.end()) return regions_[static_cast<std::size_t>(whole - shares.begin())];
    const KnotSpan span = spanOf(spline_, t);
    const std::size_t degree = static_cast<std::size_t>(spline_.degree), first = span.last - degree;
    const bool convex =
        std::all_of(convex_.begin() + static_cast<std::ptrdiff_t>(first),
                    convex_.begin() + static_cast<std::ptrdiff_t>(span.last + 1), [](bool each) { return each; });
    SoundRegion made = convex ? byShares(shares, progress) : byLevels(span, first, progress);
    if (area_) made = area_->of({std::move(made)}, shares).shape;
    return points_.moved(std::move(made.region), shares);
  }

  [[nodiscard]] std::size_t sums() const { return add_.count(); }

 private:
  SoundRegion byShares(const std::vector<double>& shares, const Progress& progress) {
    std::optional<SoundRegion> total;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (!(shares[i] > 0)) continue;
      const SoundRegion term = scaled(shapes_[i], shares[i]);
      total = total ? add_(*total, term, progress) : term;
    }
    return *total;
  }

  SoundRegion byLevels(const KnotSpan& span, std::size_t first, const Progress& progress) {
    std::vector<SoundRegion> row(shapes_.begin() + static_cast<std::ptrdiff_t>(first),
                                 shapes_.begin() + static_cast<std::ptrdiff_t>(span.last + 1));
    for (std::size_t level = 1; level < row.size(); ++level)
      for (std::size_t k = row.size() - 1; k >= level; --k)
        row[k] = between(row[k - 1], row[k], shareOf(spline_, span.u, first + k, level), add_, progress);
    return row.back();
  }

  std::span<const Region> regions_;
  PointPlaces points_;
  const ShapeKnots& spline_;
  Adder add_;
  std::vector<SoundRegion> shapes_;
  std::optional<BlendedArea> area_;  ///< that in-betweens are given
  std::vector<bool> convex_;
};

}  // namespace

ShapeKnots uniformKnots(std::size_t shapes, int degree) {
  ShapeKnots spline{degree, {}};
  const int spans = static_cast<int>(shapes) - degree;
  for (int k = -degree; k <= spans + degree; ++k) spline.knots.push_back(std::clamp(k, 0, std::max(spans, 0)));
  return spline;
}

ShapeKnots knotsFor(std::size_t shapes, int degree, const std::vector<double>& knots) {
  if (degree == 0 && knots.size() > shapes + 1) degree = static_cast<int>(knots.size() - shapes) - 1;
  if (degree == 0 && knots.empty()) degree = static_cast<int>(shapes) - 1;
  if (degree == 0)
    refuseKnots(fmt::format("{} are too few knots for {} control shapes.", knots.size(), shapes),
                fmt::format("Give {} for degree 1, up to {} for degree {}; or none, for evenly spaced ones.", shapes + 2,
                            2 * shapes, shapes - 1));
  ShapeKnots spline = knots.empty() ? uniformKnots(shapes, degree) : ShapeKnots{degree, knots};
  checkKnots(spline, shapes);
  return spline;
}

void checkKnots(const ShapeKnots& spline, std::size_t shapes) {
  if (spline.degree < 1 || static_cast<std::size_t>(spline.degree) >= shapes)
    refuseKnots(fmt::format("{} control shapes cannot have the degree {}.", shapes, spline.degree),
                fmt::format("Give a degree of 1 to {}.", shapes - 1));
  const std::size_t degree = static_cast<std::size_t>(spline.degree), wanted = shapes + degree + 1;
  if (spline.knots.size() != wanted)
    refuseKnots(fmt::format("{} control shapes of degree {} need {} knots; {} are given.", shapes, degree, wanted,
                            spline.knots.size()),
                "Give as many as shapes, the degree and one more; or none, for evenly spaced ones.");
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end()))
    refuseKnots("The knots do not rise.", "Give them from the smallest to the largest.");
  if (spline.knots.front() != firstOf(spline) || spline.knots.back() != lastOf(spline) || firstOf(spline) == lastOf(spline))
    refuseKnots("The morph would not begin at the first shape or end at the last one.",
                fmt::format("Give the first and the last knot {} times each.", degree + 1));
  for (std::size_t i = 1; i + degree < spline.knots.size() - 1; ++i)
    if (spline.knots[i] == spline.knots[i + degree])
      refuseKnots(fmt::format("The knot {} is there more often than the degree, {}.", spline.knots[i], degree),
                  "Leave out those too many: shapes would jump there.");
}

std::optional<int> continuityOf(const ShapeKnots& spline) {
  std::optional<int> least;
  for (auto knot = spline.knots.begin(); knot != spline.knots.end();) {
    const auto next = std::upper_bound(knot, spline.knots.end(), *knot);
    if (*knot > firstOf(spline) && *knot < lastOf(spline)) {
      const int here = spline.degree - static_cast<int>(next - knot);
      least = least ? std::min(*least, here) : here;
    }
    knot = next;
  }
  return least;
}

std::vector<double> influences(const ShapeKnots& spline, double t) {
  const auto [u, last] = spanOf(spline, t);
  const auto degree = static_cast<std::size_t>(spline.degree);
  std::vector<double> basis{1};
  for (std::size_t level = 1; level <= degree; ++level) {
    std::vector<double> next(level + 1, 0);
    for (std::size_t k = 0; k < level; ++k) {
      // What the function k of the level below gives to its two successors.
      const std::size_t i = last - level + 1 + k;
      const double share = (u - spline.knots[i]) / (spline.knots[i + level] - spline.knots[i]);
      next[k] += (1 - share) * basis[k];
      next[k + 1] += share * basis[k];
    }
    basis = std::move(next);
  }
  std::vector<double> all(shapesOf(spline), 0);
  std::copy(basis.begin(), basis.end(), all.begin() + static_cast<std::ptrdiff_t>(last - degree));
  return all;
}

MorphResult splineMorph(std::span<const Region> shapes, const ShapeKnots& spline, std::span<const double> times,
                        const MorphOptions& options, const Progress& progress) {
  checkKnots(spline, shapes.size());
  for (const double t : times)
    if (!(t >= 0 && t <= 1))
      throw Error(ErrorCode::InvalidParameter, fmt::format("Every t must lie between 0 and 1; one is {}.", t),
                  "A morph with a degree or knots does not go on beyond its ends: give t within them.");
  SplineMorph evaluation(shapes, spline, options, progress);
  evaluation.plan(times.size());
  MorphResult result;
  for (const double t : times) {
    progress.check();
    result.regions.push_back(evaluation.at(t, progress));
  }
  result.sums = evaluation.sums();
  return result;
}

}  // namespace blossom::minkowski
