#include "manipulators/path_points.h"

#include <algorithm>
#include <utility>

#include "kernel/morph/blossom_path.h"

namespace blossom::minkowski {

PathPoints::PathPoints(const Value& path, std::size_t arguments) : arguments_(arguments) {
  for (const Value& point : path)
    if (point.is_array() && point.size() == arguments) points_.push_back(point.get<Point>());
  if (points_.empty()) points_ = diagonal();
}

std::vector<PathPoints::Point> PathPoints::diagonal() const { return {Point(arguments_, 0), Point(arguments_, 1)}; }

Value PathPoints::written() const { return isDiagonal() ? Value::array() : Value(points_); }

double PathPoints::placeOf(std::size_t point) const {
  return points_.size() < 2 ? 0 : static_cast<double>(point) / static_cast<double>(points_.size() - 1);
}

PathPoints::Point PathPoints::at(double u) const { return pointOfPath(points_, std::clamp(u, 0.0, 1.0)); }

void PathPoints::set(std::size_t point, std::size_t argument, double value) {
  points_.at(point).at(argument) = std::clamp(value, 0.0, 1.0);
}

void PathPoints::insert(std::size_t before, Point point) {
  points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(before), std::move(point));
}

void PathPoints::remove(std::size_t point) {
  if (points_.size() <= 2)
    points_ = diagonal();
  else
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(point));
}

}  // namespace blossom::minkowski
