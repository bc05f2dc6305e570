#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"
#include "kernel/medial/diagram.h"
#include "kernel/stroke/grid.h"

namespace blossom::pocket {

namespace {

/// A diagram that failed a check; another grid may do better.
struct Rejected {
  std::string why;
};

[[noreturn]] void reject(std::string why) { throw Rejected{std::move(why)}; }
[[noreturn]] void rejectAt(const char* what, const Vec2& at) { reject(fmt::format("{} near {}", what, placeText(at))); }

/// Angles of the grids tried, in radians: unlike any that drawings prefer.
double gridAngle(std::size_t attempt) {
  return attempt == 0 ? 0 : std::fmod(double(attempt) * 0.7548776662466927, 1.0) * 1.5;
}

void checkCycles(const VoronoiGraph& graph) {
  const std::size_t count = graph.edges.size();
  for (std::size_t h = 0; h < count; ++h) {
    const HalfEdge& edge = graph.edges[h];
    if (edge.next >= count || edge.cell >= graph.cells.size()) reject("an edge has no successor");
    const HalfEdge& next = graph.edges[edge.next];
    if (next.cell != edge.cell || next.origin != graph.target(h)) reject("the edges of a cell do not follow one another");
  }
}

/// Euler's relation of a connected planar graph, with one vertex at infinity.
void checkEuler(const VoronoiGraph& graph) {
  std::vector<bool> bounded(graph.cells.size(), false);
  for (const HalfEdge& edge : graph.edges) bounded[edge.cell] = true;
  const auto faces = std::count(bounded.begin(), bounded.end(), true);
  const auto vertices = static_cast<std::ptrdiff_t>(graph.vertices.size());
  const auto edges = static_cast<std::ptrdiff_t>(graph.edges.size() / 2);
  if (faces != static_cast<std::ptrdiff_t>(graph.cells.size())) reject("a cell has no edges");
  if (vertices - edges + faces != 1) reject(fmt::format("{} vertices, {} edges and {} cells", vertices, edges, faces));
}

/// Where the boundary turns there is a vertex of clearance 0.
void checkCorners(const VoronoiGraph& graph, const std::vector<double>& clearance, const Boundary& boundary) {
  const auto& pieces = boundary.pieces();
  std::vector<bool> met(pieces.size(), false);
  for (const HalfEdge& edge : graph.edges) {
    const Site& site = graph.cells[edge.cell];
    if (site.isPoint && edge.origin != atInfinity && clearance[edge.origin] == 0) met[site.piece] = true;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& before = pieces[pieces[i].previous];
    if (met[i] || pieces[i].end == Joint::Corner || before.end == Joint::Corner) continue;
    const double turn =
        std::abs(cross(before.along(), pieces[i].along())) / (before.along().norm() * pieces[i].along().norm());
    if (turn > 1e-5) rejectAt("a vertex of the boundary is missing", pieces[i].from);
  }
}

/// Where pieces follow one another straight on, an edge runs from inside through their common end to the outside.
bool passesThroughBoundary(const EdgeParts& parts) { return parts.count == 2 && parts.part[0].to == 0; }

}  // namespace

void Diagram::findClearances(const Boundary& boundary) {
  const std::size_t count = graph_.vertices.size();
  clearance_.assign(count, -1);
  std::vector<double> minimum(count, 0);
  std::vector<double> most(count, 0);
  std::vector<double> sum(count, 0);
  std::vector<int> sites(count, 0);
  for (const HalfEdge& edge : graph_.edges) {
    if (edge.origin == atInfinity) continue;
    const std::size_t v = edge.origin;
    const Site& site = graph_.cells[edge.cell];
    const double r = distance(site, graph_.vertices[v]);
    minimum[v] = sites[v] == 0 ? r : std::min(minimum[v], r);
    most[v] = std::max(most[v], r);
    sum[v] += r;
    ++sites[v];
  }
  for (std::size_t v = 0; v < count; ++v) {
    if (sites[v] < 2) reject("a vertex has fewer than three edges");
    if (!(most[v] - minimum[v] <= slackAt(most[v])))
      rejectAt("a vertex is not as far from all its sites", graph_.vertices[v]);
    clearance_[v] = sum[v] / sites[v];
  }
  for (const HalfEdge& edge : graph_.edges) {
    const Site& site = graph_.cells[edge.cell];
    if (edge.origin == atInfinity || !site.isPoint) continue;
    if ((graph_.vertices[edge.origin] - pointOf(site)).norm() > boundary.weld() / 2) continue;
    graph_.vertices[edge.origin] = pointOf(site);
    clearance_[edge.origin] = 0;
  }
}

void Diagram::findSides(const Boundary&) {
  where_.assign(graph_.vertices.size(), Where::Unknown);
  const auto give = [&](std::size_t v, Where where) {
    if (where_[v] == Where::Unknown) {
      where_[v] = where;
      return true;
    }
    if (where_[v] != where) rejectAt("inside and outside meet", graph_.vertices[v]);
    return false;
  };
  std::vector<std::size_t> open;
  const auto apart = [&](std::size_t v) { return 4 * slackAt(clearance_[v]); };
  for (const HalfEdge& edge : graph_.edges) {
    if (edge.origin == atInfinity || clearance_[edge.origin] <= apart(edge.origin)) continue;
    const Site& site = graph_.cells[edge.cell];
    if (site.isPoint) continue;
    const Piece& piece = (*pieces_)[site.piece];
    const double side = cross(piece.along(), graph_.vertices[edge.origin] - piece.from) / piece.along().norm();
    if (std::abs(side) > apart(edge.origin) && give(edge.origin, side > 0 ? Where::Inside : Where::Outside))
      open.push_back(edge.origin);
  }
  // Vertices among points alone lie on the side of their neighbours.
  std::vector<std::vector<std::size_t>> unknown(graph_.vertices.size());
  for (std::size_t h = 0; h < graph_.edges.size(); ++h) {
    const std::size_t a = graph_.edges[h].origin;
    const std::size_t b = graph_.target(h);
    if (a == atInfinity || clearance_[a] == 0 || passesThroughBoundary(parts_[h / 2])) continue;
    if (b == atInfinity) {
      if (give(a, Where::Outside)) open.push_back(a);
    } else if (where_[b] == Where::Unknown && clearance_[b] > 0) {
      unknown[a].push_back(b);
    }
  }
  while (!open.empty()) {
    const std::size_t v = open.back();
    open.pop_back();
    for (const std::size_t next : unknown[v])
      if (give(next, where_[v])) open.push_back(next);
  }
}

void Diagram::certify(const Boundary& boundary, const Progress& progress) const {
  const auto holdsNothing = [&](const Vec2& center, double radius, const char* what) {
    if (boundary.flatDistance(center) < radius - slackAt(radius)) rejectAt(what, center);
  };
  parallelFor(graph_.vertices.size(), 512, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      holdsNothing(graph_.vertices[v], clearance_[v], "the disc of a vertex holds boundary");
  });
  parallelFor(parts_.size(), 512, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      if (!parts_[e].primary) continue;
      for (int k = 0; k < parts_[e].count; ++k) {
        const EdgePart& part = parts_[e].part[static_cast<std::size_t>(k)];
        if (std::isinf(std::max(part.from, part.to)) || std::abs(part.from - part.to) < slackAt(part.to)) continue;
        const double middle = (part.from + part.to) / 2;
        holdsNothing(pointAt(e, k, middle), middle, "the disc of an edge holds boundary");
      }
    }
  });
}

