#pragma once
#include <optional>

#include "scene/picking.h"
#include "scene/scene.h"

class vtkActor;
class vtkCamera;

/// How faces are shaded: by the lights of `setUpRenderer`, written out in the fragment shader. Software rendering spends
/// most of a frame there, and the general code for four lights costs several times as much.
namespace blossom {

/// Shades faces by the lights of `setUpRenderer` with a fragment shader written for them. Software rendering spends most of
/// a frame there, and VTK's general code for four lights is several times slower.
/// @param capped the shape is closed and cut by a section: its visible inside is painted as the section, hatched in the
/// plane of the cut
void shadeFaces(vtkActor&, bool capped);

/// Appearance of the section of closed shapes.
struct CapLook {
  Color fill, hatch;
  double spacing = 5;  ///< mm between hatching lines
};
/// Updates the plane of the section and its look in a capped actor. Call it before each frame.
void placeCap(vtkActor&, const CutPlane&, const CapLook&, vtkCamera&);

}  // namespace blossom
