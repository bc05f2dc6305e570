#include "kernel/medial/medial_prune.h"

#include <algorithm>
#include <cmath>

namespace blossom::pocket {

namespace {

/// The pieces that a half-edge leads away from: from the foot on its left, along the boundary, to the foot on its right.
/// Calls `visit(vertex, piece that begins there)`; stops and returns false at a corner or when `visit` returns false.
template <class Visit>
bool walkCovered(const Boundary& boundary, const Diagram& diagram, std::size_t half, const Progress& progress,
                 const Visit& visit) {
  const auto& pieces = boundary.pieces();
  const VoronoiGraph& graph = diagram.graph();
  const Site& a = graph.cells[graph.edges[half].cell];
  const Site& b = graph.cells[graph.edges[half ^ 1].cell];
  if (a.isPoint && pieces[pieces[a.piece].previous].end == Joint::Corner) return false;
  std::size_t current = a.piece;
  for (std::size_t step = 0; step <= pieces.size() && current != b.piece; ++step) {
    if (step % 4096 == 4095) progress.check();
    if (pieces[current].end == Joint::Corner) return false;
    current = pieces[current].next;
    if (!visit(pieces[current].from, current)) return false;
  }
  return current == b.piece;
}

class Pruner {
 public:
  Pruner(const Boundary& boundary, const Diagram& diagram, double tolerance, const Progress& progress)
      : boundary_(boundary), diagram_(diagram), graph_(diagram.graph()), tolerance_(tolerance), progress_(progress) {}

  KeptEdges prune() {
    takeInnerEdges();
    for (std::size_t h = 0; h < graph_.edges.size(); ++h)
      if (startsAtFlattening(h)) open_.push_back(h);
    // Shallow branches first, so that a vertex is reached after all that hangs on it.
    std::sort(open_.begin(), open_.end(), [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
    while (!open_.empty()) {
      const std::size_t h = open_.back();
      open_.pop_back();
      cut(h);
    }
    for (const std::size_t h : stopped_)
      if (kept_.edge[h / 2] && kept_.degree[graph_.edges[h].origin] == 1) kept_.tips.push_back(h);
    return std::move(kept_);
  }

 private:
  [[nodiscard]] double depth(std::size_t h) const { return diagram_.clearance(graph_.target(h)); }

  void takeInnerEdges() {
    kept_.edge.assign(graph_.edges.size() / 2, false);
    kept_.degree.assign(graph_.vertices.size(), 0);
    out_.assign(graph_.vertices.size(), {});
    for (std::size_t e = 0; e < kept_.edge.size(); ++e) {
      const EdgeParts& parts = diagram_.parts(e);
      bool inside = parts.primary;
      for (int i = 0; i < parts.count; ++i)
        inside = inside && parts.part[static_cast<std::size_t>(i)].where == Where::Inside;
      if (!inside) continue;
      kept_.edge[e] = true;
      for (const std::size_t h : {2 * e, 2 * e + 1}) {
        ++kept_.degree[graph_.edges[h].origin];
        out_[graph_.edges[h].origin].push_back(h);
      }
    }
  }

  [[nodiscard]] bool startsAtFlattening(std::size_t h) const {
    const std::size_t origin = graph_.edges[h].origin;
    if (!kept_.edge[h / 2] || diagram_.clearance(origin) > 0 || kept_.degree[origin] != 1) return false;
    const auto& pieces = boundary_.pieces();
    const Site& left = graph_.cells[graph_.edges[h].cell];
    const Site& right = graph_.cells[graph_.edges[h ^ 1].cell];
    return !left.isPoint && !right.isPoint && pieces[left.piece].next == right.piece &&
           pieces[left.piece].end != Joint::Corner;
  }

  [[nodiscard]] bool leadsToNothing(std::size_t h) const {
    const std::size_t deep = graph_.target(h);
    const Vec2& center = graph_.vertices[deep];
    const double most = diagram_.clearance(deep) + tolerance_;
    return walkCovered(boundary_, diagram_, h, progress_,
                       [&](const Vec2& vertex, std::size_t) { return (vertex - center).norm() <= most; });
  }

  void cut(std::size_t h) {
    if (!kept_.edge[h / 2]) return;
    if (!leadsToNothing(h)) {
      stopped_.push_back(h);
      return;
    }
    kept_.edge[h / 2] = false;
    const std::size_t deep = graph_.target(h);
    --kept_.degree[graph_.edges[h].origin];
    if (--kept_.degree[deep] == 0) kept_.lonely.push_back(deep);
    if (kept_.degree[deep] != 1) return;
    for (const std::size_t next : out_[deep])
      if (kept_.edge[next / 2]) open_.push_back(next);
  }

  const Boundary& boundary_;
  const Diagram& diagram_;
  const VoronoiGraph& graph_;
  double tolerance_;
  const Progress& progress_;
  KeptEdges kept_;
  std::vector<std::vector<std::size_t>> out_;
  std::vector<std::size_t> open_, stopped_;
};

}  // namespace

KeptEdges keptEdges(const Boundary& boundary, const Diagram& diagram, double tolerance, const Progress& progress) {
  return Pruner(boundary, diagram, tolerance, progress).prune();
}

std::optional<Leaf> leafBeyond(const Boundary& boundary, const Diagram& diagram, std::size_t tip) {
  const VoronoiGraph& graph = diagram.graph();
  const auto& pieces = boundary.pieces();
  const std::size_t v = graph.edges[tip].origin;
  if (diagram.clearance(v) == 0) return std::nullopt;
  double sharpest = 0;
  std::size_t where = 0;
  double parameter = 0;
  const auto consider = [&](std::size_t piece, double t) {
    const double k = boundary.curves()[pieces[piece].curve].curvature(t);
    if (k <= sharpest) return;
    sharpest = k;
    where = piece;
    parameter = t;
  };
  const auto look = [&](std::size_t piece) {
    const Piece& p = pieces[piece];
    for (int i = 0; i <= 4; ++i) consider(piece, p.t0 + (p.t1 - p.t0) * i / 4.0);
  };
  look(graph.cells[graph.edges[tip].cell].piece);
  const bool smooth = walkCovered(boundary, diagram, tip, Progress::none(), [&](const Vec2&, std::size_t piece) {
    look(piece);
    return true;
  });
  if (!smooth || !(sharpest > 0)) return std::nullopt;
  // Between the samples the curvature is as good as a parabola: golden sections find its top.
  const double step = (pieces[where].t1 - pieces[where].t0) / 4;
  double low = std::max(0.0, parameter - step);
  double high = std::min(1.0, parameter + step);
  const TrueCurve& curve = boundary.curves()[pieces[where].curve];
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    (curve.curvature(a) < curve.curvature(b) ? low : high) = curve.curvature(a) < curve.curvature(b) ? a : b;
  }
  if (const double t = (low + high) / 2; curve.curvature(t) > sharpest) parameter = t;
  const double radius = 1 / curve.curvature(parameter);
  const Vec2 tangent = curve.tangent(parameter);
  const Disc disc{curve.point(parameter) + radius * Vec2(-tangent.y(), tangent.x()), radius};
  // Behind the tip there is no leaf, and a disc that holds boundary is none either.
  const double chord = boundary.chord();
  if (radius > diagram.clearance(v) + chord || (disc.center - graph.vertices[v]).norm() > diagram.clearance(v))
    return std::nullopt;
  if (boundary.nearest(disc.center).distance < radius - 1e-3 * chord) return std::nullopt;
  return Leaf{disc, pieces[where].curve, parameter};
}

}  // namespace blossom::pocket
