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
  double tolerance = 1e-3;       ///< mm, maximum error of the distance of an offset
  bool exactPredicates = false;  ///< build the Delaunay graph at once; slow, used in tests for comparison
};

/// Statistics of the construction of a diagram.
struct DiagramStats {
  std::size_t sites = 0;     ///< straight pieces of the flattened boundary
  std::size_t vertices = 0;  ///< number of Voronoi vertices on both sides
  std::size_t attempts = 0;  ///< number of diagrams built until one passed its checks
  std::string method;        ///< "sweep line", or "Delaunay graph" when that one failed
  double milliseconds = 0;
};

/// The Voronoi diagram of a region's boundary, from which offsets at any distance, the medial axis and clearances are
/// derived. Immutable; copies share it; usable from several threads at once.
///
/// The boundary is flattened to a quarter of the tolerance and every piece refers to its curve, so that the results lie on
/// the offsets of the true curves (Jeong & Kim, "Offset of free-form curves by Voronoi diagrams"). All lengths in mm.
/// Construction takes O(n log n) for n pieces, an offset O(n).
class ClearanceDiagram {
 public:
  /// @throws Error InvalidInput (empty, not finite, crossing itself; the message names the place), InvalidParameter
  /// (tolerance), LimitExceeded (more than two million pieces), Cancelled.
  explicit ClearanceDiagram(const Region&, const ClearanceOptions& = {}, const Progress& = Progress::none());

  /// The region eroded (inside) or dilated (outside) by a disc of radius `distance`. Loops of lines and arcs, outer loops
  /// counter-clockwise, holes clockwise; empty when nothing is left. @throws Error InvalidParameter when distance is
  /// negative or not finite.
  [[nodiscard]] Region offset(double distance, Side, const Progress& = Progress::none()) const;

  /// The centres of all maximal discs in the region. Branches caused by the flattening are left out; leaves of smooth
  /// boundaries are centres of curvature.
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
