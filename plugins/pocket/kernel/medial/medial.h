#pragma once
#include "core/progress.h"
#include "geometry/planar/medial_axis.h"
#include "kernel/medial/contact.h"
#include "kernel/medial/diagram.h"

namespace blossom::pocket {

/// The largest disc in the region near a vertex of the diagram, on the true curves: the best candidate of Newton's iteration
/// and of the centres of arcs.
Disc trueDisc(const Boundary&, const Diagram&, std::size_t vertex);

/// The medial axis on the true curves: inner edges of the diagram without those caused by the flattening, joined to chains,
/// with vertices and points moved onto the true bisectors by Newton's iteration, and every vertex's disc verified. O(n log
/// n).
MedialAxis medialAxis(const Boundary&, const Diagram&, double tolerance, const Progress&);

}  // namespace blossom::pocket
