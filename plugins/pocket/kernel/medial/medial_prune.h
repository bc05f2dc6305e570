#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "kernel/medial/contact.h"
#include "kernel/medial/diagram.h"

namespace blossom::pocket {

/// The edges of a diagram that belong to the medial axis of the drawing.
struct KeptEdges {
  std::vector<bool> edge;           ///< by edge
  std::vector<int> degree;          ///< by vertex, kept edges only
  std::vector<std::size_t> tips;    ///< half-edges away from vertices where branches caused by the flattening were removed
  std::vector<std::size_t> lonely;  ///< vertices without remaining edges, where the region is a disc
};

/// Removes branches that end at vertices of the flattening, as long as the boundary at their ends stays within `tolerance`
/// of their discs: two pieces of one smooth curve are one site.
KeptEdges keptEdges(const Boundary&, const Diagram&, double tolerance, const Progress&);

/// A disc that touches the boundary in one place of maximum curvature.
struct Leaf {
  Disc disc;
  std::size_t curve = 0;  ///< of the boundary
  double parameter = 0;   ///< on it
};
/// The leaf of the true medial axis beyond a tip: the centre of curvature where the boundary beyond the tip has its maximum
/// curvature.
std::optional<Leaf> leafBeyond(const Boundary&, const Diagram&, std::size_t tip);

}  // namespace blossom::pocket
