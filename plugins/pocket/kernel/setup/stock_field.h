#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/vector.h"
#include "geometry/numeric/boxes.h"
#include "geometry/shape/toolpath.h"
#include "geometry/values/box.h"
#include "kernel/path/obstacle.h"
#include "kernel/setup/tool_stages.h"

namespace blossom::pocket {

/// How high material stands over each cell of a grid, as a mill with an upright tool leaves it. Cells are known at their
/// middles; tiles of cells know their highest one, so that what is cut already costs nothing.
class StockField {
 public:
  /// A block. @param cells about as many at most
  StockField(const Bounds&, std::size_t cells);

  /// Lowers each cell to the highest of the triangles over it, or to the bottom where there is none.
  void lowerTo(const Triangles&);

  /// Removes what the cutter sweeps on a straight way of its tip.
  void cut(const Cutter&, const Vec3& from, const Vec3& to);

  /// A place on a straight way where material stands by more than `allowed` mm into the cutter. A cell's breadth at its
  /// border does not count.
  [[nodiscard]] std::optional<Vec3> metBy(const Cutter&, const Vec3& from, const Vec3& to, double allowed) const;
  /// The same of the upright cylinder around a stage of the tool.
  [[nodiscard]] std::optional<Vec3> metBy(const ToolStage&, const Vec3& from, const Vec3& to, double allowed) const;

  [[nodiscard]] double bottom() const { return bottom_; }
  [[nodiscard]] double cell() const { return cell_; }  ///< mm, side of a cell
  [[nodiscard]] double heightAt(std::size_t column, std::size_t row) const { return heights_[row * columns_ + column]; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] Vec2 middleOf(std::size_t column, std::size_t row) const;
  [[nodiscard]] double volume() const;  ///< mm3 of what stands

 private:
  static constexpr std::size_t tile = 16;  ///< cells along its side

  struct Span {
    std::size_t from = 0, to = 0;  ///< the latter excluded
  };
  [[nodiscard]] Span columnsWithin(double low, double high) const;
  [[nodiscard]] Span rowsWithin(double low, double high) const;
  /// Calls `visit(row, columns, tile)` for the rows of all tiles around a box whose highest cell stands above `height`.
  template <class Visit>
  void overTiles(const Box2& around, double height, const Visit& visit) const;
  void measureTile(std::size_t number);
  /// The first cell near a way that stands above what `lowest(middle)` tells.
  template <class Lowest>
  [[nodiscard]] std::optional<Vec3> standing(const Box2& around, double low, const Lowest& lowest) const;

  Vec2 corner_;
  double cell_ = 1, bottom_ = 0;
  std::size_t columns_ = 0, rows_ = 0, tileColumns_ = 0;
  std::vector<double> heights_;
  std::vector<double> highest_;  ///< of each tile
};

}  // namespace blossom::pocket
