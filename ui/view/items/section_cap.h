#pragma once
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>

#include "scene/picking.h"
#include "scene/scene.h"
#include "ui/view/items/item_paint.h"

class vtkCamera;
class vtkRenderer;

namespace blossom::ui {

/// The section of one shape in a renderer: filled, hatched and outlined.
class SectionCap {
 public:
  /// Cuts anew when the faces or the plane are others. @returns whether the renderer has other actors now
  bool follow(vtkRenderer&, vtkPolyData& solid, const CutPlane&);
  bool leave(vtkRenderer&);  ///< removes the section. @returns whether there was one

  struct Drawn {
    double spacing = 5;  ///< mm between the lines of the hatching
    double share = 1;    ///< 0 to 1: where sections overlap, the larger one is seen
    double angle = 0;    ///< of the lines
    bool filled = true, outlined = true;
  };
  void paint(const ItemPaint&, const Drawn&, vtkCamera&) const;

 private:
  vtkSmartPointer<vtkPolyData> faces_;  // of the solid that was cut last
  std::optional<CutPlane> plane_;
  vtkSmartPointer<vtkActor> area_, outline_;  // null before there is anything to be drawn
  bool hasArea_ = false, hasOutline_ = false;
};

}  // namespace blossom::ui
