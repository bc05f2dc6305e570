#pragma once
#include <optional>

#include "scene/picking.h"
#include "scene/scene.h"
#include "scene/surface_display.h"

class vtkCamera;
class vtkLookupTable;
class vtkMapper;

/// How faces are shaded: by the lights of `setUpRenderer`, written out in the fragment shader. Software rendering spends
/// most of a frame there, and the general code for four lights costs several times as much.
namespace blossom {

/// What is told by the shading of faces.
struct FaceShading {
  SurfaceDisplay display = SurfaceDisplay::Plain;
  ZebraLook zebra = {};
  vtkLookupTable* colors = nullptr;  ///< of a curvature; faces whose points have no curvatures keep their own
};

/// Shades faces by the lights of `setUpRenderer` with a fragment shader written for them. Software rendering spends most of
/// a frame there, and VTK's general code for four lights is several times slower.
void shadeFaces(vtkActor&, const FaceShading& = {});

/// Colours by those of the cells, or else by the actor's own one.
void useOwnColors(vtkMapper&);

/// The colours of a curvature between the ends of a range, for `FaceShading`.
vtkSmartPointer<vtkLookupTable> curvatureColors(SurfaceDisplay, const CurvatureRange&);

/// Shades the section of a solid as a drawing does: filled and hatched.
void shadeSection(vtkActor&);

struct HatchLook {
  Color fill, lines;
  double spacing = 5;             ///< mm between the lines
  double angle = 0.785398163397;  ///< of the lines to an axis of the plane
};
/// Updates the hatching of a section. Call it before each frame.
void placeHatching(vtkActor&, const CutPlane&, const HatchLook&, vtkCamera&);

}  // namespace blossom
