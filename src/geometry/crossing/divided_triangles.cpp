#include "geometry/crossing/divided_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>

namespace blossom {
namespace {

constexpr int undivided = -1;  // a side that is not halved

class Divider {
 public:
  Divider(std::vector<Vec3>& points, const SmoothSheets& sheets, const SideJudge& tooLong, DivisionMemory& memory)
      : points_(points), sheets_(sheets), tooLong_(tooLong), memory_(memory) {}

  /// The middles of a triangle's sides, to be asked for all triangles before any is divided.
  void look(const SheetTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) look(t, k);
  }

  bool divide(const SheetTriangle& t, std::vector<SheetTriangle>& made) {
    const std::array<int, 3> middle{middleOf(t, 0), middleOf(t, 1), middleOf(t, 2)};
    const auto count = 3 - std::count(middle.begin(), middle.end(), undivided);
    if (count == 0) {
      made.push_back(t);
      return false;
    }
    // Round the triangle, corners and middles.
    std::vector<Corner> round;
    for (std::size_t k = 0; k < 3; ++k) {
      round.push_back({t.corners[k], t.at[k], false});
      if (middle[k] != undivided) round.push_back({middle[k], endsOf(t, k).middle(), true});
    }
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      const Corner &x = round[a % round.size()], &y = round[b % round.size()], &z = round[c % round.size()];
      made.push_back({{x.point, y.point, z.point}, {x.at, y.at, z.at}, t.face});
    };
    if (count == 3) {
      add(5, 0, 1), add(1, 2, 3), add(3, 4, 5), add(1, 3, 5);
      return true;
    }
    // A fan from a middle, across the corner between two of them.
    std::size_t from = 0;
    while (!round[from].isMiddle || (count == 2 && !round[(from + 2) % round.size()].isMiddle)) ++from;
    for (std::size_t k = 1; k + 1 < round.size(); ++k) add(from, from + k, from + k + 1);
    return true;
  }

 private:
  struct Corner {
    int point = 0;
    Vec2 at;
    bool isMiddle = false;
  };

  /// A side that is halved, or not yet known to be.
  struct Side {
    int face = 0;
    Vec2 at;     ///< parameters of the middle on the face
    Vec3 bulge;  ///< from the middle of the chord to the face
    bool isKnown = false;
    int middle = undivided;
  };

  [[nodiscard]] const SurfaceFrame& frame(int face, const Vec2& at) const { return memory_.frame(sheets_, face, at); }

  /// The parameters of both ends of a side.
  struct Ends {
    Vec2 from, to;
    [[nodiscard]] Vec2 middle() const { return (from + to) / 2; }
  };

  /// At a pole, where a row of the face is one point, the parameter along that row means nothing: the one of the other end
  /// counts, so that the middle does not turn aside and fold its triangles.
  [[nodiscard]] Ends endsOf(const SheetTriangle& t, std::size_t k) const {
    constexpr double still = 1e-6;  // of the speed at the other end
    Ends ends{t.at[k], t.at[(k + 1) % 3]};
    const SurfaceFrame a = frame(t.face, ends.from), b = frame(t.face, ends.to);
    const auto carryOver = [&](double fromSpeed, double toSpeed, Eigen::Index which) {
      if (fromSpeed <= still * toSpeed) ends.from[which] = ends.to[which];
      if (toSpeed <= still * fromSpeed) ends.to[which] = ends.from[which];
    };
    carryOver(a.du.norm(), b.du.norm(), 0);
    carryOver(a.dv.norm(), b.dv.norm(), 1);
    return ends;
  }

  static DivisionMemory::Key keyOf(const SheetTriangle& t, std::size_t k) {
    const std::size_t l = (k + 1) % 3;
    const auto low = static_cast<std::uint64_t>(std::min(t.corners[k], t.corners[l])),
               high = static_cast<std::uint64_t>(std::max(t.corners[k], t.corners[l]));
    return low << 32U | high;
  }

