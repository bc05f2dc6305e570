#include "kernel/pocket_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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
    const double first = radius_ + o_.leaveWall + o_.finish;
    tree_ = passTree(diagram_, {.first = first, .step = o_.stepover, .radius = radius_, .climb = o_.climb},
                     progress.part(0.3, 0.7));
    if (tree_.roots.empty()) refuseTool();
    std::vector<Stroke> rim;
    for (const std::size_t root : tree_.roots)
      for (const Pass& pass : tree_.nodes[root].passes) rim.insert(rim.end(), pass.strokes().begin(), pass.strokes().end());
    inside_ = InsideTest(rim);
    rim_ = StrokeTree(std::move(rim));
    findNarrow();
  }

  PocketResult cut() {
    result_.path.cutter = o_.cutter;
    const double total = o_.depth - o_.leaveFloor;
    const auto depths = static_cast<std::size_t>(std::max(1.0, std::ceil(total / o_.stepdown - 1e-9)));
    result_.depths = result_.path.passes = depths;
    std::vector<std::size_t> waiting = tree_.roots;
    for (std::size_t done = 0; !waiting.empty(); ++done) {
      const std::size_t root = takeNearest(waiting);
      for (std::size_t i = 0; i < depths; ++i) {
        progress_.report(0.7 + 0.3 * (static_cast<double>(done) + static_cast<double>(i) / static_cast<double>(depths)) /
                                   static_cast<double>(tree_.roots.size()),
                         "Cutting");
        above_ = -total * static_cast<double>(i) / static_cast<double>(depths);
        floor_ = -total * static_cast<double>(i + 1) / static_cast<double>(depths);
        clear(root);
        writer_.lift();
      }
    }
    if (o_.finish > 0) finish();
    writer_.lift();
    return std::move(result_);
  }

 private:
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
  void findNarrow() {
    const Region& region = diagram_.region();
    for (const RegionComponent& part : components(region)) {
      const Path& outer = region.loops[part.outer];
      const bool entered = std::any_of(tree_.roots.begin(), tree_.roots.end(), [&](std::size_t root) {
        return windingNumber(outer, tree_.nodes[root].passes.front().strokes().front().from) != 0;
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
  void clear(std::size_t root) {
    std::vector<std::pair<std::size_t, bool>> stack{{root, false}};
    while (!stack.empty()) {
      const auto [node, ready] = stack.back();
      stack.pop_back();
      if (ready) {
        clearPasses(tree_.nodes[node]);
        continue;
      }
      stack.emplace_back(node, true);
      for (const std::size_t inner : tree_.nodes[node].inner) stack.emplace_back(inner, false);
    }
  }

  void clearPasses(const PassNode& node) {
    std::vector<std::size_t> waiting(node.passes.size());
    for (std::size_t i = 0; i < waiting.size(); ++i) waiting[i] = i;
    while (!waiting.empty()) {
      progress_.check();
      std::size_t best = 0;
      Pass::Foot foot;
      for (std::size_t i = 0; i < waiting.size(); ++i) {
        const Pass::Foot each = writer_.isDown() ? node.passes[waiting[i]].nearest(writer_.place()) : Pass::Foot{0, {}, 0};
        if (i == 0 || each.distance < foot.distance) foot = each, best = i;
      }
      const std::size_t index = waiting[best];
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best));
      const Pass& pass = node.passes[index];
      const double from = writer_.isDown() && mayStayDown(writer_.place(), foot.point) ? linked(foot) : entered(node, pass);
      runAround(node, index, from);
      ++result_.loops;
    }
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
  double entered(const PassNode& node, const Pass& pass) {
    ++result_.entries;
    if (o_.entry == Entry::Helix && node.inner.empty())
      if (const auto at = helix(node, pass)) return *at;
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

  /// A helix in the largest disc of the node, then over to the pass; nothing when there is no room for one.
  std::optional<double> helix(const PassNode& node, const Pass& pass) {
    const auto [middle, clearance] = widest(node);
    const double room = clearance - radius_ - o_.leaveWall - o_.finish;
    const double turn = std::min(0.8 * radius_, room);
    if (turn < 0.15 * radius_) return std::nullopt;
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
    const Pass::Foot foot = pass.nearest(writer_.place());
    if (!mayStayDown(writer_.place(), foot.point)) {  // around a corner: from the middle, the way to a wall is free
      writer_.straight(middle);
      return linked(pass.nearest(middle));
    }
    return linked(foot);
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

  /// The finishing pass at full depth, entered beside the wall where the passes cleared.
  void finish() {
    const double distance = radius_ + o_.leaveWall;
    const Region walls = diagram_.offset(distance, Side::Inside, progress_);
    for (const Path& loop : walls.loops) {
      progress_.check();
      const Pass pass(strokesOf(o_.climb ? loop : reversed(loop), 1e-4));
      if (!(pass.length() > 0)) continue;
      finish(pass);
      ++result_.loops;
    }
  }

  void finish(const Pass& pass) {
    const double radius = std::max(o_.finish, radius_ / 4);
    const auto lead = leadPlace(pass, radius);
    writer_.lift();
    if (!lead) {  // nowhere room for an arc: straight down beside the wall, where the passes were
      const Stroke& first = pass.strokes().front();
      const StrokeTree::Nearest near = rim_.nearest(first.from);
      const Stroke& passed = rim_.strokes()[near.stroke];
      writer_.approach(passed.at(passed.nearestShare(first.from)), floor_);
      writer_.straight(first.from);
      writer_.along(pass, 0, pass.length(), floor_);
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
    writer_.approach(arrive.from, floor_);
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
        if (diagram_.clearance(center) >= needed - touching && isCleared(center + radius * along) &&
            isCleared(center - radius * along))
          return std::pair(begin + whole / 2, side);
      }
      begin += whole;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool isCleared(const Vec2& p) const { return inside_(p); }

  const PocketOptions o_;
  const Progress progress_;
  const double radius_;
  const ClearanceDiagram diagram_;
  PassTree tree_;
  StrokeTree rim_;
  InsideTest inside_;
  std::optional<MedialAxis> axis_;
  PocketResult result_;
  PathWriter writer_;
  double above_ = 0, floor_ = 0;
};

}  // namespace

PocketResult pocketPath(const Region& region, const PocketOptions& options, const Progress& progress) {
  return PocketCutter(region, checkedOptions(options), progress).cut();
}

}  // namespace blossom::pocket
