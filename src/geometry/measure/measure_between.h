#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/measure/measure.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/shape/shape.h"

namespace blossom {

/// A shape or one part of it, numbered as geometry/occt/sub_shape.h says.
struct MeasuredPart {
  Shape shape;
  SubShapeKind kind = SubShapeKind::Whole;
  int index = -1;
};

/// Figures of one part, or of two to one another, and what a drawing of them shows.
struct Measurement {
  std::string kind;             ///< name of the figure that a label shows: "distance", "radius", "angle", ..
  std::vector<Measure> values;  ///< that one first; lengths in mm, angles in degrees
  /// Polylines to draw. Of a distance: one from foot point to foot point; of a radius: from the centre; of an angle: its
  /// arc.
  std::vector<std::vector<Vec3>> lines;
  Vec3 label = Vec3::Zero();  ///< where the label stands
};

/// What one part is by itself.
/// vertex: x y z; edge: length, of circles and arcs radius diameter length angle (arcs only) center_x .. , of ellipses
/// major_radius minor_radius length; face: area perimeter, before them radius diameter of cylinders and spheres, the
/// half_angle of cones, major_radius minor_radius of tori; whole: volume area or what `measure` calls first, and size_x .. .
/// Lines, circles and planes given as B-splines are known for what they are.
/// @throws Error NotFound (no such part), InvalidInput (nothing to measure), Degenerate, Cancelled.
Measurement measureOne(const MeasuredPart&, const Progress& = Progress::none());

/// Two parts to one another: `distance`, the smallest between their exact curves and surfaces (0 where they meet or one lies
/// in the other's solid), and delta_x delta_y delta_z from foot point to foot point; `angle` between lines, axes and planar
/// faces (0..90, or 0..180 for edges that leave a common point; it leads where the two touch); plane_distance of parallel
/// planes (also of a point, a parallel line and a plane), axis_distance of axes and lines, center_distance of circles and
/// spheres. Meshes are measured by their triangles.
/// @throws Error as measureOne.
Measurement measureBetween(const MeasuredPart&, const MeasuredPart&, const Progress& = Progress::none());

}  // namespace blossom
