#include "kernel/offset/offset_loops.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/planar/segment_point.h"
#include "kernel/medial/contact.h"
#include "kernel/offset/arc_fit.h"
#include "kernel/offset/curve_offset.h"

namespace blossom::pocket {

namespace {

constexpr double turnOnce = 2 * std::numbers::pi;

/// Traced pieces that follow one curve, or go round one corner.
struct Run {
  std::size_t first = 0, count = 0;
  const TrueCurve* curve = nullptr;  ///< nullptr: around a corner
  Vec2 corner = Vec2::Zero();
};

class LoopMaker {
 public:
  LoopMaker(const Boundary& boundary, const CurveArcs& arcs, const TracedLoop& loop, const LoopOptions& options)
      : boundary_(boundary),
        arcs_(arcs),
        pieces_(boundary.pieces()),
        loop_(loop),
        o_(options),
        sign_(o_.side == Side::Inside ? 1 : -1) {}

  Path make() {
    findRuns();
    findJoints();
    dropCollapsed();
    Path path;
    path.closed = true;
    for (std::size_t i = 0; i < runs_.size(); ++i) append(path.segments, i);
    return path;
  }

 private:
  [[nodiscard]] const TracedPiece& at(std::size_t i) const { return loop_[i % loop_.size()]; }

  /// The curve a site belongs to; none for a corner of the drawing.
  [[nodiscard]] const TrueCurve* curveOf(const Site& site) const {
    const Piece& piece = pieces_[site.piece];
    if (site.isPoint && pieces_[piece.previous].end != Joint::Inner) return nullptr;
    return &boundary_.curves()[piece.curve];
  }

  /// Whether the offset goes on along the same curve from traced piece i to the next: the boundary between their feet bulges
  /// no further out of the disc around the joint than the tolerance.
  [[nodiscard]] bool goesOn(std::size_t i) const {
    const Site& a = at(i).site;
    const Site& b = at(i + 1).site;
    if (!curveOf(a) || curveOf(a) != curveOf(b)) return false;
    if (a.isPoint && !b.isPoint && a.piece == b.piece) return true;
    constexpr int farthest = 4096;
    std::size_t current = a.piece;
    for (int step = 0; step < farthest; ++step) {
      if (pieces_[current].end != Joint::Inner) return false;
      current = pieces_[current].next;
      if (std::abs((at(i).to - pieces_[current].from).norm() - o_.distance) > o_.tolerance) return false;
      if (current == b.piece) return true;
    }
    return false;
  }

  void findRuns() {
    std::size_t start = 0;
    while (start < loop_.size() && goesOn(start + loop_.size() - 1)) ++start;
    whole_ = start == loop_.size();
    if (whole_) start = 0;
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      const std::size_t i = start + k;
      if (k > 0 && goesOn(i - 1)) {
        ++runs_.back().count;
        continue;
      }
      const Site& site = at(i).site;
      runs_.push_back({i, 1, curveOf(site), pieces_[site.piece].from});
    }
  }

  /// Unit normal towards the offset where a piece begins or ends.
  [[nodiscard]] Vec2 normalAt(const Piece& piece, bool atEnd) const {
    const double t = atEnd ? piece.t1 : piece.t0;
    const bool endOfCurve = t == 0 || t == 1;
    return sign_ * toTheLeft(endOfCurve ? boundary_.curves()[piece.curve].tangent(t) : Vec2(piece.along().normalized()));
  }

  /// Whether the boundary keeps its direction from one piece to the next, though another part of it may touch it there.
  [[nodiscard]] bool goesStraightOn(const Piece& piece, const Piece& next) const {
    if (piece.end == Joint::Smooth) return true;
    return piece.end == Joint::Corner && turnBetween(normalAt(piece, true), normalAt(next, false)) < smoothTurn;
  }

  /// Whether a point at the distance from two curves is at that distance from the boundary, as one is that lies beside a
  /// point that the diagram has: no chord is nearer to that one, and no curve by more than a chord's error.
  [[nodiscard]] bool counts(const Vec2& exact, const Vec2& traced) const {
    return (exact - traced).norm() <= o_.tolerance / 4 || isAtDistance(boundary_, exact, o_.distance, o_.tolerance / 16);
  }

  /// Where run ends and the next begins, on the true curves; as the chords have it when that cannot be told.
  [[nodiscard]] Vec2 jointAfter(std::size_t i) const {
    const auto exact = exactJoint(i);
    return exact && counts(*exact, at(i).to) ? *exact : at(i).to;
  }

  [[nodiscard]] std::optional<Vec2> exactJoint(std::size_t i) const {
    const Site& a = at(i).site;
    const Site& b = at(i + 1).site;
    const Vec2& rough = at(i).to;
    const bool follows = !a.isPoint && pieces_[a.piece].next == b.piece;
    if (follows && (b.isPoint ? !curveOf(b) : goesStraightOn(pieces_[a.piece], pieces_[b.piece])))
      return pieces_[b.piece].from + o_.distance * normalAt(pieces_[a.piece], true);
    if (a.isPoint && !b.isPoint && a.piece == b.piece && !curveOf(a))
      return pieces_[a.piece].from + o_.distance * normalAt(pieces_[a.piece], false);
    // The joint of chords may be off by the chord error over the sine of the angle between them.
    const double reach = std::max(200 * boundary_.chord(), 1e-3 * o_.distance);
    return pointAtDistance(contactOf(boundary_, a, rough), contactOf(boundary_, b, rough), o_.distance, rough, reach);
  }

