#include "kernel/check/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/check/cleared.h"
#include "kernel/check/residue.h"
#include "kernel/stroke/tool_moves.h"
#include "kernel/stroke/walls.h"

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

/// Where a control may be instead of at the corner between two ways: on its inner side, by the blending at most, and no
/// farther than a curve reaches that leaves and joins each way at its middle.
std::optional<Vec2> cutCorner(const Stroke& before, const Stroke& after, double blending) {
  constexpr double straight = 1e-6;
  const double shorter = std::min(before.length(), after.length());
  if (!(blending > 0) || shorter < straight) return std::nullopt;
  const Vec2 inwards = after.direction(0) - before.direction(1);
  const double bend = inwards.norm();  // twice the sine of half the angle
  if (bend < straight) return std::nullopt;
  return after.from + inwards / bend * std::min(blending, shorter / 2 * bend / 2);
}

class GougeSearch {
 public:
  GougeSearch(const Toolpath& path, const Walls& walls, const SimulationOptions& options, double floor,
              SimulationResult& result)
      : path_(path), walls_(walls), o_(options), floor_(floor), result_(result) {}

  void run(const Progress& progress) {
    std::optional<MoveBelow> last;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      if (i % 256 == 0)
        progress.report(static_cast<double>(i) / static_cast<double>(path_.moves.size()), "Looking for gouges");
      const auto move = below(startOf(path_, i), path_.moves[i], o_.top);
      if (move) measure(*move, i, progress);
      const bool cuts = path_.moves[i].kind != MoveKind::Rapid;
      if (move && last && cuts && last->to == move->from) corner(*last, *move, i);
      last = cuts ? move : std::nullopt;
    }
  }

 private:
  void measure(const MoveBelow& move, std::size_t index, const Progress& progress) {
    const double low = std::min(move.from.z(), move.to.z());
    const double radius = radiusAt(path_.cutter, o_.top - low);
    const auto [depth, share] = walls_.gouge(move.way, radius, progress);
    const Vec2 at = move.way.at(share);
    take(depth, {at.x(), at.y(), low}, index);
    take(floor_ - low, {at.x(), at.y(), low}, index);
    if (!(o_.leave > 0) || depth > o_.tolerance) return;
    if (const double into = walls_.gouge(move.way, radius + o_.leave, progress).first; into > result_.allowance) {
      result_.allowance = into;
      result_.allowanceMove = index;
    }
  }

  void corner(const MoveBelow& before, const MoveBelow& after, std::size_t index) {
    const auto at = cutCorner(before.way, after.way, path_.blending);
    if (at)
      take(walls_.depth(*at, radiusAt(path_.cutter, o_.top - after.from.z())), {at->x(), at->y(), after.from.z()}, index);
  }

  void take(double gouge, const Vec3& at, std::size_t index) {
    constexpr double same = 1e-9;  // the first of moves that are alike
    if (gouge <= result_.gouge + (result_.gouge > 0 ? same : 0)) return;
    result_.gouge = gouge;
    result_.gougeAt = at;
    result_.gougeMove = index;
  }

  const Toolpath& path_;
  const Walls& walls_;
  const SimulationOptions& o_;
  double floor_;
  SimulationResult& result_;
};

/// A rapid below the stock's top may only run where the tool has cut before.
void countRapidsInStock(const Toolpath& path, double top, SimulationResult& result, const Progress& progress) {
  // When the program states the part's top, the stock may be higher beside it: it is the solid of the face.
  const double stockTop = path.stock.empty || path.task ? top : std::max(top, path.stock.high.z());
  Cleared cleared(path.cutter, stockTop, path.stock);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i);
    const ToolMove& move = path.moves[i];
    if (move.kind != MoveKind::Rapid) {
      cleared.cut(from, move);
      continue;
    }
    if (!cleared.isHit(from, move, progress)) continue;
    if (result.rapidsInStock++ > 0) continue;
    result.rapidAt = move.to;
    result.rapidMove = i;
  }
}

/// The first move that cuts deepest.
std::size_t deepestMove(const Toolpath& path, double top) {
  double low = top;
  std::size_t found = path.moves.size();
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    if (path.moves[i].kind != MoveKind::Rapid && path.moves[i].to.z() < low) low = path.moves[i].to.z(), found = i;
  return found;
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

double gougeOnly(const Toolpath& path, const Region& part, const SimulationOptions& options, const Progress& progress) {
  validate(path, part, options);
  SimulationResult result;
  const std::size_t deepest = deepestMove(path, options.top);
  const double lowest = deepest < path.moves.size() ? path.moves[deepest].to.z() : options.top;
  const double floor = options.depth > 0 ? options.top - options.depth : lowest;
  GougeSearch(path, Walls(part, options.tolerance / 500), options, floor, result).run(progress);
  return result.gouge;
}

SimulationResult simulate(const Toolpath& path, const Region& part, const SimulationOptions& options,
                          const Progress& progress) {
  validate(path, part, options);
  SimulationResult result;
  result.deepestMove = deepestMove(path, options.top);
  if (result.deepestMove == path.moves.size())
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The program does not cut below the part's top at z = {:.3f} mm.", options.top),
                "Check where the work's zero lies.");
  const double lowest = path.moves[result.deepestMove].to.z();
  const double floor = options.depth > 0 ? options.top - options.depth : lowest;
  result.missing = std::max(0.0, lowest - floor);
  const Walls walls(part, options.tolerance / 500);
  GougeSearch(path, walls, options, floor, result).run(progress.part(0, 0.3));
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
  problem.corner = path.cutter.cornerRadius;
  problem.leave = options.leave;
  problem.tolerance = options.tolerance;
  problem.cells = options.cells;
  const Residue residue = residueOf(part, problem, progress.part(0.3, 1));
  result.residue = residue.area;
  result.residueAt = residue.places;
  result.reachable = residue.reachable;
  result.resolution = residue.resolution;
  result.ridge = residue.ridge;
  return result;
}

}  // namespace blossom::pocket
