#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

struct SimulationOptions {
  double top = 0;                 ///< mm, height of the part's upper face
  double depth = 0;               ///< mm below the top that the pocket has; 0: as deep as the program cuts
  double leave = 0;               ///< mm that were to stay on the walls
  double tolerance = 0.01;        ///< mm within which residue does not count
  std::size_t cells = 4'000'000;  ///< most that the search for residue looks at; above, the tolerance grows
};

struct SimulationResult {
  double gouge = 0;             ///< mm, the deepest cut beyond a wall or the floor
  Vec3 gougeAt = Vec3::Zero();  ///< the tool's tip there
  std::size_t gougeMove = 0;    ///< the number of that move
  double allowance = 0;         ///< mm, the deepest cut into what was to stay on the walls
  std::size_t allowanceMove = 0;
  double missing = 0;  ///< mm by which the deepest cut ends above the floor
  std::size_t deepestMove = 0;
  double ridge = 0;               ///< mm, the highest that a round tool leaves between its passes at the floor
  std::optional<double> residue;  ///< mm2 at the floor; nothing for V bits, whose width there is none
  double resolution = 0;          ///< mm within which residue was looked for
  std::vector<Vec2> residueAt;    ///< some places of it
  double reachable = 0;           ///< mm2 that the tool could open
  std::size_t rapidsInStock = 0;  ///< rapids through material
  std::size_t rapidMove = 0;      ///< the first of them
  Vec3 rapidAt = Vec3::Zero();    ///< its end
};

/// Sweeps the tool along every move and compares with the part.
///
/// Gouge: of each move below the top, the tool's radius there less the least distance of the move to the boundary, lines and
/// arcs in closed form, splines as lines within tolerance / 500; where two cuts meet in a corner, of the place that a
/// control may cut it at (Toolpath::blending) as well. Residue: what the tool can open (all discs of its radius that lie in
/// the part, less what is to be left) and no move at the floor sweeps, by quartering squares until they lie on one side;
/// points within the tolerance of either boundary do not count. Deeper moves also clear what lies above, so the floor is
/// where most is left; a round tool clears as much as it is wide the tolerance above the floor. Rapids may run where cuts
/// have taken the material away (see Cleared). O((moves + boundary / tolerance) log n).
/// @throws Error InvalidInput (no cutter, no moves, not finite, an empty part), Cancelled.
SimulationResult simulate(const Toolpath&, const Region& part, const SimulationOptions& = {},
                          const Progress& = Progress::none());

/// Of this only the gouge.
double gougeOnly(const Toolpath&, const Region& part, const SimulationOptions&, const Progress&);

/// mm from the axis to the cutter's side at a height above its tip.
double radiusAt(const Cutter&, double height);

}  // namespace blossom::pocket