  void look(const SheetTriangle& t, std::size_t k) {
    if (memory_.isShort(keyOf(t, k))) return;
    const auto [found, isNew] = sides_.try_emplace(keyOf(t, k));
    Side& side = found->second;
    if (!isNew && side.face == t.face) return;
    const Ends ends = endsOf(t, k);
    const Vec2 at = ends.middle();
    // Corners on a border may lie off this face: their middle belongs to the neighbouring face, and only its parameters lie
    // on this one. So the face tells how far a middle is from its chord, not where it is: a flat face stays flat.
    const auto onFace = [&](const Vec2& parameters) { return frame(t.face, parameters).point; };
    const Vec3 bulge = onFace(at) - (onFace(ends.from) + onFace(ends.to)) / 2;
    side = isNew ? Side{t.face, at, bulge, false, undivided}
                 : Side{t.face, at, bulgeOfBoth(side, {t.face, at, bulge, false, undivided}), false, undivided};
  }

  [[nodiscard]] Vec3 normalAt(const Side& side) const {
    const SurfaceFrame there = frame(side.face, side.at);
    return there.du.cross(there.dv).normalized();
  }

  /// Along an edge between two faces the middle lies on both: a flat end knows nothing of the round wall.
  [[nodiscard]] Vec3 bulgeOfBoth(const Side& a, const Side& b) const {
    constexpr double smooth = 0.1;  // sine of the angle between the faces
    const Vec3 n = normalAt(a), m = normalAt(b);
    const double cosine = n.dot(m), square = 1 - cosine * cosine;
    if (!(square > smooth * smooth)) return a.bulge.norm() < b.bulge.norm() ? b.bulge : a.bulge;
    const double x = n.dot(a.bulge), y = m.dot(b.bulge);
    return (x - cosine * y) / square * n + (y - cosine * x) / square * m;
  }

  /// The middle of the side from corner k to the next, one point for all its triangles.
  int middleOf(const SheetTriangle& t, std::size_t k) {
    if (memory_.isShort(keyOf(t, k))) return undivided;
    Side& side = sides_.at(keyOf(t, k));
    if (side.isKnown) return side.middle;
    side.isKnown = true;
    const Vec3 p = points_[static_cast<std::size_t>(t.corners[k])],
               q = points_[static_cast<std::size_t>(t.corners[(k + 1) % 3])];
    Vec3 middle = (p + q) / 2 + side.bulge;
    // Where the parameters say little, as beside a pole, the chord is safer.
    if (!((middle - (p + q) / 2).norm() < (p - q).norm() / 2)) middle = (p + q) / 2;
    if (!tooLong_(p, q, middle)) {
      memory_.setShort(keyOf(t, k));
      return undivided;
    }
    points_.push_back(middle);
    return side.middle = static_cast<int>(points_.size()) - 1;
  }

  std::vector<Vec3>& points_;
  const SmoothSheets& sheets_;
  const SideJudge& tooLong_;
  DivisionMemory& memory_;
  std::unordered_map<std::uint64_t, Side> sides_;
};

}  // namespace

std::size_t DivisionMemory::HashOfPlace::operator()(const Place& p) const {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;  // 2^64 divided by the golden ratio
  std::uint64_t hash = static_cast<std::uint64_t>(p.face);
  for (const double each : {p.u, p.v}) hash = (hash ^ std::hash<double>{}(each)) * odd, hash ^= hash >> 29U;
  return hash;
}

const SurfaceFrame& DivisionMemory::frame(const SmoothSheets& sheets, int face, const Vec2& at) {
  const auto [found, isNew] = frames_.try_emplace(Place{face, at.x(), at.y()});
  if (isNew) found->second = sheets.frame(face, at);
  return found->second;
}

bool divideOnce(std::vector<Vec3>& points, std::vector<SheetTriangle>& triangles, const SmoothSheets& sheets,
                const SideJudge& tooLong, DivisionMemory& memory) {
  Divider divider(points, sheets, tooLong, memory);
  std::vector<SheetTriangle> made;
  made.reserve(2 * triangles.size());
  bool any = false;
  for (const SheetTriangle& t : triangles) divider.look(t);
  for (const SheetTriangle& t : triangles) any |= divider.divide(t, made);
  triangles = std::move(made);
  return any;
}

}  // namespace blossom
