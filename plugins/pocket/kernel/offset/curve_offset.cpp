#include "kernel/offset/curve_offset.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "kernel/medial/contact.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

namespace {

constexpr double shareOfArcs = 0.4;  // of the tolerance: the rest goes to the arcs along the curve, and to its chords

/// A place on the offset, where one arc ends and the next begins.
struct Node {
  double parameter = 0;  ///< of its foot on the curve
  TangentPoint place;
  std::ptrdiff_t joint = -1;     ///< parallel to that joint of the arcs along the curve
  bool isBeforeSkipped = false;  ///< pieces of the curve that follow have no part of the offset
};

class OffsetAlong {
 public:
  explicit OffsetAlong(const CurveRun& run)
      : run_(run),
        curve_(run.boundary->curves()[run.curve]),
        joints_(run.arcs->of(run.curve)),
        apart_(1e-2 * run.boundary->chord()) {}

  std::vector<Segment> segments(const Vec2& from, const Vec2& to) {
    const double start = footFrom(0, from), end = footFrom(run_.count - 1, to);
    traced_ = tracedPieces();
    nodes_.push_back({start, {from, curve_.tangent(start)}});
    addNodes(start, end);
    while (nodes_.size() > 1 && isPast(to, nodes_.back().place)) nodes_.pop_back();
    nodes_.push_back({end, {to, curve_.tangent(end)}});
    for (std::size_t k = 0; k + 1 < nodes_.size(); ++k) join(nodes_[k], nodes_[k + 1]);
    return std::move(segments_);
  }

 private:
  /// The traced part of one piece, with the parameters of the curve along the piece.
  struct Traced {
    double from = 0, to = 0;
    const TracedPiece* of = nullptr;
  };

  [[nodiscard]] const Piece& pieceOf(const TracedPiece& traced) const { return run_.boundary->pieces()[traced.site.piece]; }

  [[nodiscard]] double footFrom(std::size_t k, const Vec2& x) const {
    Contact contact = contactOf(*run_.boundary, run_.piece(k).site, x);
    contact.margin = 0;
    footOn(contact, x);
    return contact.parameter;
  }

  [[nodiscard]] std::vector<Traced> tracedPieces() const {
    std::vector<Traced> all;
    for (std::size_t k = 0; k < run_.count; ++k) {
      const TracedPiece& traced = run_.piece(k);
      if (!traced.site.isPoint) all.push_back({pieceOf(traced).t0, pieceOf(traced).t1, &traced});
    }
    std::sort(all.begin(), all.end(), [](const Traced& a, const Traced& b) { return a.from < b.from; });
    return all;
  }

  [[nodiscard]] TangentPoint offsetOf(const TangentPoint& place) const {
    return {place.at + run_.sign * run_.distance * toTheLeft(place.tangent), place.tangent};
  }

  /// Whether x, at the distance from a place of the boundary, is so near to a line traced by the diagram that it can be
  /// nowhere nearer to the boundary by more than the tolerance allows: no chord is nearer to that line than the distance,
  /// and no curve by more than a chord's error, a quarter of the tolerance.
  [[nodiscard]] bool isBeside(const Vec2& x, const TracedPiece& traced, double share) const {
    const Vec2 foot = traced.from + nearestShare(traced.from, traced.to, x) * (traced.to - traced.from);
    return (x - foot).squaredNorm() <= share * share * run_.tolerance * run_.tolerance;
  }

  void addNodes(double start, double end) {
    auto joint = joints_.begin();
    for (std::size_t k = 0; k < traced_.size(); ++k) {
      if (k > 0 && traced_[k].from > traced_[k - 1].to) nodes_.back().isBeforeSkipped = true;
      const double from = std::max(traced_[k].from, start), to = std::min(traced_[k].to, end);
      while (joint != joints_.end() && joint->parameter <= from) ++joint;
      for (; joint != joints_.end() && joint->parameter < to; ++joint) addParallel(joint, *traced_[k].of);
    }
  }

  /// None may lead back.
  [[nodiscard]] bool leadsOn(const TangentPoint& from, const TangentPoint& to) const {
    return (to.at - from.at).dot(to.tangent) > apart_;
  }

  [[nodiscard]] bool isPast(const Vec2& end, const TangentPoint& last) const {
    const double near = 1e3 * run_.boundary->chord();
    const Vec2 rest = end - last.at;
    return rest.norm() < near && rest.dot(last.tangent) <= apart_;
  }

  void addParallel(std::span<const ArcJoint>::iterator joint, const TracedPiece& traced) {
    constexpr double share = 0.6;
    const TangentPoint place = offsetOf(joint->place);
    if (!leadsOn(nodes_.back().place, place)) return;
    if (isBeside(place.at, traced, share) || isAtDistance(*run_.boundary, place.at, run_.distance, share * run_.tolerance))
      nodes_.push_back({joint->parameter, place, joint - joints_.begin()});
  }

