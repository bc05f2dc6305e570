#include "geometry/planar/single_point.h"

namespace blossom {

std::optional<Vec2> singlePoint(std::span<const Path> drawing) {
  if (drawing.size() != 1 || drawing.front().segments.size() != 1) return std::nullopt;
  const auto* line = std::get_if<Line2>(&drawing.front().segments.front());
  return line && line->from == line->to ? std::optional(line->from) : std::nullopt;
}

Curves pointDrawing(const Vec2& at) { return {{Path{{Line2{at, at}}, false, {}, {}}}, {}}; }

}  // namespace blossom
