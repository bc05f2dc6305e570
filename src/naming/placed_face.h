#pragma once
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <memory>
#include <vector>

#include "core/vector.h"

namespace blossom {

/// A face with what is needed to tell whether points lie on it.
class PlacedFace {
 public:
  explicit PlacedFace(const TopoDS_Face&);

  /// Two points inside the face, none of them in a place of symmetry; fewer where none was found.
  [[nodiscard]] const std::vector<Vec3>& inside() const { return inside_; }
  /// Whether no point of it lies in a box.
  [[nodiscard]] bool isOutside(const Bnd_Box& box) const { return box_.IsOut(box); }
  /// Whether a point lies within a distance of the surface, wherever the face ends.
  [[nodiscard]] bool onSurface(const Vec3&, double tolerance) const;
  /// Whether a point lies on the face, within a distance.
  [[nodiscard]] bool holds(const Vec3&, double tolerance) const;

 private:
  void findInside();

  TopoDS_Face face_;
  Bnd_Box box_;
  Handle(ShapeAnalysis_Surface) surface_;
  std::unique_ptr<BRepTopAdaptor_FClass2d> border_;
  std::vector<Vec3> inside_;
};

}  // namespace blossom
