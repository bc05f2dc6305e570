#pragma once
#include <array>
#include <memory>
#include <optional>

#include "core/progress.h"
#include "scene/scene.h"
#include "scene/surface_display.h"

namespace blossom {

/// What the displays of surfaces draw of a shape: the same triangles as ever, with the curvatures of their points, and the
/// curves of constant parameter.
struct SurfaceStudy {
  /// The points of its faces and pieces have the arrays of `curvatureArray`.
  SceneData scene;
  vtkSmartPointer<vtkPolyData> isoCurves;  ///< lines with the cell array "iso"; null when there are none
  std::array<double, 3> bounds{};          ///< of Gaussian, Mean, Largest; see `curvatureBound`
};

/// @param options those by which the shape is drawn otherwise: points, triangles and numbers are the same then
/// @param isoCurves in each direction of a face
/// @throws Error as tessellate and isoCurves.
SurfaceStudy studySurfaces(const Shape&, const TessellationOptions& options, int isoCurves, const Progress&);

/// The name of the array of points that holds a curvature.
const char* curvatureArray(SurfaceDisplay);
/// One value of a point's curvatures. @pre showsCurvature(display).
double curvatureValue(const SurfaceCurvature&, SurfaceDisplay);

/// Absolute value that a scale of colours should reach: 98 of 100 parts of the area that bends at all have less, so that a
/// few places, such as the tip of a cone, do not take all the colours. Of two digits; above 0 also when nothing bends.
/// O(n log n).
double curvatureBound(const Tessellation&, SurfaceDisplay);
/// Of the study; 0 for one without faces.
double curvatureBound(const SurfaceStudy&, SurfaceDisplay);

/// The value drawn at a point of a face, from the corners of the triangle that is nearest to it; empty when the face is not
/// there. O(triangles).
std::optional<double> drawnCurvature(const SurfaceStudy&, SurfaceDisplay, int face, const Vec3& point);

/// The actor of the iso-curves, drawn in front of the faces that they lie on.
vtkSmartPointer<vtkActor> makeIsoCurveActor(vtkPolyData* isoCurves, const Look&);

}  // namespace blossom
