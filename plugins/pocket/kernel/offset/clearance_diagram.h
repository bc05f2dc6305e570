#pragma once
#include <cstddef>
#include <memory>
#include <string>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/medial_axis.h"
#include "geometry/planar/region.h"

namespace blossom::pocket {

enum class Side { Inside, Outside };

struct ClearanceOptions {
  double tolerance = 1e-3;       ///< mm, most that a point of an offset may be off its distance
  bool exactPredicates = false;  ///< build the Delaunay graph at once; slow, the peer of the sweep line in tests
};

/// How a diagram came about, for users who ask.
struct DiagramStats {
  std::size_t sites = 0;     ///< straight pieces of the flattened boundary
  std::size_t vertices = 0;  ///< of the Voronoi diagram, both sides
  std::size_t attempts = 0;  ///< diagrams built until one passed its checks
  std::string method;        ///< "sweep line", or "Delaunay graph" when that one failed
  double milliseconds = 0;
};

/// The Voronoi diagram of a region's boundary, from which offsets at any distance, the medial axis and clearances are read.
/// Immutable after it is built; copies share it; safe to use from several threads at once.
///
/// The boundary is flattened to a quarter of the tolerance and every piece remembers the curve it came from, so that the
/// results lie on the offsets of the true curves (Jeong & Kim, "Offset of free-form curves by Voronoi diagrams"). All
/// lengths in mm. Building takes O(n log n) for n pieces, an offset O(n).
class ClearanceDiagram {
 public:
  /// @throws Error InvalidInput (empty, not finite, crossing itself; the message names the place), InvalidParameter
  /// (tolerance), LimitExceeded (more than two million pieces), Cancelled.
  explicit ClearanceDiagram(const Region&, const ClearanceOptions& = {}, const Progress& = Progress::none());

  /// What is left of the region when everything nearer than `distance` to its boundary is taken away (inside), or the region
  /// with everything within `distance` of it added (outside). Loops of lines and arcs, outer ones counter-clockwise, holes
  /// clockwise; empty when nothing is left. @throws Error InvalidParameter when distance is negative or not finite.
  [[nodiscard]] Region offset(double distance, Side, const Progress& = Progress::none()) const;

  /// The centres of all discs in the region that no other disc in it holds. Branches that only the flattening makes are left
  /// out; leaves of smooth boundaries stand at centres of curvature.
  [[nodiscard]] MedialAxis medialAxis(const Progress& = Progress::none()) const;

  /// Radius and centre of the largest disc in the region.
  [[nodiscard]] double largestClearance() const;
  [[nodiscard]] Vec2 largestCenter() const;

  /// Whether the region may have a place that is about twice as wide as the distance and no wider beside: a slot, or one
  /// that is about as long as wide. Clearances are those of the flattened boundary, within `slack` of the distance. O(n).
  [[nodiscard]] bool isLevelNear(double distance, double slack) const;

  /// Distance to the true boundary; negative outside. O(log n).
  [[nodiscard]] double clearance(const Vec2&) const;

  [[nodiscard]] const Region& region() const;
  [[nodiscard]] double tolerance() const;
  [[nodiscard]] const DiagramStats& stats() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace blossom::pocket
