#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/measure/measure.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/shape/shape.h"

namespace blossom {

/// A shape or one of its sub-shapes, numbered as in geometry/occt/sub_shape.h.
struct MeasuredPart {
  Shape shape;
  SubShapeKind kind = SubShapeKind::Whole;
  int index = -1;
};

/// Figures of one part or of a pair of parts, and the lines that illustrate them.
struct Measurement {
  std::string kind;             ///< name of the figure shown in the label: "distance", "radius", "angle", ..
  std::vector<Measure> values;  ///< the figure of the label first; lengths in mm, angles in degrees
  /// Polylines to draw. For a distance: between the foot points; for a radius: from the centre; for an angle: its
  /// arc.
  std::vector<std::vector<Vec3>> lines;
  Vec3 label = Vec3::Zero();  ///< position of the label
};

/// Figures of one part.
/// vertex: x y z; edge: length, of circles and arcs radius diameter length angle (arcs only) center_x .. , of ellipses
/// major_radius minor_radius length; face: area perimeter, before them radius diameter of cylinders and spheres, the
/// half_angle of cones, major_radius minor_radius of tori; whole: volume area, or the first measures of `measure`, and
/// size_x .. . Lines, circles and planes given as B-splines are recognised.
/// @throws Error NotFound (no such part), InvalidInput (nothing to measure), Degenerate, Cancelled.
Measurement measureOne(const MeasuredPart&, const Progress& = Progress::none());

/// Figures of two parts: `distance`, the minimum distance of their exact curves and surfaces (0 where they meet or one lies
/// inside the other's solid), and delta_x delta_y delta_z from foot point to foot point; `angle` between lines, axes and
/// planar faces (0..90, or 0..180 between edges with a common end; it comes first where the parts touch); plane_distance of
/// parallel planes (also of a plane and a point or a parallel line), axis_distance of axes and lines, center_distance of
/// circles and spheres. Meshes are measured by their triangles.
/// @throws Error as measureOne.
Measurement measureBetween(const MeasuredPart&, const MeasuredPart&, const Progress& = Progress::none());

}  // namespace blossom
