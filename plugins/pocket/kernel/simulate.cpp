#include "kernel/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/residue.h"
#include "kernel/stroke_tree.h"
#include "kernel/tool_moves.h"

namespace blossom::pocket {

namespace {

void validate(const Toolpath& path, const Region& part, const SimulationOptions& options) {
  const Cutter& c = path.cutter;
  if (!(c.diameter > 0) || !std::isfinite(c.diameter))
    throw Error(ErrorCode::InvalidInput, "The toolpath does not say which tool it is for.", "Give the tool's diameter.");
  if (!(options.tolerance > 0)) throw Error(ErrorCode::InvalidParameter, "The tolerance must be above 0.");
  if (path.moves.empty()) throw Error(ErrorCode::InvalidInput, "The toolpath has no moves.");
  if (part.loops.empty()) throw Error(ErrorCode::InvalidInput, "The part is empty.", "Give a region with an outline.");
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    if (!path.moves[i].to.allFinite() || !path.moves[i].center.allFinite())
      throw Error(ErrorCode::InvalidInput, fmt::format("Move {} of the toolpath goes to no finite place.", i + 1));
}

/// Walls as strokes, with what is inside.
class Walls {
 public:
  Walls(const Region& part, double chord) {
    std::vector<Stroke> strokes;
    for (const Path& loop : part.loops) {
      const std::vector<Stroke> some = strokesOf(loop, chord);
      strokes.insert(strokes.end(), some.begin(), some.end());
    }
    inside_ = InsideTest(strokes);
    tree_ = StrokeTree(std::move(strokes));
  }

  /// How far a tool of this radius cuts beyond the walls on its way, at most, and the share of the way.
  [[nodiscard]] std::pair<double, double> gouge(const Stroke& way, double radius) const {
    constexpr double touching = 1e-9;
    const bool in = inside_(way.at(0.5));
    const double away = tree_.nearest(way, in ? radius : 1e300).distance;
    if (in && away > touching) return {radius - away, 0.5};
    return deepest(way, radius);
  }

 private:
  [[nodiscard]] double depth(const Vec2& p, double radius) const {
    const double away = tree_.nearest(p).distance;
    return radius + (inside_(p) ? -away : away);
  }

  /// A way that leaves the part: the depth changes at most as fast as the tool moves, so intervals that cannot hold the
  /// deepest place are dropped.
  [[nodiscard]] std::pair<double, double> deepest(const Stroke& way, double radius) const {
    constexpr double fineness = 1e-4;
    constexpr int most = 20000;
    double best = 0, share = 0;
    struct Interval {
      double from, to;
    };
    std::vector<Interval> open{{0, 1}};
    for (int i = 0; i < most && !open.empty(); ++i) {
      const Interval v = open.back();
      open.pop_back();
      const double middle = (v.from + v.to) / 2, half = (v.to - v.from) / 2 * way.length();
      const double d = depth(way.at(middle), radius);
      if (d > best) best = d, share = middle;
      if (half < fineness || d + half < best + fineness) continue;
      open.push_back({v.from, middle});
      open.push_back({middle, v.to});
    }
    return {best, share};
  }

  StrokeTree tree_;
  InsideTest inside_;
};

void measureGouge(const Toolpath& path, const Walls& walls, const SimulationOptions& options, double floor,
                  SimulationResult& result, const Progress& progress) {
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (i % 256 == 0) progress.report(static_cast<double>(i) / static_cast<double>(path.moves.size()), "Looking for gouges");
    const auto move = below(startOf(path, i), path.moves[i], options.top);
    if (!move) continue;
    const double low = std::min(move->from.z(), move->to.z());
    const auto [depth, share] = walls.gouge(move->way, radiusAt(path.cutter, options.top - low));
    const Vec2 at = move->way.at(share);
    const auto take = [&](double gouge) {
      if (gouge <= result.gouge) return;
      result.gouge = gouge;
      result.gougeAt = {at.x(), at.y(), low};
    };
    take(depth);
    take(floor - low);
  }
}

/// A rapid below the stock's top may only run where the tool has cut before at that height or deeper: straight up, or down
/// again on a way that was cut.
void countRapidsInStock(const Toolpath& path, double top, SimulationResult& result, const Progress& progress) {
  constexpr double same = 1e-3;
  std::vector<MoveBelow> cut;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i);
    const ToolMove& move = path.moves[i];
    const auto part = below(from, move, top);
    if (!part) continue;
    if (move.kind != MoveKind::Rapid) {
      cut.push_back(*part);
      continue;
    }
    progress.check();
    const bool vertical = (move.to - from).head<2>().norm() < same;
    if (vertical && move.to.z() >= from.z()) continue;
    const double low = std::min(part->from.z(), part->to.z());
    const bool cleared = vertical && std::any_of(cut.begin(), cut.end(), [&](const MoveBelow& c) {
                           return std::max(c.from.z(), c.to.z()) <= low + same && distance(c.way, part->way.from) < same;
                         });
    if (cleared) continue;
    if (result.rapidsInStock++ == 0) result.rapidAt = move.to;
  }
}

double deepestCut(const Toolpath& path, double top) {
  double low = top;
  for (const ToolMove& move : path.moves)
    if (move.kind != MoveKind::Rapid) low = std::min(low, move.to.z());
  return low;
}

}  // namespace

double radiusAt(const Cutter& cutter, double height) {
  const double radius = cutter.diameter / 2;
  if (height <= 0) return 0;
  if (cutter.vAngle > 0) return std::min(radius, height * std::tan(cutter.vAngle / 2));
  const double corner = cutter.cornerRadius;
  if (height >= corner) return radius;
  return radius - corner + std::sqrt(corner * corner - (corner - height) * (corner - height));
}

SimulationResult simulate(const Toolpath& path, const Region& part, const SimulationOptions& options,
                          const Progress& progress) {
  validate(path, part, options);
  SimulationResult result;
  const double lowest = deepestCut(path, options.top);
  if (!(lowest < options.top))
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The program does not cut below the part's top at z = {:.3f} mm.", options.top),
                "Check where the work's zero lies.");
  const double floor = options.depth > 0 ? options.top - options.depth : lowest;
  const Walls walls(part, options.tolerance / 500);
  measureGouge(path, walls, options, floor, result, progress.part(0, 0.3));
  countRapidsInStock(path, options.top, result, progress);
  if (path.cutter.vAngle > 0) return result;
  constexpr double sameHeight = 1e-3;
  const double slice = std::max(floor, lowest);
  ResidueProblem problem;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i);
    if (path.moves[i].kind == MoveKind::Rapid) continue;
    if (std::max(from.z(), path.moves[i].to.z()) > slice + sameHeight) {
      // What comes down to the floor cuts it where it arrives.
      if (path.moves[i].to.z() <= slice + sameHeight)
        problem.cut.push_back(Stroke::line(path.moves[i].to.head<2>(), path.moves[i].to.head<2>()));
      continue;
    }
    problem.cut.push_back(wayOf(from, path.moves[i]));
  }
  problem.radius = path.cutter.diameter / 2;
  problem.leave = options.leave;
  problem.tolerance = options.tolerance;
  problem.cells = options.cells;
  const Residue residue = residueOf(part, problem, progress.part(0.3, 1));
  result.residue = residue.area;
  result.residueAt = residue.places;
  result.reachable = residue.reachable;
  result.resolution = residue.resolution;
  return result;
}

}  // namespace blossom::pocket
