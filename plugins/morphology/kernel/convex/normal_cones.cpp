#include "kernel/convex/normal_cones.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

namespace blossom::morphology {

NormalCones::NormalCones(const Mesh& triangles)
    : points_(triangles.points), inside_(points_.size(), Vec3::Zero()), around_(points_.size()) {
  struct Half {
    int from, to, face;  // the face to its left
  };
  std::vector<Half> halves;
  halves.reserve(3 * triangles.faceCount());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const auto face = triangles.face(f);
    normals_.push_back((point(face[1]) - point(face[0])).cross(point(face[2]) - point(face[0])).normalized());
    for (std::size_t k = 0; k < 3; ++k) {
      halves.push_back({face[k], face[(k + 1) % 3], static_cast<int>(f)});
      around_[static_cast<std::size_t>(face[k])].push_back(face[(k + 1) % 3]);
      inside_[static_cast<std::size_t>(face[k])] += normals_.back();
    }
  }
  for (Vec3& normal : inside_) normal.normalize();
  // Both halves of an edge come together, that from the lower corner first.
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
    return std::tuple(std::min(a.from, a.to), std::max(a.from, a.to), a.from) <
           std::tuple(std::min(b.from, b.to), std::max(b.from, b.to), b.from);
  });
  edges_.reserve(halves.size() / 2);
  for (std::size_t k = 0; k + 1 < halves.size(); k += 2)
    edges_.push_back({halves[k].from, halves[k].to, halves[k].face, halves[k + 1].face});
}

int NormalCones::highest(const Vec3& direction, int from) const {
  int at = from;
  double height = direction.dot(point(at));
  for (bool higher = true; higher;) {
    higher = false;
    for (const int other : around(at))
      if (const double h = direction.dot(point(other)); h > height) height = h, at = other, higher = true;
  }
  return at;
}

bool NormalCones::holds(int corner, const Vec3& direction) const {
  return std::all_of(around(corner).begin(), around(corner).end(),
                     [&](int other) { return direction.dot(point(other) - point(corner)) <= 0; });
}

NormalCones::Way NormalCones::leftBetween(const Vec3& first, const Vec3& last, int corner, double after) const {
  Way way;
  double steepest = 0;
  for (const int other : around(corner)) {
    const Vec3 along = point(other) - point(corner);
    const double atFirst = first.dot(along), atLast = last.dot(along);
    if (!(atLast > 0) || !(atLast > atFirst)) continue;
    const double share = std::max(after, std::min(1.0, atFirst / (atFirst - atLast)));
    if (way.to >= 0 && (share > way.share || (share == way.share && atLast <= steepest))) continue;
    way = {share, other};
    steepest = atLast;
  }
  return way;
}

}  // namespace blossom::morphology