  void findJoints() {
    joints_.resize(runs_.size());
    for (std::size_t r = 0; r < runs_.size(); ++r)
      joints_[r] = whole_ ? at(runs_[r].first + runs_[r].count - 1).to : jointAfter(runs_[r].first + runs_[r].count - 1);
  }

  [[nodiscard]] std::size_t before(std::size_t r) const { return (r + runs_.size() - 1) % runs_.size(); }

  [[nodiscard]] double roughLength(const Run& run) const {
    double sum = 0;
    for (std::size_t k = 0; k < run.count; ++k) sum += (at(run.first + k).to - at(run.first + k).from).norm();
    return sum;
  }

  /// Where two runs meet whose joint is about `guess`.
  [[nodiscard]] Vec2 meeting(std::size_t r, std::size_t next, const Vec2& guess) const {
    const Contact a = contactOf(boundary_, at(runs_[r].first + runs_[r].count - 1).site, guess);
    const Contact b = contactOf(boundary_, at(runs_[next].first).site, guess);
    const auto exact = pointAtDistance(a, b, o_.distance, guess, std::max(200 * boundary_.chord(), 1e-3 * o_.distance));
    return exact && isAtDistance(boundary_, *exact, o_.distance, o_.tolerance / 16) ? *exact : guess;
  }

  /// Runs that exact joints leave no length: their neighbours meet instead.
  void dropCollapsed() {
    for (std::size_t r = 0; r < runs_.size() && runs_.size() > 1;) {
      const Vec2 step = joints_[r] - joints_[before(r)];
      const double rough = roughLength(runs_[r]);
      const bool speck = step.norm() < 1e-3 * o_.tolerance && rough < 4 * o_.tolerance;
      const Vec2 direction = at(runs_[r].first + runs_[r].count - 1).to - at(runs_[r].first).from;
      // Around a corner that only the chords round, the true curves' offsets meet before.
      const bool turned = runs_.size() > 2 && step.dot(direction) < 0 &&
                          (!runs_[r].curve || rough < 4 * o_.tolerance || step.norm() < 4 * o_.tolerance);
      if (!speck && !turned) {
        ++r;
        continue;
      }
      joints_[before(r)] =
          speck ? joints_[r] : meeting(before(r), (r + 1) % runs_.size(), (joints_[r] + joints_[before(r)]) / 2);
      runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(r));
      joints_.erase(joints_.begin() + static_cast<std::ptrdiff_t>(r));
      if (r > 0) --r;
    }
  }

  void append(std::vector<Segment>& out, std::size_t r) const {
    const Run& run = runs_[r];
    const Vec2& from = joints_[before(r)];
    const Vec2& to = joints_[r];
    if (!run.curve) {
      out.push_back(arc(run, run.corner, o_.distance, -sign_, from, to));
    } else if (run.curve->line()) {
      out.emplace_back(Line2{from, to});
    } else if (const Arc2* of = run.curve->arc()) {
      const double turn = of->sweep > 0 ? 1 : -1;
      out.push_back(arc(run, of->center, of->radius - sign_ * turn * o_.distance, turn, from, to));
    } else {
      const auto curve = static_cast<std::size_t>(run.curve - boundary_.curves().data());
      const CurveRun along{&boundary_, &arcs_,      curve, &loop_,      run.first % loop_.size(),
                           run.count,  o_.distance, sign_, o_.tolerance};
      for (Segment& segment : offsetAlong(along, from, to)) out.push_back(std::move(segment));
    }
  }

  [[nodiscard]] Segment arc(const Run& run, const Vec2& center, double radius, double turn, const Vec2& from,
                            const Vec2& to) const {
    const Vec2 a = from - center;
    const Vec2 b = to - center;
    double sweep = turn * std::atan2(cross(a, b), a.dot(b));
    const double expected = radius > 0 ? roughLength(run) / radius : 0;
    sweep += turnOnce * std::round((expected - sweep) / turnOnce);
    if (sweep < 0) return Line2{from, to};  // shorter than rounding
    sweep *= turn;
    // All around, the ends say nothing about the centre.
    if (std::abs(sweep) > 0.9 * turnOnce && (from - to).norm() < 1e-9 * radius)
      return Arc2{center, a.norm(), std::atan2(a.y(), a.x()), sweep};
    const double off = std::max(std::abs(a.norm() - radius), std::abs(b.norm() - radius));
    if (std::abs(sweep) > 1e-9 && off < 1e-11 * (1 + radius)) return Arc2{center, radius, std::atan2(a.y(), a.x()), sweep};
    return arcBetween(from, to, sweep);
  }

  const Boundary& boundary_;
  const CurveArcs& arcs_;
  const std::vector<Piece>& pieces_;
  const TracedLoop& loop_;
  LoopOptions o_;
  double sign_;
  std::vector<Run> runs_;
  std::vector<Vec2> joints_;  ///< by run: where it ends
  bool whole_ = false;        ///< one run all around
};

}  // namespace

Path loopOnTrueCurves(const Boundary& boundary, const CurveArcs& arcs, const TracedLoop& loop, const LoopOptions& options) {
  return LoopMaker(boundary, arcs, loop, options).make();
}

}  // namespace blossom::pocket
