#include "kernel/medial/disc_proof.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/planar_bezier.h"

namespace blossom::pocket {

namespace {

/// Most that a piece is off its chord: no more than its poles, whose weights are positive.
double hullBulge(const BezierPiece& piece, const Stroke& chord) {
  double most = 0;
  for (const Vec3& pole : piece) most = std::max(most, distance(chord, euclidean(pole)));
  return most;
}

}  // namespace

DiscProof::DiscProof(const Region& region, double bulge, const Progress& progress) {
  constexpr int deepest = 40;  // beyond it, the bulge that is left counts as it is
  std::size_t halved = 0;
  const auto addBezier = [&](const BezierPiece& whole) {
    std::vector<std::pair<BezierPiece, int>> open{{whole, 0}};
    while (!open.empty()) {
      auto [piece, depth] = std::move(open.back());
      open.pop_back();
      const Stroke chord = Stroke::line(euclidean(piece.front()), euclidean(piece.back()));
      const double off = hullBulge(piece, chord);
      if (!(off > bulge) || depth == deepest) {
        pieces_.push_back({chord, off});
        continue;
      }
      if (++halved % 1024 == 0) progress.check();
      auto [before, after] = halves(piece);
      open.emplace_back(std::move(after), depth + 1);
      open.emplace_back(std::move(before), depth + 1);
    }
  };
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) {
      if (const auto* line = std::get_if<Line2>(&segment))
        pieces_.push_back({Stroke::line(line->from, line->to), 0});
      else if (const auto* arc = std::get_if<Arc2>(&segment))
        pieces_.push_back({Stroke::arc(arc->center, arc->radius, arc->start, arc->sweep), 0});
      else
        for (const BezierPiece& piece : bezierPieces(std::get<Spline2>(segment))) addBezier(piece);
    }
  std::vector<Box2> boxes;
  for (const Piece& piece : pieces_) {
    const auto [low, high] = piece.stroke.box();
    boxes.emplace_back(low.array() - piece.bulge, high.array() + piece.bulge);
  }
  tree_ = BoxTree<2>(boxes);
}

bool DiscProof::isClear(const Vec2& center, double radius) const {
  bool nothing = true;
  tree_.walk([&](const Box2& box) { return boxDistance(box, center); },
             [&](std::size_t i) { nothing = nothing && distance(pieces_[i].stroke, center) - pieces_[i].bulge >= radius; },
             [&](double away) { return nothing && away <= radius; });
  return nothing;
}

}  // namespace blossom::pocket