void Diagram::accept(VoronoiGraph graph, const Boundary& boundary, const Progress& progress) {
  graph_ = std::move(graph);
  checkCycles(graph_);
  checkEuler(graph_);
  findClearances(boundary);
  checkCorners(graph_, clearance_, boundary);
  findParts();
  findSides(boundary);
  markParts();
  for (std::size_t h = 0; h < graph_.edges.size(); ++h) {
    const std::size_t origin = graph_.edges[h].origin;
    const bool leaves = origin == atInfinity || graph_.target(h) == atInfinity;
    const bool straight = !graph_.cells[graph_.edges[h].cell].isPoint && !graph_.cells[graph_.edges[h ^ 1].cell].isPoint;
    if (leaves && straight) reject("an edge between two pieces does not end");
    if (leaves && origin != atInfinity && where_[origin] == Where::Inside && !passesThroughBoundary(parts_[h / 2]))
      rejectAt("an inner edge does not end", graph_.vertices[origin]);
  }
  findWalks();
  certify(boundary, progress);
  deepest_ = atInfinity;
  for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
    if (where_[v] == Where::Inside && (deepest_ == atInfinity || clearance_[v] > clearance_[deepest_])) deepest_ = v;
  if (deepest_ == atInfinity) reject("no vertex lies inside");
}

Diagram::Diagram(const Boundary& boundary, bool exactPredicates, const Progress& progress) : pieces_(&boundary.pieces()) {
  constexpr std::size_t sweeps = 6;
  size_ = boundary.size();
  slack_ = 32 * TurnedGrid(boundary.middle(), boundary.size(), 0).step();
  std::string why;
  for (attempts_ = exactPredicates ? sweeps + 1 : 1; attempts_ <= sweeps + 1; ++attempts_) {
    exact_ = attempts_ > sweeps;
    progress.report(double(attempts_ - 1) / double(sweeps + 1), "Building the Voronoi diagram");
    try {
      VoronoiGraph graph =
          exact_ ? delaunayGraph(boundary, progress) : sweepLineGraph(boundary, gridAngle(attempts_ - 1), progress);
      accept(std::move(graph), boundary, progress);
      return;
    } catch (const Rejected& rejected) {
      why = rejected.why;
    }
  }
  throw Error(ErrorCode::Degenerate, fmt::format("No Voronoi diagram of the outline could be certified: {}.", why),
              "Look whether outlines nearly touch there, or change the tolerance.");
}

}  // namespace blossom::pocket
