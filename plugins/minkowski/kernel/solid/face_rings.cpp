#include "kernel/solid/face_rings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "core/error.h"

namespace blossom::minkowski {
namespace {

std::size_t slotOf(int index) { return static_cast<std::size_t>(index); }

std::vector<Vec3> areasOf(std::span<const FaceSide> sides, std::span<const Vec3> points) {
  std::vector<Vec3> areas;
  std::vector<int> seen;  // a corner of each face, so that places far away cost no digits
  for (const FaceSide& side : sides) {
    if (areas.size() <= slotOf(side.face)) {
      areas.resize(slotOf(side.face) + 1, Vec3::Zero());
      seen.resize(slotOf(side.face) + 1, -1);
    }
    if (seen[slotOf(side.face)] < 0) seen[slotOf(side.face)] = side.from;
    const Vec3& origin = points[slotOf(seen[slotOf(side.face)])];
    areas[slotOf(side.face)] += (points[slotOf(side.from)] - origin).cross(points[slotOf(side.to)] - origin) / 2;
  }
  return areas;
}

/// Which faces meet at an edge, and the corners of each.
struct FaceNeighbourhood {
  std::vector<std::set<int>> faces, corners;

  FaceNeighbourhood(std::span<const FaceSide> sides, std::size_t count) : faces(count), corners(count) {
    std::map<std::pair<int, int>, std::vector<int>> facesOfEdge;
    for (const FaceSide& side : sides) {
      corners[slotOf(side.face)].insert(side.from);
      facesOfEdge[std::minmax({side.from, side.to})].push_back(side.face);
    }
    for (const auto& [edge, all] : facesOfEdge)
      for (const int a : all)
        for (const int b : all)
          if (a != b) faces[slotOf(a)].insert(b);
  }
};

/// The largest distance of corners of a face from each other, roughly.
double extentOfCorners(const std::set<int>& corners, std::span<const Vec3> points) {
  double reach = 0;
  for (const int v : corners) reach = std::max(reach, (points[slotOf(v)] - points[slotOf(*corners.begin())]).norm());
  return reach;
}

}  // namespace

std::vector<FaceSide> withoutPairs(std::vector<FaceSide> sides) {
  std::map<FaceSide, int> counts;
  for (const FaceSide& side : sides) {
    if (side.from < side.to)
      ++counts[side];
    else if (side.to < side.from)
      --counts[{side.face, side.to, side.from}];
  }
  sides.clear();
  for (const auto& [side, count] : counts)
    for (int k = 0; k < std::abs(count); ++k) sides.push_back(count > 0 ? side : FaceSide{side.face, side.to, side.from});
  return sides;
}

void joinFlat(std::vector<FaceSide>& sides, std::span<const Vec3> points, double tolerance, const Progress& progress) {
  const std::vector<Vec3> areas = areasOf(sides, points);
  const FaceNeighbourhood around(sides, areas.size());
  std::vector<int> order(areas.size()), part(areas.size(), -1);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return areas[slotOf(a)].norm() > areas[slotOf(b)].norm(); });
  for (const int seed : order) {
    if (part[slotOf(seed)] >= 0 || around.corners[slotOf(seed)].empty()) continue;
    progress.check();
    part[slotOf(seed)] = seed;
    const Vec3 normal = areas[slotOf(seed)].normalized(), origin = points[slotOf(*around.corners[slotOf(seed)].begin())];
    const auto fits = [&](int face) {
      const std::set<int>& corners = around.corners[slotOf(face)];
      if (std::any_of(corners.begin(), corners.end(),
                      [&](int v) { return std::abs((points[slotOf(v)] - origin).dot(normal)) > tolerance; }))
        return false;
      // The normal of a sliver is chance.
      return areas[slotOf(face)].dot(normal) > 0 ||
             areas[slotOf(face)].norm() <= tolerance * extentOfCorners(corners, points);
    };
    for (std::vector<int> open{seed}; !open.empty();) {
      const int face = open.back();
      open.pop_back();
      for (const int next : around.faces[slotOf(face)])
        if (part[slotOf(next)] < 0 && fits(next)) {
          part[slotOf(next)] = seed;
          open.push_back(next);
        }
    }
  }
  for (FaceSide& side : sides) side.face = part[slotOf(side.face)];
  sides = withoutPairs(std::move(sides));
}

namespace {

/// Takes the sides of one face one after the other.
class RingTracer {
 public:
  RingTracer(std::span<const FaceSide> sides, std::span<const Vec3> points, const Vec3& normal) : points_(points) {
    for (const FaceSide& side : sides) next_[side.from].push_back(side.to);
    z_ = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(0, 0, 1);
    x_ = z_.unitOrthogonal();
    y_ = z_.cross(x_);
  }

