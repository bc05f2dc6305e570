#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "geometry/shape/shape.h"

namespace blossom::modeling {

/// The affine image of a shape. B-reps keep names and colours; under rigid motions they stay shared, under similarities
/// their surfaces keep their kind, otherwise they become B-splines. Regions and curves that leave the plane z = 0 become
/// flat faces and wires in space. Faces look outward also after a reflection. O(size).
/// @throws Error InvalidInput for a motion, Degenerate when the map flattens space.
Shape transformed(const Shape&, const Eigen::Affine3d&);

/// Several shapes of one kind as one: instances of an assembly, polygons of one mesh, loops of one region, frame by frame of
/// a sequence. Regions that overlap are united. Other kinds become B-reps.
/// @throws Error InvalidInput.
Shape gathered(const std::vector<Shape>&);

/// The same shape as a B-rep: regions as faces, curves as wires, surfaces as faces.
/// @throws Error InvalidInput for other kinds.
Brep asBrep(const Shape&);

/// Flat faces in z = 0 as a region again.
Region asRegion(const TopoDS_Shape& faces);

}  // namespace blossom::modeling
