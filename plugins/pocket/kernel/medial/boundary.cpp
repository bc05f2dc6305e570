#include "kernel/medial/boundary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "core/units.h"
#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"
#include "kernel/stroke/grid.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

namespace {

constexpr std::size_t maximumPieces = 2'000'000;
/// Radians: a curve that turns more than this from chord to chord has a corner inside.
constexpr double innerTurn = 0.8;

bool finite(const Vec2& p) { return p.allFinite(); }
bool finite(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return finite(line->from) && finite(line->to);
  if (const auto* arc = std::get_if<Arc2>(&segment))
    return finite(arc->center) && std::isfinite(arc->radius) && std::isfinite(arc->start) && std::isfinite(arc->sweep);
  const auto& spline = std::get<Spline2>(segment);
  return std::all_of(spline.poles.begin(), spline.poles.end(), [](const Vec3& p) { return p.allFinite() && p.z() > 0; }) &&
         std::all_of(spline.knots.begin(), spline.knots.end(), [](double k) { return std::isfinite(k); });
}

void checkNumbers(const Region& region) {
  for (std::size_t loop = 0; loop < region.loops.size(); ++loop) {
    const auto& segments = region.loops[loop].segments;
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (!finite(segments[i]))
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("Segment {} of outline {} has coordinates that are not finite numbers.", i + 1, loop + 1),
                    "Repair or delete that outline.");
  }
}

void checkClosed(const Path& path) {
  const Vec2 from = startPoint(path);
  const Vec2 to = endPoint(path);
  if (path.closed && (from - to).norm() <= Tolerance().joining) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("The outline is open: it begins at {} and ends at {}.", placeText(from), placeText(to)),
              "Close the gap in the drawing.");
}

template <class Kind>
bool containsAny(const Region& region) {
  return std::any_of(region.loops.begin(), region.loops.end(), [](const Path& path) {
    return std::any_of(path.segments.begin(), path.segments.end(),
                       [](const Segment& segment) { return std::holds_alternative<Kind>(segment); });
  });
}

/// Chords as near to their curves as the grid of the diagram is fine would turn at random. What arcs give is exact with any
/// chords, so theirs are made longer; with splines the tolerance cannot be kept.
/// @throws Error InvalidParameter.
double chordOnGrid(const Region& region, double chord, double step, double size) {
  const double minimum = 2 * step;
  if (chord >= minimum) return chord;
  if (containsAny<Spline2>(region)) {
    constexpr double chordsPerTolerance = 4;
    throw Error(
        ErrorCode::InvalidParameter,
        fmt::format("A tolerance of {:.3g} mm is finer than free-form curves of a part of {:.4g} mm can be told apart.",
                    chordsPerTolerance * chord, size),
        fmt::format("Give at least {:.2g} mm.", std::ceil(chordsPerTolerance * minimum * 1e9) / 1e9));
  }
  return containsAny<Arc2>(region) ? minimum : chord;
}

/// The outlines with straight segments shorter than a length shrunk to points; what follows begins where the one before
/// them ends. Segments keep their numbers.
Region withoutJogs(const Region& region, double length) {
  Region smooth = region;
  for (Path& path : smooth.loops) {
    std::vector<std::size_t> kept, jogs;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
      const auto* line = std::get_if<Line2>(&path.segments[i]);
      (line && (line->to - line->from).norm() < length ? jogs : kept).push_back(i);
    }
    if (kept.size() < 2 || jogs.empty()) continue;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (auto* line = std::get_if<Line2>(&path.segments[kept[i]])) {
        const Vec2 before = endPoint(path.segments[kept[(i + kept.size() - 1) % kept.size()]]);
        if ((before - line->from).norm() < 4 * length) line->from = before;
      }
    for (const std::size_t jog : jogs) {
      const auto next = std::upper_bound(kept.begin(), kept.end(), jog);
      const Vec2 there = startPoint(path.segments[next == kept.end() ? kept.front() : *next]);
      path.segments[jog] = Line2{there, there};
    }
  }
  return smooth;
}

/// Parameters at the ends of the curves that a segment is made of.
std::vector<double> breaksOf(const Segment& segment) {
  const auto* const spline = std::get_if<Spline2>(&segment);
  return spline ? toBezier(toCurve(*spline)).breaks : std::vector<double>{0, 1};
}

}  // namespace

