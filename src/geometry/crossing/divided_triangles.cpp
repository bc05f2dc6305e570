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

SheetPatch patchOf(const SheetTriangle& t) {
  return {{t.corners[0], t.corners[1], t.corners[2], 0}, {t.at[0], t.at[1], t.at[2], Vec2(0, 0)}, t.face, 3};
}

class Divider {
 public:
  Divider(std::vector<Vec3>& points, const SmoothSheets& sheets, const SideJudge& tooLong, DivisionMemory& memory,
          double fine = 0)
      : points_(points), sheets_(sheets), tooLong_(tooLong), memory_(memory), fine_(fine) {}

  /// The middles of a patch's sides, to be asked for all patches before any is divided.
  void look(const SheetPatch& p) {
    for (std::size_t k = 0; k < p.count; ++k) look(sideOf(p, k, (k + 1) % p.count));
  }

  /// @returns whether the patch was divided; else it is finished
  bool divide(const SheetPatch& p, std::vector<SheetPatch>& made) {
    std::array<int, 4> middle{undivided, undivided, undivided, undivided};
    for (std::size_t k = 0; k < p.count; ++k) middle[k] = middleOf(sideOf(p, k, (k + 1) % p.count));
    return p.count == 3 ? divideTriangle(p, {middle[0], middle[1], middle[2]}, made) : divideStrip(p, middle, made);
  }

 private:
  struct Corner {
    int point = 0;
    Vec2 at;
    bool isMiddle = false;
  };

  /// One side of a patch.
  struct SideOf {
    int face, from, to;
    Vec2 atFrom, atTo;
  };
  static SideOf sideOf(const SheetPatch& p, std::size_t from, std::size_t to) {
    return {p.face, p.corners[from], p.corners[to], p.at[from], p.at[to]};
  }

