#include "geometry/planar/sums/flattening.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/tolerance.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/bounding_polyline.h"
#include "geometry/planar/polygons/refusal.h"
#include "geometry/planar/polygons/straightened.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/sums/loop_checks.h"
#include "geometry/planar/sums/shared_sides.h"
#include "geometry/planar/sums/touching_arcs.h"
#include "geometry/planar/winding/nesting.h"
#include "geometry/planar/winding/snap_rounding.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::planar {
namespace {

constexpr std::size_t maximumCorners = 200'000;
constexpr double largestTolerance = 0.01;         // mm, where none is given
constexpr double automaticShare = 1e-4;           // of the shape's size
constexpr double shareOfThickness = 2e-3;         // a long strip then has its area within about a thousandth
constexpr double coarsestShare = 0.05;            // a circle becomes a heptagon there
constexpr double coarsestShareOfThickness = 0.1;  // the same for a circle
constexpr double farTooMany = 4e6;                // by the estimate, which is generous

void checkLoop(const Path& path, std::size_t number, const std::string& name) {
  if (path.segments.empty())
    refuse(ErrorCode::InvalidInput, name, fmt::format("has an empty loop, number {}.", number), "Remove the loop.");
  refuseWhatIsNoNumber(path, fmt::format("loop {}", number), name);
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Vec2 from = endPoint(path.segments[i]), to = startPoint(path.segments[(i + 1) % path.segments.size()]);
    if ((from - to).norm() > Tolerance{}.joining)
      refuse(ErrorCode::InvalidInput, name, fmt::format("is open: a gap of {:.3g} mm at {}.", (from - to).norm(), at(from)),
             "Close the gap in the drawing; a sum needs an area.");
    refuseFarAway(from, name);
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

/// How large a shape is, and how far from the origin, the centres of its arcs among it.
struct ShapeExtent {
  Vec2 low, high;
  double farthest = 0;
  [[nodiscard]] double size() const { return (high - low).maxCoeff(); }
  [[nodiscard]] Vec2 middle() const { return (low + high) / 2; }
  void add(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  }
  void add(const Line2& line) { add(line.from), add(line.to); }
  void add(const Arc2& arc) {
    const Box2 drawn = boxAround(arc);
    add(Vec2(drawn.min())), add(Vec2(drawn.max()));
    farthest = std::max(farthest, arc.center.cwiseAbs().maxCoeff() + std::abs(arc.radius));
  }
  void add(const Spline2& spline) {
    for (const Vec3& pole : spline.poles)
      if (pole.z() > 0) add(Vec2(pole.head<2>() / pole.z()));
  }
};

ShapeExtent shapeExtentOf(const Region& region) {
  const Vec2 start = startPoint(region.loops.front());
  ShapeExtent extent{start, start, start.cwiseAbs().maxCoeff()};
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) std::visit([&](const auto& each) { extent.add(each); }, segment);
  return extent;
}

/// What is below this is nothing: a share of the shape, but no less than the rounding of its numbers.
double confusionOf(const ShapeExtent& extent) {
  const double rounding = 2e-15 * extent.farthest;
  return std::min(Tolerance{}.confusion, std::max(1e-6 * extent.size(), rounding));
}

double toleranceFor(const Region& region, const ShapeExtent& extent, const FlatteningOptions& options,
                    const std::string& name) {
  if (!hasCurves(region)) return options.share * options.tolerance.value_or(largestTolerance);
  if (!options.tolerance) return options.share * defaultTolerance(region);
  const double bySize = coarsestShare * extent.size(), byThickness = coarsestShareOfThickness * thicknessOf(region);
  const double tolerance = options.share * *options.tolerance, coarsest = std::min(bySize, byThickness);
  if (tolerance > coarsest)
    refuse(
        ErrorCode::InvalidParameter, name,
        fmt::format("at {} is {:.3g} mm large{}; a tolerance of {:.3g} mm is too coarse for its curves.",
                    at(extent.middle()), extent.size(),
                    byThickness < 0.999 * bySize ? fmt::format(" and {:.3g} mm thick", thicknessOf(region)) : std::string(),
                    *options.tolerance),
        smallerTolerance(coarsest / options.share));
  return tolerance;
}

Loop cornersOf(const Path& path, double tolerance, double confusion) {
  Loop loop;
  for (const Vec2& p : flatten(path, tolerance))
    if (loop.empty() || loop.back() != p) loop.push_back(p);
  while (loop.size() > 1 && (loop.back() - loop.front()).norm() <= confusion) loop.pop_back();
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

std::optional<Vec2> crossingOf(const std::vector<Loop>& loops, const Progress& progress) {
  std::vector<Edge> edges;
  std::vector<Box2> boxes;
  for (const Loop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Edge& edge = edges.emplace_back(Edge{loop[i], loop[(i + 1) % loop.size()]});
      boxes.emplace_back(edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to));
    }
  std::optional<Vec2> found;
  forEachNearPair<2>(boxes, 0, progress, [&](std::size_t i, std::size_t j) {
    Vec2 place;
    if (crossInside(edges[i], edges[j], place)) found = place;
    return !found;
  });
  return found;
}

/// What passes through corners or along edges, and so crosses nothing inside of two edges: outlines drawn twice, loops that
/// cross in a corner. Exact, but only looked for where loops touch at all.
void refuseOverlaps(const Nesting& nesting, double confusion, const std::string& name, const Progress& progress) {
  if (nesting.clear()) return;
  const Grid& grid = nesting.grid();
  const auto flaw = misplacedFace(edgesOf(nesting.snappedLoops()), confusion / grid.unit, progress);
  if (flaw)
    refuse(ErrorCode::InvalidInput, name, fmt::format("crosses itself or overlaps itself at {}.", at(grid.point(*flaw))),
           "Remove what is drawn twice there, or correct the outline.");
}

std::vector<Loop> cornersOf(const Region& region, double tolerance, double confusion, const std::string& name,
                            const Progress& progress) {
  std::vector<Loop> all;
  std::size_t corners = 0;
  for (const Path& path : region.loops) {
    progress.check();
    double expected = 0;
    for (const Segment& segment : path.segments) expected += expectedCorners(segment, tolerance);
    Loop loop = expected > farTooMany ? Loop() : cornersOf(path, tolerance, confusion);
    corners += loop.size();
    if (expected > farTooMany || corners > maximumCorners)
      refuse(ErrorCode::LimitExceeded, name,
             fmt::format("needs more than {} corners within {:.3g} mm.", maximumCorners, tolerance), "Raise the tolerance.");
    if (loop.size() < 3)
      refuse(ErrorCode::InvalidInput, name, fmt::format("has a loop at {} that encloses nothing.", at(loop.front())),
             "Remove it, or lower the tolerance if it is small.");
    all.push_back(std::move(loop));
  }
  return all;
}

std::size_t cornerCount(const std::vector<Loop>& loops) {
  std::size_t count = 0;
  for (const Loop& loop : loops) count += loop.size();
  return count;
}

/// Where polylines beside the curves cross, they enclose what both of them do, or leave out what both do.
Polygons flattenedBeside(const Region& region, double tolerance, Approximation side, const Progress& progress) {
  std::vector<Loop> loops;
  for (const Path& path : region.loops) {
    Loop loop = side == Approximation::Outside ? polylineToTheRight(path, tolerance, progress)
                                               : polylineToTheLeft(path, tolerance, progress);
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops.empty() ? Polygons() : Nesting(std::move(loops), progress).polygons(progress);
}

Region straightened(Region region, double tolerance) {
  for (Path& loop : region.loops) straighten(loop, tolerance);
  return region;
}

/// A region that passed all checks.
struct CheckedRegion {
  double tolerance;
  Nesting nesting;  ///< of its loops, flattened
  Region region;    ///< without shared sides, arcs divided where they touch, nearly straight ones lines
};

CheckedRegion checkedRegion(const Region& region, const FlatteningOptions& options, const std::string& name,
                            const Progress& progress) {
  if (options.tolerance && (!(*options.tolerance > 0) || !std::isfinite(*options.tolerance)))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The tolerance must be above 0; it is {}.", *options.tolerance));
  if (region.loops.empty())
    refuse(ErrorCode::InvalidInput, name, "is empty: it has no outline.", "Give a shape with an area.");
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    checkLoop(region.loops[i], i + 1, name);
    progress.check();
  }
  const ShapeExtent extent = shapeExtentOf(region);
  const double tolerance = toleranceFor(region, extent, options, name), confusion = confusionOf(extent);
  SharedSides shared = withoutSharedSides(region, tolerance, progress);
  if (shared.drawnTwice) refuseTwice(*shared.drawnTwice, name);
  Region drawn = straightened(shared.without ? *std::move(shared.without) : region, tolerance);
  if (auto divided = dividedWhereArcsTouch(drawn, tolerance, progress)) drawn = *std::move(divided);
  const std::vector<Loop> all = cornersOf(drawn, tolerance, confusion, name, progress);
  Nesting nesting(all, progress);
  if (!nesting.clear())
    if (const auto crossing = crossingOf(all, progress)) refuseCrossing(name, *crossing);
  if (!nesting.clear() && options.effort)
    options.effort->spend(static_cast<std::size_t>(2 * Effort::pairsOfEdge) * cornerCount(all));
  refuseOverlaps(nesting, confusion, name, progress);
  refuseTwice(all, name);
  refuseEmptyLoops(all, confusion, name);
  refuseCollapsed(nesting, all, extent.size(), name);
  refuseStrayHole(nesting, all, name);
  return {tolerance, std::move(nesting), std::move(drawn)};
}

double farthestIn(const Box2& box) { return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff(); }

/// Without segments that have no length beyond the rounding of their coordinates, and so no direction: files end what they
/// close that near to its beginning.
Path withoutPoints(Path path, const Progress& progress) {
  progress.check();
  const Box2 box = boxAround({&path, 1});
  const double drawn = std::ldexp(farthestIn(box), -46), withCenters = std::ldexp(farthestIn(looseBox({&path, 1})), -46);
  const double rounding = std::max(drawn, std::min(withCenters, 1e-9 * box.sizes().maxCoeff()));
  std::erase_if(path.segments, [&](const Segment& segment) {
    if (const auto* line = std::get_if<Line2>(&segment)) return (line->to - line->from).norm() <= rounding;
    const auto* arc = std::get_if<Arc2>(&segment);
    return arc && arc->radius * std::abs(arc->sweep) <= rounding;
  });
  return path;
}

}  // namespace

