#pragma once
#include <span>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace blossom::subdivision {

/// A limit point as a linear combination of control points, x = sum weights[i] P[indices[i]]; exact, not interpolated.
struct Row {
  std::vector<int> indices;
  std::vector<double> weights;
};

inline Vec3 combined(const Row& row, std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < row.indices.size(); ++i)
    sum += row.weights[i] * points[static_cast<std::size_t>(row.indices[i])];
  return sum;
}

/// Parameters of a point on a limit shape.
struct Foot {
  int patch = 0;
  double u = 0, v = 0;
};

/// Point and derivatives at a foot; derivatives by v are 0 on a curve.
struct Frame {
  Vec3 at = Vec3::Zero(), du = Vec3::Zero(), dv = Vec3::Zero(), duu = Vec3::Zero(), duv = Vec3::Zero(), dvv = Vec3::Zero();
};

/// Range of u and v of a patch.
enum class Domain {
  Square,    ///< u and v in 0..1
  Triangle,  ///< u and v in 0..1, u + v <= 1
  Interval,  ///< u in 0..1, v is 0
  Circle     ///< the same, periodic
};

/// A curve or surface whose points are linear in its control points.
class LimitShape {
 public:
  virtual ~LimitShape() = default;
  [[nodiscard]] virtual Domain domain(int patch) const = 0;
  [[nodiscard]] virtual Row row(const Foot&) const = 0;
  [[nodiscard]] virtual Frame frame(const Foot&, std::span<const Vec3> points) const = 0;
  /// Feet distributed over the shape, dense enough that Newton's method finds the closest point from one of the nearest.
  [[nodiscard]] virtual std::vector<Foot> seeds() const = 0;
  /// Edges of the cage or polygon.
  [[nodiscard]] virtual std::vector<std::pair<int, int>> edges() const = 0;
  [[nodiscard]] virtual bool isCurve() const = 0;
};

}  // namespace blossom::subdivision
