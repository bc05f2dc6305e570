#include "kernel/pocket_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/planar.h"
#include "kernel/path_writer.h"

namespace blossom::pocket {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Error(ErrorCode::InvalidParameter, what, hint);
}

/// The options with what was left open filled in.
PocketOptions checkedOptions(PocketOptions o) {
  const double diameter = o.cutter.diameter;
  const auto above = [](double value, const char* name) {
    if (!(value > 0) || !std::isfinite(value))
      refuse(fmt::format("The {} must be above 0; it is {:g}.", name, value), fmt::format("Give a {} above 0.", name));
  };
  const auto fromZero = [](double value, const char* name) {
    if (!(value >= 0) || !std::isfinite(value))
      refuse(fmt::format("The {} must not be below 0; it is {:g}.", name, value), "Give 0 or more.");
  };
  above(diameter, "diameter of the tool");
  fromZero(o.cutter.cornerRadius, "radius of the tool's corners");
  if (o.cutter.cornerRadius > diameter / 2)
    refuse(fmt::format("Corners of {:.4g} mm do not fit on a tool of {:.4g} mm.", o.cutter.cornerRadius, diameter),
           "Give at most half the diameter; that is a ball.");
  above(o.depth, "depth");
  fromZero(o.stepdown, "stepdown");
  fromZero(o.stepover, "stepover");
  fromZero(o.leaveWall, "stock to leave on walls");
  fromZero(o.leaveFloor, "stock to leave on the floor");
  fromZero(o.finish, "finishing allowance");
  above(o.safeHeight, "safe height");
  above(o.approach, "approach height");
  above(o.feed, "feed");
  above(o.plungeFeed, "plunge feed");
  above(o.rampAngle, "ramp angle");
  above(o.tolerance, "tolerance");
  if (o.stepover == 0) o.stepover = 0.45 * diameter;
  if (o.stepdown == 0) o.stepdown = diameter / 2;
  if (o.stepover > diameter * (1 + 1e-12))
    refuse(fmt::format("A stepover of {:.4g} mm is wider than the tool, which is {:.4g} mm: ridges would stay.", o.stepover,
                       diameter),
           "Give at most 100 %; 40 to 50 % is usual.");
  if (o.leaveFloor >= o.depth)
    refuse("The stock to leave on the floor is as thick as the pocket is deep.", "Leave less, or go deeper.");
  if (o.rampAngle > fullTurn / 4 - 1e-3) o.entry = Entry::Plunge;
  constexpr std::size_t mostDepths = 10000;
  if (o.depth / o.stepdown > mostDepths)
    throw Error(ErrorCode::LimitExceeded, fmt::format("More than {} depths are needed.", mostDepths),
                "Use a larger stepdown.");
  return o;
}

class PocketCutter {
 public:
  PocketCutter(const Region& region, const PocketOptions& options, const Progress& progress)
      : o_(options),
        progress_(progress),
        radius_(o_.cutter.diameter / 2),
        diagram_(region, {.tolerance = o_.tolerance}, progress.part(0, 0.3)),
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

  PocketResult cut() {
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

 private:
  [[nodiscard]] PassTree passesFrom(double distance, const Progress& progress) const {
    return passTree(diagram_, {.first = distance, .step = o_.stepover, .radius = radius_, .climb = o_.climb}, progress);
  }

  template <class Cut>
  void atEachDepth(const Cut& cutOne) {
    const auto depths = static_cast<double>(result_.depths);
    for (std::size_t i = 0; i < result_.depths; ++i) {
      above_ = -total_ * static_cast<double>(i) / depths;
      floor_ = -total_ * static_cast<double>(i + 1) / depths;
      cutOne();
    }
  }

  void refuseLargeTool() const {
    if (diagram_.largestClearance() <= radius_ + o_.leaveWall + o_.finish) refuseTool();
  }

  [[noreturn]] void refuseTool() const {
    const double fits = 2 * (diagram_.largestClearance() - o_.leaveWall - o_.finish);
    // Rounded down: what is said must fit.
    const double said = std::floor(fits * 100 - 1e-6) / 100;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("A tool of {:.4g} mm does not fit into the part, not even at its widest place ({:.2f}, {:.2f}).",
                            o_.cutter.diameter, diagram_.largestCenter().x(), diagram_.largestCenter().y()),
                said > 0 ? fmt::format("The largest tool that fits has a diameter of {:.2f} mm.", said)
                         : std::string("No tool fits with so much stock to leave."));
  }

