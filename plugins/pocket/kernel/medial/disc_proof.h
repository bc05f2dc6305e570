#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/planar/region.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// Proves that discs contain no point of a boundary, on the curves as drawn. Lines and arcs by their distance in closed
/// form; splines by the convex hulls of their Bézier pieces, halved until each lies within `bulge` of its chord. Uses
/// neither the flattening that diagrams are built on nor Newton's iteration.
class DiscProof {
 public:
  /// @param bulge mm, above 0  @throws Error Cancelled.
  DiscProof(const Region&, double bulge, const Progress&);
  /// True only if no boundary point is nearer to the centre than the radius; may be false for distances up to `bulge` above
  /// the radius.
  [[nodiscard]] bool isClear(const Vec2& center, double radius) const;

 private:
  struct Piece {
    Stroke stroke;
    double bulge = 0;  ///< mm, maximum distance of the curve from the stroke
  };
  std::vector<Piece> pieces_;
  BoxTree<2> tree_;
};

}  // namespace blossom::pocket
