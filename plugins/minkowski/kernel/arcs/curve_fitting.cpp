#include "kernel/arcs/curve_fitting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "kernel/arcs/segment_crossing.h"

namespace blossom::minkowski {
namespace {

/// Consecutive sides of a ring that lie on one curve, as the corners that they pass.
struct Run {
  TrueCurve curve;
  std::vector<Vec2> corners;
};

/// Where a run ends and the next one begins; two points when their curves miss each other.
struct Junction {
  Vec2 end, begin;
};

double lengthOf(const std::vector<Vec2>& corners) {
  double length = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
  return length;
}

/// Angle about a centre that corners pass, counter-clockwise positive.
double sweepAbout(const Vec2& centre, const std::vector<Vec2>& corners) {
  double sweep = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec2 from = corners[i - 1] - centre, to = corners[i] - centre;
    sweep += std::atan2(cross(from, to), from.dot(to));
  }
  return sweep;
}

double angleOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }

class RingFitter {
 public:
  RingFitter(const Grid& grid, const CurveOfEdge& curveOf, const CurveFitting& fitting)
      : grid_(grid), curveOf_(curveOf), fitting_(fitting) {}

  /// Nothing when the curves do not fit; a path without segments when the ring is narrower than the rounding.
  std::optional<Path> run(const TracedLoop& ring) {
    makeRuns(ring);
    for (;;) {
      if (runs_.empty()) return Path{};
      if (runs_.size() == 1) return wholeCurve();
      if (!makeJunctions()) return std::nullopt;
      Path path;
      path.closed = true;
      const std::optional<std::size_t> backward = addSegments(path);
      if (!backward) return path;
      if (lengthOf(runs_[*backward].corners) > fitting_.reach) return std::nullopt;
      remove(*backward);
    }
  }