double thicknessOf(const Region& region) {
  double area = 0, perimeter = 0;
  for (const Path& loop : region.loops) {
    area += signedArea(loop);
    perimeter += length(loop);
  }
  return perimeter > 0 ? 2 * std::abs(area) / perimeter : 0;
}

double defaultTolerance(const Region& region) {
  const double bySize = automaticShare * shapeExtentOf(region).size();
  // An outline that encloses nothing is refused in its turn.
  const double byThickness = std::max(shareOfThickness * thicknessOf(region), 1e-3 * bySize);
  return std::min({largestTolerance, bySize, byThickness});
}

Polygons flattened(const Region& region, const FlatteningOptions& options, const std::string& name,
                   const Progress& progress) {
  const CheckedRegion checked = checkedRegion(region, options, name, progress);
  if (options.side == Approximation::Either || !hasCurves(checked.region)) return checked.nesting.polygons(progress);
  return flattenedBeside(checked.region, checked.tolerance, options.side, progress);
}

Polygons polygonsBeside(const SoundRegion& shape, Approximation side, const std::string& name, const Progress& progress,
                        Effort& effort) {
  const double within = std::min(shape.tolerance, defaultTolerance(shape.region));
  return flattened(shape.region, {.tolerance = within, .side = side, .effort = &effort}, name, progress);
}

SoundRegion soundRegion(const Region& region, const FlatteningOptions& options, const std::string& name,
                        const Progress& progress) {
  const CheckedRegion checked = checkedRegion(region, options, name, progress);
  const Region& drawn = checked.region;
  const auto parts = hasCurves(drawn) ? checked.nesting.touchingParts(progress) : checked.nesting.parts();
  if (!parts) return {toRegion(checked.nesting.polygons(progress)), checked.tolerance, !hasCurves(drawn)};
  SoundRegion sound{{}, checked.tolerance, !hasSplines(drawn)};
  for (const auto& [outer, holes] : *parts) {
    sound.region.loops.push_back(withoutPoints(drawn.loops[outer], progress));
    for (const std::size_t hole : holes) sound.region.loops.push_back(withoutPoints(drawn.loops[hole], progress));
  }
  return sound;
}

}  // namespace blossom::planar
