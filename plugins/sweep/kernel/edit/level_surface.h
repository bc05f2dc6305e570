#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/bspline/hierarchical_surface.h"
#include "kernel/edit/edit_level.h"
#include "kernel/edit/least_change.h"
#include "kernel/edit/place_row.h"
#include "kernel/edit/seam_v.h"

namespace blossom::sweep {

/// Which functions an edit changes.
struct EditLevel {
  int level = 0;
  int parts = 1;  ///< copies around the motion, along u
};

/// The change of an orientation or a scaling by an edit of some level: a surface of truncated hierarchical B-splines over
/// the base knots, 0 but for the active functions of the level around the places (finer levels), or a spline with fewer
/// knots (coarser ones). Its coefficients are chosen like poles (kernel/edit/least_change.h); then it is added to the
/// factor, which first gets the knots that it needs and does not have. Both steps are knot insertions, so that the sum is
/// exact. In a ring, functions along v are those of the periodic spline that the factor is (ringSpace), which pass over the
/// seam, and so the sum is as smooth there as the factor was.
class LevelSurface {
 public:
  /// @param base its base knots in u and v  @param places of the edit, with copies  @param ring how the ends in v are joined
  LevelSurface(const Surface& factor, double closure, const std::array<std::vector<double>, 2>& base, const EditLevel&,
               std::span<const MotionPlace> places, const std::optional<JoinedEnds>& ring = {});

  /// Shares of the functions that may change; their indices are those of PoleChange.
  [[nodiscard]] PlaceRow row(const MotionPlace&) const;
  /// @throws Error LimitExceeded when the factor would get more than a million poles.
  /// @returns how many poles the change moves
  std::size_t apply(const PoleChange&, Surface& factor) const;

 private:
  double closure_;
  HierarchicalSurface change_;
  SplineSpace nowU_, nowV_, refinedU_, refinedV_;
  SpaceMap toRefinedV_;  ///< from the finest functions of the change
};

/// The same for the Euclidean poles of a trajectory, whose weights follow from the knots inserted: a function of the level
/// moves each of them by its coefficient there. In the curve it is the sum of those rational functions, so that all of them
/// together move the curve as a whole.
class LevelCurve {
 public:
  LevelCurve(const Curve& trajectory, const std::vector<double>& base, const EditLevel&, std::span<const MotionPlace> places,
             const std::optional<JoinedEnds>& ring = {});

  [[nodiscard]] PlaceRow row(double v) const;
  std::size_t apply(const PoleChange&, Curve& trajectory) const;

 private:
  Curve refined_;
  SpaceMap toRefined_;        ///< from the functions of the level
  std::vector<char> active_;  ///< of these
};

}  // namespace blossom::sweep
