#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/bspline/spline_space.h"

namespace blossom {

/// A rectangle of parameters. In a direction that is closed it may pass beyond the domain.
struct ParameterBox {
  double firstU = 0, lastU = 0, firstV = 0, lastV = 0;
};

/// A surface of truncated hierarchical B-splines with values in R^4 (C. Giannelli, B. Juettler and H. Speleers,
/// "THB-splines: the truncated basis for hierarchical splines", CAGD 29, 2012).
///
/// Levels are tensor products of nested spaces, level 0 over the whole domain, level l over a part of it, Omega^l, inside
/// Omega^(l-1). **Active** are the functions of level l whose support lies in Omega^l but not in Omega^(l+1) (Kraft). Each
/// is
/// **truncated**: written in the functions of the next level, those with a support in Omega^(l+1) are left out, and so on
/// for all finer levels. Truncated functions are >= 0, linearly independent, and in open and periodic spaces sum to 1; the
/// values of a surface do not change when it is refined, and the coefficients of functions that stay active do not either.
///
/// Spaces need not be dyadic: a level may have more knots in some places and none in others. A direction may be closed, also
/// with the other sign after one period. Where Omega ends inside a span of the level above, the functions still are as
/// described; that they span all splines of that mesh is known for borders along knots of the level above.
class HierarchicalSurface {
 public:
  /// Without a level: to be assigned to.
  HierarchicalSurface() = default;
  /// One level. @param coefficients u-major, one for each function
  HierarchicalSurface(SplineSpace u, SplineSpace v, std::vector<Vec4> coefficients);

  /// Adds a finer level over the spans (of that level) whose middles lie in one of the boxes; of them, what lies in the part
  /// of the level above. The surface stays as it is. O(functions * spans under a support).
  /// @throws Error InvalidInput when the spaces do not hold those of the level above.
  void refine(SplineSpace u, SplineSpace v, std::span<const ParameterBox> where);

  [[nodiscard]] std::size_t levels() const { return levels_.size(); }
  [[nodiscard]] const SplineSpace& spaceU(std::size_t level) const { return levels_[level].u; }
  [[nodiscard]] const SplineSpace& spaceV(std::size_t level) const { return levels_[level].v; }

  /// @param function u-major index among those of the level, here and below
  [[nodiscard]] bool active(std::size_t level, std::size_t function) const {
    return levels_[level].inside[function] && !levels_[level].covered[function];
  }
  [[nodiscard]] const Vec4& coefficient(std::size_t level, std::size_t function) const {
    return levels_[level].coefficients[function];
  }
  /// @pre the function is active.
  void setCoefficient(std::size_t level, std::size_t function, const Vec4& value) {
    levels_[level].coefficients[function] = value;
  }

  struct ActiveValue {
    std::size_t level, function;
    double value;
  };
  /// The truncated functions of all levels that are not 0 at a place, and their values there. O(levels degree^4).
  [[nodiscard]] std::vector<ActiveValue> activeAt(double u, double v) const;
  /// Their sum, times the coefficients: the tensor product is not formed.
  [[nodiscard]] Vec4 evaluate(double u, double v) const;

  /// Coefficients of the same surface in the tensor product of the finest level: convex combinations. O(functions degree).
  [[nodiscard]] std::vector<Vec4> finest() const;

 private:
  struct Level {
    SplineSpace u, v;
    SpaceMap fromU, fromV;      ///< from the level above
    std::vector<char> domain;   ///< Omega, as spans of this level, u-major
    std::vector<char> inside;   ///< functions with a support in Omega
    std::vector<char> covered;  ///< functions with a support in the Omega of the next level
    std::vector<Vec4> coefficients;
  };

  std::vector<Level> levels_;
};

}  // namespace blossom