  void join(const Node& a, const Node& b) {
    const bool isParallel = a.joint >= 0 && b.joint == a.joint + 1;
    if (!a.isBeforeSkipped && (isParallel || isFollowedByBiarc(a, b))) return addBiarc(a.place, b.place);
    const std::vector<FitJoint> joints = fittedJoints(samplesBetween(a, b), shareOfArcs * run_.tolerance);
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) addBiarc(joints[k].place, joints[k + 1].place);
  }

  /// Between nodes where nothing is parallel, which are the ends of a run as a rule.
  [[nodiscard]] bool isFollowedByBiarc(const Node& a, const Node& b) const {
    const Biarc fit = biarcBetween(a.place, b.place, 1e-3 * run_.tolerance);
    if (fit.isOverHalfATurn()) return false;
    auto traced = firstFrom(a.parameter);
    for (const double share : {0.25, 0.5, 0.75}) {
      const double t = a.parameter + share * (b.parameter - a.parameter);
      while (traced != traced_.end() && traced->to < t) ++traced;
      if (traced == traced_.end() || traced->from > t) return false;
      const auto place = exactPlace(t, *traced->of);
      if (!place || !fit.isWithin(place->at, shareOfArcs * run_.tolerance)) return false;
    }
    return true;
  }

  void addBiarc(const TangentPoint& a, const TangentPoint& b) {
    const Biarc fit = biarcBetween(a, b, 1e-3 * run_.tolerance);
    if (fit.isOverHalfATurn() || fit.length() > 2 * (b.at - a.at).norm())
      segments_.emplace_back(Line2{a.at, b.at});
    else
      for (std::size_t k = 0; k < fit.count; ++k) segments_.push_back(fit.bows[k].segment());
  }

  /// Places on the exact offset from one node to the next, or as the chords have it where that is none.
  [[nodiscard]] std::vector<TangentPoint> samplesBetween(const Node& a, const Node& b) const {
    const auto first = firstFrom(a.parameter);
    auto last = first;
    while (last != traced_.end() && last->from < b.parameter) ++last;
    constexpr std::ptrdiff_t manyChords = 4;  // two places on each tell the curve
    const int parts = last - first >= manyChords ? 2 : 4;
    std::vector<TangentPoint> samples{a.place};
    for (auto traced = first; traced != last; ++traced)
      for (int i = 0; i < parts; ++i) addSample(*traced->of, (i + 0.5) / parts, a.parameter, b.parameter, samples);
    while (samples.size() > 1 && isPast(b.place.at, samples.back())) samples.pop_back();
    samples.push_back(b.place);
    return samples;
  }

  void addSample(const TracedPiece& traced, double share, double after, double before,
                 std::vector<TangentPoint>& samples) const {
    const double first = contactOf(*run_.boundary, traced.site, traced.from).parameter,
                 last = contactOf(*run_.boundary, traced.site, traced.to).parameter, t = first + share * (last - first);
    if (!(t > after && t < before)) return;
    const TangentPoint rough{traced.from + share * (traced.to - traced.from), pieceOf(traced).along().normalized()};
    const TangentPoint next = exactPlace(t, traced).value_or(rough);
    if (leadsOn(samples.back(), next)) samples.push_back(next);
  }

  /// Of the offset, where it is not beyond a centre of curvature, or nearer to another part of the boundary.
  [[nodiscard]] std::optional<TangentPoint> exactPlace(double t, const TracedPiece& traced) const {
    const TrueCurve::Place onCurve = curve_.placeAt(t);
    if (1 - run_.sign * run_.distance * onCurve.curvature < 1e-6) return std::nullopt;
    const TangentPoint place = offsetOf({onCurve.point, onCurve.tangent});
    if (isBeside(place.at, traced, 0.25) || isAtDistance(*run_.boundary, place.at, run_.distance, run_.tolerance / 16))
      return place;
    return std::nullopt;
  }

  [[nodiscard]] std::vector<Traced>::const_iterator firstFrom(double t) const {
    const auto isBefore = [](const Traced& traced, double parameter) { return traced.to <= parameter; };
    return std::lower_bound(traced_.begin(), traced_.end(), t, isBefore);
  }

  const CurveRun& run_;
  const TrueCurve& curve_;
  std::span<const ArcJoint> joints_;
  double apart_;  ///< mm between nodes
  std::vector<Traced> traced_;
  std::vector<Node> nodes_;
  std::vector<Segment> segments_;
};

}  // namespace

bool isAtDistance(const Boundary& boundary, const Vec2& x, double distance, double tolerance) {
  return std::abs(boundary.nearest(x).distance - distance) <= tolerance;
}

std::vector<Segment> offsetAlong(const CurveRun& run, const Vec2& from, const Vec2& to) {
  return OffsetAlong(run).segments(from, to);
}

}  // namespace blossom::pocket
