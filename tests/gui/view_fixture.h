#pragma once
#include <BRepPrimAPI_MakeBox.hxx>
#include <memory>

#include "geometry/shape/brep.h"
#include "scene/picking.h"
#include "ui/look/theme.h"
#include "ui/view/view_widget.h"

/// What views show in their tests.
namespace blossom::ui {

inline SceneData sceneOf(const Shape& shape) {
  SceneData scene = toSceneData(tessellate(shape, {.chord = 0.01, .angle = 0.1}));
  scene.solid = true;
  scene.picks = std::make_shared<const PickIndex>(scene);
  return scene;
}

/// From (-10, -10, 0) to (10, 10, 20).
inline const Brep& box() {
  static const Brep made(BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), 20, 20, 20).Shape());
  return made;
}

/// A view of 800 x 600 on the screen.
inline std::unique_ptr<ViewWidget> openView() {
  auto view = std::make_unique<ViewWidget>();
  view->resize(800, 600);
  view->setLook(theme().look());
  view->show();
  return view;
}

}  // namespace blossom::ui
