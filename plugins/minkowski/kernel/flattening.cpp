#include "kernel/flattening.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/tolerance.h"
#include "geometry/planar.h"
#include "kernel/near_pairs.h"
#include "kernel/snap_rounding.h"
#include "kernel/winding_faces.h"

namespace blossom::minkowski {
namespace {

constexpr double farthest = 1e9;  // mm
constexpr std::size_t mostCorners = 200'000;
constexpr double farTooMany = 4e6;  // by the estimate, which is generous

std::string at(const Vec2& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); }

[[noreturn]] void refuse(ErrorCode code, const std::string& name, const std::string& what, const std::string& remedy) {
  std::string sentence = fmt::format("{} {}", name, what);
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  throw Error(code, sentence, remedy);
}

/// Every number of a segment, before anything is computed from them.
bool isFinite(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return line->from.allFinite() && line->to.allFinite();
  if (const auto* arc = std::get_if<Arc2>(&segment))
    return arc->center.allFinite() && std::isfinite(arc->radius) && std::isfinite(arc->start) && std::isfinite(arc->sweep);
  const auto& spline = std::get<Spline2>(segment);
  return std::all_of(spline.poles.begin(), spline.poles.end(), [](const Vec3& pole) { return pole.allFinite(); }) &&
         std::all_of(spline.knots.begin(), spline.knots.end(), [](double knot) { return std::isfinite(knot); });
}

void checkLoop(const Path& path, std::size_t number, const std::string& name) {
  if (path.segments.empty())
    refuse(ErrorCode::InvalidInput, name, fmt::format("has an empty loop, number {}.", number), "Remove the loop.");
  for (std::size_t i = 0; i < path.segments.size(); ++i)
    if (!isFinite(path.segments[i]))
      refuse(ErrorCode::InvalidInput, name,
             fmt::format("has coordinates that are not numbers, in segment {} of loop {}.", i + 1, number),
             "Draw that segment anew, or repair the file.");
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Vec2 from = endPoint(path.segments[i]), to = startPoint(path.segments[(i + 1) % path.segments.size()]);
    if ((from - to).norm() > Tolerance{}.joining)
      refuse(ErrorCode::InvalidInput, name, fmt::format("is open: a gap of {:.3g} mm at {}.", (from - to).norm(), at(from)),
             "Close the gap in the drawing; a sum needs an area.");
    if (from.cwiseAbs().maxCoeff() > farthest)
      refuse(ErrorCode::LimitExceeded, name, fmt::format("reaches {}, farther than 1e9 mm from the origin.", at(from)),
             "Check the unit of the drawing, or move it to the origin.");
  }
}

/// About how many corners a segment gets, from above: before they are made, for a tolerance may ask for billions.
double expectedCorners(const Segment& segment, double tolerance) {
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const double reach = std::clamp(1 - tolerance / std::max(std::abs(arc->radius), 1e-300), -1.0, 1.0);
    return std::abs(arc->sweep) / std::max(2 * std::acos(reach), 1e-9);
  }
  const auto* spline = std::get_if<Spline2>(&segment);
  if (!spline) return 1;
  double bend = 0;  // a chord leaves a Bézier piece by at most d (d-1) / 8 times the second difference of its poles
  const auto at = [&](std::size_t i) { return Vec2(spline->poles[i].head<2>() / spline->poles[i].z()); };
  for (std::size_t i = 2; i < spline->poles.size(); ++i) bend = std::max(bend, (at(i) - 2 * at(i - 1) + at(i - 2)).norm());
  return static_cast<double>(spline->poles.size()) *
         (1 + std::sqrt(spline->degree * (spline->degree - 1) / 8.0 * bend / tolerance));
}

Loop cornersOf(const Path& path, double tolerance) {
  Loop loop;
  for (const Vec2& p : flatten(path, tolerance))
    if (loop.empty() || loop.back() != p) loop.push_back(p);
  while (loop.size() > 1 && (loop.back() - loop.front()).norm() <= Tolerance{}.confusion) loop.pop_back();
  return loop;
}

struct Edge {
  Vec2 from, to;
};

/// Where two edges cross inside of both; a touch is none.
bool crossInside(const Edge& a, const Edge& b, Vec2& place) {
  const Vec2 alongA = a.to - a.from, alongB = b.to - b.from;
  const double size = alongA.norm() * alongB.norm();
  const double side = cross(alongA, alongB);
  if (std::abs(side) <= 1e-12 * size) return false;
  const double s = cross(b.from - a.from, alongB) / side, t = cross(b.from - a.from, alongA) / side;
  constexpr double rounding = 1e-9;
  if (!(s > rounding && s < 1 - rounding && t > rounding && t < 1 - rounding)) return false;
  place = a.from + s * alongA;
  return true;
}

