#pragma once
#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/sound_set.h"

namespace blossom::planar {

/// A + B of sets with curves and points: what one sweeps along the curves of the other. Curves take part in the convolution
/// as loops there and back, whose winding numbers count where A meets x - B along the curve, so nothing is thickened; what
/// bounds the sum are lines, arcs and splines as of curved_sum.h. The area is regularised: what is swept without width is
/// left out. Where one set is points alone, the curves and points of the other come along.
/// @throws Error LimitExceeded, Cancelled; TooMuchWork.
SoundSet sum(const SoundSet& a, const SoundSet& b, const Progress&, Effort&);

/// Adds the curves and points of A + B that `sum` leaves out where it makes an area, so that sums to come are whole: curves
/// of one at points of the other, sums of points, and of parallel lines. Some of them may lie in the area. Other curves
/// sweep an area everywhere. O(|A| |B|)
void addThinSum(const SoundSet& a, const SoundSet& b, SoundSet& out, const Progress&, Effort&);

/// {p : p + B inside the area of A}, regularised; never too large. Of lines and arcs it has lines and arcs again; where
/// there are splines, straight lines on the safe side, unless B is one point, which moves A. @pre B is not empty. @throws as
/// sum
SoundRegion difference(const SoundRegion& a, const SoundSet& b, const Progress&, Effort&);

}  // namespace blossom::planar
