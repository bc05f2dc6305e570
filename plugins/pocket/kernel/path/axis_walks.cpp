#include "kernel/path/axis_walks.h"

#include <algorithm>

namespace blossom::pocket {

void AxisWalks::add(const MedialAxis& axis) {
  std::vector<bool> met(axis.vertices.size(), false);
  for (const MedialEdge& edge : axis.edges) {
    if (edge.from < met.size()) met[edge.from] = true;
    if (edge.to < met.size()) met[edge.to] = true;
    add(edge);
  }
  for (std::size_t i = 0; i < axis.vertices.size(); ++i)
    if (!met[i] && holds(axis.vertices[i].clearance)) addPoint(axis.vertices[i].at, axis.vertices[i].clearance);
}

void AxisWalks::addPoint(const Vec2& p, double clearance) {
  if (wanted_({Vec3(p.x(), p.y(), clearance)})) single_.push_back(p);
}

std::vector<std::vector<Vec2>> AxisWalks::walks() const {
  std::vector<std::vector<Vec2>> all;
  for (const Vec2& p : single_) all.push_back({p});
  PiecesAt at;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    at[pieces_[i].from].push_back(i);
    at[pieces_[i].to].push_back(i);
  }
  std::vector<bool> used(pieces_.size(), false);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (used[i]) continue;
    std::vector<Vec2> walk{pieces_[i].points.front()};
    walkFrom(pieces_[i].from, at, used, walk);
    all.push_back(std::move(walk));
  }
  return all;
}

void AxisWalks::add(const MedialEdge& edge) {
  std::vector<Vec3> run;
  bool touchesStart = false;
  const auto finish = [&](bool touchesEnd) {
    keep(run, touchesStart ? std::optional(edge.from) : std::nullopt, touchesEnd ? std::optional(edge.to) : std::nullopt);
    run.clear();
    touchesStart = false;
  };
  for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
    const Vec3 &a = edge.points[i], &b = edge.points[i + 1];
    double first = 0, last = 1;
    if (!clip(a.z(), b.z(), first, last)) {
      finish(false);
      continue;
    }
    if (run.empty()) {
      run.push_back(a + first * (b - a));
      touchesStart = i == 0 && first == 0;
    }
    run.push_back(a + last * (b - a));
    if (last < 1) finish(false);
  }
  finish(true);
}

/// The shares of a straight change of clearance that lie between the bounds.
bool AxisWalks::clip(double from, double to, double& first, double& last) const {
  if (std::max(from, to) <= low_ || std::min(from, to) >= high_) return false;
  const double change = to - from;
  const auto share = [&](double clearance) { return std::clamp((clearance - from) / change, 0.0, 1.0); };
  if (from < low_ || from > high_) first = share(from < low_ ? low_ : high_);
  if (to < low_ || to > high_) last = share(to < low_ ? low_ : high_);
  return first < last;
}

void AxisWalks::keep(const std::vector<Vec3>& run, std::optional<std::size_t> from, std::optional<std::size_t> to) {
  if (run.size() < 2 || !wanted_(run)) return;
  constexpr std::size_t ownEnds = std::size_t{1} << 40;  // beyond the vertices of the axis
  Piece piece;
  piece.from = from.value_or(ownEnds + 2 * pieces_.size());
  piece.to = to.value_or(ownEnds + 2 * pieces_.size() + 1);
  for (const Vec3& p : run) piece.points.emplace_back(p.head<2>());
  pieces_.push_back(std::move(piece));
}

void AxisWalks::walkFrom(std::size_t start, const PiecesAt& at, std::vector<bool>& used, std::vector<Vec2>& walk) const {
  struct Step {
    std::size_t end;
    std::size_t next = 0;
    std::vector<Vec2> back;  // the way by which it was reached, to be gone back
  };
  std::vector<Step> stack{{start, 0, {}}};
  while (!stack.empty()) {
    Step& step = stack.back();
    const std::vector<std::size_t>& pieces = at.at(step.end);
    if (step.next == pieces.size()) {
      walk.insert(walk.end(), step.back.begin(), step.back.end());
      stack.pop_back();
      continue;
    }
    const std::size_t index = pieces[step.next++];
    if (used[index]) continue;
    used[index] = true;
    const Piece& piece = pieces_[index];
    std::vector<Vec2> way = piece.points;
    const bool forward = piece.from == step.end;
    if (!forward) std::reverse(way.begin(), way.end());
    walk.insert(walk.end(), way.begin() + 1, way.end());
    stack.push_back({forward ? piece.to : piece.from, 0, {way.rbegin() + 1, way.rend()}});
  }
}

}  // namespace blossom::pocket
