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
  enum class Form { Body, Flat, Lines, Points };
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

/// A mesh or B-rep becomes a Body; regions, closed outlines, planar faces and open planar meshes become Flat pieces; other
/// curves and wires Lines; a mesh without faces Points. @throws Error InvalidInput, Cancelled.
Operand operandOf(const Shape&, const OperandOptions&, const Progress& = Progress::none());

}  // namespace blossom::morphology
