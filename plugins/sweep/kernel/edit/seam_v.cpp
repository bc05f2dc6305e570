#include "kernel/edit/seam_v.h"

#include <algorithm>
#include <map>
#include <span>

#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

/// Below this share of what the poles contribute, what is left of the free ones is rounding: see smallestShare of placeRow.
constexpr double leftOfShares = 1e-6;

/// What the poles piece - degree .. piece contribute to the blossom of the piece that begins at knots[piece] (de Boor's
/// recurrence with an argument of its own for each step).
std::vector<double> blossomShares(int degree, std::span<const double> knots, std::size_t piece,
                                  std::span<const double> arguments) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<std::vector<double>> shares(p + 1, std::vector<double>(p + 1, 0.0));
  for (std::size_t i = 0; i <= p; ++i) shares[i][i] = 1;
  for (std::size_t level = 1; level <= p; ++level)
    for (std::size_t i = p; i >= level; --i) {
      const double from = knots[piece - p + i], to = knots[piece + 1 + i - level];
      const double part = (arguments[level - 1] - from) / (to - from);
      for (std::size_t k = 0; k <= p; ++k) shares[i][k] = (1 - part) * shares[i - 1][k] + part * shares[i][k];
    }
  return shares[p];
}

using Shares = std::map<std::size_t, double>;

/// The periodic spline that a clamped one with joined ends is.
class Ring {
 public:
  Ring(int degree, const std::vector<double>& clamped, const JoinedEnds& ends)
      : degree_(degree),
        kept_(static_cast<std::size_t>(ends.continuity)),
        poles_(clamped.size() - static_cast<std::size_t>(degree) - 1),
        free_(poles_ - 1 - kept_),
        clamped_(clamped),
        knots_(ringSpace({degree, clamped}, ends).knots) {}

  [[nodiscard]] std::size_t countFree() const { return free_; }
  [[nodiscard]] std::size_t countPoles() const { return poles_; }

  /// Whether a clamped pole is a free one, which then is pole - continuity.
  [[nodiscard]] bool isFree(std::size_t pole) const { return pole >= kept_ && pole + kept_ < poles_; }

  /// A clamped pole by free ones.
  [[nodiscard]] Shares sharesOf(std::size_t pole, double ratio) const {
    if (isFree(pole)) return {{pole - kept_, 1}};
    const auto p = static_cast<std::size_t>(degree_);
    const std::size_t piece = pole < kept_ ? 2 * p - kept_ - 1 : p + free_ - 1;
    const std::vector<double> rows = blossomShares(degree_, knots_, piece, std::span(clamped_).subspan(pole + 1, p));
    Shares shares;
    for (std::size_t i = 0; i <= p; ++i) {
      // Row p - 1 is the first free pole; those before and after one period are multiples of others.
      double share = rows[i];
      std::size_t row = piece - p + i;
      for (; row + 1 < p; row += free_) share /= ratio;
      for (; row + 1 - p >= free_; row -= free_) share *= ratio;
      if (share != 0) shares[row + 1 - p] += share;
    }
    return shares;
  }

  /// The value of a free pole, from one value at each clamped pole.
  [[nodiscard]] double atFree(std::size_t free, const std::vector<double>& values) const {
    if (isFree(free + kept_)) return values[free + kept_];
    const auto p = static_cast<std::size_t>(degree_);
    const auto arguments = std::span(knots_).subspan(free + p, p);
    const std::size_t piece = findSpan(degree_, clamped_, arguments.front());
    const std::vector<double> shares = blossomShares(degree_, clamped_, piece, arguments);
    double value = 0;
    for (std::size_t i = 0; i <= p; ++i) value += shares[i] * values[piece - p + i];
    return value;
  }

 private:
  int degree_;
  std::size_t kept_, poles_, free_;
  std::vector<double> clamped_, knots_;  ///< of the given spline; of the periodic one, unwrapped
};

std::vector<double> weightsOfFree(const Curve& trajectory, const Ring& ring) {
  std::vector<double> weights;
  for (const Vec4& pole : trajectory.poles) weights.push_back(pole[3]);
  const double smallest = *std::min_element(weights.begin(), weights.end());
  std::vector<double> result;
  for (std::size_t free = 0; free < ring.countFree(); ++free) {
    const double weight = ring.atFree(free, weights);
    result.push_back(weight > 0 ? weight : smallest);
  }
  return result;
}

}  // namespace

