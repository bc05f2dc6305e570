#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/planar/winding/certain_inside.h"
#include "geometry/planar/winding/convolution.h"

namespace blossom::planar {

/// The edges of a convolution that are left out because they lie inside the sum, and what takes their place there: paths
/// inside between the ends that others do not meet, and loops around all of the inside that keep its winding number
/// positive. Outside of it all winding numbers stay.
class LeftOutEdges {
 public:
  explicit LeftOutEdges(const CertainInside&);

  /// Whether the edge is left out.
  bool take(const CountedEdge&);
  /// Those that others of the same inside have taken, too.
  void add(LeftOutEdges&&);
  /// Edges that close the cycles again.
  /// @throws Error LimitExceeded above some hundred million edges at one height
  std::vector<CountedEdge> closings();

 private:
  using End = std::pair<GridPoint, int>;  ///< as often as edges begin there, less those that end there

  void countHeights(const CountedEdge&);
  void addEnd(const GridPoint& at, int count);
  void joinIfMany();
  void joinEnds();
  std::vector<CountedEdge> paths();
  void addAlong(std::vector<End>&, const GridPoint& door, std::vector<CountedEdge>&);
  void addPath(const CountedEdge&, std::vector<CountedEdge>&);
  [[nodiscard]] int largestChange() const;
  void addLoops(int times, std::vector<CountedEdge>&) const;
  void addUpright(int times, std::vector<CountedEdge>&) const;

  const CertainInside& inside_;
  std::vector<End> ends_;
  std::size_t full_ = 200'000;
  std::vector<std::int64_t> heights_;  ///< for each row: more edges than pass the row before
  bool any_ = false;
};

}  // namespace blossom::planar
