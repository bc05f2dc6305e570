#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "geometry/measure/measure_between.h"
#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// The form of a part as far as axes, planes and centres are concerned.
struct PartForm {
  enum class Kind { Free, Point, Line, Circle, Ellipse, Plane, Cylinder, Cone, Sphere, Torus };
  Kind kind = Kind::Free;
  Vec3 origin = Vec3::Zero();                 ///< the point, a point of the line or plane, or the centre
  Vec3 direction = Vec3::UnitZ();             ///< of the line or axis, or normal of the plane; unit length
  double radius = 0, minor = 0;               ///< mm; `minor` of ellipses and tori only
  double angle = 0;                           ///< radians: of an arc from end to end, the half angle of a cone
  std::optional<std::pair<Vec3, Vec3>> ends;  ///< of an edge

  [[nodiscard]] bool hasAxis() const;    ///< has a direction and is no plane
  [[nodiscard]] bool hasCentre() const;  ///< of a circle, an ellipse or a sphere
};

/// A part as an exact OCCT shape, or as triangles when it belongs to a mesh.
struct PartGeometry {
  TopoDS_Shape exact;
  std::vector<Triangle3> triangles;
  PartForm form;
  bool full = false;  ///< the triangles bound a solid
};

/// @throws Error NotFound, InvalidInput.
PartGeometry geometryOf(const MeasuredPart&);

PartForm formOf(const TopoDS_Shape&);

}  // namespace blossom
