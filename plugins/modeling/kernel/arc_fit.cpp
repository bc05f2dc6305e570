#include "kernel/arc_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/planar_bezier.h"

namespace blossom::modeling {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The arc from p in direction t that ends in q; a line when it hardly bends.
Segment arcThrough(const Vec2& p, const Vec2& t, const Vec2& q) {
  const Vec2 chord = q - p;
  const double bend = cross(t, chord);
  if (std::abs(bend) < 1e-9 * chord.norm()) return Line2{p, q};
  const double radius = chord.squaredNorm() / (2 * bend);
  const Vec2 center = p + radius * Vec2(-t.y(), t.x()), out = p - center;
  return Arc2{center, std::abs(radius), std::atan2(out.y(), out.x()), 2 * std::atan2(bend, t.dot(chord))};
}

/// The arc that arrives in q with direction t.
Segment arcInto(const Vec2& p, const Vec2& q, const Vec2& t) {
  const Segment back = arcThrough(q, -t, p);
  if (std::holds_alternative<Line2>(back)) return Line2{p, q};
  const Arc2& arc = std::get<Arc2>(back);
  return Arc2{arc.center, arc.radius, arc.start + arc.sweep, -arc.sweep};
}

double distanceTo(const Segment& segment, const Vec2& point) {
  if (const auto* arc = std::get_if<Arc2>(&segment)) return std::abs((point - arc->center).norm() - arc->radius);
  const auto& line = std::get<Line2>(segment);
  return std::abs(cross((line.to - line.from).normalized(), point - line.from));
}

struct Ends {
  Vec2 p, tp, q, tq;
};

/// Where both arcs meet: both legs of the control polygon have the same length.
Vec2 jointOf(const Ends& e) {
  const Vec2 v = e.q - e.p, t = e.tp + e.tq;
  const double along = v.dot(t), opening = 2 * (1 - e.tp.dot(e.tq));
  const double leg = opening < 1e-12 ? v.squaredNorm() / (2 * along)
                                     : (std::sqrt(along * along + opening * v.squaredNorm()) - along) / opening;
  return (e.p + e.q + leg * (e.tp - e.tq)) / 2;
}

class Fitter {
 public:
  explicit Fitter(double tolerance) : tolerance_(tolerance) {}

  void fit(const BezierPiece& piece, int depth, std::vector<Segment>& out) {
    constexpr int deepest = 16;
    const Ends e = endsOf(piece);
    if ((e.q - e.p).norm() < 1e-9) {
      if (depth < deepest) split(piece, depth, out);
      return;
    }
    const Vec2 joint = jointOf(e);
    const std::array<Segment, 2> pair{arcThrough(e.p, e.tp, joint), arcInto(joint, e.q, e.tq)};
    const double error = errorOf(piece, pair);
    if (depth < deepest && !(error <= tolerance_ && bendsLittle(pair))) return split(piece, depth, out);
    deviation = std::max(deviation, error);
    out.insert(out.end(), pair.begin(), pair.end());
  }

  double deviation = 0;

 private:
  void split(const BezierPiece& piece, int depth, std::vector<Segment>& out) {
    const auto [before, after] = halves(piece);
    fit(before, depth + 1, out);
    fit(after, depth + 1, out);
  }

  static Ends endsOf(const BezierPiece& piece) {
    const auto direction = [&](double t, double inside) {
      const Vec2 at = evaluate(piece, t).derivative;
      return (at.norm() > 1e-9 ? at : evaluate(piece, inside).derivative).normalized();
    };
    return {euclidean(piece.front()), direction(0, 1e-4), euclidean(piece.back()), direction(1, 1 - 1e-4)};
  }

  static double errorOf(const BezierPiece& piece, const std::array<Segment, 2>& pair) {
    double error = 0;
    for (int i = 1; i < 12; ++i) {
      const Vec2 point = evaluate(piece, i / 12.0).point;
      error = std::max(error, std::min(distanceTo(pair[0], point), distanceTo(pair[1], point)));
    }
    return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
  }

  /// Long arcs could fit the points by luck.
  static bool bendsLittle(const std::array<Segment, 2>& pair) {
    return std::all_of(pair.begin(), pair.end(), [](const Segment& segment) {
      const auto* arc = std::get_if<Arc2>(&segment);
      return !arc || std::abs(arc->sweep) < 1.2;
    });
  }

  double tolerance_;
};

}  // namespace

ArcFitResult fitArcs(const Region& region, const ArcFitOptions& o) {
  ArcFitResult result;
  Fitter fitter(o.tolerance);
  for (const Path& loop : region.loops) {
    Path fitted = loop;
    fitted.segments.clear();
    for (const Segment& segment : loop.segments) {
      const auto* spline = std::get_if<Spline2>(&segment);
      if (!spline) {
        fitted.segments.push_back(segment);
        continue;
      }
      ++result.splines;
      for (const BezierPiece& piece : bezierPieces(*spline)) fitter.fit(piece, 0, fitted.segments);
    }
    result.region.loops.push_back(std::move(fitted));
  }
  result.deviation = fitter.deviation;
  return result;
}

}  // namespace blossom::modeling
