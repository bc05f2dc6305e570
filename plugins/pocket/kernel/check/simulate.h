#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

struct SimulationOptions {
  double top = 0;                 ///< mm, height of the part's upper face
  double depth = 0;               ///< mm, depth of the pocket below the top; 0: as deep as the program cuts
  double leave = 0;               ///< mm, stock to leave on the walls
  double tolerance = 0.01;        ///< mm, residue narrower than this does not count
  std::size_t cells = 4'000'000;  ///< maximum number of cells of the search for residue; above, the tolerance is raised
};

struct SimulationResult {
  double gouge = 0;             ///< mm, depth of the deepest cut beyond a wall or the floor
  Vec3 gougeAt = Vec3::Zero();  ///< position of the tool's tip there
  std::size_t gougeMove = 0;    ///< index of that move
  double allowance = 0;         ///< mm, depth of the deepest cut into the stock to leave on the walls
  std::size_t allowanceMove = 0;
  double missing = 0;  ///< mm, distance of the deepest cut above the floor
  std::size_t deepestMove = 0;
  double ridge = 0;               ///< mm, maximum height of ridges between passes at the floor, left by a round tool
  std::optional<double> residue;  ///< mm2 at the floor; empty for V bits, whose width there is 0
  double resolution = 0;          ///< mm, resolution of the search for residue
  std::vector<Vec2> residueAt;    ///< some points of it
  double reachable = 0;           ///< mm2, opening of the part by the tool
  std::size_t rapidsInStock = 0;  ///< number of rapids through material
  std::size_t rapidMove = 0;      ///< index of the first of them
  Vec3 rapidAt = Vec3::Zero();    ///< its end
};

/// Sweeps the tool along every move and compares the swept volume with the part.
///
/// Gouge: for each move below the top, the tool's radius there minus the minimum distance of the move to the boundary; lines
/// and arcs in closed form, splines as lines within tolerance / 500. Where two cuts meet in a corner, also for the corner as
/// the control may round it (Toolpath::blending). Residue: the opening of the part by the tool (all discs of its radius in
/// the part, less the stock to leave) minus the area swept at the floor, by quartering squares until each lies on one side;
/// points within the tolerance of either boundary do not count. Deeper moves also clear everything above, so most material
/// is left at the floor; a round tool clears there as much as its width at the height of the tolerance. Rapids may run where
/// cuts have removed the material (see Cleared). O((moves + boundary / tolerance) log n).
/// @throws Error InvalidInput (no cutter, no moves, not finite, an empty part), Cancelled.
SimulationResult simulate(const Toolpath&, const Region& part, const SimulationOptions& = {},
                          const Progress& = Progress::none());

/// The gouge alone.
double gougeOnly(const Toolpath&, const Region& part, const SimulationOptions&, const Progress&);

/// mm, radius of the cutter at a height above its tip.
double radiusAt(const Cutter&, double height);

}  // namespace blossom::pocket
