#include "kernel/validity.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "kernel/edit/seam_v.h"
#include "kernel/greville.h"
#include "kernel/grid/motion_grid.h"
#include "kernel/grid/motion_point.h"
#include "kernel/grid/span_parameters.h"
#include "kernel/product_surface.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t placesInSpan = 8, mostPlaces = 4'000'000;  // 13 numbers each

/// Lengths of x_u cross x_v on a grid of parameters.
class NormalSamples {
 public:
  struct Place {
    std::size_t k, l;
  };

  NormalSamples(const Motion& motion, std::vector<double> us, std::vector<double> vs, const Progress& progress)
      : us_(std::move(us)), vs_(std::move(vs)) {
    evaluateGrid(motion, us_, vs_, grid_, GridDerivatives::Yes, progress);
    length_.reserve(us_.size() * vs_.size());
    for (std::size_t k = 0; k < us_.size(); ++k)
      for (std::size_t l = 0; l < vs_.size(); ++l) length_.push_back(grid_.duAt(k, l).cross(grid_.dvAt(k, l)).norm());
    largest_ = *std::max_element(length_.begin(), length_.end());
  }

  [[nodiscard]] double at(const Place& p) const { return length_[p.k * vs_.size() + p.l]; }
  [[nodiscard]] double largest() const { return largest_; }

  [[nodiscard]] Vec3 normal(const Place& p) const { return grid_.duAt(p.k, p.l).cross(grid_.dvAt(p.k, p.l)); }
  [[nodiscard]] Vec2 parameters(const Place& p) const { return {us_[p.k], vs_[p.l]}; }

  using Turn = std::pair<Place, Place>;
  /// Neighbours whose normals point away from each other, some along every line of the grid: a sharp edge along one of them
  /// does not hide a fold along another. A sample without a normal, at a pole or just where the surface folds, is passed
  /// over: what rounding leaves there points anywhere. So are neighbours along the rim: where the surface ends in an edge,
  /// its last section runs forth and back along it, and what folds farther inside is seen there.
  /// @param least length of what is a normal
  [[nodiscard]] std::vector<Turn> turns(double least) const {
    std::vector<Turn> found;
    for (std::size_t k = 0; k < us_.size(); ++k) {
      std::vector<Turn> acrossU;
      for (std::size_t l = 1; l + 1 < vs_.size(); ++l) addTurn({k, l}, {1, 0}, least, acrossU);
      addSome(acrossU, found);
    }
    for (std::size_t l = 0; l < vs_.size(); ++l) {
      std::vector<Turn> acrossV;
      for (std::size_t k = 1; k + 1 < us_.size(); ++k) addTurn({k, l}, {0, 1}, least, acrossV);
      addSome(acrossV, found);
    }
    return found;
  }

  [[nodiscard]] Place leastPlace() const {
    const auto least = static_cast<std::size_t>(std::min_element(length_.begin(), length_.end()) - length_.begin());
    return {least / vs_.size(), least % vs_.size()};
  }
  [[nodiscard]] Validity least() const {
    const Place p = leastPlace();
    return {at(p), 0, us_[p.k], vs_[p.l], grid_.pointAt(p.k, p.l), {}};
  }

  /// Parameters one step before and after a sample, those at the ends of the domain left where they are.
  [[nodiscard]] std::array<std::pair<double, double>, 2> around(const Place& p) const {
    const auto step = [](const std::vector<double>& all, std::size_t i) {
      return std::pair(all[i == 0 ? 0 : i - 1], all[std::min(i + 1, all.size() - 1)]);
    };
    return {step(us_, p.k), step(vs_, p.l)};
  }

  /// Samples that are not larger than their neighbours, the least ones first. Those of a surface whose normal hardly changes
  /// are none: nothing smaller is to be expected there.
  [[nodiscard]] std::vector<Place> lows() const {
    constexpr std::size_t most = 32;
    constexpr double promising = 0.5;  // of the largest
    const double below = promising * largest();
    std::vector<Place> found;
    for (std::size_t k = 0; k < us_.size(); ++k)
      for (std::size_t l = 0; l < vs_.size(); ++l)
        if (at({k, l}) > 0 && at({k, l}) < below && isLow(k, l)) found.push_back({k, l});
    std::stable_sort(found.begin(), found.end(), [&](const Place& a, const Place& b) { return at(a) < at(b); });
    if (found.size() > most) found.resize(most);
    return found;
  }

