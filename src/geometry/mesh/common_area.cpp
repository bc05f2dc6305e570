#include "geometry/mesh/common_area.h"

#include <Eigen/Geometry>
#include <utility>

namespace blossom {

std::vector<Vec3> commonPolygon(const Triangle3& a, const Triangle3& b) {
  std::vector<Vec3> polygon(a.begin(), a.end());
  const Vec3 normal = (b[1] - b[0]).cross(b[2] - b[0]);
  for (std::size_t k = 0; k < 3 && !polygon.empty(); ++k) {
    const Vec3 &from = b[k], inwards = normal.cross(b[(k + 1) % 3] - b[k]);
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double d = (p - from).dot(inwards), e = (q - from).dot(inwards);
      if (d >= 0) kept.push_back(p);
      if ((d > 0 && e < 0) || (d < 0 && e > 0)) kept.push_back(p + d / (d - e) * (q - p));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

double areaOf(const std::vector<Vec3>& polygon) {
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 2; k < polygon.size(); ++k) twice += (polygon[k - 1] - polygon[0]).cross(polygon[k] - polygon[0]);
  return twice.norm() / 2;
}

}  // namespace blossom
