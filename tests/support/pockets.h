#pragma once
#include <cmath>

#include "feature/feature_type.h"
#include "geometry/planar/planar.h"
#include "support/planar_parts.h"

namespace blossom::test {

/// mm2, by the direction of the outlines.
inline double areaOf(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += signedArea(loop);
  return std::abs(sum);
}

inline double perimeter(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += length(loop);
  return sum;
}

/// A wavy outline with a wavy hole and a round one.
inline Region wave() {
  return {{wavyPath({0, 0}, 30, 5, 5), wavyPath({-8, 2}, 6, 1.5, 3, true), circlePath({12, -3}, 5, true)}};
}

/// Of the figures that a feature type tells besides the measures; not a number when it does not.
inline double figureOf(const Evaluated& made, const char* name) {
  for (const Measure& figure : made.figures)
    if (figure.name == name) return std::get<double>(figure.value);
  return std::nan("");
}

}  // namespace blossom::test
