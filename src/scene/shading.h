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
/// @param capped the shape is closed and cut by a section: its visible inside is painted as the section, hatched in the
/// plane of the cut
void shadeFaces(vtkActor&, bool capped, const FaceShading& = {});

/// Colours by those of the cells, or else by the actor's own one.
void useOwnColors(vtkMapper&);

/// The colours of a curvature between the ends of a range, for `FaceShading`.
vtkSmartPointer<vtkLookupTable> curvatureColors(SurfaceDisplay, const CurvatureRange&);

/// Appearance of the section of closed shapes.
struct CapLook {
  Color fill, hatch;
  double spacing = 5;  ///< mm between hatching lines
};
/// Updates the plane of the section and its look in a capped actor. Call it before each frame.
void placeCap(vtkActor&, const CutPlane&, const CapLook&, vtkCamera&);

}  // namespace blossom
