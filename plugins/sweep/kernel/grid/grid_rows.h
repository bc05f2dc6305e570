#pragma once
#include "geometry/shape/motion.h"
#include "kernel/grid/factor_grid.h"
#include "kernel/grid/grid_range.h"
#include "kernel/grid/motion_grid.h"
#include "kernel/grid/trajectory_table.h"

namespace blossom::sweep {

/// The factors of a motion, tabulated at the parameters of a grid.
struct GridFactors {
  FactorGrid orientation, scaling;
  TrajectoryTable trajectory;
  Vec3 point{0, 0, 1};  ///< p, in the moving frame
};

/// @throws nothing; O((pole rows + 1) * columns * degreeV).
GridFactors tabulateFactors(const Motion&, std::span<const double> us, std::span<const double> vs);

/// Columns are evaluated in blocks of this many, counted from the first one of the grid: a place then has the same
/// neighbours in a vector, and so the same result to the last bit, whatever else is evaluated with it.
inline constexpr std::size_t blockSize = 32;

/// The whole blocks that cover some of the `count` columns of a grid.
GridRange wholeBlocks(const GridRange& columns, std::size_t count);

/// Points and unit normals of a rectangle of the grid, whose arrays have their final sizes; derivatives too when `grid` has
/// arrays for them. The columns of the rectangle are whole blocks. Runs on all cores, with
/// the same result for any number. O(places * degreeU).
///
/// The general formula is x = t + R a with a = s p / sw, x_u = R (a_u + W_u x a), W_u = 2 vec(conj(r) r_u) / |r|^2 (the
/// body's angular velocity). Where p lies on an axis e of the moving frame, a = a e and x = t + a c with c = vec(r e
/// conj(r)) / |r|^2 takes half of the operations: c_u = 2 (vec(r_u e conj(r)) - (r . r_u) c) / |r|^2. (Yoon & Lee 2009,
/// section 3, in quaternion form.)
void evaluateRows(const GridFactors&, const GridRectangle&, MotionGrid& grid);

}  // namespace blossom::sweep
