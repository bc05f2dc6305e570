#pragma once
#include <vector>

#include "geometry/shape/motion.h"
#include "kernel/edit/factor_changes.h"
#include "manipulators/edit_region.h"

namespace blossom::sweep {

enum class Factor { Trajectory, Orientation, Scaling };

/// Where the poles of a factor stand over the (u, v) domain, and how far each has influence. The trajectory is one row,
/// in the middle of u, for each of its poles belongs to all of u.
struct FactorLayout {
  Factor factor = Factor::Scaling;
  bool closed = false;  ///< in u
  std::pair<double, double> domainU{0, 1}, domainV{0, 1};
  std::vector<double> us, vs;          ///< of rows and columns: Greville abscissae, those of a closed motion in its period
  std::vector<double> knotsU, knotsV;  ///< different ones, both ends included; the trajectory has none in u
  std::vector<std::pair<double, double>> reachU, reachV;  ///< supports; of a closed motion they may leave the period

  [[nodiscard]] std::size_t rows() const { return us.size(); }
  [[nodiscard]] std::size_t columns() const { return vs.size(); }
  [[nodiscard]] bool contains(const FactorPole& pole) const { return pole.row < rows() && pole.column < columns(); }
  /// As borderOf draws it.
  [[nodiscard]] EditRegion region(const FactorPole&) const;
};

FactorLayout layoutOf(const Motion&, Factor);

/// What a pole of a factor says: the point of the trajectory, the factors of the scaling; and its weight.
struct PoleValue {
  Vec3 vector{0, 0, 0};
  double weight = 1;
};
PoleValue poleValue(const Motion&, Factor, const FactorPole&);

/// Angle of the rotation of a pole of the orientation, degrees, 0 to 360.
double poleAngle(const Motion&, const FactorPole&);

}  // namespace blossom::sweep
