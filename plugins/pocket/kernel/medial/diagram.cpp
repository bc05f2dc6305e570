#include "kernel/medial/diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Vec2 rightOf(const Vec2& v) { return {v.y(), -v.x()}; }

/// Where the bisector of two sites comes nearest to them, and the direction it runs in there.
struct Bisector {
  enum class Kind { Straight, Parabola, Points, Normal } kind = Kind::Straight;
  Vec2 apex = Vec2::Zero(), axis = Vec2::Zero(), up = Vec2::Zero();
  double minimum = 0;  ///< clearance at the apex
};

Bisector bisectorOf(const Site& a, const Site& b, const std::vector<Piece>& pieces) {
  if (!a.isPoint && !b.isPoint) return {};
  const Vec2 focus = pieces[a.isPoint ? a.piece : b.piece].from;
  if (a.isPoint && b.isPoint) {
    const Vec2 other = pieces[b.piece].from;
    const Vec2 between = other - focus;
    return {Bisector::Kind::Points, (focus + other) / 2, rightOf(between).normalized(), Vec2::Zero(), between.norm() / 2};
  }
  const Piece& piece = pieces[a.isPoint ? b.piece : a.piece];
  const Vec2 axis = piece.along().normalized();
  if (focus == piece.from || focus == piece.to) return {Bisector::Kind::Normal, focus, rightOf(axis), Vec2::Zero(), 0};
  const double height = cross(axis, focus - piece.from);
  const Vec2 up = (height > 0 ? -1.0 : 1.0) * rightOf(axis);
  const Vec2 foot = focus - std::abs(height) * up;
  return {Bisector::Kind::Parabola, foot + std::abs(height) / 2 * up, axis, up, std::abs(height) / 2};
}

}  // namespace

double Diagram::distance(const Site& site, const Vec2& x) const {
  const Piece& piece = (*pieces_)[site.piece];
  if (site.isPoint) return (x - piece.from).norm();
  return (piece.from + nearestShare(piece.from, piece.to, x) * piece.along() - x).norm();
}

Vec2 Diagram::towardsInfinity(std::size_t half) const {
  // The cell of a half-edge lies to its left.
  const Site& left = graph_.cells[graph_.edges[half].cell];
  const Site& right = graph_.cells[graph_.edges[half ^ 1].cell];
  const auto middle = [&](const Site& site) -> Vec2 {
    const Piece& piece = (*pieces_)[site.piece];
    return site.isPoint ? piece.from : Vec2((piece.from + piece.to) / 2);
  };
  return rightOf(middle(left) - middle(right)).normalized();
}

EdgeParts Diagram::partsOf(std::size_t edge) const {
  const std::size_t half = 2 * edge;
  const std::size_t a = graph_.edges[half].origin;
  const std::size_t b = graph_.target(half);
  const Bisector bisector =
      bisectorOf(graph_.cells[graph_.edges[half].cell], graph_.cells[graph_.edges[half ^ 1].cell], *pieces_);
  const double ra = a == atInfinity ? infinite : clearance_[a];
  const double rb = b == atInfinity ? infinite : clearance_[b];
  const Vec2 atA = a == atInfinity ? Vec2(-towardsInfinity(half)) : graph_.vertices[a];
  const Vec2 atB = b == atInfinity ? towardsInfinity(half) : graph_.vertices[b];
  EdgeParts parts;
  parts.primary = bisector.kind != Bisector::Kind::Normal;
  bool dips = false;
  if (bisector.kind != Bisector::Kind::Straight) {
    const double xa = a == atInfinity ? atA.dot(bisector.axis) : (atA - bisector.apex).dot(bisector.axis);
    const double xb = b == atInfinity ? atB.dot(bisector.axis) : (atB - bisector.apex).dot(bisector.axis);
    dips = xa * xb < 0 && bisector.minimum < ra && bisector.minimum < rb;
  }
  if (dips) {
    parts.count = 2;
    parts.part[0] = {ra, bisector.minimum, Where::Unknown, atA};
    parts.part[1] = {bisector.minimum, rb, Where::Unknown, atB};
  } else {
    parts.count = 1;
    parts.part[0] = {ra, rb, Where::Unknown, ra > rb ? atA : atB};
  }
  return parts;
}

