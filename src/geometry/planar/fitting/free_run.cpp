#include "geometry/planar/fitting/free_run.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/hermite_spline.h"
#include "geometry/planar/planar.h"

namespace blossom::planar {
namespace {

/// A point of the curve, and the corner of the run where it is.
struct Passage {
  DirectedPoint point;
  std::size_t corner = 0;
};

class RunSpline {
 public:
  RunSpline(const FreeRun& run, double rounding, double gap)
      : corners_(run.corners), sides_(run.sides), rounding_(rounding), gap_(gap) {}

  [[nodiscard]] Spline2 between(const Vec2& from, const Vec2& to) {
    passages_ = {{{from, directionAt(0, corners_.front())}, 0}};
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const FreeSide& side = sides_[i];
      const bool forward = (side.to.at - side.from.at).dot(corners_[i + 1] - corners_[i]) > 0;
      if (i > 0) add(i, forward ? side.from : side.to, i, to);
      if (side.between && isPassed(i, side.between->at)) add(i, *side.between, i, to);
      if (i + 1 < sides_.size()) add(i, forward ? side.to : side.from, i + 1, to);
    }
    const std::size_t last = sides_.size();
    passages_.push_back({{to, directionAt(last - 1, corners_.back())}, last});
    points_ = {passages_.front().point};
    for (std::size_t k = 1; k < passages_.size(); ++k) {
      addCornersBetween(passages_[k - 1], passages_[k]);
      points_.push_back(passages_[k].point);
    }
    return splineThrough(points_, gap_ / 16);
  }

 private:
  void add(std::size_t side, const FreePoint& point, std::size_t corner, const Vec2& end) {
    if (!point.isOnCurve) return;
    const Vec2 along = alongRun(side, point.normal);
    const bool isBeforeEnd = side + 2 < sides_.size() || isAhead(end - point.at, along);
    if (isBeforeEnd && isAhead(point.at - passages_.back().point.at, along))
      passages_.push_back({{point.at, along}, corner});
  }

  /// The ends of a run are corners of the polygon: on a way from there to a point just beside it a spline would run across.
  [[nodiscard]] bool isAhead(const Vec2& way, const Vec2& along) const {
    return way.dot(along) > std::max(rounding_, 3 * std::abs(cross(along, way)));
  }

  /// Whether a point lies beside what is left of side i.
  [[nodiscard]] bool isPassed(std::size_t i, const Vec2& p) const {
    const Vec2 along = corners_[i + 1] - corners_[i];
    const double way = (p - corners_[i]).dot(along);
    return way > 0 && way < along.squaredNorm();
  }

  void addCornersBetween(const Passage& from, const Passage& to) {
    if (to.corner < from.corner + 2) return;
    const auto between = corners_.subspan(from.corner + 1, to.corner - from.corner - 1);
    if (keepsNear(from.point, to.point, between, gap_ / 4)) return;
    const std::size_t middle = (from.corner + to.corner) / 2;
    const Vec2& corner = corners_[middle];
    const Vec2 along = (directionAt(middle - 1, corner) + directionAt(middle, corner)).normalized();
    const Passage there{{corner, along}, middle};
    addCornersBetween(from, there);
    points_.push_back(there.point);
    addCornersBetween(there, to);
  }

  /// Along side i, where the normal has an angle.
  [[nodiscard]] Vec2 alongRun(std::size_t i, double normal) const {
    const Vec2 along(-std::sin(normal), std::cos(normal));
    return along.dot(corners_[i + 1] - corners_[i]) < 0 ? Vec2(-along) : along;
  }

  /// In a point of side i, whose normal turns evenly.
  [[nodiscard]] Vec2 directionAt(std::size_t i, const Vec2& p) const {
    const FreePoint &from = sides_[i].from, &to = sides_[i].to;
    const Vec2 along = to.at - from.at;
    const double share = std::clamp((p - from.at).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return alongRun(i, from.normal + share * turnFrom(from.normal, to.normal));
  }

  std::span<const Vec2> corners_;
  std::span<const FreeSide> sides_;
  double rounding_, gap_;
  std::vector<Passage> passages_;
  std::vector<DirectedPoint> points_;
};

}  // namespace

Spline2 splineAlong(const FreeRun& run, const Vec2& from, const Vec2& to, double rounding, double gap) {
  return RunSpline(run, rounding, gap).between(from, to);
}

}  // namespace blossom::planar
