#include "kernel/morph/extrapolation.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/boundary_tree.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_point.h"
#include "geometry/planar/sums/curved_sum.h"
#include "geometry/planar/sums/flattening.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr double roundingOfSize = 1e-9;

struct SignedTerms {
  std::optional<SoundRegion> added, taken;
};

void include(SignedTerms& terms, const SoundRegion& shape, double weight, Adder& add, const Progress& progress) {
  if (weight == 0) return;
  std::optional<SoundRegion>& total = weight > 0 ? terms.added : terms.taken;
  const SoundRegion term = scaled(shape, std::abs(weight));
  total = total ? add(*total, term, progress) : term;
}

/// Weights of a convex shape add up before it is taken.
SignedTerms termsAt(std::span<const double> t, std::span<const SoundRegion> shapes, Adder& add, const Progress& progress) {
  SignedTerms terms;
  const auto weights = weightsOf(t);
  const std::vector<double> shares = sharesOf(t);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (isConvex(shapes[i])) {
      include(terms, shapes[i], shares[i], add, progress);
      continue;
    }
    for (const auto& [weight, count] : weights[i])
      include(terms, repeated(shapes[i], count, add, progress), weight, add, progress);
  }
  return terms;
}

double sizeOf(const SoundRegion& shape) { return looseBox(shape.region.loops).sizes().norm(); }

/// Of straight lines where there are splines.
Region comparable(const SoundRegion& shape, Effort& effort, const Progress& progress) {
  if (!hasSplines(shape.region)) return shape.region;
  return toRegion(polygonsBeside(shape, Approximation::Either, "the morph", progress, effort));
}

/// The largest distance of a corner or the middle of a segment from the other outline. Lines and arcs that share these three
/// points are the same, and where the other one has a corner between them, that is asked for from the other side.
/// @pre no splines
double farthestFrom(const Region& other, const Region& one, const Progress& progress) {
  const BoundaryTree tree(other, progress);
  double distance = 0;
  for (const Path& loop : one.loops)
    for (const Segment& segment : loop.segments) {
      progress.check();
      distance = std::max({distance, tree.distanceTo(startPoint(segment)), tree.distanceTo(middleOf(segment))});
    }
  return distance;
}

double apart(const SoundRegion& a, const SoundRegion& b, Effort& effort, const Progress& progress) {
  const Region first = comparable(a, effort, progress), second = comparable(b, effort, progress);
  return std::max(farthestFrom(first, second, progress), farthestFrom(second, first, progress));
}

}  // namespace

bool isBeyond(std::span<const double> t) {
  return std::any_of(t.begin(), t.end(), [](double level) { return level < 0 || level > 1; });
}

std::optional<InBetween> continuedTo(std::span<const double> t, std::span<const SoundRegion> shapes, Adder& add,
                                     const Progress& progress) {
  const SignedTerms terms = termsAt(t, shapes, add, progress);
  const SoundRegion &whole = *terms.added, &part = *terms.taken;
  SoundRegion rest = difference(whole, part, progress, add.effort());
  if (rest.region.loops.empty()) return std::nullopt;
  const SoundRegion again = add(rest, part, progress);
  if (again.region.loops.size() != whole.region.loops.size()) return std::nullopt;
  const bool freeForm = !whole.plain || !part.plain;
  const double within = roundingOfSize * sizeOf(whole) + (freeForm ? 2 * (whole.tolerance + part.tolerance) : 0);
  const double found = apart(again, whole, add.effort(), progress);
  if (found > within) return std::nullopt;
  return InBetween{std::move(rest), freeForm ? found : 0};
}

double farthestTowards(double t, std::span<const SoundRegion> shapes, Adder& add, const Progress& progress) {
  constexpr int halvings = 10;
  double good = t > 1 ? 1 : 0, bad = t;
  for (int k = 0; k < halvings; ++k) {
    progress.check();
    const double middle = std::round((good + bad) / 2 * 1e4) / 1e4;
    if (middle == good || middle == bad) break;
    (continuedTo(std::vector<double>(shapes.size() - 1, middle), shapes, add, progress) ? good : bad) = middle;
  }
  return good;
}

}  // namespace blossom::minkowski
