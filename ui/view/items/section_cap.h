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

  /// @param spacing mm between the lines of the hatching
  void paint(const ItemPaint&, double spacing, bool outlined, vtkCamera&) const;

 private:
  vtkSmartPointer<vtkPolyData> faces_;  // of the solid that was cut last
  std::optional<CutPlane> plane_;
  vtkSmartPointer<vtkActor> area_, outline_;
};

}  // namespace blossom::ui