Vec2 Diagram::pointAt(std::size_t edge, int index, double d) const {
  const std::size_t half = 2 * edge;
  const EdgePart& part = parts_[edge].part[static_cast<std::size_t>(index)];
  const Bisector bisector =
      bisectorOf(graph_.cells[graph_.edges[half].cell], graph_.cells[graph_.edges[half ^ 1].cell], *pieces_);
  if (bisector.kind == Bisector::Kind::Straight) {
    const Vec2& a = graph_.vertices[graph_.edges[half].origin];
    const Vec2& b = graph_.vertices[graph_.target(half)];
    const double share = (d - part.from) / (part.to - part.from);
    return a + std::clamp(share, 0.0, 1.0) * (b - a);
  }
  const bool unbounded = std::isinf(std::max(part.from, part.to));
  const double ahead = (unbounded ? part.high : Vec2(part.high - bisector.apex)).dot(bisector.axis);
  const double sign = ahead < 0 ? -1 : 1;
  if (bisector.kind == Bisector::Kind::Normal) return bisector.apex + sign * d * bisector.axis;
  if (bisector.kind == Bisector::Kind::Points)
    return bisector.apex + sign * std::sqrt(std::max(0.0, d * d - bisector.minimum * bisector.minimum)) * bisector.axis;
  if (!unbounded && (part.high - bisector.apex).dot(bisector.up) < 0) {
    // The point lies so nearly on the line of the piece that the diagram's grid has it on the other side: far away from
    // both, the edge is as good as straight.
    const Vec2& a = graph_.vertices[graph_.edges[half].origin];
    const Vec2& b = graph_.vertices[graph_.target(half)];
    return a + std::clamp((d - part.from) / (part.to - part.from), 0.0, 1.0) * (b - a);
  }
  const double across = std::sqrt(std::max(0.0, 4 * bisector.minimum * (d - bisector.minimum)));
  return bisector.apex + sign * across * bisector.axis + (d - bisector.minimum) * bisector.up;
}

std::vector<Vec3> Diagram::polyline(std::size_t half, double chord) const {
  const std::size_t a = graph_.edges[half].origin;
  const std::size_t b = graph_.target(half);
  const auto end = [&](std::size_t v) { return Vec3(graph_.vertices[v].x(), graph_.vertices[v].y(), clearance_[v]); };
  const Bisector bisector =
      bisectorOf(graph_.cells[graph_.edges[half].cell], graph_.cells[graph_.edges[half ^ 1].cell], *pieces_);
  std::vector<Vec3> points{end(a)};
  if (bisector.kind == Bisector::Kind::Parabola || bisector.kind == Bisector::Kind::Points) {
    const double from = (graph_.vertices[a] - bisector.apex).dot(bisector.axis);
    const double to = (graph_.vertices[b] - bisector.apex).dot(bisector.axis);
    const double sagitta = (to - from) * (to - from) / (8 * std::max(bisector.minimum, chord));
    const int steps = static_cast<int>(std::clamp(std::ceil(std::sqrt(sagitta / chord)), 1.0, 256.0));
    for (int i = 1; i < steps; ++i) {
      const double x = from + (to - from) * i / steps;
      Vec2 at = bisector.apex + x * bisector.axis;
      double clearance = std::hypot(x, bisector.minimum);
      if (bisector.kind == Bisector::Kind::Parabola) {
        const double rise = x * x / (4 * bisector.minimum);
        at += rise * bisector.up;
        clearance = bisector.minimum + rise;
      }
      points.emplace_back(at.x(), at.y(), clearance);
    }
  }
  points.push_back(end(b));
  return points;
}

void Diagram::findParts() {
  parts_.clear();
  parts_.reserve(graph_.edges.size() / 2);
  for (std::size_t edge = 0; edge < graph_.edges.size() / 2; ++edge) parts_.push_back(partsOf(edge));
}

void Diagram::markParts() {
  const auto whereOf = [&](std::size_t vertex) { return vertex == atInfinity ? Where::Outside : where_[vertex]; };
  for (std::size_t edge = 0; edge < parts_.size(); ++edge) {
    EdgeParts& parts = parts_[edge];
    const Where a = whereOf(graph_.edges[2 * edge].origin);
    const Where b = whereOf(graph_.target(2 * edge));
    parts.part[0].where = parts.count == 2 || parts.part[0].from > parts.part[0].to ? a : b;
    parts.part[1].where = b;
  }
}

namespace {

/// A step along the parts on one side, low above high when there are none.
CellStep stepOn(Where side, std::size_t half, const EdgeParts& parts) {
  CellStep step{half, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int k = 0; k < parts.count; ++k) {
    const EdgePart& part = parts.part[static_cast<std::size_t>(k)];
    if (part.where != side) continue;
    step.low = std::min({step.low, part.from, part.to});
    step.high = std::max({step.high, part.from, part.to});
  }
  return step;
}

}  // namespace

void Diagram::findWalks() {
  const auto& edges = graph_.edges;
  for (const Where side : {Where::Inside, Where::Outside}) {
    CellWalks made;
    std::vector<bool> seen(edges.size(), false);
    for (std::size_t start = 0; start < edges.size(); ++start) {
      CellWalk walk{made.steps.size(), 0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
      for (std::size_t h = start; !seen[h]; h = edges[h].next) {
        seen[h] = true;
        const CellStep step = stepOn(side, h, parts_[h / 2]);
        if (step.low > step.high) continue;
        made.steps.push_back(step);
        walk.low = std::min(walk.low, step.low);
        walk.high = std::max(walk.high, step.high);
      }
      walk.count = made.steps.size() - walk.first;
      if (walk.count > 0) made.walks.push_back(walk);
    }
    walks_[side == Where::Inside ? 0 : 1] = std::move(made);
  }
}

}  // namespace blossom::pocket
