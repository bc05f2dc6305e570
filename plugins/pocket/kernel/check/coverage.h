#pragma once
#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/check/simulate.h"
#include "kernel/check/uncut.h"

namespace blossom::pocket {

/// How the area of a part at the floor is divided, mm2.
struct Coverage {
  double part = 0;
  double cut = 0;          ///< swept by the moves; within `Uncut::within`
  double unreachable = 0;  ///< the part less its opening by the tool: corners rounder than drawn, slots that are too narrow
  double left = 0;         ///< within reach, but asked to be left on the walls
  double missed = 0;       ///< within reach and not cut: the residue of the simulation
};

struct CoverageOptions {
  double radius = 0;  ///< mm, of the tool
  double leave = 0;   ///< mm, stock to leave on the walls
  double tolerance = 0.01;
};

/// The four shares come from three measurements that do not know of each other: of the moves (`uncutOf`), of the openings of
/// the part (`residueOf`), and of the residue between both; that they add up to the part is a test of all of them.
/// @param simulated of the same moves, with the same tolerance. O(boundary / tolerance log n) where something is to be left.
/// @throws Error as residueOf.
Coverage coverageOf(const Region& part, const Uncut&, const SimulationResult& simulated, const CoverageOptions&,
                    const Progress& = Progress::none());

}  // namespace blossom::pocket
