#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/ball.h"
#include "kernel/operand.h"

/// Morphology of solids (Liu, Chen, Wan, Zhu, "An Algorithm of 3-D Objects Morphing and Its Implementation Based on
/// Morphology", sections 2 and 3). Coordinates are absolute: the origin matters, and need not lie in either shape.
///
/// Operands are rounded to a grid of 2^-52 of their size, then all is computed in exact arithmetic, except that bends too
/// small to be distinguished from that rounding are ignored (see flatness.h). The corners of results are rounded to doubles,
/// and an exact test for intersections of faces follows. Solids are regular closed sets: parts without volume are left out.
/// They may touch themselves in common vertices and edges.
namespace blossom::morphology {

/// How a result was made; all ways give the same solid.
enum class Way {
  Prisms,    ///< two prisms along one axis of the coordinates, by their sections (kernel/prisms/prism.h)
  Hulls,     ///< convex solids, by the overlay of their Gauss maps (kernel/convex/convex_sum.h)
  Planes,    ///< a convex solid, whose planes were moved inwards (kernel/convex/hull.h)
  Arranged,  ///< any others, by an arrangement of facets (kernel/arrangement/arranged_sum.h)
};

struct MorphologyStats {
  Way way = Way::Arranged;     ///< of the last frame
  std::size_t candidates = 0;  ///< facets that may bound the sums
  double checkMs = 0, sumMs = 0, uniteMs = 0, outputMs = 0;
};

/// Closed, oriented polygons; coplanar faces are joined.
struct MorphologyResult {
  std::vector<Mesh> solids;  ///< one per frame
  MorphologyStats stats;
  std::vector<std::string> warnings;
};

/// A + B = {a + b} (Definition 5). @throws Error InvalidInput, Degenerate when it has no volume, LimitExceeded, Cancelled.
MorphologyResult solidSum(const Operand& a, const Operand& b, const Progress& = Progress::none());

/// {x : x + B inside A}, the complement of (complement of A) + (-B). The paper's Definition 5 erodes by -B; this definition
/// makes A - B the inverse of A + B for a translation. @throws Error as solidSum; Degenerate when nothing is left.
MorphologyResult solidDifference(const Operand& a, const Operand& b, const Progress& = Progress::none());

/// (A - B) + B: the part of A covered by copies of B inside A.
MorphologyResult solidOpening(const Operand& a, const Operand& b, const Progress& = Progress::none());
/// (A + B) - B: A and all places that B cannot reach from outside.
MorphologyResult solidClosing(const Operand& a, const Operand& b, const Progress& = Progress::none());

/// (1 - w) A + w B for every weight w in 0..1 (Definition 9, w = f(t)); A itself at 0, B itself at 1. Both are solids.
MorphologyResult solidMorph(const Operand& a, const Operand& b, const std::vector<double>& weights,
                            const Progress& = Progress::none());

struct GrowOptions {
  std::vector<double> radii{1};  ///< mm, one solid each, not decreasing; 0 for the solid itself
  int subdivisions = 1;          ///< of the ball
  BallFit fit = BallFit::Inscribed;
};

/// A + ball (section 3.2).
MorphologyResult inflated(const Operand& a, const GrowOptions&, const Progress& = Progress::none());
/// A - ball. The paper writes A + tB here too, but means the difference. Ends before the first radius at which nothing is
/// left, with a warning. @throws Error Degenerate when nothing is left at the first radius.
MorphologyResult melted(const Operand& a, const GrowOptions&, const Progress& = Progress::none());

}  // namespace blossom::morphology
