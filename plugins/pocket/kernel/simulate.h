#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/region.h"
#include "geometry/toolpath.h"

namespace blossom::pocket {

struct SimulationOptions {
  double top = 0;                 ///< mm, height of the part's upper face
  double depth = 0;               ///< mm below the top that the pocket has; 0: as deep as the program cuts
  double leave = 0;               ///< mm that were to stay on the walls
  double tolerance = 0.01;        ///< mm within which residue does not count
  std::size_t cells = 4'000'000;  ///< most that the search for residue looks at; above, the tolerance grows
};

struct SimulationResult {
  double gouge = 0;               ///< mm, the deepest cut beyond a wall or the floor
  Vec3 gougeAt = Vec3::Zero();    ///< the tool's tip there
  std::optional<double> residue;  ///< mm2 at the floor; nothing for V bits, whose width there is none
  double resolution = 0;          ///< mm within which residue was looked for
  std::vector<Vec2> residueAt;    ///< some places of it
  double reachable = 0;           ///< mm2 that the tool could open
  std::size_t rapidsInStock = 0;  ///< rapids through material
  Vec3 rapidAt = Vec3::Zero();    ///< the end of the first of them
};

/// Sweeps the tool along every move and compares with the part.
///
/// Gouge: of each move below the top, the tool's radius there less the least distance of the move to the boundary, lines and
/// arcs in closed form, splines as lines within tolerance / 500. Residue: what the tool can open (all discs of its radius
/// that lie in the part, less what is to be left) and no move at the floor sweeps, by quartering squares until they lie on
/// one side; points within the tolerance of either boundary do not count. Deeper moves also clear what lies above, so the
/// floor is where most is left. O((moves + boundary / tolerance) log n).
/// @throws Error InvalidInput (no cutter, no moves, not finite, an empty part), Cancelled.
SimulationResult simulate(const Toolpath&, const Region& part, const SimulationOptions& = {},
                          const Progress& = Progress::none());

/// mm from the axis to the cutter's side at a height above its tip.
double radiusAt(const Cutter&, double height);

}  // namespace blossom::pocket
