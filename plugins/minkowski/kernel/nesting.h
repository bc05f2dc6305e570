#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "kernel/grid.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// For every loop the one directly around it, nothing for those in none. Exact. O(n log n).
/// @pre the loops neither touch nor cross (see isClear)
std::vector<std::optional<std::size_t>> loopsAround(const std::vector<GridLoop>&, const Progress& = Progress::none());

/// Loops, counter-clockwise around what they enclose and clockwise around what they leave out, as the set of their positive
/// winding numbers. Loops that stay apart are sorted into one another as they are; those that touch or lie over one another
/// are read off their exact arrangement.
class Nesting {
 public:
  explicit Nesting(std::vector<Loop>, const Progress& = Progress::none());

  /// Whether the loops stay apart from one another and from themselves.
  [[nodiscard]] bool clear() const { return clear_; }
  /// The loops on the grid, one outline each; those that collapse left out.
  [[nodiscard]] const std::vector<GridPolygon>& snappedLoops() const { return snapped_; }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// Of loops that stay apart: a clockwise one that lies in nothing.
  [[nodiscard]] std::optional<std::size_t> strayHole() const;
  /// Parts with their holes. @throws Error LimitExceeded, Cancelled (see windingFaces).
  [[nodiscard]] Polygons polygons(const Progress& = Progress::none()) const;

 private:
  [[nodiscard]] bool isProper() const;

  std::vector<Loop> loops_;
  Grid grid_;
  std::vector<GridPolygon> snapped_;
  std::vector<std::size_t> places_;  ///< which loop a snapped one comes from
  bool clear_ = true;
  std::vector<int> turns_;  ///< of the snapped loops that stay apart
  std::vector<std::optional<std::size_t>> around_;
};

}  // namespace blossom::minkowski