  /// Parts of the region that no pass lies in.
  void findNarrow(const PassTree& tree) {
    const Region& region = diagram_.region();
    for (const RegionComponent& part : components(region)) {
      const Path& outer = region.loops[part.outer];
      const bool entered = std::any_of(tree.roots.begin(), tree.roots.end(), [&](std::size_t root) {
        return windingNumber(outer, tree.nodes[root].passes.front().strokes().front().from) != 0;
      });
      if (!entered) result_.tooNarrow.push_back(startPoint(outer));
    }
  }

  std::size_t takeNearest(std::vector<std::size_t>& roots) const {
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

  /// Clears what lies within a node, then along its own passes. Walks the tree without recursion: narrow steps make it deep.
  void clear(const PassTree& tree, std::size_t root) {
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

  void clearPasses(const PassNode& node) {
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

  /// Which of the passes is nearest to where the tool is; the first one when it is above the stock.
  [[nodiscard]] std::pair<std::size_t, Pass::Foot> nearestOf(const PassNode& node,
                                                             const std::vector<std::size_t>& passes) const {
    std::pair<std::size_t, Pass::Foot> best{0, {}};
    for (std::size_t i = 0; writer_.isDown() && i < passes.size(); ++i)
      if (const Pass::Foot foot = node.passes[passes[i]].nearest(writer_.place()); foot.distance < best.second.distance)
        best = {i, foot};
    return best;
  }

  double linked(const Pass::Foot& foot) {
    writer_.straight(foot.point);
    return foot.at;
  }

  /// The tool's centre stays where it may be, and the way is so short that it hardly cuts more than the pass it leads to.
  [[nodiscard]] bool mayStayDown(const Vec2& from, const Vec2& to) const {
    const double way = (to - from).norm();
    if (way > 2 * radius_ + o_.stepover) return false;
    constexpr double margin = 1e-4;  // the ends may lie on the rim
    if (way <= 2 * margin) return true;
    const Vec2 inwards = (to - from) * (std::min(margin, way / 4) / way);
    const Stroke link = Stroke::line(from + inwards, to - inwards);
    return inside_(link.at(0.5)) && rim_.nearest(link, 1).distance > 1e-9;
  }

  /// Gets down to the floor somewhere on the pass and tells where.
  double entered(const Pass& pass) {
    ++result_.entries;
    const Vec2 start = pass.strokes().front().from;
    writer_.approach(start, above_);
    const double distance = (above_ - floor_) / std::tan(o_.rampAngle);
    constexpr double mostTurns = 40;
    const bool room = pass.length() > radius_ / 4 && distance < mostTurns * pass.length();
    if (o_.entry == Entry::Plunge || !room) {
      if (o_.entry != Entry::Plunge) ++result_.plunged;
      writer_.straight(start, floor_);
      return 0;
    }
    writer_.along(pass, 0, distance, floor_);
    return std::fmod(distance, pass.length());
  }

  /// Down by a helix in the largest disc of the node, to where the nearest pass can be reached straight; false when there is
  /// no room for one.
  bool helix(const PassNode& node) {
    const auto [middle, clearance] = widest(node);
    const double room = clearance - radius_ - o_.leaveWall - o_.finish;
    const double turn = std::min(0.8 * radius_, room);
    if (turn < 0.15 * radius_) return false;
    ++result_.entries;
    const double side = o_.climb ? 1 : -1;
    const Stroke there = Stroke::arc(middle, turn, 0, side * fullTurn / 2);
    const Stroke back = Stroke::arc(middle, turn, fullTurn / 2, side * fullTurn / 2);
    writer_.approach(there.from, above_);
    const double fall = above_ - floor_;
    const int halves = std::max(2, static_cast<int>(std::ceil(fall / (std::tan(o_.rampAngle) * there.length()))));
    for (int i = 1; i <= halves; ++i) writer_.along(i % 2 == 1 ? there : back, above_ - fall * i / halves);
    if (halves % 2 == 1) writer_.along(back);
    writer_.along(there);
    writer_.along(back);
    Pass::Foot nearest;
    for (const Pass& pass : node.passes)
      if (const Pass::Foot foot = pass.nearest(writer_.place()); foot.distance < nearest.distance) nearest = foot;
    // Around a corner: from the middle of the disc, the way to the nearest pass is free.
    if (!mayStayDown(writer_.place(), nearest.point)) writer_.straight(middle);
    return true;
  }

  /// The vertex of the medial axis with the largest clearance in a node.
  std::pair<Vec2, double> widest(const PassNode& node) {
    if (!axis_) axis_ = diagram_.medialAxis(progress_);
    std::vector<Stroke> rim;
    for (const Pass& pass : node.passes) rim.insert(rim.end(), pass.strokes().begin(), pass.strokes().end());
    const InsideTest within(rim);
    std::pair<Vec2, double> best{Vec2::Zero(), 0};
    const auto take = [&](const Vec2& p, double clearance) {
      if (clearance > best.second && within(p)) best = {p, clearance};
    };
    for (const MedialVertex& v : axis_->vertices) take(v.at, v.clearance);
    for (const MedialEdge& edge : axis_->edges)
      for (const Vec3& p : edge.points) take(p.head<2>(), p.z());
    take(diagram_.largestCenter(), diagram_.largestClearance());
    return best;
  }

  /// Once around a pass, out along its spokes and back on the way.
  void runAround(const PassNode& node, std::size_t index, double from) {
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

  /// Takes off what the passes left on the walls.
  void finish() {
    for (const std::size_t root : walls_.roots) {
      progress_.check();
      const PassNode& node = walls_.nodes[root];
      if (!isCleared(root)) {  // too narrow for the passes: nothing was cut there yet
        writer_.lift();
        atEachDepth([&] {
          clear(walls_, root);
          writer_.lift();
        });
        continue;
      }
      for (std::size_t i = 0; i < node.passes.size(); ++i) finish(node, i);
    }
  }

  /// Whether any of the clearing passes lies within a loop along the walls.
  [[nodiscard]] bool isCleared(std::size_t root) const {
    std::vector<Stroke> outline;
    for (const Pass& pass : walls_.nodes[root].passes)
      outline.insert(outline.end(), pass.strokes().begin(), pass.strokes().end());
    const InsideTest within(outline);
    return std::any_of(tree_.roots.begin(), tree_.roots.end(), [&](std::size_t cleared) {
      return within(tree_.nodes[cleared].passes.front().strokes().front().from);
    });
  }

  void finish(const PassNode& node, std::size_t index) {
    const Pass& pass = node.passes[index];
    ++result_.loops;
    const auto [nearestPlace, farthest] = besidePasses(pass);
    const Beside nearest = nearestPlace;
    writer_.lift();
    if (nearest.distance > o_.finish + 2 * o_.tolerance) {  // all of it where the passes did not come
      atEachDepth([&] {
        runAround(node, index, entered(pass));
        writer_.lift();
      });
    } else if (farthest > o_.finish + radius_ / 2) {  // some of it runs through full material, so it goes down in steps
      atEachDepth([&] { finish(pass, nearest.at); });
    } else {
      finish(pass, nearest.at);
    }
  }

  struct Beside {
    double at = 0, distance = 1e300;
  };
  /// Where a pass is nearest to those that cleared, and how far from them it goes.
  [[nodiscard]] std::pair<Beside, double> besidePasses(const Pass& pass) const {
    Beside nearest;
    double farthest = 0, begin = 0;
    const double apart = radius_ / 4;
    for (const Stroke& s : pass.strokes()) {
      const int steps = std::max(1, static_cast<int>(std::ceil(s.length() / apart)));
      for (int k = 0; k < steps; ++k) {
        const double share = (k + 0.5) / steps;
        const double away = rim_.nearest(s.at(share)).distance;
        if (away < nearest.distance) nearest = {begin + share * s.length(), away};
        farthest = std::max(farthest, away);
      }
      begin += s.length();
    }
    return {nearest, farthest};
  }

  /// Down to the floor in what the passes cleared, yet slowly: no pass need have been exactly here.
  void plungeBeside(const Vec2& p) {
    writer_.approach(p, 0);
    writer_.straight(p, floor_);
  }

  /// Once around at the floor, by quarter circles from and to what the passes cleared; where there is room for none,
  /// straight from the nearest place on them.
  void finish(const Pass& pass, double nearest) {
    const double radius = std::max(o_.finish, radius_ / 4);
    const auto lead = leadPlace(pass, radius);
    writer_.lift();
    if (!lead) {
      Vec2 begin = pass.strokes().front().from;
      pass.walk(nearest, 1e-6, [&](const Stroke& s) { begin = s.from; });
      const Stroke& passed = rim_.strokes()[rim_.nearest(begin).stroke];
      plungeBeside(passed.at(passed.nearestShare(begin)));
      writer_.straight(begin);
      writer_.along(pass, nearest, pass.length(), floor_);
      return;
    }
    const auto [at, side] = *lead;
    Stroke tangent;
    pass.walk(at, 1e-6, [&](const Stroke& s) { tangent = s; });
    const Vec2 point = tangent.from, along = tangent.direction(0), in = side * Vec2(-along.y(), along.x());
    const Vec2 center = point + radius * in;
    const double angle = std::atan2(-in.y(), -in.x());
    const Stroke arrive = Stroke::arc(center, radius, angle - side * fullTurn / 4, side * fullTurn / 4);
    const Stroke leave = Stroke::arc(center, radius, angle, side * fullTurn / 4);
    plungeBeside(arrive.from);
    writer_.along(arrive);
    writer_.straight(point);
    writer_.along(pass, at, pass.length(), floor_);
    writer_.along(leave);
  }

  /// Where on a pass a quarter circle leads in and out within what the passes cleared; the side is +1 to the left.
  [[nodiscard]] std::optional<std::pair<double, double>> leadPlace(const Pass& pass, double radius) const {
    const double side = o_.climb ? 1 : -1;
    double begin = 0;
    for (const Stroke& s : pass.strokes()) {
      const double whole = s.length();
      if (whole > 1e-3) {
        const Vec2 along = s.direction(0.5), in = side * Vec2(-along.y(), along.x());
        const Vec2 center = s.at(0.5) + radius * in;
        constexpr double touching = 1e-6;
        const double needed = radius_ + o_.leaveWall + radius - 2 * o_.tolerance;
        if (diagram_.clearance(center) >= needed - touching && inside_(center + radius * along) &&
            inside_(center - radius * along))
          return std::pair(begin + whole / 2, side);
      }
      begin += whole;
    }
    return std::nullopt;
  }

  const PocketOptions o_;
  const Progress progress_;
  const double radius_;
  const ClearanceDiagram diagram_;
  PassTree tree_;   ///< clears
  PassTree walls_;  ///< along the walls, when a finishing pass is wanted
  StrokeTree rim_;
  InsideTest inside_;
  std::optional<MedialAxis> axis_;
  PocketResult result_;
  PathWriter writer_;
  double total_ = 0, above_ = 0, floor_ = 0;
};

}  // namespace

PocketResult pocketPath(const Region& region, const PocketOptions& options, const Progress& progress) {
  return PocketCutter(region, checkedOptions(options), progress).cut();
}

}  // namespace blossom::pocket
