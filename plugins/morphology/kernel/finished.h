#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/progress.h"
#include "core/vector.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// What has been lost to rounding.
struct RoundingLoss {
  double moved = 0;      ///< mm that corners have moved by at most, beyond the rounding of doubles
  double thickness = 0;  ///< mm below which bodies, voids, walls or gaps have been left out; 0 where none has

  /// Of two steps of one piece of work.
  void add(const RoundingLoss&);
  /// Nothing when nothing is lost.
  [[nodiscard]] std::string sentences() const;
};

/// A result with corners rounded to doubles.
struct Finished {
  Mesh mesh;  ///< closed polygons in the user's coordinates; the exact test finds no intersections
  RoundingLoss loss;
};

enum class Slivers : std::uint8_t { Stay, Go };

/// Corners cannot be rounded to doubles so that no faces cross: sheets lie nearer to each other than that.
class CannotBeRounded : public Error {
 public:
  explicit CannotBeRounded(const std::string& message);
};

/// Closed, oriented triangles about `centre` as polygons: coplanar triangles are joined, vertices inside straight edges
/// removed (see joinedFacesFlatness). Where rounding makes faces intersect, fewer are joined; where they still do, corners
/// are rounded to coarser grids, and what nearly lies on each other is made one (separated.h). The same solid always results
/// in the same mesh, however it was triangulated.
/// @param slivers whether voids and bodies stay that are thinner than rounding, which may turn them inside out
/// @throws CannotBeRounded with the place when faces intersect on every grid; Error Internal, Cancelled.
Finished finished(const Mesh& triangles, const Vec3& centre, Slivers slivers, const Progress&);

struct OnGrid {
  Mesh triangles;
  double step = 0;  ///< mm by which corners have moved at most
  RoundingLoss loss;
};
/// Triangles of the same solid with corners on the grid of `step`, or on one that is up to 2^24 times as coarse, that cross
/// nowhere; corners that come together there are one. Where a few times as coarse is not enough, what is nearly one is made
/// one first, unless walls would vanish. Nothing when that fails, or when they are not closed there.
std::optional<OnGrid> onCoarserGrid(const Mesh& triangles, double step, const Progress& = Progress::none());

}  // namespace blossom::morphology
