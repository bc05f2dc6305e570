#include "kernel/edit/edit_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t mostPlaces = 400;
constexpr int largestFold = 360;
/// A residual above this share of what was wanted is more than rounding.
constexpr double unmet = 1e-9;

MotionPlace placeInside(const Motion& motion, const MotionPlace& place) {
  const MotionPlace inside{insidePeriod(motion, place.u), place.v};
  const auto require = [](const char* name, double value, std::pair<double, double> domain) {
    if (value >= domain.first && value <= domain.second) return;
    throw Error(
        ErrorCode::InvalidParameter,
        fmt::format("{} = {} lies outside the motion, which runs from {} to {}.", name, value, domain.first, domain.second),
        "Give a place on the surface.");
  };
  require("u", inside.u, motion.domainU());
  require("v", inside.v, motion.domainV());
  return inside;
}

}  // namespace

EditPlaces::EditPlaces(const Motion& motion, std::span<const MotionPlace> at, std::span<const MotionPlace> pins,
                       const EditSymmetry& symmetry, int level, const Progress& progress)
    : given_(at.begin(), at.end()),
      seams_(seamsInV(motion)),
      level_{level, symmetry.fold},
      base_(baseKnots(motion)),
      own_(level == 0 && !motion.base),
      symmetric_(symmetry.fold != 1 || symmetry.mirror),
      progress_(progress) {
  if (level < coarsestLevel || level > finestLevel)
    throw Error(ErrorCode::InvalidParameter, fmt::format("The level of an edit must lie between {} and {}; it is {}.",
                                                         coarsestLevel, finestLevel, level));
  if (symmetry.fold < 1 || symmetry.fold > largestFold)
    throw Error(ErrorCode::InvalidParameter, fmt::format("The fold of a symmetric edit must lie between 1 and {}; it is {}.",
                                                         largestFold, symmetry.fold));
  if (at.empty()) throw Error(ErrorCode::InvalidParameter, "An edit needs a place.", "Give u and v of a place.");
  const std::size_t copies = static_cast<std::size_t>(symmetry.fold) * (symmetry.mirror ? 2 : 1);
  if ((at.size() + pins.size()) * copies > mostPlaces)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("An edit of {} places and pins with {} copies each is too large; at most {} can be solved for "
                            "together.",
                            at.size() + pins.size(), copies, mostPlaces),
                "Make several edits of it.");
  for (std::size_t k = 0; k < at.size(); ++k)
    for (const SymmetricPlace& copy : symmetricPlaces(motion, placeInside(motion, at[k]), symmetry)) {
      if (!(evaluate(motion.orientation, copy.at.u, copy.at.v).squaredNorm() > 0))
        throw Error(ErrorCode::Degenerate,
                    fmt::format("The orientation of this motion vanishes at u = {:.4g}, v = {:.4g}.", copy.at.u, copy.at.v));
      places_.push_back({copy.at, copy.turn, k});
    }
  for (const MotionPlace& pin : pins)
    for (const SymmetricPlace& copy : symmetricPlaces(motion, placeInside(motion, pin), symmetry)) pins_.push_back(copy.at);
  result_.motion = motion;
}

template <class Vector>
Eigen::MatrixXd EditPlaces::wantedAt(const std::function<Vector(EditPlace&)>& wanted) {
  Eigen::MatrixXd all(static_cast<Eigen::Index>(places_.size()), Vector::RowsAtCompileTime);
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const Vector value = wanted(places_[k]);
    if (!std::isfinite(value.squaredNorm()))
      throw Error(ErrorCode::Degenerate,
                  fmt::format("At u = {:.4g}, v = {:.4g}, what this edit asks for is beyond all numbers.", places_[k].at.u,
                              places_[k].at.v),
                  "Choose a nearer target.");
    all.row(static_cast<Eigen::Index>(k)) = value.transpose();
  }
  return all;
}

template <class Row>
PoleChange EditPlaces::changeOf(Row row, const SeamV& seam, const Eigen::MatrixXd& wanted) {
  progress_.check();
  std::vector<PlaceRow> moved, pinned;
  for (EditPlace& place : places_) {
    moved.push_back(seam.onFreePoles(row(place.at)));
    if (moved.back().cancelled) place.obstacles.push_back(Unreached::Cancelled);
  }
  for (const MotionPlace& pin : pins_) pinned.push_back(seam.onFreePoles(row(pin)));
  const PoleChange change = leastChange(moved, wanted, pinned, progress_);
  together_ = change.residual > unmet * wanted.rowwise().norm().maxCoeff();
  result_.swing = std::max(result_.swing, change.swing);
  return seam.onAllPoles(change);
}

std::vector<MotionPlace> EditPlaces::spots() const {
  std::vector<MotionPlace> all;
  for (const EditPlace& place : places_) all.push_back(place.at);
  return all;
}

void EditPlaces::remember() {
  if (!result_.motion.base) result_.motion.base = base_;
}

