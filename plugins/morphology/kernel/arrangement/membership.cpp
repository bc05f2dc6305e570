#include "kernel/arrangement/membership.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/closed_triangles.h"

namespace blossom::morphology::arrangement {

namespace {

/// On which side of a triangle's plane, seen from its normal.
int sideOf(const Normal3& normal, const Grid3& through, const Grid3& p) {
  const Bounded about = dot({rounded(normal[0]), rounded(normal[1]), rounded(normal[2])}, exactly(p - through));
  return about.decided() ? signOf(about.value) : signOf(dot(normal, p - through));
}

/// Whether a segment and a triangle have a point in common, but for segments in the plane of the triangle.
bool meet(const Grid3& p, const Grid3& q, const std::array<Grid3, 3>& t) {
  const Normal3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const int sideOfP = sideOf(normal, t[0], p), sideOfQ = sideOf(normal, t[0], q);
  if (sideOfP * sideOfQ > 0 || (sideOfP == 0 && sideOfQ == 0)) return false;
  int turning = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = sideOf(cross(q - p, t[k] - p), p, t[(k + 1) % 3]);
    if (side * turning < 0) return false;
    if (side != 0) turning = side;
  }
  return true;
}

}  // namespace

Membership::Membership(const Features& a, const Features& b, bool insideOut, const Progress& progress)
    : a_(a), b_(b), insideOut_(insideOut), progress_(progress) {}

bool Membership::operator()(const Grid3& place) const {
  const Placed first{a_.points, a_};
  Placed second{{}, b_};
  for (const Grid3& p : b_.points) second.points.push_back(place - p);
  if (anyEdgeMeets(first, second, progress_) || anyEdgeMeets(second, first, progress_)) return true;
  const auto isInFirst = [&](int corner) {
    return holds(first, second.points[static_cast<std::size_t>(corner)], progress_) != insideOut_;
  };
  if (std::any_of(b_.parts.begin(), b_.parts.end(), isInFirst)) return true;
  return std::any_of(a_.parts.begin(), a_.parts.end(),
                     [&](int corner) { return holds(second, first.points[static_cast<std::size_t>(corner)], progress_); });
}

bool Membership::anyEdgeMeets(const Placed& edges, const Placed& faces, const Progress& progress) {
  std::vector<Box3> boxes;
  boxes.reserve(faces.features.faces.size());
  const auto corner = [&](const Features::Face& face, std::size_t k) -> const Grid3& {
    return faces.points[static_cast<std::size_t>(face.corners[k])];
  };
  for (const Features::Face& face : faces.features.faces)
    boxes.push_back(Box3(inDoubles(corner(face, 0))).extend(inDoubles(corner(face, 1))).extend(inDoubles(corner(face, 2))));
  const BoxTree<3> tree(boxes, 4, progress);
  bool met = false;
  for (const Features::Edge& edge : edges.features.edges) {
    const Grid3 &p = edges.points[static_cast<std::size_t>(edge.from)], &q = edges.points[static_cast<std::size_t>(edge.to)];
    tree.meeting(Box3(inDoubles(p)).extend(inDoubles(q)), [&](std::size_t f) {
      const Features::Face& face = faces.features.faces[f];
      met = met || meet(p, q, {corner(face, 0), corner(face, 1), corner(face, 2)});
    });
    if (met) return true;
  }
  return false;
}

/// Thin shapes hold nothing: their faces turn both ways around every place.
bool Membership::holds(const Placed& solid, const Grid3& point, const Progress& progress) {
  std::vector<Triangle3> triangles;
  triangles.reserve(solid.features.faces.size());
  const auto at = [&](int corner) { return Vec3(inDoubles(solid.points[static_cast<std::size_t>(corner)])); };
  for (const Features::Face& face : solid.features.faces)
    triangles.push_back({at(face.corners[0]), at(face.corners[1]), at(face.corners[2])});
  return std::abs(windingNumber(triangles, inDoubles(point), progress)) > 0.5;
}

}  // namespace blossom::morphology::arrangement
