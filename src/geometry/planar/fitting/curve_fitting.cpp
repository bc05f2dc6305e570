#include "geometry/planar/fitting/curve_fitting.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/free_run.h"
#include "geometry/planar/fitting/segment_crossing.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/sound_region.h"

namespace blossom::planar {
namespace {

/// Consecutive sides of a ring that lie on one curve, as the corners that they pass.
struct Run {
  TrueCurve curve;
  std::vector<Vec2> corners;
  std::vector<FreeSide> sides;  ///< of a free curve, between the corners
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
  std::optional<Path> run(const TracedLoop& ring, const Progress& progress) {
    makeRuns(ring);
    for (;;) {
      progress.check();
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
      Run run{*curve, {from, to}, {}};
      if (isFree(*curve)) run.sides.push_back(std::get<FreeSide>(*curve));
      if (!runs_.empty() && continues(runs_.back(), run))
        append(runs_.back(), run);
      else
        runs_.push_back(std::move(run));
    }
    std::erase_if(runs_, [&](const Run& run) { return lengthOf(run.corners) <= fitting_.rounding; });
    joinNeighbours();
  }

  /// Runs of one curve that have become neighbours.
  void joinNeighbours() {
    std::vector<Run> joined;
    for (Run& run : runs_) {
      if (!joined.empty() && continues(joined.back(), run))
        append(joined.back(), run);
      else
        joined.push_back(std::move(run));
    }
    if (joined.size() > 1 && continues(joined.back(), joined.front())) {
      append(joined.back(), joined.front());
      joined.front() = std::move(joined.back());
      joined.pop_back();
    }
    runs_ = std::move(joined);
  }

  /// Whether two runs that follow each other lie on one curve.
  [[nodiscard]] bool continues(const Run& run, const Run& next) const {
    if (!isFree(run.curve) || !isFree(next.curve))
      return sameCurve(run.curve, next.curve, fitting_.rounding) || areOneWhereDrawn(run, next);
    // Free curves may cross themselves. They go on where a side ends, along the same side, or, hollow ones whose sides cross
    // each other, where the normal goes on.
    const FreeSide &last = run.sides.back(), &first = next.sides.front();
    const Vec2& corner = next.corners.front();
    const auto isAt = [&](const FreePoint& p) { return (p.at - corner).norm() <= fitting_.rounding; };
    const auto oneNormal = [](const FreePoint& p, const FreePoint& q) {
      return std::abs(turnFrom(p.normal, q.normal)) <= sameAngle;
    };
    const bool goesOn = isAt(last.from) || isAt(last.to) || (last.from.at == first.from.at && last.to.at == first.to.at) ||
                        oneNormal(last.to, first.from) || oneNormal(last.from, first.to);
    return goesOn && last.name == first.name && (run.corners.back() - corner).norm() <= fitting_.rounding;
  }

  /// Circles much larger than what is drawn of them: their centres are not known as well as their sides.
  [[nodiscard]] bool areOneWhereDrawn(const Run& run, const Run& next) const {
    constexpr double almost = 1e-3;  // of the radius
    const auto *a = std::get_if<Circle>(&run.curve), *b = std::get_if<Circle>(&next.curve);
    if (!a || !b || std::abs(a->radius - b->radius) > almost * a->radius) return false;
    const Vec2& corner = run.corners.back();
    if ((corner - a->centre).dot(corner - b->centre) <= 0) return false;
    const auto apart = [&](const Vec2& p) {
      return std::abs(((p - a->centre).norm() - a->radius) - ((p - b->centre).norm() - b->radius));
    };
    return std::max({apart(run.corners.front()), apart(corner), apart(next.corners.back())}) <= fitting_.rounding;
  }

  /// Sides go on from the last corner.
  static void append(Run& run, const Run& next) {
    run.corners.insert(run.corners.end(), next.corners.begin() + 1, next.corners.end());
    run.sides.insert(run.sides.end(), next.sides.begin(), next.sides.end());
    const auto *line = std::get_if<StraightCurve>(&run.curve), *longer = std::get_if<StraightCurve>(&next.curve);
    if (line && longer && (longer->to - longer->from).squaredNorm() > (line->to - line->from).squaredNorm())
      run.curve = next.curve;  // which knows its direction better
  }

  void remove(std::size_t run) {
    runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(run));
    joinNeighbours();
  }

  /// A ring on one curve: a circle, or a line or an arc there and back.
  [[nodiscard]] std::optional<Path> wholeCurve() const {
    if (isFree(runs_.front().curve)) return wholeFreeCurve();
    const auto* circle = std::get_if<Circle>(&runs_.front().curve);
    if (!circle) return Path{};
    const double sweep = sweepAbout(circle->centre, runs_.front().corners);
    constexpr double unsure = 0.5;
    if (std::abs(sweep) < unsure) return Path{};
    if (std::abs(std::abs(sweep) - fullTurn) > unsure) return std::nullopt;
    const double start = angleOf(runs_.front().corners.front() - circle->centre);
    return Path{{Arc2{circle->centre, circle->radius, start, sweep > 0 ? fullTurn : -fullTurn}}, true, {}, {}};
  }

