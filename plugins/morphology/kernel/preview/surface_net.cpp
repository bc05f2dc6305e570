#include "kernel/preview/surface_net.h"

namespace blossom::morphology {

namespace {

class SurfaceNet {
 public:
  explicit SurfaceNet(const GridValues& grid) : grid_(grid), cornerOf_(grid.values.size(), -1) {}

  Mesh made(const Progress& progress) {
    for (int z = 0; z + 1 < grid_.count[2]; ++z) {
      progress.check();
      for (int y = 0; y + 1 < grid_.count[1]; ++y)
        for (int x = 0; x + 1 < grid_.count[0]; ++x) addCorner(x, y, z);
    }
    for (int z = 1; z + 1 < grid_.count[2]; ++z) {
      progress.check();
      for (int y = 1; y + 1 < grid_.count[1]; ++y)
        for (int x = 1; x + 1 < grid_.count[0]; ++x)
          for (std::size_t axis = 0; axis < 3; ++axis) addQuad({x, y, z}, axis);
    }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] float at(int x, int y, int z) const { return grid_.values[grid_.index(x, y, z)]; }

  void addCorner(int x, int y, int z) {
    Vec3 sum = Vec3::Zero();
    int crossings = 0;
    for (int low = 0; low < 8; ++low)
      for (int axis = 0; axis < 3; ++axis) {
        const int high = low | (1 << axis);
        if (high == low) continue;
        const auto corner = [](int k) { return Vec3(k & 1, k >> 1 & 1, k >> 2); };
        const auto value = [&](int k) { return static_cast<double>(at(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))); };
        const double from = value(low), to = value(high);
        if ((from > 0) == (to > 0)) continue;
        sum += corner(low) + from / (from - to) * (corner(high) - corner(low));
        ++crossings;
      }
    if (crossings == 0) return;
    cornerOf_[grid_.index(x, y, z)] = static_cast<int>(mesh_.points.size());
    mesh_.points.emplace_back(grid_.low + grid_.step * (Vec3(x, y, z) + sum / crossings));
  }

  /// Around the edge from a place on along an axis.
  void addQuad(const std::array<int, 3>& p, std::size_t axis) {
    std::array<int, 3> q = p;
    ++q[axis];
    const bool fromOutside = at(p[0], p[1], p[2]) > 0, toOutside = at(q[0], q[1], q[2]) > 0;
    if (fromOutside == toOutside) return;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<int, 4> quad{};
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> cell = p;
      if (k == 0 || k == 3) --cell[u];
      if (k < 2) --cell[v];
      quad[toOutside ? k : 3 - k] = cornerOf_[grid_.index(cell[0], cell[1], cell[2])];
    }
    mesh_.addFace(quad);
  }

  const GridValues& grid_;
  std::vector<int> cornerOf_;  ///< of each cell, by its lowest place
  Mesh mesh_;
};

}  // namespace

Mesh surfaceNet(const GridValues& grid, const Progress& progress) { return SurfaceNet(grid).made(progress); }

}  // namespace blossom::morphology