 private:
  void addTurn(const Place& from, const Place& step, double least, std::vector<Turn>& turns) const {
    constexpr double away = -0.5;  // cosine
    Place next{from.k + step.k, from.l + step.l};
    if (within(next) && !(at(next) > least)) next = {from.k + 2 * step.k, from.l + 2 * step.l};
    if (!within(next) || !(at(from) > least) || !(at(next) > least)) return;
    if (normal(from).dot(normal(next)) < away * at(from) * at(next)) turns.emplace_back(from, next);
  }
  static void addSome(const std::vector<Turn>& turns, std::vector<Turn>& found) {
    constexpr std::size_t most = 8;
    const std::size_t count = std::min(turns.size(), most);
    for (std::size_t i = 0; i < count; ++i) found.push_back(turns[i * turns.size() / count]);
  }
  [[nodiscard]] bool within(const Place& p) const { return p.k < us_.size() && p.l < vs_.size(); }

  /// Of neighbours that are equal up to rounding the first one alone: a fold along a line is one place.
  [[nodiscard]] bool isLow(std::size_t k, std::size_t l) const {
    constexpr double rounding = 1e-9;
    const double own = at({k, l});
    for (std::size_t i = k == 0 ? 0 : k - 1; i <= std::min(k + 1, us_.size() - 1); ++i)
      for (std::size_t j = l == 0 ? 0 : l - 1; j <= std::min(l + 1, vs_.size() - 1); ++j) {
        const bool before = std::pair(i, j) < std::pair(k, l);
        if (std::pair(i, j) != std::pair(k, l) && at({i, j}) < own * (before ? 1 + rounding : 1 - rounding)) return false;
      }
    return true;
  }

  std::vector<double> us_, vs_;
  MotionGrid grid_;
  std::vector<double> length_;
  double largest_ = 0;
};

using Turns = std::vector<std::pair<Vec2, Vec2>>;  // from (u, v) to (u, v)

/// @param most of them, evenly chosen
void addTurns(const NormalSamples& samples, double least, std::size_t most, Turns& found) {
  const auto turns = samples.turns(least);
  const std::size_t count = std::min(turns.size(), most);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [from, to] = turns[i * turns.size() / count];
    found.emplace_back(samples.parameters(from), samples.parameters(to));
  }
}

/// The least normal near a sample: finer samples in smaller and smaller windows about the least one. Where the normal
/// reverses twice between two samples, these alone see it.
Validity leastAround(const Motion& motion, const NormalSamples& samples, const NormalSamples::Place& low, Turns& turns,
                     const Progress& progress) {
  constexpr std::size_t places = 9;
  constexpr int rounds = 24;
  constexpr double vanished = 1e-9, level = 1.05;  // share of the largest; the largest of a window where nothing vanishes
  constexpr double deep = 1e-6;                    // share of the largest that rounding and tolerances do not explain
  constexpr std::size_t fewTurns = 4;
  auto window = samples.around(low);
  Validity result;
  result.smallestNormal = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds && result.smallestNormal > vanished * samples.largest(); ++round) {
    const NormalSamples finer(motion, evenParameters(window[0], places), evenParameters(window[1], places), progress);
    if (const Validity least = finer.least(); least.smallestNormal < result.smallestNormal) result = least;
    addTurns(finer, deep * samples.largest(), fewTurns, turns);
    if (finer.largest() < level * result.smallestNormal) break;
    window = finer.around(finer.leastPlace());
  }
  return result;
}

/// Whether the surface is closed both ways.
bool isRing(const Motion& motion) { return motion.closedU != ClosedU::No && joinedInV(motion).has_value(); }

/// Of the places at which neighbouring normals point away from each other, the first where the surface folds; of a ring
/// rather one where its sections go back, for it encloses no body there.
std::optional<Fold> worstFold(const Motion& motion, const Turns& turns, const Progress& progress) {
  // A sheet may wind up along its middle with little pitch, which looks like a tip. No ring does so within a step of
  // samples.
  constexpr double pinchOfRing = 0.1, pinchOfOthers = 1e-3;
  const bool ring = isRing(motion);
  std::optional<Fold> found;
  for (const auto& [from, to] : turns) {
    progress.check();
    const std::optional<Fold> fold = foldBetween(motion, from, to, ring ? pinchOfRing : pinchOfOthers);
    if (fold && (!found || fold->backwards)) found = fold;
    if (found && (!ring || found->backwards)) break;
  }
  return found;
}

}  // namespace