  bool divideTriangle(const SheetPatch& t, const std::array<int, 3>& middle, std::vector<SheetPatch>& made) {
    const auto count = 3 - std::count(middle.begin(), middle.end(), undivided);
    if (count == 0) return false;
    // Round the triangle, corners and middles.
    std::vector<Corner> round;
    for (std::size_t k = 0; k < 3; ++k) {
      round.push_back({t.corners[k], t.at[k], false});
      if (middle[k] != undivided) round.push_back({middle[k], endsOf(sideOf(t, k, (k + 1) % 3)).middle(), true});
    }
    const auto corner = [&](std::size_t k) -> const Corner& { return round[k % round.size()]; };
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      const Corner &x = corner(a), &y = corner(b), &z = corner(c);
      made.push_back({{x.point, y.point, z.point, 0}, {x.at, y.at, z.at, Vec2(0, 0)}, t.face, 3});
    };
    if (count == 3) {
      add(5, 0, 1), add(1, 2, 3), add(3, 4, 5), add(1, 3, 5);
      return true;
    }
    // Across the corner between two middles; a fan from a single one.
    std::size_t from = 0;
    while (!round[from].isMiddle || (count == 2 && !corner(from + 2).isMiddle)) ++from;
    add(from, from + 1, from + 2);
    if (count == 1)
      add(from, from + 2, from + 3);
    else
      addStrip(t.face, {corner(from), corner(from + 2), corner(from + 3), corner(from + 4)}, made);
    return true;
  }

  bool divideStrip(const SheetPatch& p, const std::array<int, 4>& middle, std::vector<SheetPatch>& made) {
    const auto count = 4 - std::count(middle.begin(), middle.end(), undivided);
    const auto one = p.triangles();
    if (count == 0) {
      if (!isLong(sideOf(p, 0, 2))) return false;
      for (const SheetTriangle& t : one) made.push_back(patchOf(t));
      return true;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      if (count != 2 || middle[k] == undivided || middle[k + 2] == undivided) continue;
      const std::array<std::size_t, 4> round{k, k + 1, (k + 2) % 4, (k + 3) % 4};
      const auto corner = [&](std::size_t i) { return Corner{p.corners[round[i]], p.at[round[i]], false}; };
      const auto middleAfter = [&](std::size_t i) {
        return Corner{middle[round[i]], endsOf(sideOf(p, round[i], round[(i + 1) % 4])).middle(), true};
      };
      const Corner first = middleAfter(0), second = middleAfter(2);
      addStrip(p.face, {corner(0), first, second, corner(3)}, made);
      addStrip(p.face, {first, corner(1), corner(2), second}, made);
      return true;
    }
    // Two triangles over the diagonal, which nothing halves in this round.
    const auto half = [&](const SheetTriangle& t, int first, int second, int third) {
      if (!divideTriangle(patchOf(t), {first, second, third}, made)) made.push_back(patchOf(t));
    };
    half(one[0], middle[0], middle[1], undivided);
    half(one[1], undivided, middle[2], middle[3]);
    return true;
  }

  /// Along the shorter diagonal.
  void addStrip(int face, const std::array<Corner, 4>& c, std::vector<SheetPatch>& made) const {
    const auto at = [&](std::size_t k) -> const Vec3& { return points_[static_cast<std::size_t>(c[k].point)]; };
    const std::size_t turn = (at(3) - at(1)).squaredNorm() <= (at(2) - at(0)).squaredNorm() ? 1 : 0;
    SheetPatch strip;
    strip.face = face;
    strip.count = 4;
    for (std::size_t k = 0; k < 4; ++k) strip.corners[k] = c[(k + turn) % 4].point, strip.at[k] = c[(k + turn) % 4].at;
    made.push_back(strip);
  }

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
  [[nodiscard]] Ends endsOf(const SideOf& side) const {
    constexpr double still = 1e-6;  // of the speed at the other end
    Ends ends{side.atFrom, side.atTo};
    const SurfaceFrame a = frame(side.face, ends.from), b = frame(side.face, ends.to);
    const auto carryOver = [&](double fromSpeed, double toSpeed, Eigen::Index which) {
      if (fromSpeed <= still * toSpeed) ends.from[which] = ends.to[which];
      if (toSpeed <= still * fromSpeed) ends.to[which] = ends.from[which];
    };
    carryOver(a.du.norm(), b.du.norm(), 0);
    carryOver(a.dv.norm(), b.dv.norm(), 1);
    return ends;
  }

  static DivisionMemory::Key keyOf(const SideOf& side) {
    const auto low = static_cast<std::uint64_t>(std::min(side.from, side.to)),
               high = static_cast<std::uint64_t>(std::max(side.from, side.to));
    return low << 32U | high;
  }

  /// Corners on a border may lie off this face: their middle belongs to the neighbouring face, and only its parameters lie
  /// on this one. So the face tells how far a middle is from its chord, not where it is: a flat face stays flat.
  [[nodiscard]] Side sideOn(const SideOf& s) const {
    const Ends ends = endsOf(s);
    const auto onFace = [&](const Vec2& parameters) { return frame(s.face, parameters).point; };
    const Vec2 at = ends.middle();
    return {s.face, at, onFace(at) - (onFace(ends.from) + onFace(ends.to)) / 2, false, undivided};
  }

  void look(const SideOf& s) {
    if (isShort(s)) return;
    const auto [found, isNew] = sides_.try_emplace(keyOf(s));
    Side& side = found->second;
    if (!isNew && side.face == s.face) return;
    Side here = sideOn(s);
    if (!isNew) here.bulge = bulgeOfBoth(side, here);
    side = here;
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

  [[nodiscard]] Vec3 placeOfMiddle(const SideOf& s, const Side& side) const {
    const Vec3 &p = pointAt(s.from), &q = pointAt(s.to);
    const Vec3 middle = (p + q) / 2 + side.bulge;
    // Where the parameters say little, as beside a pole, the chord is safer.
    return (middle - (p + q) / 2).norm() < (p - q).norm() / 2 ? middle : Vec3((p + q) / 2);
  }

  /// The middle of a side, one point for all its patches.
  int middleOf(const SideOf& s) {
    if (isShort(s)) return undivided;
    Side& side = sides_.at(keyOf(s));
    if (side.isKnown) return side.middle;
    side.isKnown = true;
    const Vec3 middle = placeOfMiddle(s, side);
    if (!tooLong_(pointAt(s.from), pointAt(s.to), middle)) {
      memory_.setShort(keyOf(s));
      return undivided;
    }
    points_.push_back(middle);
    return side.middle = static_cast<int>(points_.size()) - 1;
  }

  /// Of a diagonal, which is no side of anything else.
  [[nodiscard]] bool isLong(const SideOf& s) const {
    if (isShort(s)) return false;
    if (tooLong_(pointAt(s.from), pointAt(s.to), placeOfMiddle(s, sideOn(s)))) return true;
    memory_.setShort(keyOf(s));
    return false;
  }

  [[nodiscard]] bool isShort(const SideOf& s) const {
    return (pointAt(s.to) - pointAt(s.from)).squaredNorm() <= fine_ * fine_ || memory_.isShort(keyOf(s));
  }
  [[nodiscard]] const Vec3& pointAt(int k) const { return points_[static_cast<std::size_t>(k)]; }

  std::vector<Vec3>& points_;
  const SmoothSheets& sheets_;
  const SideJudge& tooLong_;
  DivisionMemory& memory_;
  double fine_;
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

std::vector<SheetTriangle> SheetPatch::triangles() const {
  std::vector<SheetTriangle> result{{{corners[0], corners[1], corners[2]}, {at[0], at[1], at[2]}, face}};
  if (count == 4) result.push_back({{corners[0], corners[2], corners[3]}, {at[0], at[2], at[3]}, face});
  return result;
}

TriangleDivision::TriangleDivision(std::vector<Vec3>& points, const std::vector<SheetTriangle>& triangles,
                                   const SmoothSheets& sheets, SideJudge tooLong, double fine)
    : points_(points), sheets_(sheets), tooLong_(std::move(tooLong)), fine_(fine) {
  open_.reserve(triangles.size());
  for (const SheetTriangle& t : triangles) open_.push_back(patchOf(t));
}

bool TriangleDivision::isWanted(const SheetPatch& p, const Wanted& wanted) const {
  const auto at = [&](std::size_t k) -> const Vec3& { return points_[static_cast<std::size_t>(p.corners[k])]; };
  return wanted({at(0), at(1), at(2)}) || (p.count == 4 && wanted({at(0), at(2), at(3)}));
}

bool TriangleDivision::divideOnce(const Wanted& wanted) {
  std::erase_if(open_, [&](const SheetPatch& p) { return !isWanted(p, wanted); });
  Divider divider(points_, sheets_, tooLong_, memory_, fine_);
  for (const SheetPatch& p : open_) divider.look(p);
  std::vector<SheetPatch> made;
  made.reserve(2 * open_.size());
  for (const SheetPatch& p : open_)
    if (!divider.divide(p, made)) finished_.push_back(p);
  open_ = std::move(made);
  return !open_.empty();
}

std::vector<SheetTriangle> TriangleDivision::triangles(const Wanted& wanted) const {
  std::vector<SheetTriangle> result;
  result.reserve(2 * count());
  for (const auto* patches : {&finished_, &open_})
    for (const SheetPatch& p : *patches)
      for (const SheetTriangle& t : p.triangles())
        if (isWanted(patchOf(t), wanted)) result.push_back(t);
  return result;
}

bool divideOnce(std::vector<Vec3>& points, std::vector<SheetTriangle>& triangles, const SmoothSheets& sheets,
                const SideJudge& tooLong, DivisionMemory& memory) {
  Divider divider(points, sheets, tooLong, memory);
  for (const SheetTriangle& t : triangles) divider.look(patchOf(t));
  std::vector<SheetTriangle> divided;
  divided.reserve(2 * triangles.size());
  bool any = false;
  std::vector<SheetPatch> made;
  for (const SheetTriangle& t : triangles) {
    made.clear();
    const bool isDivided = divider.divide(patchOf(t), made);
    any |= isDivided;
    if (!isDivided) divided.push_back(t);
    for (const SheetPatch& p : made)
      for (const SheetTriangle& part : p.triangles()) divided.push_back(part);
  }
  triangles = std::move(divided);
  return any;
}

}  // namespace blossom
