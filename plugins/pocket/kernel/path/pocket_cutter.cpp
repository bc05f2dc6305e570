#include "kernel/path/pocket_cutter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/error.h"
#include "core/units.h"
#include "geometry/planar/planar.h"

namespace blossom::pocket {

PocketCutter::PocketCutter(const Region& region, const PocketOptions& options, const Progress& progress)
    : o_(options),
      progress_(progress),
      radius_(o_.cutter.diameter / 2),
      diagram_(region, {.tolerance = o_.tolerance}, progress.part(0, 0.3)),
      slots_(diagram_),
      writer_(result_.path, o_.feed, o_.plungeFeed, {o_.safeHeight, o_.approach}) {
  refuseLargeTool();
  tree_ = passesFrom(radius_ + o_.leaveWall + o_.finish, progress.part(0.3, 0.6));
  if (tree_.roots.empty()) refuseTool();
  if (o_.finish > 0) walls_ = passesFrom(radius_ + o_.leaveWall, progress.part(0.6, 0.7));
  std::vector<Stroke> rim;
  for (const std::size_t root : tree_.roots)
    for (const Pass& pass : tree_.nodes[root].passes) rim.insert(rim.end(), pass.strokes().begin(), pass.strokes().end());
  inside_ = InsideTest(rim);
  rim_ = StrokeTree(std::move(rim));
  findNarrow(o_.finish > 0 ? walls_ : tree_);
}

PocketResult PocketCutter::cut() {
  result_.path.cutter = o_.cutter;
  total_ = o_.depth - o_.leaveFloor;
  result_.depths = static_cast<std::size_t>(std::max(1.0, std::ceil(total_ / o_.stepdown - 1e-9)));
  result_.path.passes = result_.depths;
  std::vector<std::size_t> waiting = tree_.roots;
  for (std::size_t done = 0; !waiting.empty(); ++done) {
    progress_.report(0.7 + 0.3 * static_cast<double>(done) / static_cast<double>(tree_.roots.size()), "Cutting");
    const std::size_t root = takeNearest(waiting);
    atEachDepth([&] {
      clear(tree_, root);
      writer_.lift();
    });
  }
  if (o_.finish > 0) finish();
  writer_.lift();
  return std::move(result_);
}

PassTree PocketCutter::passesFrom(double distance, const Progress& progress) {
  return passTree(diagram_, slots_, {.first = distance, .step = o_.stepover, .radius = radius_, .climb = o_.climb},
                  progress);
}

double PocketCutter::widestTool() const { return 2 * (diagram_.largestClearance() - o_.leaveWall - o_.finish); }

void PocketCutter::refuseLargeTool() {
  // Where the walls are bent, the true widest place may lie beside the diagram's.
  if (o_.cutter.diameter > widestTool() + o_.tolerance) refuseTool();
}

double PocketCutter::largestThatFits() {
  const auto fits = [&](double diameter) {
    return hasPass(diagram_, slots_, diameter / 2 + o_.leaveWall + o_.finish, progress_);
  };
  const double widest = widestTool(), written = std::round(widest * 1e6) / 1e6;
  if (written > 0 && written < o_.cutter.diameter && fits(written)) return written;  // a slot
  double low = std::max(widest - 8 * o_.tolerance, widest / 2), high = widest;
  constexpr double smallest = 1e-3;
  while (low > smallest * widest && !fits(low)) high = low, low /= 2;
  if (!(low > smallest * widest)) return 0;
  constexpr double fineness = 1e-4;
  while (high - low > fineness * low) (fits((low + high) / 2) ? low : high) = (low + high) / 2;
  const double lastDigit = std::pow(10, std::floor(std::log10(low)) - 4);
  return std::floor(low / lastDigit) * lastDigit;
}

[[noreturn]] void PocketCutter::refuseTool() {
  const Vec2 at = diagram_.largestCenter();
  const double fits = largestThatFits();
  throw Error(ErrorCode::InvalidInput,
              fmt::format("A tool of {} mm does not fit into the part, not even at its widest place ({:.2f}, {:.2f}).",
                          formatNumber(o_.cutter.diameter), at.x(), at.y()),
              fits > 0 ? fmt::format("The largest tool that fits has a diameter of {:.12g} mm.", fits)
                       : std::string("No tool fits with so much stock to leave."));
}

void PocketCutter::findNarrow(const PassTree& tree) {
  const Region& region = diagram_.region();
  for (const RegionComponent& part : components(region)) {
    const Path& outer = region.loops[part.outer];
    const bool entered = std::any_of(tree.roots.begin(), tree.roots.end(), [&](std::size_t root) {
      return windingNumber(outer, tree.nodes[root].passes.front().strokes().front().from) != 0;
    });
    if (!entered) result_.tooNarrow.push_back(startPoint(outer));
  }
}

std::size_t PocketCutter::takeNearest(std::vector<std::size_t>& roots) const {
  std::size_t best = 0;
  if (!result_.path.moves.empty()) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const double away = tree_.nodes[roots[i]].passes.front().nearest(writer_.place()).distance;
      if (away < nearest) nearest = away, best = i;
    }
  }
  const std::size_t taken = roots[best];
  roots.erase(roots.begin() + static_cast<std::ptrdiff_t>(best));
  return taken;
}

