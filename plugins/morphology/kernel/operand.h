#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/shape/shape.h"
#include "geometry/values/box.h"

namespace blossom::morphology {

/// An operand of morphology: a solid, or a thinner shape with which a solid is dilated or eroded.
struct Operand {
  enum class Form { Body, Sheet, Lines, Points };
  Form form = Form::Body;
  Mesh mesh;                              ///< of a Body
  std::vector<std::vector<Vec3>> pieces;  ///< of other forms: triangles, segments or points
  std::string name = "The solid";         ///< in messages
  [[nodiscard]] Bounds bounds() const;
};

struct OperandOptions {
  double deviation = 0.05;  ///< mm, maximum distance between a curved shape and its polyhedron
  std::string name = "The solid";
  bool solidOnly = false;  ///< refuse shapes without volume
};

/// A mesh or B-rep becomes a Body; regions, closed outlines, surfaces, faces without a solid and open planar meshes become
/// Sheet pieces; other curves and wires Lines; a mesh without faces Points. Any other open mesh stays a Body, which the
/// checks of solids refuse: it more often is a solid with a hole in its skin. @throws Error InvalidInput, Cancelled.
Operand operandOf(const Shape&, const OperandOptions&, const Progress& = Progress::none());

}  // namespace blossom::morphology
