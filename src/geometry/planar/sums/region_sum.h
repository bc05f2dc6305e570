#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

struct RegionSumOptions {
  /// mm, between the exact result and its polygons, divided among the shapes; empty: see FlatteningOptions
  std::optional<double> tolerance{};
  std::size_t maximumWork = Effort::unlimited;  ///< see effort.h
  /// Of a sum: factors of the shapes about the origin of the document, 1 where none is given. A negative one also turns by
  /// 180 degrees, which reflects in the origin; 0 leaves the origin, which changes nothing.
  std::vector<double> weights{};
  /// Of a difference of sets, see set_operations.h: the room without width comes along, as curves and points.
  bool keepDegenerate = false;
};

struct RegionSumResult {
  Region region;  ///< outer loops counter-clockwise, holes clockwise
  std::size_t sums = 0;
  std::vector<std::string> warnings;
};

/// v A + w B + .. (Lee, Lee, Kim & Kim 2002, section 2.3, equation 1.4): all sums of a point of each, about the origin of
/// the document. Lines and arcs stay lines and arcs, splines become cubic splines within the tolerance.
/// @throws Error InvalidParameter (fewer than two), InvalidInput naming shape and place (see flattening.h), LimitExceeded,
/// Cancelled; TooMuchWork. O((m + k) log m) for the m edges of the convolution with k crossings.
RegionSumResult minkowskiSum(std::span<const Region>, const RegionSumOptions& = {}, const Progress& = Progress::none());

/// A - B - ..: the points p with p + B inside A (erosion), regularised. A is approximated from inside and the others from
/// outside, so that the result is never too large; where it is hardly wider than the tolerance, a warning says so. Where
/// nothing is left the result is empty, and a warning says that. @throws as minkowskiSum
RegionSumResult minkowskiDifference(std::span<const Region>, const RegionSumOptions& = {},
                                    const Progress& = Progress::none());

/// @throws Error InvalidParameter for fewer than two shapes, more weights than shapes, or weights that are all 0
void checkSummands(std::size_t shapes, const RegionSumOptions&);

/// A - B - .. as minkowskiDifference; empty when nothing is left.
Region roomInside(std::span<const Region>, const RegionSumOptions&, const Progress&);

/// What is said of a difference that is empty, "Nothing is left: ..".
std::string nothingLeft(std::optional<double> toleranceOfCurves);

/// The factor of shape i in a sum.
double weightOf(const RegionSumOptions&, std::size_t i);

/// Whether free-form curves are to bound the room of a difference: those of the first shape, and where that is no convex
/// polygon also those of the others, which roll over its inner corners and along its arcs.
/// @param splinesFit  whether a shape that is to fit inside has free-form curves
bool splinesBoundRoom(const Region& first, bool splinesFit);

/// Adds a warning to a result that is of straight lines alone although it should have free-form curves.
void warnOfLines(bool hasCurvesOfShapes, const Region& result, const std::optional<double>& tolerance,
                 std::vector<std::string>& warnings);

}  // namespace blossom::planar