double turnBetween(const Vec2& a, const Vec2& b) { return std::atan2(std::abs(cross(a, b)), a.dot(b)); }

std::string placeText(const Vec2& p) {
  const auto rounded = [](double v) { return formatNumber(std::round(v * 1000) / 1000); };
  return fmt::format("({}, {})", rounded(p.x()), rounded(p.y()));
}

Boundary::Boundary(const Region& region, double chord, const Progress& progress) : chord_(chord) {
  if (region.loops.empty())
    throw Error(ErrorCode::InvalidInput, "The region is empty.", "Give a region with at least one outline.");
  checkNumbers(region);
  takeWithoutCrossing(region, progress);
  region_ = toRegion({region.loops, FillRule::EvenOdd});
  if (region_ != region) takeWithoutCrossing(region_, progress);
}

void Boundary::takeWithoutCrossing(const Region& region, const Progress& progress) {
  // Chords of curves that nearly touch may cross where the curves do not; finer chords decide.
  constexpr int attempts = 3;
  const double wanted = chord_;
  std::optional<Trouble> trouble;
  for (int attempt = 0; attempt < attempts; ++attempt, chord_ /= 8) {
    take(region, progress);
    const double chord = attempt == 0 ? chordOnGrid(region, chord_, TurnedGrid(middle_, size_, 0).step(), size_) : chord_;
    if (chord > chord_) {
      chord_ = chord;
      take(region, progress);
    }
    splitWhereTouched(progress);
    trouble = crossing(progress);
    if (!trouble) return;
  }
  // Jogs far below the tolerance may look like crossings on the grid of the diagram; the outline without them decides.
  for (const double jog : {wanted / 256, wanted / 16, wanted / 4}) {
    const Region smooth = withoutJogs(region, jog);
    if (smooth == region) continue;
    chord_ = wanted;
    take(smooth, progress);
    splitWhereTouched(progress);
    if (!crossing(progress)) return;
  }
  throw Error(ErrorCode::InvalidInput,
              fmt::format("The outline {} near {}.", trouble->along ? "runs along itself" : "crosses itself",
                          placeText(trouble->at)),
              "Redraw it there, or unite what overlaps.");
}

void Boundary::take(const Region& region, const Progress& progress) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const Path& path : region.loops) {
    progress.check();
    if (path.segments.empty()) continue;
    checkClosed(path);
    for (const Segment& segment : path.segments)
      for (const Vec2& p : flatten(segment, std::max(chord_, 1e-3 * length(segment)))) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
  }
  size_ = (high - low).maxCoeff();
  middle_ = (low + high) / 2;
  if (!(size_ > 0)) throw Error(ErrorCode::InvalidInput, "The outline has no extent.", "Draw one that encloses an area.");
  // Far from the origin doubles are coarser than the grid of the diagram.
  weld_ = std::max({1e-8 * size_, 1e-13 * middle_.norm(), 1e-3 * chord_});
  curves_.clear();
  sources_.clear();
  pieces_.clear();
  for (std::size_t loop = 0; loop < region.loops.size(); ++loop) {
    progress.check();
    take(region.loops[loop], loop);
  }
  makeTree();
}

