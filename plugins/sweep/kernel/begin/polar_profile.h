#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/bspline/curve.h"

namespace blossom::sweep {

/// A closed planar curve as a radius over the angle about a centre: what the scaling of a motion can make of one point.
class PolarProfile {
 public:
  /// The centre is `centre`, or the centroid of the area enclosed. Angle 0 points along x, or along y where the plane is
  /// square to x; the curve is followed counter-clockwise, seen so that it lies near the plane z = 0 from above.
  /// @throws Error InvalidInput when the curve is open or not planar, or when a ray from the centre meets it more than once
  /// (it is not star-shaped), with the place. O(poles).
  explicit PolarProfile(const Curve&, const std::optional<Vec3>& centre = {});

  struct Value {
    double radius = 0, slopeLeft = 0, slopeRight = 0;  ///< mm and mm per radian
  };
  /// At an angle in radians. O(log pieces).
  [[nodiscard]] Value at(double angle) const;
  /// At the start of a joint, from both sides.
  struct Joint {
    double angle = 0;  ///< 0 to 2 pi
    bool corner = false;
    Value value;
  };
  /// Where the knots of the curve are, sorted by angle.
  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  /// Largest radius.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }

 private:
  void cutPieces(const Curve& flat);
  [[nodiscard]] double largestRadius() const;
  void requireStar() const;
  void findJoints(const std::vector<double>& breaks);
  [[nodiscard]] double slopeOf(const Curve& piece, double t) const;

  Vec3 centre_{0, 0, 0};
  std::vector<Curve> pieces_;   ///< about the centre, in the plane, counter-clockwise
  std::vector<double> starts_;  ///< angle at the start of each piece, increasing, and that of the first one turned round
  std::vector<Joint> joints_;
  double reach_ = 0;
};

}  // namespace blossom::sweep
