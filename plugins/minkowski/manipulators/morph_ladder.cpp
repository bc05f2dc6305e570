#include "manipulators/morph_ladder.h"

namespace blossom::minkowski {

std::vector<double> levelsSeen(const Value& parameters, std::size_t shapes, std::optional<double> seen) {
  const std::size_t degree = shapes > 0 ? shapes - 1 : 0;
  const Value& blossom = parameters.at("blossom");
  if (!blossom.empty() && !seen) return blossom.get<std::vector<double>>();
  return std::vector<double>(degree, seen.value_or(parameters.at("t").get<double>()));
}

bool hasLadder(const Value& parameters) {
  const auto knots = parameters.find("knots");
  return knots == parameters.end() || knots->empty();
}

std::vector<std::vector<Vec3>> ladderOfPoints(std::vector<Vec2> points, const std::vector<double>& t) {
  std::vector<std::vector<Vec3>> levels;
  for (const double level : t) {
    if (points.size() < 3) break;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = (1 - level) * points[i] + level * points[i + 1];
    points.pop_back();
    std::vector<Vec3>& polygon = levels.emplace_back();
    for (const Vec2& p : points) polygon.emplace_back(p.x(), p.y(), 0);
  }
  return levels;
}

}  // namespace blossom::minkowski
