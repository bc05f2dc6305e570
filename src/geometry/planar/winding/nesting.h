#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/polygons/polygons.h"

namespace blossom::planar {

/// For every loop the innermost loop that contains it; empty for outermost loops. Exact. O(n log n). @pre the loops neither
/// touch nor cross (see isClear)
std::vector<std::optional<std::size_t>> loopsAround(const std::vector<GridLoop>&, const Progress& = Progress::none());

/// The set of positive winding numbers of loops (counter-clockwise around areas, clockwise around holes). Disjoint loops are
/// only sorted by containment; loops that touch or overlap are evaluated by their winding numbers.
class Nesting {
 public:
  explicit Nesting(std::vector<Loop>, const Progress& = Progress::none());

  /// Whether no loop touches or crosses another or itself.
  [[nodiscard]] bool clear() const { return clear_; }
  /// The loops on the grid, each as an outline; collapsed loops are left out.
  [[nodiscard]] const std::vector<GridPolygon>& snappedLoops() const { return snapped_; }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// When `clear`: a clockwise loop that lies in no other.
  [[nodiscard]] std::optional<std::size_t> strayHole() const;
  /// An outer loop and the holes in it, as numbers of the loops.
  struct Part {
    std::size_t outer = 0;
    std::vector<std::size_t> holes;
  };
  /// The loops sorted into parts when they are clear and parts and holes alternate from the outside in; else nothing.
  [[nodiscard]] std::optional<std::vector<Part>> parts() const;
  /// The same for loops that may touch one another, but neither cross nor run along one another.
  [[nodiscard]] std::optional<std::vector<Part>> touchingParts(const Progress& = Progress::none()) const;
  /// Parts with their holes. @throws Error LimitExceeded, Cancelled (see windingFaces).
  [[nodiscard]] Polygons polygons(const Progress& = Progress::none()) const;

 private:
  using Around = std::vector<std::optional<std::size_t>>;  ///< of each snapped loop the one that it lies in
  [[nodiscard]] std::optional<std::vector<Part>> partsBy(const Around&) const;

  std::vector<Loop> loops_;
  Grid grid_;
  std::vector<GridPolygon> snapped_;
  std::vector<std::size_t> places_;  ///< which loop a snapped one comes from
  bool clear_ = true;
  std::vector<int> turns_;  ///< of the snapped loops that stay apart
  Around around_;
};

}  // namespace blossom::planar