[[noreturn]] void refuseCrossing(const std::string& name, const Vec2& place) {
  refuse(ErrorCode::InvalidInput, name, fmt::format("crosses itself at {}.", at(place)),
         "Correct the outline there; where thin curved parts are drawn too coarsely, lower the tolerance.");
}

void refuseCrossings(const Polygons& loops, const std::string& name, const Progress& progress) {
  std::vector<Edge> edges;
  std::vector<Box2> boxes;
  for (const auto& [loop, none] : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Edge& edge = edges.emplace_back(Edge{loop[i], loop[(i + 1) % loop.size()]});
      boxes.push_back({edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to)});
    }
  forEachNearPair(boxes, 0, progress, [&](std::size_t i, std::size_t j) {
    Vec2 place;
    if (crossInside(edges[i], edges[j], place)) refuseCrossing(name, place);
    return true;
  });
}

/// What passes through corners or along edges, and so crosses nothing inside of two edges: outlines drawn twice, loops that
/// cross in a corner. Exact, but only looked for where loops touch at all.
void refuseOverlaps(const Polygons& loops, const std::string& name, const Progress& progress) {
  const Box2 box = boxOf(loops);
  const Grid grid{(box.low + box.high) / 2, gridUnit(box.size())};
  const std::vector<GridPolygon> snappedLoops = snapped(loops, grid);
  if (isClear(snappedLoops, progress)) return;
  const auto flaw = misplacedFace(edgesOf(snappedLoops), Tolerance{}.confusion / grid.unit, progress);
  if (flaw)
    refuse(ErrorCode::InvalidInput, name, fmt::format("crosses itself or overlaps itself at {}.", at(grid.point(*flaw))),
           "Remove what is drawn twice there, or correct the outline.");
}

void refuseEmptyLoops(const Polygons& loops, const std::string& name) {
  for (const auto& [loop, none] : loops) {
    double perimeter = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) perimeter += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    if (std::abs(signedArea(loop)) <= perimeter * Tolerance{}.confusion)
      refuse(ErrorCode::InvalidInput, name, fmt::format("has a loop at {} that encloses nothing.", at(loop.front())),
             "Remove it, or lower the tolerance if it is small.");
  }
}

Path closedPath(const Loop& loop) {
  Path path;
  path.closed = true;
  for (std::size_t i = 0; i < loop.size(); ++i) path.segments.emplace_back(Line2{loop[i], loop[(i + 1) % loop.size()]});
  return path;
}

}  // namespace

Polygons flattened(const Region& region, double tolerance, const std::string& name, const Progress& progress) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The tolerance must be above 0; it is {}.", tolerance));
  if (region.loops.empty())
    refuse(ErrorCode::InvalidInput, name, "is empty: it has no outline.", "Give a shape with an area.");
  Polygons all;
  std::size_t corners = 0;
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    checkLoop(region.loops[i], i + 1, name);
    double expected = 0;
    for (const Segment& segment : region.loops[i].segments) expected += expectedCorners(segment, tolerance);
    Loop loop = expected > farTooMany ? Loop() : cornersOf(region.loops[i], tolerance);
    corners += loop.size();
    if (expected > farTooMany || corners > mostCorners)
      refuse(ErrorCode::LimitExceeded, name,
             fmt::format("needs more than {} corners within {:.3g} mm.", mostCorners, tolerance), "Raise the tolerance.");
    if (loop.size() < 3)
      refuse(ErrorCode::InvalidInput, name, fmt::format("has a loop at {} that encloses nothing.", at(loop.front())),
             "Remove it, or lower the tolerance if it is small.");
    all.push_back({std::move(loop), {}});
  }
  refuseCrossings(all, name, progress);  // before nesting, which needs loops that do not cross
  refuseOverlaps(all, name, progress);
  refuseEmptyLoops(all, name);

  Polygons result;
  for (const RegionComponent& part : components(toRegion(all))) {
    Polygon& polygon = result.emplace_back(Polygon{all[part.outer].outer, {}});
    for (const std::size_t hole : part.holes) polygon.holes.push_back(all[hole].outer);
  }
  return result;
}

Region toRegion(const Polygons& polygons) {
  Region region;
  for (const Polygon& polygon : polygons) {
    region.loops.push_back(closedPath(polygon.outer));
    for (const Loop& hole : polygon.holes) region.loops.push_back(closedPath(hole));
  }
  return region;
}

}  // namespace blossom::minkowski
