#include "geometry/planar/outline_crossing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom {
namespace {

constexpr double touching = 1e-6;  // mm
constexpr double bend = 1e-7;      // mm between a piece and its chord

struct PieceBox {
  Vec2 minimum = Vec2::Constant(1e300), maximum = Vec2::Constant(-1e300);
  void add(const Vec2& p) {
    minimum = minimum.cwiseMin(p);
    maximum = maximum.cwiseMax(p);
  }
  [[nodiscard]] bool near(const PieceBox& other) const {
    return ((minimum - other.maximum).array() <= touching).all() && ((other.minimum - maximum).array() <= touching).all();
  }
};

PieceBox boxOf(const BezierPiece& piece) {
  PieceBox box;
  for (const Vec3& pole : piece) box.add(euclidean(pole));
  return box;
}

/// A path in pieces whose control polygons turn by less than half a turn: such a piece does not meet itself.
struct Piece {
  BezierPiece curve;
  PieceBox box;
};

bool turnsLittle(const BezierPiece& piece) {
  double turn = 0;
  std::optional<Vec2> before;
  for (std::size_t k = 0; k + 1 < piece.size(); ++k) {
    const Vec2 leg = euclidean(piece[k + 1]) - euclidean(piece[k]);
    if (leg.squaredNorm() == 0) continue;
    if (before) turn += std::abs(std::atan2(cross(*before, leg), before->dot(leg)));
    before = leg;
  }
  return turn < 3;
}

void addPieces(const BezierPiece& curve, int depth, std::vector<Piece>& pieces) {
  if (depth == 0 || turnsLittle(curve)) {
    pieces.push_back({curve, boxOf(curve)});
    return;
  }
  const auto [first, second] = halves(curve);
  addPieces(first, depth - 1, pieces);
  addPieces(second, depth - 1, pieces);
}

std::vector<BezierPiece> curvesOf(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return {{line->from.homogeneous(), line->to.homogeneous()}};
  if (const auto* arc = std::get_if<Arc2>(&segment))
    return bezierPieces(ellipticArc(arc->center, {arc->radius, 0}, 1, arc->start, arc->sweep));
  return bezierPieces(std::get<Spline2>(segment));
}

std::vector<Piece> piecesOf(const Path& path) {
  constexpr int deepest = 12;
  std::vector<Piece> pieces;
  for (const Segment& segment : path.segments)
    for (const BezierPiece& curve : curvesOf(segment)) {
      // The line that closes a rounded end is none: its neighbours follow each other.
      const PieceBox box = boxOf(curve);
      if ((box.maximum - box.minimum).norm() > touching) addPieces(curve, deepest, pieces);
    }
  return pieces;
}

bool isStraight(const BezierPiece& piece) {
  const Vec2 from = euclidean(piece.front()), along = euclidean(piece.back()) - from;
  const double reach = along.norm();
  return std::all_of(piece.begin(), piece.end(), [&](const Vec3& pole) {
    const Vec2 offset = euclidean(pole) - from;
    return reach > 0 ? std::abs(cross(along, offset)) <= bend * reach : offset.norm() <= bend;
  });
}

/// The point of the chord a b nearest to p.
Vec2 nearest(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0 ? Vec2(a + std::clamp((p - a).dot(along) / squared, 0.0, 1.0) * along) : a;
}

/// A zone around the common end of two neighbours in which they may meet.
struct Joint {
  Vec2 place = Vec2::Zero();
  double reach = 0;
};

/// Where two curves meet, and the unit directions in which they pass.
struct Contact {
  Vec2 place, along, other;
  bool steep;  ///< they cross at an angle, not just touch or run side by side
};

using Counts = std::function<bool(const Contact&)>;

class Finder {
 public:
  /// Contacts count when `counts` says so; all of them when it is empty. Of curves that run side by side it is asked once
  /// for all within a hundredth of `extent`.
  explicit Finder(std::vector<Joint> joints, Counts counts = {}, double extent = 0)
      : joints_(std::move(joints)), counts_(std::move(counts)), extent_(extent) {}

