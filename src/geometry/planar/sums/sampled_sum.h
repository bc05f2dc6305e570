#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/fitting/true_curve.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/region.h"
#include "geometry/planar/sums/sampled_pair.h"
#include "geometry/planar/winding/convolution.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::planar {

/// The sum of two sampled sets by their polygons, as byFinerPolygons asks for it: what bounds it are sides of polygons, each
/// of which knows the curve that it stands for. @throws Error LimitExceeded, Cancelled; TooMuchWork.
class SampledSum {
 public:
  /// @param tolerance of both together
  SampledSum(SampledPair, double tolerance, Inside, const Progress&, Effort&);

  /// Nothing when the polygons are too coarse.
  [[nodiscard]] std::optional<Region> curves(const Progress&) const;
  /// The same of what keeps out of the sum, with lines across gaps within the tolerance, where it may fall to pieces.
  [[nodiscard]] std::optional<Region> curvesInPieces(const Progress&) const;
  [[nodiscard]] Region lines() const;

 private:
  [[nodiscard]] std::optional<Region> curvesClosing(double closed, const Progress&) const;
  [[nodiscard]] double largestGap() const { return 4 * tolerance_; }
  [[nodiscard]] std::optional<TrueCurve> curveOfEdge(const CountedEdge&, double rounding) const;

  double tolerance_;
  Inside inside_;
  SampledRegion a_, b_;
  Grid grid_;
  PairSources sources_;
  std::vector<CountedEdge> edges_;
  std::vector<TracedPart> faces_;
};

}  // namespace blossom::planar
