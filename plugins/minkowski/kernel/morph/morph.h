#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/region.h"
#include "kernel/morph/evaluation_order.h"

namespace blossom::minkowski {

using namespace planar;

struct MorphOptions {
  EvaluationOrder evaluation = EvaluationOrder::Automatic;
  bool degreeElevate = false;   ///< elevate the degree by one; the morph does not change when all shapes are convex
  bool areaPreserving = false;  ///< scale about the centre, so that the areas of the control shapes are blended
  /// mm, between curves and their polygons; empty: see FlatteningOptions. Of shapes without curves so much may be left out
  /// at high degrees, before the scaling that preserves areas.
  std::optional<double> tolerance{};
  std::size_t maximumWork = Effort::unlimited;  ///< see effort.h
};

struct MorphResult {
  std::vector<Region> regions;  ///< one per argument; outer loops counter-clockwise
  std::size_t sums = 0;         ///< Minkowski sums computed
  /// By which in-betweens were computed, the one chosen when it is automatic; none of the ends and beyond them.
  std::optional<EvaluationOrder> evaluation;
  double deviation = 0;               ///< mm, by which an in-between may differ: hulls, filled dents; see the tolerance
  std::vector<std::string> warnings;  ///< full sentences
};

/// n equal arguments t, with which the blossom is C(t).
std::vector<double> diagonal(std::size_t degree, double t);

/// In-between shapes of control shapes A0..An by de Casteljau's algorithm with Minkowski sums instead of sums of points
/// (Lee, Lee, Kim & Kim 2002, section 4.2, equations 4.5 to 4.9; the blossom of section 4.3, equation 4.10). Each argument
/// consists of one number per level; equal numbers t give C(t), beyond 0..1 as extrapolation.h has it. When all are 0 or all
/// are 1, the result is the first or the last control shape itself. Scaling is about the origin of the document. The blossom
/// is symmetric in its arguments for all evaluations, also for shapes that are not convex. Control shapes and results may be
/// points, as regions of point_shape.h.
/// @throws Error InvalidParameter (fewer than two shapes, a wrong number of arguments, numbers beyond 0..1 to which the
/// morph does not continue), InvalidInput naming the shape and the place (see flattening.h; also a shape that is not convex
/// for Evaluation::Convex), LimitExceeded, Cancelled; TooMuchWork.
MorphResult morph(std::span<const Region> shapes, std::span<const std::vector<double>> arguments, const MorphOptions& = {},
                  const Progress& = Progress::none());

}  // namespace blossom::minkowski