void Boundary::take(const Path& path, std::size_t loop) {
  const std::size_t first = pieces_.size();
  std::optional<Vec2> last;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const std::vector<double> breaks = breaksOf(path.segments[i]);
    std::size_t span = 0;
    for (TrueCurve& curve : trueCurves(path.segments[i])) {
      const CurveSource source{loop, i, breaks[span], breaks[span + 1]};
      ++span;
      if (!(curve.lengthBound() > weld_)) continue;
      const std::vector<CurveSample> samples = flattened(curve, chord_);
      if (pieces_.size() + samples.size() > maximumPieces)
        throw Error(ErrorCode::LimitExceeded,
                    fmt::format("The outline needs more than {} straight pieces at this tolerance.", maximumPieces),
                    "Raise the tolerance.");
      double t = 0;
      if (!last) last = samples.front().point;
      const std::size_t before = pieces_.size();
      for (const CurveSample& sample : samples) {
        if ((sample.point - *last).norm() <= weld_) continue;
        pieces_.push_back({*last, sample.point, curves_.size(), t, sample.parameter, 0, 0, Joint::Inner});
        t = sample.parameter;
        last = sample.point;
      }
      if (pieces_.size() == before) continue;
      pieces_.back().t1 = 1;
      curves_.push_back(std::move(curve));
      sources_.push_back(source);
    }
  }
  const std::size_t end = pieces_.size();
  if (end < first + 2) {  // a speck: nothing that a diagram could see
    pieces_.resize(first);
    return;
  }
  pieces_[end - 1].to = pieces_[first].from;
  if (pieces_[end - 1].along().norm() <= weld_) {
    pieces_.pop_back();
    pieces_.back().to = pieces_[first].from;
    pieces_.back().t1 = 1;
  }
  const std::size_t count = pieces_.size() - first;
  for (std::size_t i = 0; i < count; ++i) {
    Piece& piece = pieces_[first + i];
    piece.next = first + (i + 1) % count;
    piece.previous = first + (i + count - 1) % count;
  }
  for (std::size_t i = first; i < pieces_.size(); ++i) {
    Piece& piece = pieces_[i];
    const Piece& next = pieces_[piece.next];
    if (piece.curve == next.curve && piece.next == i + 1) {
      piece.end = turnBetween(piece.along(), next.along()) < innerTurn ? Joint::Inner : Joint::Corner;
      continue;
    }
    const double turn = turnBetween(curves_[piece.curve].tangent(1), curves_[next.curve].tangent(0));
    piece.end = turn < smoothTurn ? Joint::Smooth : Joint::Corner;
  }
}

void Boundary::makeTree() {
  std::vector<Box2> boxes;
  boxes.reserve(pieces_.size());
  for (const Piece& piece : pieces_) boxes.push_back(piece.box());
  tree_ = BoxTree<2>(boxes);
}

Boundary::Nearest Boundary::nearest(const Vec2& x) const {
  Nearest best;
  best.distance = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::size_t i, double t) {
    const Vec2 foot = curves_[pieces_[i].curve].point(t);
    const double distance = (x - foot).norm();
    if (distance < best.distance) best = {distance, i, t, foot};
  };
  const auto visit = [&](std::size_t i) {
    const Piece& piece = pieces_[i];
    const double share = nearestShare(piece.from, piece.to, x);
    const double flat = (piece.from + share * piece.along() - x).norm();
    if (flat > best.distance + 2 * chord_ + weld_) return;
    const double guess = piece.t0 + share * (piece.t1 - piece.t0);
    consider(i, guess);
    consider(i, std::clamp(curves_[piece.curve].foot(x, guess, 0), 0.0, 1.0));
  };
  tree_.walk([&](const Box2& box) { return boxDistance(box, x); }, visit,
             [&](double away) { return away <= best.distance + 2 * chord_ + weld_; });
  return best;
}

double Boundary::flatDistance(const Vec2& x) const {
  double best = std::numeric_limits<double>::infinity();
  const auto visit = [&](std::size_t i) {
    const Piece& piece = pieces_[i];
    const double share = nearestShare(piece.from, piece.to, x);
    best = std::min(best, (piece.from + share * piece.along() - x).norm());
  };
  tree_.walk([&](const Box2& box) { return boxDistance(box, x); }, visit, [&](double away) { return away <= best; });
  return best;
}

bool Boundary::contains(const Vec2& x, const Nearest& nearest) const {
  const Piece& piece = pieces_[nearest.piece];
  const Vec2 offset = x - nearest.foot;
  const auto leftOf = [&](std::size_t curve, double t) { return cross(curves_[curve].tangent(t), offset) > 0; };
  const auto atCorner = [&](std::size_t before, std::size_t after) {
    const Vec2 in = curves_[before].tangent(1);
    const Vec2 out = curves_[after].tangent(0);
    const bool left = leftOf(before, 1);
    const bool right = leftOf(after, 0);
    return cross(in, out) > 0 ? left && right : left || right;
  };
  if (nearest.parameter <= 0 && piece.t0 <= 0) return atCorner(pieces_[piece.previous].curve, piece.curve);
  if (nearest.parameter >= 1 && piece.t1 >= 1) return atCorner(piece.curve, pieces_[piece.next].curve);
  return leftOf(piece.curve, nearest.parameter);
}

}  // namespace blossom::pocket