void PocketCutter::clear(const PassTree& tree, std::size_t root) {
  std::vector<std::pair<std::size_t, bool>> stack{{root, false}};
  while (!stack.empty()) {
    const auto [node, ready] = stack.back();
    stack.pop_back();
    if (ready) {
      clearPasses(tree.nodes[node]);
      continue;
    }
    stack.emplace_back(node, true);
    for (const std::size_t inner : tree.nodes[node].inner) stack.emplace_back(inner, false);
  }
}

void PocketCutter::clearPasses(const PassNode& node) {
  std::vector<std::size_t> waiting(node.passes.size());
  for (std::size_t i = 0; i < waiting.size(); ++i) waiting[i] = i;
  while (!waiting.empty()) {
    progress_.check();
    const bool untouched = node.inner.empty() && waiting.size() == node.passes.size();
    auto [best, foot] = nearestOf(node, waiting);
    double from = 0;
    if (writer_.isDown() && mayStayDown(writer_.place(), foot.point)) {
      from = linked(foot);
    } else if (o_.entry == Entry::Helix && untouched && helix(node)) {
      std::tie(best, foot) = nearestOf(node, waiting);
      from = linked(foot);
    } else {
      from = entered(node.passes[waiting[best]]);
    }
    const std::size_t index = waiting[best];
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best));
    runAround(node, index, from);
    ++result_.loops;
  }
}

std::pair<std::size_t, Pass::Foot> PocketCutter::nearestOf(const PassNode& node,
                                                           const std::vector<std::size_t>& passes) const {
  std::pair<std::size_t, Pass::Foot> best{0, {}};
  for (std::size_t i = 0; writer_.isDown() && i < passes.size(); ++i)
    if (const Pass::Foot foot = node.passes[passes[i]].nearest(writer_.place()); foot.distance < best.second.distance)
      best = {i, foot};
  return best;
}

void PocketCutter::runAround(const PassNode& node, std::size_t index, double from) {
  const Pass& pass = node.passes[index];
  const double whole = pass.length();
  std::vector<std::pair<double, const Spoke*>> stops;
  for (const Spoke& spoke : node.spokes)
    if (spoke.pass == index) {
      double ahead = std::fmod(spoke.foot.at - from, whole);
      stops.emplace_back(ahead < 0 ? ahead + whole : ahead, &spoke);
    }
  std::sort(stops.begin(), stops.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double gone = 0;
  for (const auto& [ahead, spoke] : stops) {
    writer_.along(pass, from + gone, ahead - gone, floor_);
    gone = ahead;
    const Vec2 leave = writer_.place();
    for (const Vec2& p : spoke->walk) writer_.straight(p);
    writer_.straight(leave);
    ++result_.spokes;
  }
  writer_.along(pass, from + gone, whole - gone, floor_);
}

}  // namespace blossom::pocket
