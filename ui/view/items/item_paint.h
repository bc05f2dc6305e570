#pragma once
#include "scene/scene.h"

class vtkActor;

namespace blossom::ui {

/// How a shape takes part in what is being done, and thereby its colour.
enum class ItemRole { Plain, Made, Control };

/// How far a shape is what there is now.
enum class Presence {
  Whole,
  Outdated,    ///< that of an older document: drawn faintly
  Failed,      ///< the last one before its feature failed: drawn faintly, with edges in the colour of faults
  Beneath,     ///< a control shape: translucent, under the result
  SteppedBack  ///< not what is edited, but what it is made of or goes into: a hint of it, found by the mouse where nothing
               ///< else is
};

/// What decides how the actors of a shape are painted.
struct ItemPaint {
  const SceneData& scene;
  ItemRole role;
  Presence presence;
  const Look& look;  ///< with widths in device pixels
  bool hovered;
};

/// Curves, or faces that lie in one plane.
bool isDrawing(const SceneData&);

/// Colours, opacity, widths and the layer of one actor. Its geometry stays on the graphics card.
void paintActor(vtkActor&, const ItemPaint&);

}  // namespace blossom::ui
