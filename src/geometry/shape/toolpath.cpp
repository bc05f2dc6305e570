#include "geometry/shape/toolpath.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace blossom {

Vec3 startOf(const Toolpath& path, std::size_t i) { return i == 0 ? path.start : path.moves[i - 1].to; }

double sweepOf(const Vec3& from, const ToolMove& move) {
  if (move.turn == 0) return 0;
  const Vec2 first = from.head<2>() - move.center, last = move.to.head<2>() - move.center;
  constexpr double sameEnd = 1e-9;
  if ((first - last).norm() <= sameEnd) return move.turn * fullTurn;
  double sweep = std::atan2(cross(first, last), first.dot(last));
  if (move.turn > 0 && sweep < 0) sweep += fullTurn;
  if (move.turn < 0 && sweep > 0) sweep -= fullTurn;
  return sweep;
}

double lengthOf(const Vec3& from, const ToolMove& move) {
  if (move.turn == 0) return (move.to - from).norm();
  return std::hypot(sweepOf(from, move) * (from.head<2>() - move.center).norm(), move.to.z() - from.z());
}

std::vector<Vec3> polylineOf(const Vec3& from, const ToolMove& move, double chord) {
  if (move.turn == 0) return {from, move.to};
  const double sweep = sweepOf(from, move);
  const Vec2 first = from.head<2>() - move.center;
  const double start = std::atan2(first.y(), first.x());
  const double radius = first.norm();
  const double endRadius = (move.to.head<2>() - move.center).norm();
  const double step = chord < radius ? 2 * std::acos(1 - chord / radius) : fullTurn / 4;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / std::min(step, fullTurn / 8))));
  std::vector<Vec3> points{from};
  for (int k = 1; k < count; ++k) {
    const double t = static_cast<double>(k) / count;
    const double angle = start + t * sweep;
    const Vec2 at = move.center + (radius + t * (endRadius - radius)) * Vec2(std::cos(angle), std::sin(angle));
    points.emplace_back(at.x(), at.y(), from.z() + t * (move.to.z() - from.z()));
  }
  points.push_back(move.to);
  return points;
}

double lengthOf(const Toolpath& path) {
  double sum = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) sum += lengthOf(startOf(path, i), path.moves[i]);
  return sum;
}

std::optional<double> secondsOf(const Toolpath& path) {
  double minutes = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const ToolMove& move = path.moves[i];
    const double feed = move.kind == MoveKind::Rapid ? path.rapidFeed : move.feed;
    if (!(feed > 0)) return std::nullopt;
    minutes += lengthOf(startOf(path, i), move) / feed;
  }
  return minutes * 60;
}

namespace {

Segment segmentOf(const Vec3& from, const ToolMove& move) {
  if (move.turn == 0) return Line2{from.head<2>(), move.to.head<2>()};
  const Vec2 first = from.head<2>() - move.center;
  return Arc2{move.center, first.norm(), std::atan2(first.y(), first.x()), sweepOf(from, move)};
}

}  // namespace

Curves drawingOf(const Toolpath& path) {
  Curves drawing;
  bool cutting = false;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const ToolMove& move = path.moves[i];
    const Vec3 from = startOf(path, i);
    if (move.kind == MoveKind::Rapid) {
      cutting = false;
      continue;
    }
    if (move.turn == 0 && move.to.head<2>() == from.head<2>()) continue;
    if (!cutting) drawing.paths.emplace_back();
    cutting = true;
    drawing.paths.back().segments.push_back(segmentOf(from, move));
  }
  return drawing;
}

}  // namespace blossom
