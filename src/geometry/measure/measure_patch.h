#pragma once
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <memory>
#include <vector>

#include "core/vector.h"
#include "geometry/shape/bounds.h"

namespace blossom {

/// A face, edge or vertex as a function of 2, 1 or 0 parameters over a rectangle, with its trimming.
class MeasurePatch {
 public:
  using Parameters = std::array<double, 2>;
  struct Derivatives {
    Vec3 point;
    std::array<Vec3, 2> first;
    std::array<Vec3, 3> second;  ///< uu, vv, uv
  };
  struct Sample {
    Vec3 point;
    Parameters at{0, 0};
    int i = 0, j = 0;  ///< indices in the grid of samples
  };

  /// @pre not a degenerated edge. @throws Error InvalidInput when it is unbounded.
  explicit MeasurePatch(const TopoDS_Shape&);

  [[nodiscard]] std::size_t dimension() const { return surface_ ? 2 : curve_ ? 1 : 0; }
  [[nodiscard]] const Bounds& box() const { return box_; }
  [[nodiscard]] const Parameters& low() const { return low_; }
  [[nodiscard]] const Parameters& high() const { return high_; }
  /// Whether the patch meets itself at both ends of a parameter.
  [[nodiscard]] bool closed(std::size_t along) const { return closed_[along]; }
  [[nodiscard]] Derivatives derivatives(const Parameters&) const;
  /// Whether the parameters lie within the trimming of a face or on its boundary.
  [[nodiscard]] bool contains(const Parameters&) const;
  /// Points distributed over the patch, at least one; computed on first use.
  [[nodiscard]] const std::vector<Sample>& samples() const;
  /// Indices of the values, one per sample, that are not above any neighbour in the grid.
  [[nodiscard]] std::vector<std::size_t> localMinima(const std::vector<double>& values) const;
  /// Approximate maximum distance of a point of the patch from the nearest sample.
  [[nodiscard]] double spacing() const;

 private:
  [[nodiscard]] Vec3 point(const Parameters&) const;
  [[nodiscard]] bool closes(std::size_t along) const;
  void makeSamples() const;
  [[nodiscard]] std::size_t cell(int i, int j) const;
  [[nodiscard]] int placeOf(int i, int j) const;
  std::unique_ptr<BRepAdaptor_Surface> surface_;
  std::unique_ptr<BRepAdaptor_Curve> curve_;
  std::unique_ptr<BRepTopAdaptor_FClass2d> trimming_;
  Vec3 vertex_ = Vec3::Zero();
  Parameters low_{0, 0}, high_{0, 0};
  std::array<bool, 2> closed_{};
  Bounds box_;
  mutable std::vector<Sample> samples_;
  mutable std::vector<int> grid_;  // u-major; index in samples_, -1 where the patch is trimmed away
  mutable int countU_ = 1, countV_ = 1;
  mutable double spacing_ = 0;
};

}  // namespace blossom