  [[nodiscard]] std::optional<Path> wholeFreeCurve() const {
    const Run& run = runs_.front();
    if ((run.corners.front() - run.corners.back()).norm() > fitting_.gap) return std::nullopt;
    return Path{{splineOf(run, run.corners.front(), run.corners.front())}, true, {}, {}};
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
    if (isFree(before.curve) || isFree(after.curve)) {
      // A free end is where the polygons have it, which may be moved within the tolerance.
      const Vec2& place = isFree(before.curve) ? onAfter : onBefore;
      return miss(place) <= fitting_.gap ? std::optional(Junction{place, place}) : std::nullopt;
    }
    if (miss(onBefore) <= fitting_.rounding && miss(onAfter) <= fitting_.rounding) return Junction{corner, corner};
    const Meetings meetings = meetingsOf(before.curve, after.curve, touching());
    const auto points = meetings.points();
    const auto nearest =
        std::min_element(points.begin(), points.end(), [&](const Vec2& p, const Vec2& q) { return miss(p) < miss(q); });
    if (nearest != points.end() && miss(*nearest) <= fitting_.reach) return Junction{*nearest, *nearest};
    if ((onBefore - onAfter).norm() <= fitting_.closed) return Junction{onBefore, onAfter};
    return std::nullopt;
  }

  /// Curves that touch may miss one another by the rounding of their centres and radii.
  [[nodiscard]] double touching() const { return 4 * fitting_.rounding; }

  /// The number of a run that would go backward, if there is one.
  std::optional<std::size_t> addSegments(Path& path) const {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const Vec2 &from = junctions_[(i + runs_.size() - 1) % runs_.size()].begin, &to = junctions_[i].end;
      if (!addSegment(i, from, to, path)) return i;
      if (junctions_[i].end != junctions_[i].begin)
        path.segments.emplace_back(Line2{junctions_[i].end, junctions_[i].begin});
    }
    return std::nullopt;
  }

  [[nodiscard]] bool addSegment(std::size_t i, const Vec2& from, const Vec2& to, Path& path) const {
    const Run& run = runs_[i];
    if ((to - from).norm() <= fitting_.rounding && lengthOf(run.corners) <= fitting_.reach) return false;
    if (std::holds_alternative<StraightCurve>(run.curve)) {
      path.segments.emplace_back(Line2{from, to});
      return (to - from).dot(run.corners.back() - run.corners.front()) > 0;
    }
    if (isFree(run.curve)) {
      path.segments.emplace_back(splineOf(run, from, to));
      return true;
    }
    const auto& circle = std::get<Circle>(run.curve);
    const double start = angleOf(from - circle.centre), end = angleOf(to - circle.centre);
    const double given =
        isPassedBlindly(circle, end - start) ? smoothSweep(i, start, end) : sweepAbout(circle.centre, run.corners);
    const double sweep = given + std::remainder(end - start - given, fullTurn);
    path.segments.emplace_back(Arc2{circle.centre, circle.radius, start, sweep});
    return sweep * given > 0 && std::abs(sweep) <= fullTurn;
  }

  /// Whether corners, which lie within the gap beside the curve, may pass the centre on the wrong side.
  [[nodiscard]] bool isPassedBlindly(const Circle& circle, double turn) const {
    return circle.radius <= fitting_.gap && std::abs(std::remainder(turn, fullTurn)) > fullTurn / 4;
  }
  /// The way around the circle of a run that goes on from the run before it and into the one after it.
  [[nodiscard]] double smoothSweep(std::size_t i, double start, double end) const {
    const std::vector<Vec2>&before = runs_[(i + runs_.size() - 1) % runs_.size()].corners,
          &after = runs_[(i + 1) % runs_.size()].corners;
    const Vec2 arriving = (before.back() - before[before.size() - 2]).normalized(),
               leaving = (after[1] - after.front()).normalized();
    const auto along = [](double angle) { return Vec2(-std::sin(angle), std::cos(angle)); };
    const double ahead = inOneTurn(end - start);
    return arriving.dot(along(start)) + leaving.dot(along(end)) >= 0 ? ahead : ahead - fullTurn;
  }

  [[nodiscard]] Spline2 splineOf(const Run& run, const Vec2& from, const Vec2& to) const {
    return splineAlong({run.corners, run.sides}, from, to, fitting_.rounding, fitting_.gap);
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
    std::optional<Path> path = fitter.run(ring, progress);
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
  if (segmentsCross(region, fitting.rounding, fitting.gap / 16, progress)) return std::nullopt;
  return region;
}

Region straightRegion(const std::vector<TracedPart>& parts, const Grid& grid) {
  Polygons polygons;
  for (const TracedPart& part : parts) {
    Polygon& polygon = polygons.emplace_back(Polygon{part.outer.corners, {}});
    for (const TracedLoop& hole : part.holes) polygon.holes.push_back(hole.corners);
  }
  return toRegion(onPlane(polygons, grid));
}

}  // namespace blossom::planar
