#include "kernel/stroke/tool_moves.h"

#include <algorithm>
#include <cmath>

namespace blossom::pocket {

Stroke wayOf(const Vec3& from, const ToolMove& move) {
  if (move.turn == 0) return Stroke::line(from.head<2>(), move.to.head<2>());
  const Vec2 first = from.head<2>() - move.center;
  Stroke arc = Stroke::arc(move.center, first.norm(), std::atan2(first.y(), first.x()), sweepOf(from, move));
  arc.from = from.head<2>();
  arc.to = move.to.head<2>();
  return arc;
}

std::optional<MoveBelow> below(const Vec3& from, const ToolMove& move, double top) {
  constexpr double touching = 1e-9;
  if (std::min(from.z(), move.to.z()) >= top - touching) return std::nullopt;
  const Stroke way = wayOf(from, move);
  const double fall = move.to.z() - from.z();
  if (std::max(from.z(), move.to.z()) <= top) return MoveBelow{from, move.to, way};
  const double at = (top - from.z()) / fall;
  const bool descends = fall < 0;
  const Vec2 middle = way.at(at);
  const Vec3 entry(middle.x(), middle.y(), top);
  if (descends) return MoveBelow{entry, move.to, way.part(at, 1)};
  return MoveBelow{from, entry, way.part(0, at)};
}

}  // namespace blossom::pocket
