#include "kernel/path/pass.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "kernel/path/slots.h"
#include "kernel/path/spokes.h"
#include "kernel/stroke/inside_test.h"

namespace blossom::pocket {

namespace {

constexpr std::size_t maximumLevels = 20000;
/// Loops shorter than this clear nothing.
constexpr double shortestPass = 1e-6;

struct Grown {
  PassNode node;
  InsideTest inside;
};

std::vector<Grown> nodesOf(const Region& region, std::size_t level, bool climb) {
  std::vector<Grown> grown;
  for (const RegionComponent& part : components(region)) {
    Grown each;
    each.node.level = level;
    std::vector<Stroke> rim;
    std::vector<std::size_t> loops{part.outer};
    loops.insert(loops.end(), part.holes.begin(), part.holes.end());
    for (const std::size_t loop : loops) {
      const std::vector<Stroke> strokes = strokesOf(climb ? region.loops[loop] : reversed(region.loops[loop]), 1e-4);
      Pass pass(strokes);
      if (pass.length() < shortestPass) continue;
      rim.insert(rim.end(), strokes.begin(), strokes.end());
      each.node.passes.push_back(std::move(pass));
    }
    if (each.node.passes.empty()) continue;
    each.inside = InsideTest(rim);
    grown.push_back(std::move(each));
  }
  return grown;
}

double perimeterOf(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += length(loop);
  return sum;
}

/// The offset with the slots in it that are just twice as wide as the distance: as lines without area they are not part of
/// an offset, yet a tool goes through them. They are found by taking it next to nothing nearer to the walls.
Region offsetWithSlots(const ClearanceDiagram& diagram, double distance, const Progress& progress) {
  const double aside = 2 * slotSlack(diagram);
  Region region = diagram.offset(distance, Side::Inside, progress);
  if (distance <= 2 * aside) return region;
  Region wider = diagram.offset(distance - aside, Side::Inside, progress);
  constexpr double changes = 1e3;  // times as much as loops grow that only lie further out
  return perimeterOf(wider) > perimeterOf(region) + changes * aside ? wider : region;
}

/// The nodes at a distance. Where a corridor is just twice as wide as the distance, the offset is a line and rounding may
/// tear its loops: then it is taken a little beside, at the walls only away from them.
std::vector<Grown> nodesAt(const ClearanceDiagram& diagram, double distance, std::size_t level, bool climb,
                           const Progress& progress) {
  const double nudge = diagram.tolerance() / 4;
  for (const int aside : {0, -1, -2, 2}) {
    try {
      const double taken = distance + nudge * (level == 0 ? std::abs(aside) : aside);
      return nodesOf(offsetWithSlots(diagram, taken, progress), level, climb);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::InvalidInput) throw;
    }
  }
  throw Error(ErrorCode::Internal, fmt::format("The pass at {:.4f} mm from the walls has no clear inside.", distance),
              "Use a slightly different tool diameter or stepover.");
}

std::vector<Stroke> grownStrokes(const std::vector<Grown>& grown) {
  std::vector<Stroke> strokes;
  for (const Grown& each : grown)
    for (const Pass& pass : each.node.passes) strokes.insert(strokes.end(), pass.strokes().begin(), pass.strokes().end());
  return strokes;
}

/// Whether a way through a slot clears what a node's passes do.
bool isAlong(const PassNode& node, const StrokeTree& ways, double near) {
  for (const Pass& pass : node.passes)
    for (const Stroke& stroke : pass.strokes())
      for (const double share : {0.0, 0.25, 0.5, 0.75})
        if (ways.nearest(stroke.at(share), 2 * near).distance > near) return false;
  return true;
}

/// The nodes along the walls, those through slots just as wide as the tool among them.
std::vector<Grown> firstNodes(const ClearanceDiagram& diagram, SlotSearch& slots, double distance, bool climb,
                              const Progress& progress) {
  std::vector<Grown> grown = nodesAt(diagram, distance, 0, climb, progress);
  std::vector<Pass> passes = slots.leftOut(grownStrokes(grown), distance, progress);
  if (passes.empty()) return grown;
  std::vector<Stroke> ways;
  for (const Pass& pass : passes) ways.insert(ways.end(), pass.strokes().begin(), pass.strokes().end());
  // Torn bits of loops in the slots
  const StrokeTree tree(std::move(ways));
  std::erase_if(grown, [&](const Grown& each) { return isAlong(each.node, tree, diagram.tolerance() / 2); });
  for (Pass& pass : passes) {
    Grown& slot = grown.emplace_back();
    slot.node.passes.push_back(std::move(pass));
  }
  return grown;
}

}  // namespace

bool hasPass(const ClearanceDiagram& diagram, SlotSearch& slots, double distance, const Progress& progress) {
  return !firstNodes(diagram, slots, distance, true, progress).empty();
}

Pass::Pass(const std::vector<Stroke>& strokes) {
  double sum = 0;
  for (const Stroke& s : strokes) {
    const double length = s.length();
    if (!(length > 0)) continue;
    sum += length;
    ends_.push_back(sum);
    strokes_.push_back(s);
  }
  if (strokes_.empty() && !strokes.empty()) {
    ends_.push_back(0);
    strokes_.push_back(strokes.front());
  }
}

std::size_t Pass::strokeAt(double length) const {
  const auto found = std::upper_bound(ends_.begin(), ends_.end(), length);
  return found == ends_.end() ? ends_.size() - 1 : static_cast<std::size_t>(found - ends_.begin());
}

Pass::Foot Pass::nearest(const Vec2& p) const {
  Foot best;
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const double share = strokes_[i].nearestShare(p);
    const Vec2 at = strokes_[i].at(share);
    const double away = (at - p).norm();
    const double begin = i == 0 ? 0 : ends_[i - 1];
    if (away < best.distance) best = {begin + share * (ends_[i] - begin), at, away};
  }
  return best;
}

PassTree passTree(const ClearanceDiagram& diagram, SlotSearch& slots, const PassOptions& options, const Progress& progress) {
  PassTree tree;
  std::vector<InsideTest> within;  // of the level before
  std::vector<std::size_t> above;
  const double largest = diagram.largestClearance();
  for (std::size_t level = 0;; ++level) {
    const double distance = options.first + static_cast<double>(level) * options.step;
    if (level > 0 && distance > largest) break;
    progress.report((distance - options.first) / std::max(largest - options.first, 1e-9), "Laying the passes");
    if (level >= maximumLevels)
      throw Error(ErrorCode::LimitExceeded, fmt::format("More than {} passes side by side are needed.", maximumLevels),
                  "Use a larger stepover or a larger tool.");
    std::vector<Grown> grown = level == 0 ? firstNodes(diagram, slots, distance, options.climb, progress)
                                          : nodesAt(diagram, distance, level, options.climb, progress);
    if (grown.empty()) break;
    std::vector<std::size_t> indices;
    std::vector<InsideTest> inside;
    for (Grown& each : grown) {
      const std::size_t index = tree.nodes.size();
      const Vec2 start = each.node.passes.front().strokes().front().from;
      if (level == 0) tree.roots.push_back(index);
      for (std::size_t i = 0; i < above.size(); ++i)
        if (within[i](start)) {
          tree.nodes[above[i]].inner.push_back(index);
          break;
        }
      indices.push_back(index);
      inside.push_back(std::move(each.inside));
      tree.nodes.push_back(std::move(each.node));
    }
    above = std::move(indices);
    within = std::move(inside);
    tree.levels = level + 1;
  }
  if (options.step > options.radius) addSpokes(diagram, options, tree, progress);
  return tree;
}

}  // namespace blossom::pocket
