#include "kernel/near_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/mesh/triangle_distance.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/values/box.h"

namespace blossom::morphology {

namespace {

struct Wall {
  Triangle3 at;
  Vec3 normal;  ///< of length 1
  int body = 0;
};

/// All corners of one in the plane of the other.
bool liesInPlaneOf(const Wall& one, const Wall& other, double near) {
  return std::all_of(one.at.begin(), one.at.end(),
                     [&](const Vec3& p) { return std::abs(other.normal.dot(p - other.at[0])) <= near; });
}

bool areAcrossOneAxis(const Wall& a, const Wall& b) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto isThere = [&](const Vec3& p) { return p[k] == a.at[0][k]; };
    if (std::all_of(a.at.begin(), a.at.end(), isThere) && std::all_of(b.at.begin(), b.at.end(), isThere)) return true;
  }
  return false;
}

/// Whether triangles in one plane have more than an edge in common: no side of either separates them.
bool overlap(const Wall& a, const Wall& b, double near) {
  const auto isApart = [&](const Wall& one, const Wall& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 along = one.at[(k + 1) % 3] - one.at[k], inwards = one.normal.cross(along).normalized();
      if (std::all_of(other.at.begin(), other.at.end(), [&](const Vec3& p) { return inwards.dot(p - one.at[k]) <= near; }))
        return true;
    }
    return false;
  };
  return !isApart(a, b) && !isApart(b, a);
}

}  // namespace

std::optional<Vec3> firstNearWall(const Mesh& triangles, const std::vector<int>& bodyOfFace, double near,
                                  const Progress& progress) {
  std::vector<Wall> walls(triangles.faceCount());
  std::vector<Box3> boxes(walls.size());
  for (std::size_t f = 0; f < walls.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      walls[f].at[k] = triangles.points[static_cast<std::size_t>(triangles.face(f)[k])];
      boxes[f].extend(walls[f].at[k]);
    }
    walls[f].normal = (walls[f].at[1] - walls[f].at[0]).cross(walls[f].at[2] - walls[f].at[0]).normalized();
    walls[f].body = bodyOfFace[f];
  }
  constexpr double opposite = -1 + 1e-6;  // cosine
  std::optional<Vec3> found;
  forEachNearPair<3>(boxes, near, progress, [&](std::size_t i, std::size_t j) {
    const Wall &a = walls[i], &b = walls[j];
    if (a.body == b.body || a.normal.dot(b.normal) > opposite || areAcrossOneAxis(a, b)) return true;
    if (!liesInPlaneOf(a, b, near) && !liesInPlaneOf(b, a, near)) return true;
    if (overlap(a, b, near)) found = boxes[i].intersection(boxes[j]).center();
    return !found;
  });
  return found;
}

}  // namespace blossom::morphology
