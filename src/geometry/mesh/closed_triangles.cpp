#include "geometry/mesh/closed_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/angle.h"

namespace blossom {

double windingNumber(std::span<const Triangle3> triangles, const Vec3& point, const Progress& progress) {
  double sum = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % 4096 == 0) progress.check();
    const Vec3 a = triangles[i][0] - point, b = triangles[i][1] - point, c = triangles[i][2] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / fullTurn;
}

double signedVolume(std::span<const Triangle3> triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3& from = triangles.front()[0];
    sum += (a - from).dot((b - from).cross(c - from));
  }
  return sum / 6;
}

PointsBeside pointsBesideLargest(std::span<const Triangle3> triangles) {
  const auto crossOf = [](const Triangle3& t) -> Vec3 { return (t[1] - t[0]).cross(t[2] - t[0]); };
  const auto largest = std::max_element(triangles.begin(), triangles.end(), [&](const Triangle3& a, const Triangle3& b) {
    return crossOf(a).squaredNorm() < crossOf(b).squaredNorm();
  });
  // Not in the middle, where regular meshes have corners: a point before it would lie in line with them.
  const auto& [a, b, c] = *largest;
  const Vec3 middle = 0.3183 * a + 0.2718 * b + 0.4099 * c, cross = crossOf(*largest);
  constexpr double shareOfSize = 1e-6, roundings = 16;
  const double step = std::max(shareOfSize * std::sqrt(cross.norm()),
                               roundings * std::numeric_limits<double>::epsilon() * middle.cwiseAbs().maxCoeff());
  const Vec3 aside = step * cross.normalized();
  return {middle + aside, middle - aside};
}

}  // namespace blossom