  std::optional<Vec2> meet(const BezierPiece& a, const BezierPiece& b) {
    if (!boxOf(a).near(boxOf(b)) || withinJoint(a, b)) return std::nullopt;
    const bool straightA = isStraight(a), straightB = isStraight(b);
    if (straightA && straightB) return chordsMeet(a, b);
    const auto [a1, a2] = straightA ? std::pair(a, BezierPiece()) : halves(a);
    const auto [b1, b2] = straightB ? std::pair(b, BezierPiece()) : halves(b);
    for (const auto* partA : {&a1, &a2})
      for (const auto* partB : {&b1, &b2}) {
        if (partA->empty() || partB->empty()) continue;
        if (auto place = meet(*partA, *partB)) return place;
      }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool isMeeting(const Contact& contact) {
    const auto excuses = [&](const Joint& joint) { return (contact.place - joint.place).norm() <= joint.reach; };
    if (std::any_of(joints_.begin(), joints_.end(), excuses)) return false;
    if (!counts_) return true;
    const auto isNear = [&](const Vec2& refused) { return (contact.place - refused).norm() <= 0.01 * extent_; };
    if (!contact.steep && std::any_of(refused_.begin(), refused_.end(), isNear)) return false;
    if (counts_(contact)) return true;
    if (!contact.steep) refused_.push_back(contact.place);
    return false;
  }

  [[nodiscard]] bool withinJoint(const BezierPiece& a, const BezierPiece& b) const {
    const auto inside = [&](const Joint& joint) {
      const auto close = [&](const Vec3& pole) { return (euclidean(pole) - joint.place).norm() <= joint.reach; };
      return std::all_of(a.begin(), a.end(), close) && std::all_of(b.begin(), b.end(), close);
    };
    return std::any_of(joints_.begin(), joints_.end(), inside);
  }

  /// Proper crossings first, then ends that lie on the other chord: also what runs back over itself is found by its ends.
  [[nodiscard]] std::optional<Vec2> chordsMeet(const BezierPiece& a, const BezierPiece& b) {
    const Vec2 a0 = euclidean(a.front()), a1 = euclidean(a.back()), b0 = euclidean(b.front()), b1 = euclidean(b.back());
    const Vec2 along = (a1 - a0).normalized(), other = (b1 - b0).normalized();
    const double side = cross(a1 - a0, b1 - b0);
    if (side != 0) {
      const double s = cross(b0 - a0, b1 - b0) / side, t = cross(b0 - a0, a1 - a0) / side;
      const Vec2 place = a0 + s * (a1 - a0);
      const bool steep = std::abs(cross(along, other)) > 1e-3;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1 && isMeeting({place, along, other, steep})) return place;
    }
    for (const Vec2& p : {a0, a1})
      if ((p - nearest(p, b0, b1)).norm() <= touching && isMeeting({p, along, other, false})) return p;
    for (const Vec2& p : {b0, b1})
      if ((p - nearest(p, a0, a1)).norm() <= touching && isMeeting({p, along, other, false})) return p;
    return std::nullopt;
  }

