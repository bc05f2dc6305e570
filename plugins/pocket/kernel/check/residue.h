#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

struct ResidueProblem {
  std::vector<Stroke> cut;  ///< ways of the tool's centre at one height
  double radius = 0;        ///< mm, of the tool
  double corner = 0;        ///< mm, of its corners: what it leaves between its ways by more than the tolerance counts
  double leave = 0;         ///< mm to stay on the walls
  double tolerance = 0.01;  ///< mm that a point must lie within what the tool opens, and beyond what it swept, to count
  std::size_t cells = 4'000'000;
};

struct Residue {
  double area = 0;           ///< mm2
  double reachable = 0;      ///< mm2 that the tool can open
  double resolution = 0;     ///< mm, the tolerance that was kept
  double ridge = 0;          ///< mm, the height of what round corners leave at most where the tool's centre may be
  std::vector<Vec2> places;  ///< some of them, far apart
};

/// What a tool can open of a part and did not sweep. O(boundary / tolerance log n).
/// @throws Error as ClearanceDiagram does, Cancelled.
Residue residueOf(const Region& part, const ResidueProblem&, const Progress&);

}  // namespace blossom::pocket