  std::vector<CornerRing> rings() {
    std::vector<CornerRing> all;
    while (!next_.empty()) {
      CornerRing walk;
      int before = -1, here = next_.begin()->first;
      std::map<int, std::size_t> places;
      while (true) {
        const auto seen = places.find(here);
        if (seen != places.end()) {
          const auto start = walk.begin() + static_cast<std::ptrdiff_t>(seen->second);
          all.emplace_back(start, walk.end());
          for (auto v = start; v != walk.end(); ++v) places.erase(*v);
          walk.erase(start, walk.end());
          if (walk.empty() && !next_.contains(here)) break;
        }
        places[here] = walk.size();
        walk.push_back(here);
        const int onwards = take(before, here);
        before = here;
        here = onwards;
      }
    }
    return all;
  }

 private:
  double angle(int from, int to) const {
    const Vec3 along = points_[slotOf(to)] - points_[slotOf(from)];
    return std::atan2(along.dot(y_), along.dot(x_));
  }
  /// The next corner: of several the first clockwise from where we come from, so that the face's inside stays whole.
  int take(int before, int here) {
    const auto found = next_.find(here);
    if (found == next_.end())
      throw Error(ErrorCode::Internal, "The faces of the solid do not close.", "Please report the two shapes.");
    std::vector<int>& choices = found->second;
    std::size_t best = 0;
    if (choices.size() > 1 && before >= 0) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < choices.size(); ++k) {
        double turn = angle(here, before) - angle(here, choices[k]);
        if (turn <= 0) turn += 2 * std::numbers::pi;
        if (turn < least) {
          least = turn;
          best = k;
        }
      }
    }
    const int onwards = choices[best];
    choices.erase(choices.begin() + static_cast<std::ptrdiff_t>(best));
    if (choices.empty()) next_.erase(found);
    return onwards;
  }

  std::span<const Vec3> points_;
  std::map<int, std::vector<int>> next_;
  Vec3 x_, y_, z_;
};

}  // namespace

std::vector<RingsOfFace> ringsOf(std::span<const FaceSide> given, std::span<const Vec3> points, const Progress& progress) {
  std::vector<FaceSide> sides(given.begin(), given.end());
  std::sort(sides.begin(), sides.end());
  const std::vector<Vec3> areas = areasOf(sides, points);
  std::vector<RingsOfFace> faces;
  for (auto first = sides.begin(); first != sides.end();) {
    progress.check();
    const auto last = std::find_if(first, sides.end(), [&](const FaceSide& side) { return side.face != first->face; });
    const Vec3& normal = areas[slotOf(first->face)];
    faces.push_back({normal, RingTracer({first, last}, points, normal).rings()});
    first = last;
  }
  return faces;
}

void dropStraightCorners(std::vector<RingsOfFace>& faces, std::span<const Vec3> points, double tolerance) {
  std::vector<std::set<int>> neighbours(points.size());
  for (const RingsOfFace& face : faces)
    for (const CornerRing& ring : face.rings)
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const int a = ring[k], b = ring[(k + 1) % ring.size()];
        neighbours[slotOf(a)].insert(b);
        neighbours[slotOf(b)].insert(a);
      }
  const auto straight = [&](int v) {
    if (neighbours[slotOf(v)].size() != 2) return false;
    const int a = *neighbours[slotOf(v)].begin(), b = *neighbours[slotOf(v)].rbegin();
    if (neighbours[slotOf(a)].contains(b)) return false;
    const Vec3 in = points[slotOf(v)] - points[slotOf(a)], out = points[slotOf(b)] - points[slotOf(v)];
    if (in.dot(out) <= 0 || in.cross(out).norm() > tolerance * (in + out).norm()) return false;
    neighbours[slotOf(a)].erase(v);
    neighbours[slotOf(b)].erase(v);
    neighbours[slotOf(a)].insert(b);
    neighbours[slotOf(b)].insert(a);
    return true;
  };
  std::vector<bool> dropped(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) dropped[v] = straight(static_cast<int>(v));
  for (RingsOfFace& face : faces)
    for (CornerRing& ring : face.rings) std::erase_if(ring, [&](int v) { return dropped[slotOf(v)]; });
}

void dropBackToBack(std::vector<RingsOfFace>& faces) {
  const auto fromLowest = [](CornerRing ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    return ring;
  };
  std::map<CornerRing, std::vector<CornerRing*>> places;
  for (RingsOfFace& face : faces)
    for (CornerRing& ring : face.rings) {
      if (ring.empty()) continue;
      const auto back = places.find(fromLowest({ring.rbegin(), ring.rend()}));
      if (back == places.end() || back->second.empty()) {
        places[fromLowest(ring)].push_back(&ring);
        continue;
      }
      back->second.back()->clear();
      back->second.pop_back();
      ring.clear();
    }
  for (RingsOfFace& face : faces) std::erase_if(face.rings, [](const CornerRing& ring) { return ring.empty(); });
}

}  // namespace blossom::minkowski
