#include "kernel/path/slots.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_point.h"
#include "kernel/offset/arc_fit.h"
#include "kernel/path/axis_walks.h"
#include "kernel/stroke/inside_test.h"

namespace blossom::pocket {

namespace {

/// Of the tolerance: by how much less clearances are in the diagram than between the true walls, at most.
constexpr double offByChords = 0.3;

using Points = std::vector<Vec2>;

/// The arc from one of the points to a later one, through the middle one between; a line when none is between.
Segment arcAlong(const Points& points, std::size_t from, std::size_t to) {
  const Vec2 &a = points[from], &b = points[(from + to) / 2], &c = points[to];
  const double sides = (b - a).norm() * (c - b).norm() * (c - a).norm();
  if (from + 1 == to || !(sides > 0)) return Line2{a, c};
  const double curvature = 2 * cross(Vec2(b - a), Vec2(c - b)) / sides;
  return arcBetween(a, c, 2 * std::asin(std::clamp(curvature * (c - a).norm() / 2, -1.0, 1.0)));
}

/// Whether the lines from point to point lie near a segment.
bool isNear(const Segment& segment, const Points& points, std::size_t from, std::size_t to, double tolerance) {
  for (std::size_t i = from; i < to; ++i)
    for (const double share : {0.0, 0.25, 0.5, 0.75})
      if (distanceTo(segment, points[i] + share * (points[i + 1] - points[i])) > tolerance) return false;
  return true;
}

/// Arcs and lines along smooth points, as few as it takes. No tangents are asked for: over long lines they would make small
/// slips large.
void addFitted(const Points& points, double tolerance, Path& way) {
  for (std::size_t from = 0; from + 1 < points.size();) {
    std::size_t to = from + 1;
    Segment best = arcAlong(points, from, to);
    for (std::size_t reach = 1; reach > 0;) {
      const std::size_t farther = std::min(points.size() - 1, to + reach);
      if (farther == to) break;
      const Segment made = arcAlong(points, from, farther);
      const bool isGood = isNear(made, points, from, farther, tolerance);
      if (isGood) best = made, to = farther;
      reach = isGood ? 2 * reach : reach / 2;
    }
    way.segments.push_back(best);
    from = to;
  }
}

/// A walk as arcs and lines; at its turning points and corners it does not go on smoothly.
Pass passAlong(const Points& walk, double tolerance) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < walk.size(); ++i) length += (walk[i + 1] - walk[i]).norm();
  if (length < 2 * tolerance) return Pass({Stroke::line(walk.front(), walk.front())});
  constexpr double smooth = 0.95;  // cosine of the turn
  const double fit = tolerance / 50;
  Path way;
  Points run{walk.front()};
  for (const Vec2& next : walk) {
    if (next == run.back()) continue;
    if (run.size() > 1) {
      const Vec2 before = (run.back() - run[run.size() - 2]).normalized(), after = (next - run.back()).normalized();
      if (before.dot(after) < smooth) {
        addFitted(run, fit, way);
        run.erase(run.begin(), run.end() - 1);
      }
    }
    run.push_back(next);
  }
  addFitted(run, fit, way);
  return Pass(strokesOf(way, tolerance));
}

}  // namespace

double slotSlack(const ClearanceDiagram& diagram) {
  double perimeter = 0;
  for (const Path& loop : diagram.region().loops) perimeter += length(loop);
  // Wider than the diagram's grid tells distances apart, far below what the path may be off.
  const double tolerance = diagram.tolerance();
  return std::clamp(1e-8 * perimeter, tolerance / 1000, tolerance / 40);
}

std::vector<Pass> SlotSearch::leftOut(const std::vector<Stroke>& loops, double distance, const Progress& progress) {
  const double tolerance = diagram_.tolerance();
  std::vector<Pass> passes;
  if (!diagram_.isLevelNear(distance, 2 * offByChords * tolerance)) return passes;
  const InsideTest within(loops);
  const StrokeTree rim(loops);
  const auto isLeftOut = [&](const Vec2& p) {
    return loops.empty() || (!within(p) && rim.nearest(p, 2 * tolerance).distance > tolerance);
  };
  AxisWalks ways(distance - 2 * slotSlack(diagram_), distance + offByChords * tolerance, [&](const std::vector<Vec3>& run) {
    if (run.size() == 1) return isLeftOut(run.front().head<2>());
    for (std::size_t i = 0; i + 1 < run.size(); ++i) {
      progress.check();
      const Vec2 from = run[i].head<2>(), along = run[i + 1].head<2>() - from;
      const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / (distance / 8))));
      for (int k = 0; k <= steps; ++k)
        if (isLeftOut(from + along * k / steps)) return true;
    }
    return false;
  });
  ways.add(axis(progress));
  for (const Points& walk : ways.walks()) passes.push_back(passAlong(walk, tolerance));
  return passes;
}

const MedialAxis& SlotSearch::axis(const Progress& progress) {
  if (axis_) return *axis_;
  constexpr double finer = 16;  // the axis is given by lines near it
  try {
    axis_ = ClearanceDiagram(diagram_.region(), {.tolerance = diagram_.tolerance() / finer}, progress).medialAxis(progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::LimitExceeded) throw;
    axis_ = diagram_.medialAxis(progress);  // the part is too large for chords as fine
  }
  return *axis_;
}

}  // namespace blossom::pocket
