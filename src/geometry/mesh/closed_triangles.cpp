#include "geometry/mesh/closed_triangles.h"

#include <Eigen/Geometry>
#include <cmath>

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

}  // namespace blossom
