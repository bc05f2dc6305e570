#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "geometry/shape/shape.h"

namespace blossom::modeling {

/// The affine image of a shape. B-reps keep names and colours; under rigid motions their geometry is shared, under
/// similarities surfaces keep their type, otherwise they become B-splines. Regions and curves that leave the plane z = 0
/// become planar faces and wires. Faces are oriented outward also after a reflection. O(size).
/// @throws Error InvalidInput for a motion, Degenerate when the map is singular.
Shape transformed(const Shape&, const Eigen::Affine3d&);

/// Several shapes of one kind as one: instances of an assembly, polygons of one mesh, loops of one region. Overlapping
/// regions are united. Other kinds become B-reps.
/// @throws Error InvalidInput.
Shape gathered(const std::vector<Shape>&);

/// The same shape as a B-rep: regions as faces, curves as wires, surfaces as faces.
/// @throws Error InvalidInput for other kinds.
Brep asBrep(const Shape&);

/// The region of planar faces in z = 0.
Region asRegion(const TopoDS_Shape& faces);

}  // namespace blossom::modeling
