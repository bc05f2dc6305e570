#include "kernel/path/spokes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace blossom::pocket {

namespace {

constexpr double boundSlack = 1e-4;  // mm; what lies so near to a bound is taken as beyond it

/// A piece of the axis within a band of clearances, between two ends that other pieces may share.
struct AxisPiece {
  std::size_t from = 0, to = 0;
  std::vector<Vec2> points;
};

/// One band: what lies between a pass and the next one.
class Band {
 public:
  Band(double low, double high, double radius, const StrokeTree& next)
      : low_(low - boundSlack), high_(high + boundSlack), radius_(radius), next_(next) {}

  void add(const MedialAxis& axis) {
    std::vector<bool> met(axis.vertices.size(), false);
    for (const MedialEdge& edge : axis.edges) {
      if (edge.from < met.size()) met[edge.from] = true;
      if (edge.to < met.size()) met[edge.to] = true;
      add(edge);
    }
    for (std::size_t i = 0; i < axis.vertices.size(); ++i)
      if (!met[i] && contains(axis.vertices[i].clearance)) addPoint(axis.vertices[i].at, axis.vertices[i].clearance);
  }

  void addPoint(const Vec2& p, double clearance) {
    if (isMissed(Vec3(p.x(), p.y(), clearance), 0)) single_.push_back(p);
  }

  /// A way along every piece of each connected part and back to where it began.
  [[nodiscard]] std::vector<std::vector<Vec2>> walks() const {
    std::vector<std::vector<Vec2>> all;
    for (const Vec2& p : single_) all.push_back({p});
    std::map<std::size_t, std::vector<std::size_t>> at;
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

 private:
  [[nodiscard]] bool contains(double clearance) const { return clearance > low_ && clearance < high_; }

  /// Whether points on the lines that end here may be missed by the next pass. `near`: mm, range of points to include.
  [[nodiscard]] bool isMissed(const Vec3& p, double near) const {
    const double away = next_.nearest(p.head<2>(), 2 * radius_ + near).distance;
    return away + (p.z() - low_) > radius_ - near - boundSlack;
  }

  void add(const MedialEdge& edge) {
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

  /// The shares of a straight change of clearance that lie in the band.
  [[nodiscard]] bool clip(double from, double to, double& first, double& last) const {
    if (std::max(from, to) <= low_ || std::min(from, to) >= high_) return false;
    const double change = to - from;
    const auto share = [&](double clearance) { return std::clamp((clearance - from) / change, 0.0, 1.0); };
    if (from < low_ || from > high_) first = share(from < low_ ? low_ : high_);
    if (to < low_ || to > high_) last = share(to < low_ ? low_ : high_);
    return first < last;
  }

  void keep(const std::vector<Vec3>& run, std::optional<std::size_t> from, std::optional<std::size_t> to) {
    if (run.size() < 2 || !missed(run)) return;
    constexpr std::size_t ownEnds = std::size_t{1} << 40;  // beyond the vertices of the axis
    AxisPiece piece;
    piece.from = from.value_or(ownEnds + 2 * pieces_.size());
    piece.to = to.value_or(ownEnds + 2 * pieces_.size() + 1);
    for (const Vec3& p : run) piece.points.emplace_back(p.head<2>());
    pieces_.push_back(std::move(piece));
  }

  [[nodiscard]] bool missed(const std::vector<Vec3>& run) const {
    for (std::size_t i = 0; i + 1 < run.size(); ++i) {
      const Vec3 along = run[i + 1] - run[i];
      const int steps = std::max(1, static_cast<int>(std::ceil(along.head<2>().norm() / (radius_ / 16))));
      for (int k = 0; k <= steps; ++k)
        if (isMissed(run[i] + along * (static_cast<double>(k) / steps), radius_ / 32)) return true;
    }
    return false;
  }

  void walkFrom(std::size_t start, const std::map<std::size_t, std::vector<std::size_t>>& at, std::vector<bool>& used,
                std::vector<Vec2>& walk) const {
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
      const AxisPiece& piece = pieces_[index];
      std::vector<Vec2> way = piece.points;
      const bool forward = piece.from == step.end;
      if (!forward) std::reverse(way.begin(), way.end());
      walk.insert(walk.end(), way.begin() + 1, way.end());
      stack.push_back({forward ? piece.to : piece.from, 0, {way.rbegin() + 1, way.rend()}});
    }
  }

  double low_, high_, radius_;
  const StrokeTree& next_;
  std::vector<AxisPiece> pieces_;
  std::vector<Vec2> single_;
};

/// Turns a walk so that it begins where it is nearest to its pass.
void attach(std::vector<Vec2> walk, const std::vector<std::size_t>& nodes, PassTree& tree) {
  Spoke spoke;
  std::size_t owner = 0, begin = 0;
  for (const std::size_t node : nodes)
    for (std::size_t pass = 0; pass < tree.nodes[node].passes.size(); ++pass)
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const Pass::Foot foot = tree.nodes[node].passes[pass].nearest(walk[i]);
        if (foot.distance >= spoke.foot.distance) continue;
        spoke.foot = foot;
        spoke.pass = pass;
        owner = node;
        begin = i;
      }
  if (spoke.foot.distance > 1e299) return;
  if (walk.size() > 1) {
    walk.pop_back();  // it ends where it begins
    std::rotate(walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(begin % walk.size()), walk.end());
    walk.push_back(walk.front());
  }
  spoke.walk = std::move(walk);
  tree.nodes[owner].spokes.push_back(std::move(spoke));
}

}  // namespace

void addSpokes(const ClearanceDiagram& diagram, const PassOptions& options, PassTree& tree, const Progress& progress) {
  const MedialAxis axis = diagram.medialAxis(progress);
  for (std::size_t level = 0; level < tree.levels; ++level) {
    progress.check();
    std::vector<std::size_t> nodes;
    std::vector<Stroke> next;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      if (tree.nodes[i].level == level) nodes.push_back(i);
      if (tree.nodes[i].level != level + 1) continue;
      for (const Pass& pass : tree.nodes[i].passes) next.insert(next.end(), pass.strokes().begin(), pass.strokes().end());
    }
    const StrokeTree nextTree(std::move(next));
    const double distance = options.first + static_cast<double>(level) * options.step;
    Band band(distance + options.radius, distance + options.step, options.radius, nextTree);
    band.add(axis);
    if (axis.edges.empty() && axis.vertices.empty()) band.addPoint(diagram.largestCenter(), diagram.largestClearance());
    for (std::vector<Vec2>& walk : band.walks()) attach(std::move(walk), nodes, tree);
  }
}

}  // namespace blossom::pocket
