#include "kernel/offset/clearance_diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/stopwatch.h"
#include "core/units.h"
#include "geometry/planar/planar.h"
#include "kernel/medial/boundary.h"
#include "kernel/medial/contact.h"
#include "kernel/medial/diagram.h"
#include "kernel/medial/medial.h"
#include "kernel/offset/curve_arcs.h"
#include "kernel/offset/offset_loops.h"
#include "kernel/offset/offset_trace.h"

namespace blossom::pocket {

struct ClearanceDiagram::Parts {
  Parts(const Region& region, const ClearanceOptions& options, const Progress& progress)
      : tolerance(options.tolerance),
        boundary(region, options.tolerance / 4, progress.part(0, 0.1)),
        arcs(boundary, shareOfArcs * options.tolerance, progress),
        diagram(boundary, options.exactPredicates, progress.part(0.1, 1)) {}

  static constexpr double shareOfArcs = 0.35;

  double tolerance;
  Boundary boundary;
  CurveArcs arcs;
  Diagram diagram;
  Disc largest;
  DiagramStats stats;
};

namespace {

void checkTolerance(double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw Error(ErrorCode::InvalidParameter, "The tolerance must be a length above 0.", "0.001 mm is usual.");
}

bool isInside(const EdgeParts& parts) {
  bool inside = parts.primary;
  for (int i = 0; i < parts.count; ++i) inside = inside && parts.part[static_cast<std::size_t>(i)].where == Where::Inside;
  return inside;
}

}  // namespace

ClearanceDiagram::ClearanceDiagram(const Region& region, const ClearanceOptions& options, const Progress& progress) {
  checkTolerance(options.tolerance);
  const Stopwatch watch;
  auto parts = std::make_shared<Parts>(region, options, progress);
  parts->largest = trueDisc(parts->boundary, parts->diagram, parts->diagram.deepest());
  parts->stats = {parts->boundary.pieces().size(), parts->diagram.graph().vertices.size(), parts->diagram.attempts(),
                  parts->diagram.exactPredicates() ? "Delaunay graph" : "sweep line", watch.elapsedMs()};
  parts_ = std::move(parts);
}

Region ClearanceDiagram::offset(double distance, Side side, const Progress& progress) const {
  if (!(distance >= 0) || !std::isfinite(distance))
    throw Error(ErrorCode::InvalidParameter, "The distance of an offset must be 0 or more.",
                "Choose the side for the direction.");
  const Boundary& boundary = parts_->boundary;
  if (distance == 0) return boundary.region();
  if (distance < 4 * boundary.weld()) {
    if (distance < parts_->tolerance) return boundary.region();
    throw Error(ErrorCode::InvalidParameter, fmt::format("The distance {} mm is too small for a part of {} mm.",
                                                         formatNumber(distance), formatNumber(boundary.size())));
  }
  Region region;
  for (const TracedLoop& loop : traced(parts_->diagram, distance, boundary.weld(), side, progress)) {
    progress.check();
    Path path = loopOnTrueCurves(boundary, parts_->arcs, loop, {distance, side, parts_->tolerance});
    // Where the distance equals the clearance along a line, rounding may leave a sliver.
    if (path.segments.empty() || std::abs(signedArea(path)) <= boundary.weld() * length(path)) continue;
    region.loops.push_back(std::move(path));
  }
  return region;
}

MedialAxis ClearanceDiagram::medialAxis(const Progress& progress) const {
  return pocket::medialAxis(parts_->boundary, parts_->diagram, parts_->tolerance, progress);
}

bool ClearanceDiagram::isLevelNear(double distance, double slack) const {
  const Diagram& diagram = parts_->diagram;
  const VoronoiGraph& graph = diagram.graph();
  const auto isNear = [&](std::size_t vertex) {
    return vertex != atInfinity && std::abs(diagram.clearance(vertex) - distance) <= slack;
  };
  constexpr double shortest = 0.05;  // of the distance: a way no longer leads through no slot
  double level = 0;
  std::vector<bool> isHighest(graph.vertices.size(), true);
  for (std::size_t edge = 0; edge < graph.edges.size() / 2; ++edge) {
    const std::size_t a = graph.edges[2 * edge].origin, b = graph.target(2 * edge);
    if (isNear(a) && isNear(b) && isInside(diagram.parts(edge))) level += (graph.vertices[b] - graph.vertices[a]).norm();
    if (a == atInfinity || b == atInfinity) continue;
    if (diagram.clearance(a) < diagram.clearance(b)) isHighest[a] = false;
    if (diagram.clearance(b) < diagram.clearance(a)) isHighest[b] = false;
  }
  if (level > shortest * distance) return true;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    if (isHighest[v] && isNear(v) && diagram.where(v) == Where::Inside) return true;
  return false;
}

double ClearanceDiagram::largestClearance() const { return parts_->largest.radius; }
Vec2 ClearanceDiagram::largestCenter() const { return parts_->largest.center; }

double ClearanceDiagram::clearance(const Vec2& x) const {
  const Boundary::Nearest nearest = parts_->boundary.nearest(x);
  return parts_->boundary.contains(x, nearest) ? nearest.distance : -nearest.distance;
}

const Region& ClearanceDiagram::region() const { return parts_->boundary.region(); }
double ClearanceDiagram::tolerance() const { return parts_->tolerance; }
const DiagramStats& ClearanceDiagram::stats() const { return parts_->stats; }

}  // namespace blossom::pocket
