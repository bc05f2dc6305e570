#pragma once
#include <TopoDS_Face.hxx>

#include "core/progress.h"
#include "geometry/bspline/surface.h"
#include "geometry/measure/measure.h"
#include "geometry/mesh/mesh.h"
#include "geometry/shape/brep.h"

/// The kinds of `measure`, one file each.
namespace blossom {

Measures measureMesh(const Mesh&, const Progress&);
Measures measureSurface(const Surface&, const Progress&);
Measures measureBrep(const Brep&, const Progress&);

/// Area of a surface over its whole domain by adaptive Gauss quadrature on its Bézier spans, to 1e-10 relative where it is
/// smooth.
double surfaceArea(const Surface&, const Progress&);

/// What a face adds to the area and to the volume of its solid (the cone over it from `reference`), its orientation counted.
struct FaceIntegral {
  double area = 0;
  double volume = 0;
};
/// Planar faces by Green's formula along their edges, faces over a rectangle of parameters by Gauss quadrature span by span,
/// others by OCCT's adaptive one. Not all by OCCT because its BRepGProp is off by 5e-3 of the area of a torus of B-splines,
/// and by 1e-9 when it is asked for 1e-12.
FaceIntegral integrateFace(const TopoDS_Face&, const Vec3& reference, const Progress&);

inline Measure count(std::string name, std::size_t value) {
  return {std::move(name), static_cast<std::int64_t>(value), MeasureUnit::None};
}

}  // namespace blossom
