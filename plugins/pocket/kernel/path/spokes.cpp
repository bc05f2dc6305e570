#include "kernel/path/spokes.h"

#include <algorithm>
#include <cmath>

#include "kernel/path/axis_walks.h"

namespace blossom::pocket {

namespace {

constexpr double boundSlack = 1e-4;  // mm; what lies so near to a bound is taken as beyond it

/// What lies between a pass and the next one.
class Band {
 public:
  Band(double low, double radius, const StrokeTree& next) : low_(low - boundSlack), radius_(radius), next_(next) {}

  /// Whether something on the lines that end on a piece of the axis, or at a point of it, may be missed by the next pass.
  [[nodiscard]] bool misses(const std::vector<Vec3>& run) const {
    if (run.size() == 1) return misses(run.front(), 0);
    for (std::size_t i = 0; i + 1 < run.size(); ++i) {
      const Vec3 along = run[i + 1] - run[i];
      const int steps = std::max(1, static_cast<int>(std::ceil(along.head<2>().norm() / (radius_ / 16))));
      for (int k = 0; k <= steps; ++k)
        if (misses(run[i] + along * (static_cast<double>(k) / steps), radius_ / 32)) return true;
    }
    return false;
  }

 private:
  /// @param near mm to the points asked about, too
  [[nodiscard]] bool misses(const Vec3& p, double near) const {
    const double away = next_.nearest(p.head<2>(), 2 * radius_ + near).distance;
    return away + (p.z() - low_) > radius_ - near - boundSlack;
  }

  double low_, radius_;
  const StrokeTree& next_;
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
    const Band band(distance + options.radius, options.radius, nextTree);
    AxisWalks ways(distance + options.radius - boundSlack, distance + options.step + boundSlack,
                   [&](const std::vector<Vec3>& run) { return band.misses(run); });
    ways.add(axis);
    if (axis.edges.empty() && axis.vertices.empty()) ways.addPoint(diagram.largestCenter(), diagram.largestClearance());
    for (std::vector<Vec2>& walk : ways.walks()) attach(std::move(walk), nodes, tree);
  }
}

}  // namespace blossom::pocket
