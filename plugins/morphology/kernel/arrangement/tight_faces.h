#pragma once
#include "kernel/arrangement/pairs.h"

namespace blossom::morphology::arrangement {

/// Leaves out pairs of faces and corners that make no part of a difference. A corner b of an element can slide along a flat
/// face of a solid only as far as the edges of the element from b that lie in the plane of the face stay in it: when the
/// face is no wider than they are, across one of its own edges, the facet of both touches the difference in a line at most.
/// So are all faces that an earlier sum with the same element has made of one of its faces or edges, and their facets all
/// meet where the corner was. Only faces are tested around which the solid falls off everywhere, with few edges.
/// O(n log n + pairs), in whole numbers.
/// @param complement of the solid  @param element as it is added to the complement
void leaveOutTightFaces(FeaturePairs&, const Features& complement, const Features& element);

}  // namespace blossom::morphology::arrangement
