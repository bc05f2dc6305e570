#include "geometry/mesh/discrete_curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numbers>

namespace blossom {
namespace {

using TriangleCorners = std::array<int, 3>;

/// A triangle as seen from its corners; corner k lies between the sides `side[k]` and `side[k + 2]` reversed.
struct TriangleAngles {
  std::array<Vec3, 3> side;         ///< from corner k to corner k + 1
  std::array<double, 3> cotangent;  ///< of the angle at corner k
  std::array<double, 3> angle;
  double area = 0;
};

TriangleAngles anglesOf(std::span<const Vec3> points, const TriangleCorners& corners) {
  TriangleAngles t;
  const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(corners[k % 3])]; };
  for (std::size_t k = 0; k < 3; ++k) t.side[k] = at(k + 1) - at(k);
  const double twice = t.side[0].cross(t.side[1]).norm();
  t.area = twice / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const double cosine = -t.side[k].dot(t.side[(k + 2) % 3]);  // both times the lengths of the two sides
    t.angle[k] = std::atan2(twice, cosine);
    t.cotangent[k] = twice > 0 ? cosine / twice : 0;
  }
  return t;
}

/// The share of each corner: its Voronoi part, or where an angle is obtuse a half and two quarters of the triangle.
std::array<double, 3> mixedShares(const TriangleAngles& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (t.angle[k] > std::numbers::pi / 2) {
      std::array<double, 3> shares{t.area / 4, t.area / 4, t.area / 4};
      shares[k] = t.area / 2;
      return shares;
    }
  std::array<double, 3> shares{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, before = (k + 2) % 3;
    shares[k] = (t.side[k].squaredNorm() * t.cotangent[before] + t.side[before].squaredNorm() * t.cotangent[next]) / 8;
  }
  return shares;
}

/// Vertices whose triangles do not close to one full turn: those at an edge that is not used once in each direction.
std::vector<bool> atBorder(std::size_t points, std::span<const TriangleCorners> triangles, const Progress& progress) {
  std::vector<std::array<std::uint32_t, 2>> forward;
  forward.reserve(3 * triangles.size());
  for (const TriangleCorners& c : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      forward.push_back({static_cast<std::uint32_t>(c[k]), static_cast<std::uint32_t>(c[(k + 1) % 3])});
  progress.check();
  std::sort(forward.begin(), forward.end());
  progress.check();
  std::vector<bool> border(points);
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (i % 65536 == 0) progress.check();
    const auto& [from, to] = forward[i];
    const bool twice = (i > 0 && forward[i - 1] == forward[i]) || (i + 1 < forward.size() && forward[i + 1] == forward[i]);
    if (!twice && std::binary_search(forward.begin(), forward.end(), std::array{to, from})) continue;
    border[from] = border[to] = true;
  }
  return border;
}

class CurvatureSums {
 public:
  CurvatureSums(std::span<const Vec3> points, std::span<const Vec3> normals, std::span<const TriangleCorners> triangles)
      : normals_(normals),
        triangles_(triangles),
        area_(points.size()),
        turn_(points.size()),
        bend_(points.size(), Vec3::Zero()),
        points_(points) {}

  void gather(const Progress& progress) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (t % 65536 == 0) progress.check();
      add(triangles_[t]);
    }
  }

  [[nodiscard]] std::vector<SurfaceCurvature> inside(const std::vector<bool>& border) const {
    std::vector<SurfaceCurvature> result(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (border[i] || !(area_[i] > 0)) continue;
      SurfaceCurvature& c = result[i];
      c.gaussian = (2 * std::numbers::pi - turn_[i]) / area_[i];
      c.mean = bend_[i].dot(normals_[i]) / (4 * area_[i]);
      c.spread = std::sqrt(std::max(0.0, c.mean * c.mean - c.gaussian));
    }
    return result;
  }

  /// What the neighbours within the surface have, for the vertices that have nothing of their own.
  void fillBorder(const std::vector<bool>& border, std::vector<SurfaceCurvature>& result) const {
    std::vector<int> count(points_.size());
    const auto offer = [&](int from, int to) {
      const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
      if (border[i] || !border[j]) return;
      const double share = 1.0 / ++count[j];
      result[j].gaussian += share * (result[i].gaussian - result[j].gaussian);
      result[j].mean += share * (result[i].mean - result[j].mean);
      result[j].spread += share * (result[i].spread - result[j].spread);
    };
    for (const TriangleCorners& c : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        offer(c[k], c[(k + 1) % 3]);
        offer(c[(k + 1) % 3], c[k]);
      }
  }

 private:
  void add(const TriangleCorners& corners) {
    const TriangleAngles t = anglesOf(points_, corners);
    const std::array<double, 3> shares = mixedShares(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(corners[k]), j = static_cast<std::size_t>(corners[(k + 1) % 3]);
      area_[i] += shares[k];
      turn_[i] += t.angle[k];
      const Vec3 pull = t.cotangent[(k + 2) % 3] * t.side[k];
      bend_[i] -= pull;
      bend_[j] += pull;
    }
  }

  std::span<const Vec3> normals_;
  std::span<const TriangleCorners> triangles_;
  std::vector<double> area_, turn_;
  std::vector<Vec3> bend_;
  std::span<const Vec3> points_;
};

}  // namespace

std::vector<SurfaceCurvature> discreteCurvature(std::span<const Vec3> points, std::span<const Vec3> normals,
                                                std::span<const TriangleCorners> triangles, const Progress& progress) {
  CurvatureSums sums(points, normals, triangles);
  sums.gather(progress);
  const std::vector<bool> border = atBorder(points.size(), triangles, progress);
  std::vector<SurfaceCurvature> result = sums.inside(border);
  sums.fillBorder(border, result);
  return result;
}

std::vector<double> mixedAreas(std::span<const Vec3> points, std::span<const TriangleCorners> triangles) {
  std::vector<double> areas(points.size());
  for (const TriangleCorners& corners : triangles) {
    const std::array<double, 3> shares = mixedShares(anglesOf(points, corners));
    for (std::size_t k = 0; k < 3; ++k) areas[static_cast<std::size_t>(corners[k])] += shares[k];
  }
  return areas;
}

}  // namespace blossom
