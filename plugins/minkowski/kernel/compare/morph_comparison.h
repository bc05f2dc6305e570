#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/numeric/boxes.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/region.h"

namespace blossom::minkowski {

using namespace planar;

struct ComparisonOptions {
  std::vector<double> times{0, 0.25, 0.5, 0.75, 1};  ///< 0..1, of the in-betweens
  std::size_t resolution = 200;                      ///< cells of the distance fields along the longer side
  std::optional<double> tolerance{};                 ///< mm, between curves and their polygons; empty: see FlatteningOptions
  std::size_t maximumWork = Effort::unlimited;       ///< see effort.h
};

/// In-betweens of one way to morph.
struct MorphedWay {
  std::vector<std::vector<Path>> outlines;  ///< closed paths for each time
  std::vector<double> areas;                ///< mm^2, for each time
  double milliseconds = 0;                  ///< for all times, with what is prepared for them
};

struct MorphComparison {
  MorphedWay vertices;                 ///< see matched_outlines.h; empty when the shapes do not allow it
  std::string whyNoVertices;           ///< a full sentence then
  std::vector<std::size_t> crossings;  ///< how often the outlines of `vertices` cross, for each time
  MorphedWay fields;                   ///< see distance_field.h; an in-between may be empty
  MorphedWay sums;                     ///< see morph.h
  std::size_t sumCount = 0;            ///< Minkowski sums computed
  Box2 room;                           ///< around all in-betweens
};

/// The same two shapes morphed in three ways: by vertices matched along the outlines, by distance fields and by Minkowski
/// sums. Each shape is taken about the centroid of its area, so all in-betweens are about the origin; distance fields
/// depend on how the shapes overlap, the two other ways only move. Areas of outlines that cross themselves count what is
/// run around the other way as negative. @throws Error as morph; InvalidParameter for a resolution below 8 or without times,
/// LimitExceeded above 1000; TooMuchWork
MorphComparison compareMorphs(const Region& first, const Region& second, const ComparisonOptions& = {},
                              const Progress& = Progress::none());

}  // namespace blossom::minkowski
