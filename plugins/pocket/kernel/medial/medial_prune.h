#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "kernel/medial/contact.h"
#include "kernel/medial/diagram.h"

namespace blossom::pocket {

/// Which edges of a diagram belong to the medial axis of the drawing.
struct KeptEdges {
  std::vector<bool> edge;           ///< by edge
  std::vector<int> degree;          ///< by vertex, kept edges only
  std::vector<std::size_t> tips;    ///< half-edges away from vertices where branches of the flattening were cut off
  std::vector<std::size_t> lonely;  ///< vertices of which nothing else is left: the region is a disc there
};

/// Cuts branches off from their ends at vertices of the flattening, as long as the boundary that they lead to stays within
/// `tolerance` of their discs: two pieces of one smooth curve are one site.
KeptEdges keptEdges(const Boundary&, const Diagram&, double tolerance, const Progress&);

/// The leaf of the true medial axis beyond a tip: the centre of curvature where the boundary that the tip leads to bends
/// most.
std::optional<Disc> leafBeyond(const Boundary&, const Diagram&, std::size_t tip);

}  // namespace blossom::pocket
