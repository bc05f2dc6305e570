#include "kernel/preview/distance_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/mesh/triangle_distance.h"

namespace blossom::morphology {

namespace {

constexpr int margin = 2;  // places around the surface

/// Where a line parallel to z meets a triangle, and whether it enters there, which is where the triangle looks down.
std::optional<std::pair<double, int>> crossing(const Triangle3& t, double x, double y) {
  const auto side = [&](const Vec3& p, const Vec3& q) {
    return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
  };
  const double a = side(t[1], t[2]), b = side(t[2], t[0]), c = side(t[0], t[1]);
  const bool up = a > 0 && b > 0 && c > 0, down = a < 0 && b < 0 && c < 0;
  if (!up && !down) return std::nullopt;
  return std::pair((a * t[0].z() + b * t[1].z() + c * t[2].z()) / (a + b + c), down ? 1 : -1);
}

}  // namespace

DistanceGrid::DistanceGrid(std::span<const Triangle3> triangles, double step, const Progress& progress)
    : triangles_(triangles), step_(step) {
  for (const Triangle3& t : triangles)
    for (const Vec3& p : t) box_.add(p);
  low_ = box_.low - margin * step * Vec3::Ones();
  std::size_t places = 1;
  for (int k = 0; k < 3; ++k) {
    count_[static_cast<std::size_t>(k)] = static_cast<int>(std::ceil((box_.high[k] - box_.low[k]) / step)) + 2 * margin + 1;
    places *= static_cast<std::size_t>(count_[static_cast<std::size_t>(k)]);
  }
  nearest_.assign(places, -1);
  distances_.assign(places, std::numeric_limits<float>::infinity());
  findBesideSurface(progress);
  handOn(progress);
  tellSides(progress);
}

/// The first and last number along each axis of the places at most a step beside the box of a triangle.
std::array<std::array<int, 2>, 3> DistanceGrid::placesBeside(const Triangle3& t) const {
  const Box3 box = boxOf(t);
  std::array<std::array<int, 2>, 3> range{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    range[k] = {std::max(0, static_cast<int>(std::ceil((box.min()[axis] - low_[axis]) / step_ - 1))),
                std::min(count_[k] - 1, static_cast<int>(std::floor((box.max()[axis] - low_[axis]) / step_ + 1)))};
  }
  return range;
}

void DistanceGrid::offer(int x, int y, int z, int triangle) {
  const std::size_t i = index(x, y, z);
  if (triangle < 0 || nearest_[i] == triangle) return;
  const Vec3 p = place(x, y, z);
  const auto distance =
      static_cast<float>((closestOnTriangle(p, triangles_[static_cast<std::size_t>(triangle)]) - p).norm());
  if (!(distance < distances_[i])) return;
  distances_[i] = distance;
  nearest_[i] = triangle;
}

void DistanceGrid::findBesideSurface(const Progress& progress) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (t % 1024 == 0) progress.check();
    const auto range = placesBeside(triangles_[t]);
    for (int z = range[2][0]; z <= range[2][1]; ++z)
      for (int y = range[1][0]; y <= range[1][1]; ++y)
        for (int x = range[0][0]; x <= range[0][1]; ++x) offer(x, y, z, static_cast<int>(t));
  }
}

/// Forwards and backwards through all places, from those before.
void DistanceGrid::handOn(const Progress& progress) {
  for (const int way : {1, -1, 1, -1})
    for (int k = 0; k < count_[2]; ++k) {
      progress.check();
      const int z = way > 0 ? k : count_[2] - 1 - k;
      for (int j = 0; j < count_[1]; ++j) {
        const int y = way > 0 ? j : count_[1] - 1 - j;
        for (int i = 0; i < count_[0]; ++i) {
          const int x = way > 0 ? i : count_[0] - 1 - i;
          if (i > 0) offer(x, y, z, nearest_[index(x - way, y, z)]);
          if (j > 0) offer(x, y, z, nearest_[index(x, y - way, z)]);
          if (k > 0) offer(x, y, z, nearest_[index(x, y, z - way)]);
        }
      }
    }
}

/// Lines lie a little beside the places: edges of most models are parallel to the grid.
void DistanceGrid::tellSides(const Progress& progress) {
  constexpr double besideX = 1.234e-4, besideY = 2.718e-4;
  std::vector<std::vector<std::pair<double, int>>> lines(static_cast<std::size_t>(count_[0]) *
                                                         static_cast<std::size_t>(count_[1]));
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (t % 1024 == 0) progress.check();
    const auto range = placesBeside(triangles_[t]);
    for (int y = range[1][0]; y <= range[1][1]; ++y)
      for (int x = range[0][0]; x <= range[0][1]; ++x) {
        const Vec3 p = place(x, y, 0);
        if (const auto met = crossing(triangles_[t], p.x() + besideX * step_, p.y() + besideY * step_))
          lines[index(x, y, 0)].push_back(*met);
      }
  }
  for (int y = 0; y < count_[1]; ++y)
    for (int x = 0; x < count_[0]; ++x) {
      auto& line = lines[index(x, y, 0)];
      std::sort(line.begin(), line.end());
      int winding = 0;
      auto next = line.begin();
      for (int z = 0; z < count_[2]; ++z) {
        for (; next != line.end() && next->first < place(x, y, z).z(); ++next) winding += next->second;
        if (winding > 0) distances_[index(x, y, z)] *= -1;
      }
    }
}

double DistanceGrid::operator()(const Vec3& p) const {
  std::array<int, 3> cell{};
  std::array<double, 3> share{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double at = (p[axis] - low_[axis]) / step_;
    if (!(at >= 0 && at < count_[k] - 1)) return (p - p.cwiseMax(box_.low).cwiseMin(box_.high)).norm();
    cell[k] = static_cast<int>(at);
    share[k] = at - cell[k];
  }
  const auto along = [&](int y, int z) {
    const std::size_t i = index(cell[0], cell[1] + y, cell[2] + z);
    return (1 - share[0]) * static_cast<double>(distances_[i]) + share[0] * static_cast<double>(distances_[i + 1]);
  };
  const double low = (1 - share[1]) * along(0, 0) + share[1] * along(1, 0),
               high = (1 - share[1]) * along(0, 1) + share[1] * along(1, 1);
  return (1 - share[2]) * low + share[2] * high;
}

}  // namespace blossom::morphology
