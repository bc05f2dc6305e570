#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/planar/region.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// Proves that discs hold nothing of a boundary, on the curves as drawn. Lines and arcs by their distance in closed form;
/// splines by the convex hulls of their Bézier pieces, halved until each lies within `bulge` of its chord. Shares nothing
/// with the flattening that a diagram is built on, nor with Newton's iteration.
class DiscProof {
 public:
  /// @param bulge mm, above 0  @throws Error Cancelled.
  DiscProof(const Region&, double bulge, const Progress&);
  /// True only if no point of the boundary is nearer to the centre than the radius; at most `bulge` is given away.
  [[nodiscard]] bool holdsNothing(const Vec2& center, double radius) const;

 private:
  struct Piece {
    Stroke stroke;
    double bulge = 0;  ///< mm that the curve may be off the stroke
  };
  std::vector<Piece> pieces_;
  BoxTree<2> tree_;
};

}  // namespace blossom::pocket