Validity examine(const Motion& motion, const Progress& progress) {
  constexpr double rounded = 1e-9;  // of the largest normal
  constexpr std::size_t allTurns = std::numeric_limits<std::size_t>::max();
  const auto alongU = [&](std::size_t parts) {
    return spanParameters(motion.domainU(), {&motion.orientation.knotsU, &motion.scaling.knotsU}, parts);
  };
  const auto alongV = [&](std::size_t parts) {
    return spanParameters(motion.domainV(), {&motion.orientation.knotsV, &motion.scaling.knotsV, &motion.trajectory.knots},
                          parts);
  };
  const std::size_t parts = partsWithin(alongU(1).size() - 1, alongV(1).size() - 1, placesInSpan, mostPlaces);
  const NormalSamples samples(motion, alongU(parts), alongV(parts), progress);
  const double largest = samples.largest();
  Turns turns;
  addTurns(samples, rounded * largest, allTurns, turns);
  Validity result = samples.least();
  for (const NormalSamples::Place& low : samples.lows()) {
    const Validity finer = leastAround(motion, samples, low, turns, progress);
    if (finer.smallestNormal < result.smallestNormal) result = finer;
  }
  result.smallestShare = largest > 0 ? result.smallestNormal / largest : 0;
  result.fold = worstFold(motion, turns, progress);
  return result;
}

void requireArea(const Motion& motion, const Progress& progress) {
  constexpr std::size_t places = 4;
  constexpr double nothing = 1e-12, rounding = 1e-14;  // of the size; of the coordinates
  const auto [u0, u1] = motion.domainU();
  const auto [v0, v1] = motion.domainV();
  MotionGrid grid;
  evaluateGrid(
      motion, spanParameters({u0, u1}, {&motion.orientation.knotsU, &motion.scaling.knotsU}, places),
      spanParameters({v0, v1}, {&motion.orientation.knotsV, &motion.scaling.knotsV, &motion.trajectory.knots}, places), grid,
      GridDerivatives::Yes, progress);
  Eigen::AlignedBox3d box;
  double largest = 0, farthest = 0;
  for (std::size_t k = 0; k < grid.countU; ++k)
    for (std::size_t l = 0; l < grid.countV; ++l) {
      const Vec3 p = grid.pointAt(k, l);
      box.extend(p);
      farthest = std::max(farthest, p.norm());
      largest = std::max(largest, grid.duAt(k, l).cross(grid.dvAt(k, l)).norm());
    }
  const double size = box.diagonal().norm(), area = largest * (u1 - u0) * (v1 - v0);
  if (area > (nothing * size + rounding * farthest) * size) return;
  throw Error(ErrorCode::Degenerate,
              fmt::format("The point ({:.6g}, {:.6g}, {:.6g}) sweeps {}, which has no area.", motion.point.x(),
                          motion.point.y(), motion.point.z(), size > rounding * farthest ? "a line" : "a single point"),
              "It lies on the trajectory, or on the axis about which the frame turns. Give another point of the moving "
              "frame, away from both, or a motion that turns or scales along u.");
}

SmallestWeight smallestProductWeight(const Motion& motion, const Progress& progress) {
  return smallestWeightOf(weightCoefficients(motion, progress), motion);
}

SmallestWeight smallestWeightOf(const Surface& weights, const Motion& motion) {
  std::size_t smallest = 0;
  double largest = 0;
  for (std::size_t k = 0; k < weights.poles.size(); ++k) {
    if (weights.poles[k][3] < weights.poles[smallest][3]) smallest = k;
    largest = std::max(largest, std::abs(weights.poles[k][3]));
  }
  if (!(largest > 0) || !std::isfinite(largest))
    throw Error(ErrorCode::Degenerate, "The weights of the swept surface vanish or overflow.",
                "Scale the motion's quaternions to about unit length.");
  int exponent = 0;
  std::frexp(largest, &exponent);
  SmallestWeight result;
  result.weight = std::ldexp(weights.poles[smallest][3], -exponent);
  result.u = greville(weights.degreeU, weights.knotsU, smallest / weights.countV());
  result.v = greville(weights.degreeV, weights.knotsV, smallest % weights.countV());
  result.place = evaluate(motion, result.u, result.v).point;
  return result;
}

}  // namespace blossom::sweep
