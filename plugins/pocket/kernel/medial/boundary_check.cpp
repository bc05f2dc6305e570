#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle.h"
#include "core/error.h"
#include "kernel/medial/boundary.h"
#include "kernel/stroke/grid.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

namespace {

struct GridPiece {
  TurnedPoint from, to;
};

bool between(const TurnedPoint& a, const TurnedPoint& b, const TurnedPoint& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

bool intersect(const GridPiece& a, const GridPiece& b) {
  const int o1 = sign(orientation(a.from, a.to, b.from));
  const int o2 = sign(orientation(a.from, a.to, b.to));
  const int o3 = sign(orientation(b.from, b.to, a.from));
  const int o4 = sign(orientation(b.from, b.to, a.to));
  if (o1 * o2 < 0 && o3 * o4 < 0) return true;
  return (o1 == 0 && between(a.from, a.to, b.from)) || (o2 == 0 && between(a.from, a.to, b.to)) ||
         (o3 == 0 && between(b.from, b.to, a.from)) || (o4 == 0 && between(b.from, b.to, a.to));
}

enum class Clash { None, Crossing, Along };

/// Whether two pieces share more than an end.
Clash clash(const GridPiece& a, const GridPiece& b) {
  const bool ff = a.from == b.from;
  const bool ft = a.from == b.to;
  const bool tf = a.to == b.from;
  const bool tt = a.to == b.to;
  const int shared = int(ff) + int(ft) + int(tf) + int(tt);
  if (shared == 0) return intersect(a, b) ? Clash::Crossing : Clash::None;
  if (shared > 1) return Clash::Along;
  const TurnedPoint& at = ff || ft ? a.from : a.to;
  const TurnedPoint& p = ff || ft ? a.to : a.from;
  const TurnedPoint& q = ff || tf ? b.to : b.from;
  if (orientation(at, p, q) != 0) return Clash::None;
  const auto forward =
      (std::int64_t{p.x} - at.x) * (std::int64_t{q.x} - at.x) + (std::int64_t{p.y} - at.y) * (std::int64_t{q.y} - at.y);
  return forward > 0 ? Clash::Along : Clash::None;
}

/// Counter-clockwise angle from one direction to another, 0 to 2 pi.
double turnTo(const Vec2& from, const Vec2& to) {
  const double angle = std::atan2(cross(from, to), from.dot(to));
  return angle < 0 ? angle + fullTurn : angle;
}

/// Whether two ways through one vertex change sides there: each is given by where it comes from and where it goes.
bool changeSides(const Vec2& at, const Vec2& from, const Vec2& to, const Vec2& otherFrom, const Vec2& otherTo) {
  const double left = turnTo(to - at, from - at);
  return (turnTo(to - at, otherFrom - at) < left) != (turnTo(to - at, otherTo - at) < left);
}

Vec2 crossingPoint(const Piece& a, const Piece& b) {
  const double across = cross(a.along(), b.along());
  if (across == 0) return (b.from + b.to) / 2;
  const double share = std::clamp(cross(b.from - a.from, b.along()) / across, 0.0, 1.0);
  return a.from + share * a.along();
}

}  // namespace

void Boundary::splitWhereTouched(const Progress& progress) {
  struct Cut {
    std::size_t piece;
    double share;
    std::size_t vertex;  ///< the piece that begins at it
  };
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (i % 1024 == 0) progress.check();
    const Vec2 at = pieces_[i].from;
    tree_.meeting(Box2(at.array() - weld_, at.array() + weld_), [&](std::size_t k) {
      Piece& other = pieces_[k];
      if (k == i || k == pieces_[i].previous) return;
      const auto weldTo = [&](Piece& begins) {
        if ((begins.from - at).norm() > weld_) return false;
        begins.from = at;
        pieces_[begins.previous].to = at;
        pieces_[begins.previous].end = Joint::Corner;
        pieces_[pieces_[i].previous].end = Joint::Corner;
        return true;
      };
      if (weldTo(other) || weldTo(pieces_[other.next])) return;
      const double share = nearestShare(other.from, other.to, at);
      if (share > 0 && share < 1 && (other.from + share * other.along() - at).norm() <= weld_) cuts.push_back({k, share, i});
    });
  }
  // From the end of each piece, so that what is left of it keeps its number.
  std::sort(cuts.begin(), cuts.end(),
            [](const Cut& a, const Cut& b) { return a.piece != b.piece ? a.piece < b.piece : a.share > b.share; });
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    const Cut& cut = cuts[c];
    const Vec2 at = pieces_[cut.vertex].from;
    if (at == pieces_[cut.piece].to) continue;
    Piece rest = pieces_[cut.piece];
    Piece& first = pieces_[cut.piece];
    rest.t0 = first.t0 + nearestShare(first.from, first.to, at) * (first.t1 - first.t0);
    rest.from = at;
    rest.previous = cut.piece;
    first.to = at;
    first.t1 = rest.t0;
    first.end = Joint::Corner;
    first.next = pieces_.size();
    pieces_[rest.next].previous = pieces_.size();
    pieces_[pieces_[cut.vertex].previous].end = Joint::Corner;
    pieces_.push_back(rest);
  }
  if (!cuts.empty()) makeTree();
}

std::optional<Boundary::Trouble> Boundary::crossing(const Progress& progress) const {
  const TurnedGrid grid(middle_, size_, 0);
  std::vector<GridPiece> onGrid;
  onGrid.reserve(pieces_.size());
  for (const Piece& piece : pieces_) onGrid.push_back({grid(piece.from), grid(piece.to)});
  std::optional<Trouble> found;
  for (std::size_t i = 0; i < pieces_.size() && !found; ++i) {
    if (i % 1024 == 0) progress.check();
    const auto visit = [&](std::size_t k) {
      if (found) return;
      const Clash kind = clash(onGrid[i], onGrid[k]);
      if (kind != Clash::None) found = Trouble{crossingPoint(pieces_[i], pieces_[k]), kind == Clash::Along};
      if (onGrid[i].from == onGrid[k].from && changeSides(pieces_[i].from, pieces_[pieces_[i].previous].from, pieces_[i].to,
                                                          pieces_[pieces_[k].previous].from, pieces_[k].to))
        found = Trouble{pieces_[i].from, false};
    };
    tree_.meeting(pieces_[i].box(2 * grid.step()), visit, i + 1);
  }
  return found;
}

}  // namespace blossom::pocket
