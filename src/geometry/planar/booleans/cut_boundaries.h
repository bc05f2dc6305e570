#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/fitting/true_curve.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// A line or an arc of a boundary, cut where the other boundary meets it.
struct CutSegment {
  Segment segment;
  TrueCurve curve;
  std::vector<Vec2> cuts;  ///< from its start to its end, both included
  std::size_t loop = 0;    ///< of its region

  /// Piece k lies between cuts k and k + 1.
  [[nodiscard]] std::size_t pieces() const { return cuts.size() - 1; }
  /// Radians of a piece of an arc, below 0 when it turns right.
  [[nodiscard]] double sweepOf(std::size_t piece) const;
  /// A point of the curve along a piece, at a share from 0 to 1 of it.
  [[nodiscard]] Vec2 pointOf(std::size_t piece, double share) const;
};

struct CutBoundaries {
  std::vector<CutSegment> first, second;
  std::vector<Vec2> crossings;  ///< where a segment of one passes one of the other, at an angle and away from their ends
};

/// Cuts the boundaries of two regions of lines and arcs where they meet, which is computed from the curves themselves.
/// Points within a distance of each other become one, and where both run along one curve each is cut at the ends of the
/// other. Nothing where lines cross at less than 1e-7 radians, so that rounding decides where, and where segments do
/// not join within twice the distance. O((n + k) log n) for k meetings. @pre no splines. @throws Error Cancelled
std::optional<CutBoundaries> cutBoundaries(const Region&, const Region&, double within, const Progress&);

}  // namespace blossom::planar
