#include "kernel/check/floor_ways.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/planar.h"
#include "kernel/stroke/tool_moves.h"

namespace blossom::pocket {

namespace {

bool goesOnStraight(const Stroke& a, const Stroke& b) {
  constexpr double straight = 1e-7;
  return a.to == b.from && std::abs(cross(a.direction(1), b.direction(0))) < straight &&
         a.direction(1).dot(b.direction(0)) > 0;
}

}  // namespace

FloorWays floorWays(const Toolpath& path, double floor) {
  constexpr double sameHeight = 1e-3;
  FloorWays ways;
  bool cutting = false;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i);
    const ToolMove& move = path.moves[i];
    const bool arrives = move.kind != MoveKind::Rapid && move.to.z() <= floor + sameHeight;
    if (!arrives || from.z() > floor + sameHeight) {
      if (arrives) ways.ends.emplace_back(move.to.head<2>());
      cutting = false;
      continue;
    }
    const Stroke way = wayOf(from, move);
    if (way.length() > 0) {
      if (!cutting || ways.strokes.empty() || !goesOnStraight(ways.strokes.back(), way)) ways.ends.push_back(way.from);
      ways.strokes.push_back(way);
    }
    ways.ends.emplace_back(move.to.head<2>());
    cutting = true;
    // The disc at the end is hidden when the next way goes straight on.
    if (i + 1 < path.moves.size() && path.moves[i + 1].kind != MoveKind::Rapid && way.length() > 0 &&
        path.moves[i + 1].to.z() <= floor + sameHeight && goesOnStraight(way, wayOf(move.to, path.moves[i + 1])))
      ways.ends.pop_back();
  }
  std::sort(ways.ends.begin(), ways.ends.end(),
            [](const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  ways.ends.erase(std::unique(ways.ends.begin(), ways.ends.end()), ways.ends.end());
  return ways;
}

}  // namespace blossom::pocket
