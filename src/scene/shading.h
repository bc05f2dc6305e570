#pragma once
#include <optional>

#include "scene/picking.h"
#include "scene/scene.h"

class vtkActor;
class vtkCamera;

/// How faces are shaded: by the lights of `setUpRenderer`, written out in the fragment shader. Software rendering spends
/// most of a frame there, and the general code for four lights costs several times as much.
namespace blossom {

/// @param capped the shape is closed and a section cuts it: what is seen of its inside is painted as the cut itself, hatched
/// in the plane of the cut.
void shadeFaces(vtkActor&, bool capped);

/// What the cut through closed shapes looks like.
struct CapLook {
  Color fill, hatch;
  double spacing = 5;  ///< mm between the lines of the hatching
};
/// Tells a capped actor where the cut is. To be called before each frame.
void placeCap(vtkActor&, const CutPlane&, const CapLook&, vtkCamera&);

}  // namespace blossom