SplineSpace ringSpace(const SplineSpace& clamped, const JoinedEnds& ends) {
  const int p = clamped.degree;
  std::vector<double> period(static_cast<std::size_t>(p - ends.continuity), clamped.knots.front());
  period.insert(period.end(), clamped.knots.begin() + p + 1, clamped.knots.end() - p);
  return {p, unwrappedKnots(p, period), ends.ratio};
}

void SeamV::assign(std::vector<std::vector<Share>> freeOfPole) {
  freeOfPole_ = std::move(freeOfPole);
  polesOfFree_.assign(freeOfPole_.size(), {});
  for (std::size_t pole = 0; pole < freeOfPole_.size(); ++pole)
    for (const Share& each : freeOfPole_[pole]) polesOfFree_[each.pole].push_back({pole, each.share});
}

SeamV::SeamV(const Curve& trajectory, const JoinedEnds& ends) : ends_(ends) {
  const Ring ring(trajectory.degree, trajectory.knots, ends);
  const std::vector<double> weights = weightsOfFree(trajectory, ring);
  std::vector<std::vector<Share>> all(ring.countPoles());
  for (std::size_t pole = 0; pole + 1 < all.size(); ++pole)
    for (const auto& [free, share] : ring.sharesOf(pole, ends.ratio))
      all[pole].push_back({free, ring.isFree(pole) ? share : share * weights[free] / trajectory.poles[pole][3]});
  all.back() = all.front();  // the same point, to the bit
  assign(std::move(all));
}

SeamV::SeamV(const SplineSpace& clamped, const JoinedEnds& ends) : ends_(ends) {
  const Ring ring(clamped.degree, clamped.knots, ends);
  std::vector<std::vector<Share>> all(ring.countPoles());
  for (std::size_t pole = 0; pole + 1 < all.size(); ++pole)
    for (const auto& [free, share] : ring.sharesOf(pole, ends.ratio)) all[pole].push_back({free, share});
  for (const Share& each : all.front()) all.back().push_back({each.pole, ends.ratio * each.share});
  assign(std::move(all));
}

PlaceRow SeamV::onFreePoles(const PlaceRow& row) const {
  if (freeOfPole_.empty() || row.cancelled) return row;
  const std::size_t columns = freeOfPole_.size();
  Shares shares;
  double before = 0, after = 0;
  for (std::size_t k = 0; k < row.pole.size(); ++k) {
    const std::size_t first = row.pole[k] / columns * columns;
    before += row.share[k] * row.share[k];
    for (const Share& each : freeOfPole_[row.pole[k] % columns]) shares[first + each.pole] += row.share[k] * each.share;
  }
  for (const auto& [pole, share] : shares) after += share * share;
  PlaceRow result;
  result.cancelled = after < leftOfShares * leftOfShares * before;
  if (result.cancelled) return result;
  for (const auto& [pole, share] : shares) {
    if (share == 0) continue;
    result.pole.push_back(pole);
    result.share.push_back(share);
  }
  return result;
}

PoleChange SeamV::onAllPoles(const PoleChange& change) const {
  if (freeOfPole_.empty()) return change;
  const std::size_t columns = freeOfPole_.size();
  std::map<std::size_t, Eigen::RowVectorXd> sums;
  for (std::size_t k = 0; k < change.pole.size(); ++k) {
    const std::size_t first = change.pole[k] / columns * columns;
    for (const Share& each : polesOfFree_[change.pole[k] % columns]) {
      const Eigen::RowVectorXd by = each.share * change.by.row(static_cast<Eigen::Index>(k));
      const auto [sum, isNew] = sums.try_emplace(first + each.pole, by);
      if (!isNew) sum->second += by;
    }
  }
  PoleChange result{{}, Eigen::MatrixXd(static_cast<Eigen::Index>(sums.size()), change.by.cols()), change.residual};
  for (const auto& [pole, by] : sums) {
    result.by.row(static_cast<Eigen::Index>(result.pole.size())) = by;
    result.pole.push_back(pole);
  }
  return result;
}

SpaceMap SeamV::fromFunctions(const SplineSpace& ring) const {
  const std::size_t count = ring.size();
  SpaceMap map{count};
  for (const std::vector<Share>& shares : freeOfPole_) {
    for (const Share& each : shares) {
      // Row degree - 1 is the first free pole.
      const std::size_t row = each.pole + static_cast<std::size_t>(ring.degree) - 1;
      map.coarse.push_back(row % count);
      map.weight.push_back(afterPeriods(ring.closure, static_cast<long>(row / count)) * each.share);
    }
    map.begin.push_back(map.weight.size());
  }
  return map;
}

}  // namespace blossom::sweep
