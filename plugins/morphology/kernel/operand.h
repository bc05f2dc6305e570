#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/shape/shape.h"
#include "geometry/values/box.h"

namespace blossom::morphology {

/// What a morphology operation is made of: a solid, or something thinner that a solid is added to or melted by.
struct Operand {
  enum class Form { Body, Flat, Lines, Points };
  Form form = Form::Body;
  Mesh mesh;                              ///< of a solid
  std::vector<std::vector<Vec3>> pieces;  ///< otherwise: triangles, segments or points
  std::string name = "The solid";         ///< in messages
  [[nodiscard]] Bounds bounds() const;
};

struct OperandOptions {
  double deviation = 0.05;  ///< mm, largest distance between a curved shape and the polyhedron for it
  std::string name = "The solid";
  bool solidOnly = false;  ///< refuse what has no volume
};

/// A mesh or B-rep as a solid; regions, closed outlines, flat faces and open flat
/// meshes as flat pieces; other curves and wires as segments; a mesh
/// without faces as points. @throws Error InvalidInput, Cancelled.
Operand operandOf(const Shape&, const OperandOptions&, const Progress& = Progress::none());

}  // namespace blossom::morphology