void EditPlaces::changeTrajectory(const std::function<Vec3(EditPlace&)>& wanted) {
  Curve& trajectory = result_.motion.trajectory;
  const Eigen::MatrixXd all = wantedAt<Vec3>(wanted);
  if (own_) {
    const PoleChange change =
        changeOf([&](const MotionPlace& at) { return placeRow(trajectory, at.v); }, seams_.trajectory, all);
    result_.movedPoles += applyChange(change, trajectory);
    return;
  }
  const LevelCurve level(trajectory, base_.trajectory, level_, spots(), seams_.trajectory.ends());
  const PoleChange change = changeOf([&](const MotionPlace& at) { return level.row(at.v); }, SeamV(), all);
  if (change.by.isZero(0)) return;
  const std::size_t before = trajectory.poles.size();
  result_.movedPoles += level.apply(change, trajectory);
  if (trajectory.poles.size() != before) remember();
}

void EditPlaces::changeSurface(Surface& factor, double closure, const SeamV& seam,
                               const std::array<std::vector<double>, 2>& base, const Eigen::MatrixXd& wanted) {
  if (own_) {
    const PoleChange change = changeOf([&](const MotionPlace& at) { return placeRow(factor, at, closure); }, seam, wanted);
    result_.movedPoles += applyChange(change, factor, closure);
    return;
  }
  const LevelSurface level(factor, closure, base, level_, spots(), seam.ends());
  const PoleChange change = changeOf([&](const MotionPlace& at) { return level.row(at); }, SeamV(), wanted);
  if (change.by.isZero(0)) return;  // no knots for nothing
  const std::size_t before = factor.poles.size();
  result_.movedPoles += level.apply(change, factor);
  if (factor.poles.size() != before) remember();
}

void EditPlaces::changeOrientation(const std::function<Vec4(EditPlace&)>& wanted) {
  const Eigen::MatrixXd all = wantedAt<Vec4>(wanted);
  changeSurface(result_.motion.orientation, closureOfOrientation(result_.motion), seams_.orientation, base_.orientation,
                all);
}

void EditPlaces::changeScaling(const std::function<Vec4(EditPlace&)>& wanted) {
  const Eigen::MatrixXd all = wantedAt<Vec4>(wanted);
  changeSurface(result_.motion.scaling, closureOfScaling(result_.motion), seams_.scaling, base_.scaling, all);
}

void EditPlaces::markContradictions(const std::function<bool(std::size_t, std::size_t)>& differ) {
  constexpr double same = 1e-12;  // of the domain
  const Motion& motion = result_.motion;
  const auto apart = [](double a, double b, std::pair<double, double> domain, bool closed) {
    const double length = domain.second - domain.first;
    return std::abs(closed ? std::remainder(b - a, length) : b - a) / length;
  };
  const bool ring = joinedInV(motion).has_value();
  const auto atOneSpot = [&](const MotionPlace& a, const MotionPlace& b) {
    return apart(a.u, b.u, motion.domainU(), motion.closedU != ClosedU::No) <= same &&
           apart(a.v, b.v, motion.domainV(), ring) <= same;
  };
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (std::size_t j = i + 1; j < places_.size(); ++j) {
      EditPlace &a = places_[i], &b = places_[j];
      if (a.of == b.of || !atOneSpot(a.at, b.at) || !differ(i, j)) continue;
      a.contradicted = b.contradicted = true;
    }
}

EditResult EditPlaces::finished(const std::function<double(const EditPlace&)>& left, double allowed, Unreached otherwise) {
  const Unreached shared = !pins_.empty() ? Unreached::Pinned : symmetric_ ? Unreached::Symmetry : Unreached::TooClose;
  result_.remainders.assign(given_.size(), 0);
  for (const EditPlace& place : places_) {
    const double remainder = left(place);
    if (!std::isfinite(remainder))
      throw Error(ErrorCode::Degenerate,
                  fmt::format("At u = {:.4g}, v = {:.4g}, this edit leads beyond all numbers.", place.at.u, place.at.v),
                  "Choose a nearer target, or a smaller angle.");
    double& largest = result_.remainders[place.of];
    largest = std::max(largest, remainder);
    result_.remainder = std::max(result_.remainder, remainder);
    if (remainder <= allowed) continue;
    const auto tell = [&](Unreached why) {
      const Obstacle obstacle{why, given_[place.of]};
      if (std::find(result_.obstacles.begin(), result_.obstacles.end(), obstacle) == result_.obstacles.end())
        result_.obstacles.push_back(obstacle);
    };
    if (place.contradicted) {
      tell(Unreached::TwoTargets);
      continue;
    }
    for (const Unreached why : place.obstacles) tell(why);
    if (place.obstacles.empty()) tell(together_ || otherwise == Unreached::TooClose ? shared : otherwise);
  }
  return std::move(result_);
}

}  // namespace blossom::sweep
