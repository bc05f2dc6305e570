#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

struct ResidueProblem {
  std::vector<Stroke> cut;  ///< paths of the tool's centre at one height
  double radius = 0;        ///< mm, of the tool
  double corner = 0;        ///< mm, corner radius of the tool: ridges between its paths higher than the tolerance count
  double leave = 0;         ///< mm, stock to leave on the walls
  double tolerance =
      0.01;  ///< mm, minimum distance of a point from the borders of the reachable and of the swept area to count
  std::size_t cells = 4'000'000;
};

struct Residue {
  double area = 0;           ///< mm2
  double reachable = 0;      ///< mm2, opening of the part by the tool
  double resolution = 0;     ///< mm, the tolerance achieved
  double ridge = 0;          ///< mm, maximum height of ridges left by round corners where the tool's centre may be
  std::vector<Vec2> places;  ///< some points of the residue, far apart
};

/// The opening of a part by a tool minus the area the tool sweeps. O(boundary / tolerance log n).
/// @throws Error as ClearanceDiagram, Cancelled.
Residue residueOf(const Region& part, const ResidueProblem&, const Progress&);

}  // namespace blossom::pocket
