#include "kernel/morph/influence_curves.h"

#include <algorithm>

namespace blossom::minkowski {

InfluenceCurves influenceCurves(const ShapeKnots& spline, std::size_t intervals) {
  InfluenceCurves curves;
  for (std::size_t k = 0; k <= intervals; ++k)
    curves.times.push_back(static_cast<double>(k) / static_cast<double>(intervals));
  const double first = spline.knots.front(), last = spline.knots.back();
  for (const double knot : spline.knots) curves.times.push_back((knot - first) / (last - first));
  std::sort(curves.times.begin(), curves.times.end());
  curves.times.erase(std::unique(curves.times.begin(), curves.times.end()), curves.times.end());
  for (const double t : curves.times) {
    const std::vector<double> shares = influences(spline, t);
    curves.shares.resize(shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i) curves.shares[i].push_back(shares[i]);
  }
  return curves;
}

}  // namespace blossom::minkowski
