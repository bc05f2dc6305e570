#pragma once
#include <cmath>

#include "feature/feature_type.h"
#include "geometry/planar/planar.h"

namespace blossom::test {

/// mm2, by the direction of the outlines.
inline double areaOf(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += signedArea(loop);
  return std::abs(sum);
}

/// Of the figures that a feature type tells besides the measures; not a number when it does not.
inline double figureOf(const Evaluated& made, const char* name) {
  for (const Measure& figure : made.figures)
    if (figure.name == name) return std::get<double>(figure.value);
  return std::nan("");
}

}  // namespace blossom::test
