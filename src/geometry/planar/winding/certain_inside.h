#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/winding/bit_raster.h"

namespace blossom::planar {

struct CertainInsideOptions {
  double fewestPairs = 4'000;  ///< of an edge and a corner; the boundary of a sum of fewer is found as quickly without
  double wordsOfPair = 64;     ///< 64 cells each that may be marked for a pair
};

/// Square cells of which every point certainly lies in the interior of A + B: cells that are wholly inside one of them,
/// moved by points of the boundary of the other. Together they have no hole, so that a closed path through them winds around
/// nothing else.
class CertainInside {
 public:
  /// A run of cells, and the run beside it towards the first run of their part.
  struct Run {
    int row, first, last;  ///< cells [first, last)
    int parent = -1;       ///< -1: the first run of a part
    int door = 0;          ///< column of a cell that both runs have
  };

  /// Whether the cells of the box about two points are all inside.
  [[nodiscard]] bool contains(const GridPoint& p, const GridPoint& q) const;
  /// Whether every edge of the sum that begins or ends there lies within cells that are inside.
  [[nodiscard]] bool isDeep(const GridPoint&) const;

  /// Those of a part come one after the other, each after its parent.
  [[nodiscard]] std::span<const Run> runs() const { return runs_; }
  /// @pre within the sum
  [[nodiscard]] int rowOf(std::int64_t y) const { return static_cast<int>((y - low_.y) >> shift_); }
  /// @pre a cell that is inside contains it
  [[nodiscard]] std::size_t runAt(const GridPoint&) const;
  /// The middle of a cell.
  [[nodiscard]] GridPoint middle(int column, int row) const;
  [[nodiscard]] GridPoint corner(int column, int row) const;
  [[nodiscard]] const BitRaster& cells() const { return cells_; }
  /// Edges of the whole convolution before equal ones are joined.
  [[nodiscard]] double pairs() const { return pairs_; }

 private:
  friend std::optional<CertainInside> certainInside(std::span<const GridPolygon>, std::span<const GridPolygon>,
                                                    const Progress&, const Effort&, const CertainInsideOptions&);
  void makeRuns();

  GridPoint low_;
  int shift_ = 0;  ///< a cell is 2^shift units wide
  double pairs_ = 0;
  BitRaster cells_, deep_;
  std::vector<Run> runs_;
  std::vector<std::vector<std::uint32_t>> runsOfRow_;  ///< from left to right
};

/// Nothing where A and B have so few pairs of edges and corners that it is not worth the time. The cells are as small as is
/// worth for the number of pairs. About as much work as that of the pairs, on all cores.
/// @throws Error Cancelled; LimitExceeded above two thousand million pairs; TooMuchWork
std::optional<CertainInside> certainInside(std::span<const GridPolygon> a, std::span<const GridPolygon> b, const Progress&,
                                           const Effort& = Effort(), const CertainInsideOptions& = {});

}  // namespace blossom::planar
