#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/ball.h"
#include "kernel/operand.h"

/// Morphology of solids (Liu, Chen, Wan, Zhu, "An Algorithm of 3-D Objects Morphing and Its Implementation Based on
/// Morphology", sections 2 and 3). Coordinates are absolute: the origin matters, and need not lie in either shape.
///
/// Operands are rounded to a grid of 2^-44 of their size, or of 2^-57 where the first makes faces cross, then all is
/// computed in exact arithmetic, except that bends too small to be distinguished from that rounding are ignored (see
/// flatness.h). The corners of results are rounded to doubles, and an exact test for intersections of faces follows. Solids
/// are regular closed sets: parts without volume are left out. They may touch themselves in common vertices and edges.
namespace blossom::morphology {

/// How a result was made; all ways but the last give the same solid.
enum class Way {
  Prisms,    ///< two prisms along one axis of the coordinates, by their sections (kernel/prisms/prism.h)
  Hulls,     ///< convex solids, by the overlay of their Gauss maps (kernel/convex/convex_sum.h)
  Planes,    ///< a convex solid, whose planes were moved inwards (kernel/convex/hull.h)
  Arranged,  ///< any others, by an arrangement of facets (kernel/arrangement/arranged_sum.h)
  Field,     ///< a preview, by distance fields (kernel/preview/field_sum.h), which is only about the same
};

struct MorphologyStats {
  Way way = Way::Arranged;     ///< of the last frame
  std::size_t candidates = 0;  ///< facets that may bound the sums
  /// Those of them of arranged sums, by what they are made of (section 2.2): a corner of the first shape and a face of the
  /// second, a face and a corner, two edges.
  std::array<std::size_t, 3> families{};
  std::size_t leftOut = 0;   ///< of the candidates: they lie deep inside, and were not arranged
  std::size_t pairings = 0;  ///< searches for them; the frames of a morph of two solids share one
  double largestSize = 0;    ///< of which `melted` leaves anything, when it was asked for
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

/// What a sum is made of, for pictures of it (Figs. 4 and 5): all facets that may bound it, before those inside of it are
/// left out and those in one plane are joined.
struct SumParts {
  std::array<std::vector<std::vector<Vec3>>, 3> facets;  ///< by the families of `MorphologyStats`; from outside
  std::vector<Vec3> reflex;                              ///< ends of reflex edges of both shapes, where these lie
};
/// @throws Error as solidSum, but for sums without volume
SumParts partsOfSum(const Operand& a, const Operand& b, const Progress& = Progress::none());

/// {x : x + B inside A}, the complement of (complement of A) + (-B). The paper's Definition 5 erodes by -B; this definition
/// makes A - B the inverse of A + B for a translation. @throws Error as solidSum; Degenerate when nothing is left.
MorphologyResult solidDifference(const Operand& a, const Operand& b, const Progress& = Progress::none());

/// (A - B) + B: the part of A covered by copies of B inside A.
MorphologyResult solidOpening(const Operand& a, const Operand& b, const Progress& = Progress::none());
/// (A + B) - B: A and all places that B cannot reach from outside.
MorphologyResult solidClosing(const Operand& a, const Operand& b, const Progress& = Progress::none());

struct MorphOptions {
  /// In-between solids are scaled about the blend of the middles of the shapes, so that their volumes blend, too.
  bool volumePreserving = false;
};

/// The sum of `weights[k] * shapes[k]` for every row of weights (Definition 9, with w = f(t), for any number of shapes). The
/// shapes are solids; a shape of weight 1 is itself.
/// @param weights at least 0, of sum 1, one row for each frame and one weight for each shape
MorphologyResult solidMorph(const std::vector<Operand>& shapes, const std::vector<std::vector<double>>& weights,
                            const MorphOptions& = {}, const Progress& = Progress::none());

/// About what the sum of `weights[k] * shapes[k]` is, for pictures while something is dragged: on a grid of so many cells
/// along its longest side, as the warning says. At least one shape is a solid, which is not checked for faults.
MorphologyResult previewOfSum(const std::vector<Operand>& shapes, const std::vector<double>& weights, int cells,
                              const MorphOptions& = {}, const Progress& = Progress::none());

/// What a solid is grown or melted by.
struct GrowOptions {
  std::vector<double> sizes{1};  ///< one solid each: radii of the ball in mm, or factors of the element; 0: the solid itself
  std::optional<Operand> element{};  ///< scaled about the origin; none: a ball
  int subdivisions = 1;              ///< of the ball
  BallFit fit = BallFit::Inscribed;
  /// Of `melted`: what is left is rounded by so many times the size, as if the melting had gone on for so long and the rest
  /// had grown again: edges and thin places go first.
  double rounding = 0;
  /// Of `melted`: sizes are shares of the largest one of which anything is left. Rounding ends towards 1, for it would keep
  /// what it takes.
  bool untilNothing = false;
};

/// A + s B for the ball or element B (section 3.2).
MorphologyResult inflated(const Operand& a, const GrowOptions&, const Progress& = Progress::none());
/// A - s B, rounded: (A - s (1 + r) B) + s r B. The paper writes A + tB here too, but means the difference. Ends before the
/// first size at which nothing is left, with a warning. The largest size of all is found to a thousandth of itself, by
/// halving. @throws Error Degenerate when nothing is left at the first size.
MorphologyResult melted(const Operand& a, const GrowOptions&, const Progress& = Progress::none());

/// A solid without edges sharper than a ball of the given radius: its opening by the ball, closed by it.
enum class RoundedEdges { Convex, Reflex, Both };
MorphologyResult solidRounded(const Operand& a, const Operand& ball, RoundedEdges, const Progress& = Progress::none());

}  // namespace blossom::morphology
