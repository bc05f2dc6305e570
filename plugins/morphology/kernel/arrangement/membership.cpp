#include "kernel/arrangement/membership.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

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

/// 1: a segment passes a triangle from behind; -1: from before it; 0: it does not; nothing: it meets an edge, or lies in the
/// plane. @pre neither end lies on the triangle
std::optional<int> passedThrough(const std::array<Grid3, 3>& t, const Grid3& from, const Grid3& to) {
  const Normal3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const int before = sideOf(normal, t[0], from), after = sideOf(normal, t[0], to);
  if (before == 0 && after == 0) return std::nullopt;
  if (before * after >= 0) return 0;
  bool left = false, right = false, on = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = sideOf(cross(to - from, t[k] - from), from, t[(k + 1) % 3]);
    left = left || side > 0;
    right = right || side < 0;
    on = on || side == 0;
  }
  if (left && right) return 0;
  return on ? std::nullopt : std::optional(after);
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
  Grid3 beyond = point;
  for (const Grid3& p : solid.points) beyond[0] = std::max(beyond[0], p[0] + 1);
  if (beyond[0] == point[0]) return false;
  // Along an axis, or nearly so: few faces are anywhere near. A way that meets no edge is soon found.
  std::uint64_t random = 1;
  const auto aside = [&](int bits) {
    random = random * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::int64_t>(random >> (64 - bits)) - (std::int64_t{1} << (bits - 1));
  };
  constexpr int fewestBits = 8, mostBits = 40;
  for (int bits = fewestBits; bits <= mostBits; ++bits) {
    progress.check();
    const Grid3 end{beyond[0], point[1] + aside(bits), point[2] + aside(bits)};
    if (const std::optional<int> turns = turnsAlong(solid, point, end)) return *turns != 0;
  }
  throw Error(ErrorCode::Internal, "No way out of a cell of the sum avoids all edges.", "Please report the two shapes.");
}

/// How often the faces turn around the start of a segment that ends outside, by those that it passes; nothing when it meets
/// an edge.
std::optional<int> Membership::turnsAlong(const Placed& solid, const Grid3& from, const Grid3& to) {
  const auto liesAside = [&](const std::array<Grid3, 3>& t, std::size_t axis) {
    const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    const auto [first, last] = std::minmax(from[axis], to[axis]);
    return high < first || low > last;
  };
  int turns = 0;
  for (const Features::Face& face : solid.features.faces) {
    const auto at = [&](std::size_t k) { return solid.points[static_cast<std::size_t>(face.corners[k])]; };
    const std::array<Grid3, 3> triangle{at(0), at(1), at(2)};
    if (liesAside(triangle, 1) || liesAside(triangle, 2) || liesAside(triangle, 0)) continue;
    const std::optional<int> passed = passedThrough(triangle, from, to);
    if (!passed) return std::nullopt;
    turns += *passed;
  }
  return turns;
}

}  // namespace blossom::morphology::arrangement