  std::vector<Joint> joints_;
  Counts counts_;
  double extent_;
  std::vector<Vec2> refused_;
};

double extentOf(const Piece& piece) { return (piece.box.maximum - piece.box.minimum).norm(); }

Joint jointAt(const Piece& a, const Piece& b, const Vec3& pole) {
  return {euclidean(pole), std::max(1e-5, 1e-3 * std::min(extentOf(a), extentOf(b)))};
}

/// The pieces of one path.
struct Run {
  std::size_t begin = 0, size = 0;
  bool closed = false;
};

/// Neighbours share an end: piece i + 1 begins where piece i ends.
std::vector<Joint> jointsOf(const std::vector<Piece>& pieces, std::size_t i, std::size_t j, const Run& run) {
  std::vector<Joint> joints;
  const auto follows = [&](std::size_t first, std::size_t second) {
    return first + 1 == second || (run.closed && first + 1 == run.begin + run.size && second == run.begin);
  };
  if (follows(i, j)) joints.push_back(jointAt(pieces[i], pieces[j], pieces[j].curve.front()));
  if (follows(j, i)) joints.push_back(jointAt(pieces[i], pieces[j], pieces[i].curve.front()));
  return joints;
}

/// Calls `meet(i, j)` for all pairs of boxes that come near each other, sweeping in x, until it returns something.
template <class Meet>
std::optional<Vec2> firstOfNearPairs(const std::vector<Piece>& pieces, const Progress& progress, Meet meet) {
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t k) { return pieces[k].box.minimum.x(); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  std::vector<std::size_t> open;
  for (const std::size_t k : order) {
    progress.check();
    std::erase_if(open, [&](std::size_t other) { return pieces[other].box.maximum.x() < left(k) - touching; });
    for (const std::size_t other : open) {
      if (!pieces[k].box.near(pieces[other].box)) continue;
      if (auto place = meet(std::min(k, other), std::max(k, other))) return place;
    }
    open.push_back(k);
  }
  return std::nullopt;
}

/// Where two places of the pieces meet that count, pieces of one path only where they are no neighbours' common end.
std::optional<Vec2> meetingOf(const std::vector<Path>& loops, const Progress& progress, const Counts& counts) {
  std::vector<Piece> pieces;
  std::vector<std::size_t> begins, loopOf;
  for (const Path& loop : loops) {
    begins.push_back(pieces.size());
    for (Piece& piece : piecesOf(loop)) pieces.push_back(std::move(piece));
    loopOf.resize(pieces.size(), begins.size() - 1);
  }
  begins.push_back(pieces.size());
  return firstOfNearPairs(pieces, progress, [&](std::size_t i, std::size_t j) {
    const double extent = std::min(extentOf(pieces[i]), extentOf(pieces[j]));
    if (loopOf[i] != loopOf[j]) return Finder({}, counts, extent).meet(pieces[i].curve, pieces[j].curve);
    const std::size_t begin = begins[loopOf[i]], size = begins[loopOf[i] + 1] - begin;
    return Finder(jointsOf(pieces, i, j, {begin, size, loops[loopOf[i]].closed}), counts, extent)
        .meet(pieces[i].curve, pieces[j].curve);
  });
}

int turnsAround(const std::vector<Path>& loops, const Vec2& p) {
  int turns = 0;
  for (const Path& loop : loops) turns += windingNumber(loop, p);
  return turns;
}

/// Whether `differs` holds at some place next to a contact: between the curves where they cross, however narrow that is, and
/// all around where they touch.
bool anyBeside(const Contact& contact, const std::function<bool(const Vec2&)>& differs) {
  std::vector<Vec2> directions;
  if (contact.steep) {
    const Vec2 sum = contact.along + contact.other, difference = contact.along - contact.other;
    directions = {sum.normalized(), -sum.normalized(), difference.normalized(), -difference.normalized()};
  } else {
    constexpr int count = 32;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.37) / count;  // not along the axes
      directions.emplace_back(std::cos(angle), std::sin(angle));
    }
  }
  constexpr double away = 10 * touching;
  return std::any_of(directions.begin(), directions.end(),
                     [&](const Vec2& direction) { return differs(contact.place + away * direction); });
}

}  // namespace

std::optional<Vec2> selfCrossing(const Path& path, const Progress& progress) { return meetingOf({path}, progress, {}); }

std::optional<Vec2> crossing(const Path& a, const Path& b, const Progress& progress) {
  std::vector<Piece> pieces = piecesOf(a);
  const std::size_t ofFirst = pieces.size();
  for (Piece& piece : piecesOf(b)) pieces.push_back(std::move(piece));
  return firstOfNearPairs(pieces, progress, [&](std::size_t i, std::size_t j) -> std::optional<Vec2> {
    if ((i < ofFirst) == (j < ofFirst)) return std::nullopt;
    return Finder({}).meet(pieces[i].curve, pieces[j].curve);
  });
}

std::optional<Vec2> misfilledCrossing(const Curves& drawing, const Region& region, const Progress& progress) {
  const std::vector<Path> paths = joined(drawing).paths;
  const auto differs = [&](const Vec2& p) {
    const int turns = turnsAround(paths, p);
    const bool filled = drawing.fillRule == FillRule::EvenOdd ? turns % 2 != 0 : turns != 0;
    return filled != (turnsAround(region.loops, p) > 0);
  };
  return meetingOf(paths, progress, [&](const Contact& contact) {
    progress.check();
    return anyBeside(contact, differs);
  });
}

}  // namespace blossom
