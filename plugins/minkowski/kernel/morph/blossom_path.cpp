#include "kernel/morph/blossom_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace blossom::minkowski {

void checkPath(std::span<const Arguments> points, std::size_t shapes) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].size() + 1 != shapes)
      throw Error(ErrorCode::InvalidParameter,
                  fmt::format("Point {} of the path has {} {}; with {} control shapes it takes {}.", k + 1, points[k].size(),
                              points[k].size() == 1 ? "number" : "numbers", shapes, shapes - 1),
                  "Give one number of 0 to 1 for each control shape after the first.");
    for (const double t : points[k])
      if (!(t >= 0 && t <= 1))
        throw Error(ErrorCode::InvalidParameter,
                    fmt::format("Every number of the path must lie between 0 and 1; one of point {} is {}.", k + 1, t));
  }
}

Arguments pointOfPath(std::span<const Arguments> points, double u) {
  if (!(u >= 0 && u <= 1))
    throw Error(ErrorCode::InvalidParameter, fmt::format("A path goes from t = 0 to 1; {} lies beyond it.", u),
                "Give a t within them, or leave out the path.");
  const std::size_t ways = points.size() - 1;
  if (ways == 0) return points.front();
  const double along = u * static_cast<double>(ways);
  const std::size_t from = std::min(static_cast<std::size_t>(along), ways - 1);
  const double part = along - static_cast<double>(from);
  Arguments t;
  for (std::size_t i = 0; i < points[from].size(); ++i) t.push_back(std::lerp(points[from][i], points[from + 1][i], part));
  return t;
}

}  // namespace blossom::minkowski
