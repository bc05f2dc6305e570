#include "kernel/morph/expansion.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "geometry/planar/segment_box.h"
#include "geometry/planar/sums/convex_hull.h"
#include "kernel/hull_distance.h"
#include "kernel/morph/point_shape.h"
#include "kernel/morph/thinning.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

std::size_t cornersOf(const SoundRegion& shape) {
  std::size_t corners = 0;
  for (const Path& loop : shape.region.loops) corners += loop.segments.size();
  return corners;
}

/// Whether so many corners may meet that the sums take long, and dents are filled (see thinning.h).
bool makeVeryManyCorners(const std::vector<SoundRegion>& terms) {
  constexpr double veryMany = 1e9;
  if (std::any_of(terms.begin(), terms.end(), [](const SoundRegion& term) { return hasCurves(term.region); })) return false;
  const auto times = [](double product, const SoundRegion& term) { return product * static_cast<double>(cornersOf(term)); };
  return std::accumulate(terms.begin(), terms.end(), 1.0, times) > veryMany;
}

/// So the dents of small shapes are filled before larger ones multiply them.
void smallestFirst(std::vector<SoundRegion>& terms) {
  const auto size = [](const SoundRegion& term) { return boxAround(term.region.loops).sizes().norm(); };
  std::stable_sort(terms.begin(), terms.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
}

}  // namespace

void Expansion::repeatFor(std::span<const double> t, const Progress& progress) {
  for (const auto& [i, weight, count] : termsOf(t, progress)) {
    const auto [place, isNew] = repetitions_.try_emplace({i, count});
    if (!isNew) continue;
    place->second = repeated(shapes_[i], count, add_, progress);
    add_.keep(place->second);
  }
}

InBetween Expansion::at(std::span<const double> t, const Progress& progress) const {
  std::vector<SoundRegion> terms;
  const Arguments key(t.begin(), t.end());
  std::map<std::size_t, double> multiples;
  for (const auto& [i, weight, count] : hullsFor_.at(key)) multiples[i] += weight * static_cast<double>(count);
  terms.reserve(multiples.size() + termsFor_.at(key).size());
  for (const auto& [i, multiple] : multiples) terms.push_back(scaled(hulls_[i]->shape, multiple));
  for (const auto& [i, weight, count] : termsFor_.at(key)) terms.push_back(scaled(repetitions_.at({i, count}), weight));
  if (terms.empty()) return {};  // points alone
  const double tolerance = toleranceAt(t);
  double deviation = errorOfHulls_.at(key);
  const bool many = makeVeryManyCorners(terms);
  if (many) smallestFirst(terms);
  SoundRegion total = std::move(terms.front());
  for (std::size_t k = 1; k < terms.size(); ++k) {
    total = add_(total, terms[k], progress);
    if (terms.size() <= 2) continue;  // one sum alone stays as it is
    // Half is left for the sums to come, which have the most corners, if not the smallest shapes came first.
    const bool isLast = k + 1 == terms.size();
    Thinning thin((tolerance - deviation) / (many || isLast ? 1 : 2));
    total = thin(std::move(total), progress);
    deviation += thin.deepest();
  }
  return {std::move(total), deviation};
}

Expansion::Hull& Expansion::hullOf(std::size_t i, const Progress& progress) {
  std::optional<Hull>& hull = hulls_[i];
  if (!hull) {
    hull = Hull{convexHull(shapes_[i], progress)};
    hull->ofOne = circumradius(hull->shape.region, tolerance_, progress);
    hull->distance = std::numbers::sqrt2 * hull->ofOne;
  }
  return *hull;
}

double Expansion::toleranceAt(std::span<const double> t) const {
  const std::vector<double> shares = sharesOf(t);
  double sum = 0;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (!isOrigin(shapes_[i])) sum += shares[i];
  return tolerance_ * std::min(sum, 1.0);
}

double Expansion::errorOf(const Term& term, const Progress& progress) {
  constexpr std::size_t many = 64;  // then doubling takes longer than measuring
  Hull& hull = hullOf(term.shape, progress);
  if (term.count == 1) return term.weight * hull.ofOne;
  if (term.weight * hull.distance > tolerance_ && term.count > many && !hull.isMeasured) {
    const SoundRegion two = repeated(shapes_[term.shape], 2, add_, progress);
    const double precision = 1e-3 * hull.distance;
    const double measured = distanceToHull(two.region, scaled(hull.shape, 2).region, precision, progress).atMost;
    hull.distance = std::min(hull.distance, measured);
    hull.isMeasured = true;
  }
  return term.weight * hull.distance;
}

const std::vector<Expansion::Term>& Expansion::termsOf(std::span<const double> t, const Progress& progress) {
  const auto [place, isNew] = termsFor_.try_emplace(Arguments(t.begin(), t.end()));
  if (!isNew) return place->second;
  std::vector<Term>& hulls = hullsFor_[place->first];
  std::vector<std::pair<double, Term>> byError;
  const auto weights = weightsOf(t);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (isOrigin(shapes_[i])) continue;
    for (const auto& [weight, count] : weights[i]) {
      const Term term{i, weight, count};
      if (isConvex(shapes_[i]))
        place->second.push_back(term);
      else
        byError.emplace_back(errorOf(term, progress), term);
    }
  }
  std::stable_sort(byError.begin(), byError.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const bool isOneSum = place->second.size() + byError.size() <= 2;  // which stays as it is
  const double tolerance = isOneSum ? 0 : toleranceAt(t);
  double error = 0;
  for (const auto& [more, term] : byError) {
    if (error + more <= tolerance) {
      error += more;
      hulls.push_back(term);
    } else {
      place->second.push_back(term);
    }
  }
  errorOfHulls_[place->first] = error;
  std::stable_sort(place->second.begin(), place->second.end(),
                   [](const Term& a, const Term& b) { return a.shape < b.shape; });
  return place->second;
}

}  // namespace blossom::minkowski
