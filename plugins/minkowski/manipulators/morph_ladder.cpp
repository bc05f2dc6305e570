#include "manipulators/morph_ladder.h"

#include <algorithm>

#include "core/error.h"
#include "feature/frame_keys.h"
#include "manipulators/path_points.h"

namespace blossom::minkowski {
namespace {

double distanceToLeg(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double length = way.squaredNorm();
  const double part = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
  return (p - a - part * way).norm();
}

/// One level of de Casteljau's algorithm.
void blendNeighbours(std::vector<Vec2>& points, double t) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = (1 - t) * points[i] + t * points[i + 1];
  points.pop_back();
}

}  // namespace

double timeOfFrame(const Value& parameters, int frame, int frames) {
  const double place = frames < 2 ? 0 : static_cast<double>(frame) / (frames - 1);
  const double plain = frames < 2 ? parameters.at("t").get<double>() : place;
  const Value& keys = parameters.at("keys");
  if (keys.empty()) return plain;
  try {
    return keyedTime(frameKeysOf(keys), place, frames);
  } catch (const Error&) {
    return plain;  // the morph tells what is wrong with them
  }
}

std::vector<double> levelsSeen(const Value& parameters, std::size_t shapes, std::optional<double> seen) {
  const std::size_t degree = shapes > 0 ? shapes - 1 : 0;
  const Value& blossom = parameters.at("blossom");
  if (!blossom.empty() && !seen) return blossom.get<std::vector<double>>();
  const double u = seen.value_or(parameters.at("t").get<double>());
  return PathPoints(parameters.at("path"), degree).at(u);
}

std::optional<double> placeSeen(const Value& parameters, std::optional<double> seen) {
  if (!parameters.at("blossom").empty() && !seen) return std::nullopt;
  return seen.value_or(parameters.at("t").get<double>());
}

bool hasLadder(const Value& parameters, std::size_t shapes) {
  const auto degree = parameters.at("degree").get<std::size_t>();
  return parameters.at("knots").empty() && (degree == 0 || degree + 1 == shapes);
}

std::vector<std::vector<Vec3>> ladderOfPoints(std::vector<Vec2> points, const std::vector<double>& t) {
  std::vector<std::vector<Vec3>> levels;
  for (const double level : t) {
    if (points.size() < 3) break;
    blendNeighbours(points, level);
    std::vector<Vec3>& polygon = levels.emplace_back();
    for (const Vec2& p : points) polygon.emplace_back(p.x(), p.y(), 0);
  }
  return levels;
}

std::optional<LadderLeg> legNear(const Vec2& place, std::vector<Vec2> points, const std::vector<double>& t, double reach) {
  std::optional<LadderLeg> nearest;
  for (std::size_t level = 1; level <= t.size() && points.size() > 1; ++level) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double distance = distanceToLeg(place, points[i], points[i + 1]);
      if (distance > reach) continue;
      reach = distance;
      nearest = LadderLeg{level, i};
    }
    blendNeighbours(points, t[level - 1]);
  }
  return nearest;
}

std::pair<Vec2, Vec2> endsOf(const LadderLeg& leg, std::vector<Vec2> points, const std::vector<double>& t) {
  for (std::size_t level = 1; level < leg.level; ++level) blendNeighbours(points, t[level - 1]);
  return {points.at(leg.index), points.at(leg.index + 1)};
}

}  // namespace blossom::minkowski
