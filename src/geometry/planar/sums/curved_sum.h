#pragma once
#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/sound_region.h"

namespace blossom::planar {

struct SampledPair;

/// A + B of curved regions: an edge moved over a corner stays what it is, an arc moved along an arc with the same normals
/// becomes one with the sum of the radii (Lee, Lee, Kim & Kim 2002, section 3.1), and what comes of splines is a cubic
/// spline within the tolerances. Which of them bound the sum is decided by polygons within the tolerances, whose sides know
/// their curves; where curves do not fit together the polygons are made finer, twice at most, and the last resort are
/// straight lines within the tolerances. The centres, radii and ends of lines and arcs are those of the curves to rounding.
/// The empty set when one of them is empty.
/// @throws Error LimitExceeded, Cancelled; TooMuchWork. As polygon_sum.h for the polygons.
SoundRegion sum(const SoundRegion& a, const SoundRegion& b, const Progress&, Effort&);

/// The same with samples of both within their tolerances.
SoundRegion sum(const SoundRegion& a, const SoundRegion& b, const SampledPair&, const Progress&, Effort&);

/// {p : p + B inside A}, regularised. Of regions of lines and arcs it has lines and arcs again; which of them bound it is
/// decided by polygons around the complement of A and around B: room within the tolerances may be missed, none is invented.
/// Where there are splines, or loops of A touch, it is of straight lines on the safe side.
/// @pre B is not empty. @throws as sum
SoundRegion difference(const SoundRegion& a, const SoundRegion& b, const Progress&, Effort&);

}  // namespace blossom::planar
