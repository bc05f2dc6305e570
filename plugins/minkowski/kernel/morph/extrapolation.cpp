#include "kernel/morph/extrapolation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/error.h"
#include "geometry/planar/boundary_tree.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/segment_point.h"
#include "geometry/planar/sums/curved_sum.h"
#include "geometry/planar/sums/flattening.h"
#include "kernel/morph/point_shape.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr double sameOfSize = 1e-9;
constexpr double hiddenOfSize = 1e-6;  // of the shape, which the rounding of what it is taken from may not exceed

struct SignedTerms {
  std::optional<SoundRegion> added, taken;
};

void include(SignedTerms& terms, const SoundRegion& shape, double weight, Adder& add, const Progress& progress) {
  if (weight == 0 || isOrigin(shape)) return;
  std::optional<SoundRegion>& total = weight > 0 ? terms.added : terms.taken;
  const SoundRegion term = scaled(shape, std::abs(weight));
  total = total ? add(*total, term, progress) : term;
}

/// With a finer tolerance where curves are drawn by it: how far a shape may be off decides whether there is one.
SoundRegion finer(SoundRegion shape) {
  constexpr double times = 16;
  if (!shape.plain) shape.tolerance /= times;
  shape.kept = 0;  // what is kept of it has the other tolerance
  return shape;
}

/// Weights of a convex shape add up before it is taken.
SignedTerms termsAt(std::span<const double> t, std::span<const SoundRegion> shapes, Adder& add, const Progress& progress) {
  SignedTerms terms;
  const std::vector<double> shares = sharesOf(t);
  const bool allConvex =
      std::all_of(shapes.begin(), shapes.end(), [](const SoundRegion& each) { return repeatsAsMultiple(each); });
  if (!allConvex && choicesOf(t) > mostChoices)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The morph of {} different blossom numbers beyond its ends has too many terms.", t.size()),
                "Give equal numbers.");
  const auto weights = allConvex ? std::vector<std::map<double, std::size_t>>(shapes.size()) : weightsOf(t);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (repeatsAsMultiple(shapes[i])) {
      include(terms, shapes[i], shares[i], add, progress);
      continue;
    }
    for (const auto& [weight, count] : weights[i])
      include(terms, repeated(shapes[i], count, add, progress), weight, add, progress);
  }
  return terms;
}

double sizeOf(const SoundRegion& shape) { return boxAround(shape.region.loops).sizes().norm(); }

/// Of sums of a shape.
double roundingOf(const SoundRegion& shape) { return std::ldexp(sizeOf(shape), -35); }

/// Of coordinates far away.
double roundingOfPlaces(const SoundRegion& shape) {
  const Box2 box = looseBox(shape.region.loops);
  return std::ldexp(std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()), -44);
}

/// How far the corner where one segment ends and the next begins moves when their sides move by 1; a hundred at most.
double leverAt(const Segment& side, const Segment& next) {
  const Vec2 in = endPoint(side) - startPoint(side), out = endPoint(next) - startPoint(next);
  const double turn = std::atan2(cross(in, out), in.dot(out));
  return 1 / std::max(std::cos(turn / 2), 0.01);
}

/// Of straight lines where there are splines.
Region comparable(const SoundRegion& shape, Effort& effort, const Progress& progress) {
  if (!hasSplines(shape.region)) return shape.region;
  return toRegion(polygonsBeside(shape, Approximation::Either, "the morph", progress, effort));
}

/// Of two outlines: the largest distance, and the largest by which sides have moved if that moved the corners.
struct OutlineDifference {
  double distance = 0, sides = 0;
};

/// Of the corners and the middles of the segments from the other outline. Lines and arcs that share these three points are
/// the same, and where the other one has a corner between them, that is asked for from the other side.
/// @pre no splines
OutlineDifference differenceFrom(const Region& other, const Region& one, const Progress& progress) {
  const BoundaryTree tree(other, progress);
  OutlineDifference all;
  const auto add = [&](double distance, double lever) {
    all = {std::max(all.distance, distance), std::max(all.sides, distance / lever)};
  };
  for (const Path& loop : one.loops) {
    const std::size_t n = loop.segments.size();
    for (std::size_t i = 0; i < n; ++i) {
      progress.check();
      const Segment& segment = loop.segments[i];
      const double before = leverAt(loop.segments[(i + n - 1) % n], segment),
                   after = leverAt(segment, loop.segments[(i + 1) % n]);
      add(tree.distanceTo(startPoint(segment)), before);
      add(tree.distanceTo(middleOf(segment)), (before + after) / 2);
    }
  }
  return all;
}

OutlineDifference differenceOf(const SoundRegion& a, const SoundRegion& b, Effort& effort, const Progress& progress) {
  const Region first = comparable(a, effort, progress), second = comparable(b, effort, progress);
  const OutlineDifference one = differenceFrom(first, second, progress), other = differenceFrom(second, first, progress);
  return {std::max(one.distance, other.distance), std::max(one.sides, other.sides)};
}

}  // namespace

bool isBeyond(std::span<const double> t) {
  return std::any_of(t.begin(), t.end(), [](double level) { return level < 0 || level > 1; });
}

std::optional<InBetween> continuedTo(std::span<const double> t, std::span<const SoundRegion> shapes, Adder& add,
                                     const Progress& progress) {
  std::vector<SoundRegion> fine;
  for (const SoundRegion& shape : shapes) fine.push_back(finer(shape));
  const SignedTerms terms = termsAt(t, fine, add, progress);
  if (!terms.taken) return InBetween{terms.added.value_or(SoundRegion())};  // only points are taken away
  if (!terms.added) return std::nullopt;
  const SoundRegion &whole = *terms.added, &part = *terms.taken;
  SoundRegion rest = difference(whole, part, progress, add.effort());
  if (rest.region.loops.empty()) return std::nullopt;
  const SoundRegion again = add(rest, part, progress);
  if (again.region.loops.size() != whole.region.loops.size()) return std::nullopt;
  const double rounding = roundingOf(whole), same = sameOfSize * sizeOf(rest) + rounding + roundingOfPlaces(whole);
  if (rounding > hiddenOfSize * sizeOf(rest)) return std::nullopt;
  const bool freeForm = !whole.plain || !part.plain;
  const double curves = freeForm ? 2 * (whole.tolerance + part.tolerance) : 0;
  const OutlineDifference found = differenceOf(again, whole, add.effort(), progress);
  if (found.distance > same && found.sides > curves) return std::nullopt;
  return InBetween{std::move(rest), found.distance > same ? found.distance : 0};
}

double farthestTowards(double t, const std::function<bool(double)>& isThere, const Progress& progress) {
  constexpr int halvings = 10;
  double good = t > 1 ? 1 : 0, bad = t;
  for (int k = 0; k < halvings; ++k) {
    progress.check();
    const double middle = std::round((good + bad) / 2 * 1e4) / 1e4;
    if (middle == good || middle == bad) break;
    (isThere(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace blossom::minkowski
