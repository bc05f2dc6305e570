#include "kernel/setup/stock_mesh.h"

#include <algorithm>
#include <array>

namespace blossom::pocket {

namespace {

/// A grid of points: the middles of the cells, and around them the rim of the field.
class StockSurface {
 public:
  explicit StockSurface(const StockField& field)
      : field_(field), across_(field.columns() + 2), down_(field.rows() + 2), above_(across_ * down_), below_(above_) {
    for (std::size_t row = 0; row < down_; ++row)
      for (std::size_t column = 0; column < across_; ++column) addPoints(column, row);
  }

  Mesh mesh() {
    for (std::size_t row = 0; row + 1 < down_; ++row)
      for (std::size_t column = 0; column + 1 < across_; ++column) addSquare(column, row);
    for (std::size_t column = 0; column + 1 < across_; ++column) {
      addWall(at(column, 0), at(column + 1, 0));
      addWall(at(column + 1, down_ - 1), at(column, down_ - 1));
    }
    for (std::size_t row = 0; row + 1 < down_; ++row) {
      addWall(at(across_ - 1, row), at(across_ - 1, row + 1));
      addWall(at(0, row + 1), at(0, row));
    }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::size_t at(std::size_t column, std::size_t row) const { return row * across_ + column; }

  /// One point where nothing stands.
  void addPoints(std::size_t column, std::size_t row) {
    const std::size_t c = std::clamp<std::size_t>(column, 1, across_ - 2) - 1;
    const std::size_t r = std::clamp<std::size_t>(row, 1, down_ - 2) - 1;
    const auto shifted = [&](std::size_t i, std::size_t count) { return i == 0 ? -0.5 : i + 1 == count ? 0.5 : 0.0; };
    const Vec2 place = field_.middleOf(c, r) + field_.cell() * Vec2(shifted(column, across_), shifted(row, down_));
    const double height = field_.heightAt(c, r);
    below_[at(column, row)] = static_cast<int>(mesh_.points.size());
    mesh_.points.emplace_back(place.x(), place.y(), field_.bottom());
    above_[at(column, row)] = below_[at(column, row)];
    if (height <= field_.bottom()) return;
    above_[at(column, row)] = static_cast<int>(mesh_.points.size());
    mesh_.points.emplace_back(place.x(), place.y(), height);
  }

  [[nodiscard]] bool stands(std::size_t i) const { return above_[i] != below_[i]; }

  /// Two triangles on top, along the diagonal that bends less, and the same below.
  void addSquare(std::size_t column, std::size_t row) {
    const std::array<std::size_t, 4> c{at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)};
    if (std::none_of(c.begin(), c.end(), [&](std::size_t i) { return stands(i); })) return;
    const auto height = [&](std::size_t i) { return mesh_.points[static_cast<std::size_t>(above_[i])].z(); };
    const bool isFirst = std::abs(height(c[0]) - height(c[2])) <= std::abs(height(c[1]) - height(c[3]));
    const std::array<std::array<std::size_t, 3>, 2> halves =
        isFirst ? std::array{std::array{c[0], c[1], c[2]}, std::array{c[0], c[2], c[3]}}
                : std::array{std::array{c[1], c[2], c[3]}, std::array{c[1], c[3], c[0]}};
    for (const auto& t : halves) {
      if (std::none_of(t.begin(), t.end(), [&](std::size_t i) { return stands(i); })) continue;
      addFace({above_[t[0]], above_[t[1]], above_[t[2]]});
      addFace({below_[t[2]], below_[t[1]], below_[t[0]]});
    }
  }

  /// Below the rim, outward to the right of the way from a to b.
  void addWall(std::size_t a, std::size_t b) {
    if (stands(a)) addFace({below_[a], below_[b], above_[a]});
    if (stands(b)) addFace({above_[a], below_[b], above_[b]});
  }

  void addFace(const std::array<int, 3>& corners) { mesh_.addFace(corners); }

  const StockField& field_;
  std::size_t across_, down_;
  std::vector<int> above_, below_;
  Mesh mesh_;
};

}  // namespace

Mesh meshOf(const StockField& field) { return StockSurface(field).mesh(); }

}  // namespace blossom::pocket
