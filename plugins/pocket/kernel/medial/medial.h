#pragma once
#include "core/progress.h"
#include "geometry/planar/medial_axis.h"
#include "kernel/medial/contact.h"
#include "kernel/medial/diagram.h"

namespace blossom::pocket {

/// The largest disc in the region next to a vertex of the diagram, on the true curves: of what Newton's iteration and the
/// centres of arcs offer, the one with the most clearance.
Disc trueDisc(const Boundary&, const Diagram&, std::size_t vertex);

/// The medial axis on the true curves: inner edges of the diagram without those that the flattening makes, chains joined,
/// vertices and points moved onto the true bisectors by Newton's iteration, each vertex's disc searched for boundary.
/// O(n log n).
MedialAxis medialAxis(const Boundary&, const Diagram&, double tolerance, const Progress&);

}  // namespace blossom::pocket