 private:
  void makeRuns(const TracedLoop& ring) {
    runs_.clear();
    const std::size_t n = ring.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 from = grid_.point(ring.corners[i]), to = grid_.point(ring.corners[(i + 1) % n]);
      if (from == to) continue;
      const std::optional<TrueCurve> curve = curveOf_(ring.edges[i]);
      if (!curve) continue;
      if (!runs_.empty() && sameCurve(runs_.back().curve, *curve, fitting_.rounding))
        runs_.back().corners.push_back(to);
      else
        runs_.push_back({*curve, {from, to}});
    }
    std::erase_if(runs_, [&](const Run& run) { return lengthOf(run.corners) <= fitting_.rounding; });
    joinNeighbours();
  }

  /// Runs of one curve that have become neighbours.
  void joinNeighbours() {
    std::vector<Run> joined;
    for (Run& run : runs_) {
      if (!joined.empty() && sameCurve(joined.back().curve, run.curve, fitting_.rounding))
        append(joined.back(), run);
      else
        joined.push_back(std::move(run));
    }
    if (joined.size() > 1 && sameCurve(joined.back().curve, joined.front().curve, fitting_.rounding)) {
      append(joined.back(), joined.front());
      joined.front() = std::move(joined.back());
      joined.pop_back();
    }
    runs_ = std::move(joined);
  }

  static void append(Run& run, const Run& next) {
    run.corners.insert(run.corners.end(), next.corners.begin(), next.corners.end());
  }

  void remove(std::size_t run) {
    runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(run));
    joinNeighbours();
  }

  /// A ring on one curve: a circle, or a line there and back.
  [[nodiscard]] std::optional<Path> wholeCurve() const {
    const auto* circle = std::get_if<Circle>(&runs_.front().curve);
    if (!circle) return Path{};
    const double sweep = sweepAbout(circle->centre, runs_.front().corners);
    if (std::abs(std::abs(sweep) - 2 * std::numbers::pi) > 0.5) return std::nullopt;
    const double start = angleOf(runs_.front().corners.front() - circle->centre);
    return Path{{Arc2{circle->centre, circle->radius, start, sweep > 0 ? 2 * std::numbers::pi : -2 * std::numbers::pi}},
                true,
                {},
                {}};
  }

  bool makeJunctions() {
    junctions_.clear();
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto junction = junctionOf(runs_[i], runs_[(i + 1) % runs_.size()]);
      if (!junction) return false;
      junctions_.push_back(*junction);
    }
    return true;
  }

  [[nodiscard]] std::optional<Junction> junctionOf(const Run& before, const Run& after) const {
    const Vec2 corner = (before.corners.back() + after.corners.front()) / 2;
    const Vec2 onBefore = nearestOn(before.curve, corner), onAfter = nearestOn(after.curve, corner);
    const auto miss = [&](const Vec2& p) { return (p - corner).norm(); };
    if (miss(onBefore) <= fitting_.rounding && miss(onAfter) <= fitting_.rounding) return Junction{corner, corner};
    const Meetings meetings = meetingsOf(before.curve, after.curve, touching());
    const auto points = meetings.points();
    const auto nearest =
        std::min_element(points.begin(), points.end(), [&](const Vec2& p, const Vec2& q) { return miss(p) < miss(q); });
    if (nearest != points.end() && miss(*nearest) <= fitting_.reach) return Junction{*nearest, *nearest};
    if ((onBefore - onAfter).norm() <= fitting_.gap) return Junction{onBefore, onAfter};
    return std::nullopt;
  }

  /// Curves that touch may miss one another by the rounding of their centres and radii.
  [[nodiscard]] double touching() const { return 4 * fitting_.rounding; }

  /// The number of a run that would go backward, if there is one.
  std::optional<std::size_t> addSegments(Path& path) const {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const Vec2 &from = junctions_[(i + runs_.size() - 1) % runs_.size()].begin, &to = junctions_[i].end;
      if (!addSegment(runs_[i], from, to, path)) return i;
      if (junctions_[i].end != junctions_[i].begin)
        path.segments.emplace_back(Line2{junctions_[i].end, junctions_[i].begin});
    }
    return std::nullopt;
  }

  [[nodiscard]] bool addSegment(const Run& run, const Vec2& from, const Vec2& to, Path& path) const {
    if ((to - from).norm() <= fitting_.rounding && lengthOf(run.corners) <= fitting_.reach) return false;
    if (std::holds_alternative<StraightCurve>(run.curve)) {
      path.segments.emplace_back(Line2{from, to});
      return (to - from).dot(run.corners.back() - run.corners.front()) > 0;
    }
    const auto& circle = std::get<Circle>(run.curve);
    const double given = sweepAbout(circle.centre, run.corners);
    const double start = angleOf(from - circle.centre), end = angleOf(to - circle.centre);
    const double sweep = given + std::remainder(end - start - given, 2 * std::numbers::pi);
    path.segments.emplace_back(Arc2{circle.centre, circle.radius, start, sweep});
    return sweep * given > 0 && std::abs(sweep) <= 2 * std::numbers::pi;
  }

  const Grid& grid_;
  const CurveOfEdge& curveOf_;
  CurveFitting fitting_;
  std::vector<Run> runs_;
  std::vector<Junction> junctions_;  ///< of each run and the next one
};

/// Whether curves enclose about what the corners of their polygon do.
bool enclosesTheSame(const Path& path, const TracedLoop& ring, const Grid& grid, double within) {
  Loop corners;
  for (const Vec2& p : ring.corners) corners.push_back(grid.point(p));
  return std::abs(blossom::signedArea(path) - signedArea(corners)) <= within * perimeter(corners);
}

}  // namespace

std::optional<Region> fittedCurves(const std::vector<TracedPart>& parts, const Grid& grid, const CurveOfEdge& curveOf,
                                   const CurveFitting& fitting, const Progress& progress) {
  RingFitter fitter(grid, curveOf, fitting);
  Region region;
  const auto add = [&](const TracedLoop& ring) {
    progress.check();
    std::optional<Path> path = fitter.run(ring);
    if (!path) return false;
    if (path->segments.empty()) return true;
    if (!enclosesTheSame(*path, ring, grid, fitting.gap)) return false;
    region.loops.push_back(std::move(*path));
    return true;
  };
  for (const TracedPart& part : parts) {
    const std::size_t before = region.loops.size();
    if (!add(part.outer)) return std::nullopt;
    if (region.loops.size() == before) continue;  // holes in nothing
    for (const TracedLoop& hole : part.holes)
      if (!add(hole)) return std::nullopt;
  }
  if (segmentsCross(region, fitting.rounding, progress)) return std::nullopt;
  return region;
}

}  // namespace blossom::minkowski
