#include "ui/view/rehearsal.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "scene/scene.h"
#include "ui/tools/view_props.h"
#include "ui/view/ground_grid.h"
#include "ui/view/items/view_items.h"
#include "ui/view/painter.h"

namespace blossom::ui {

namespace {

const QSize size(64, 64);

/// A tetrahedron with edges and corners.
SceneData solid(bool colored) {
  Tessellation t;
  t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vec3& p : t.points) t.normals.push_back((p - Vec3::Constant(0.25)).normalized());
  t.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  t.faceOfTriangle = {0, 1, 2, 3};
  if (colored) t.faceColors.assign(4, Color{0.5, 0.5, 0.5});
  t.edges = {{t.points[0], t.points[1]}, {t.points[1], t.points[2]}};
  t.edgeIndices = {0, 1};
  if (colored) t.edgeColors.assign(2, Color{0.5, 0.5, 0.5});
  t.vertices = t.points;
  SceneData scene = toSceneData(t);
  scene.solid = true;
  return scene;
}

SceneData drawing() {
  Tessellation t;
  t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  t.triangles = {{0, 1, 2}};
  t.faceOfTriangle = {0};
  t.edges = {{t.points[0], t.points[1], t.points[2]}};
  t.edgeIndices = {0};
  t.vertices = t.points;
  return toSceneData(t);
}

void addHandles(vtkRenderer& stage, const Look& look) {
  const Vec3 a = Vec3::Zero(), b = Vec3::UnitX(), c = Vec3::UnitY();
  for (const PropPtr& prop : {linesProp({{a, b}}, look.control, 2), pointsProp({a, b}, look.control, 6),
                              trianglesProp({{a, b, c}}, look.control, 1), trianglesProp({{a, b, c}}, look.control, 0.2),
                              labelProp(QStringLiteral("1"), a, {Qt::white, Qt::black, Qt::gray, 1})})
    stage.AddViewProp(prop);
}

}  // namespace

void rehearse(Painter& painter) {
  if (!painter.fresh() || !painter.problem().isEmpty()) return;
  const Look look = Look::dark();
  vtkNew<vtkRenderer> stage;
  setUpRenderer(stage, look);
  painter.add(stage);
  GroundGrid grid;
  grid.follow(Vec3::Zero(), 0.01, 100, look);
  stage->AddActor(grid.actor());
  ViewItems items(stage);
  items.setLook(look);
  items.set({{"plain", solid(false), ItemRole::Plain},
             {"coloured", solid(true), ItemRole::Control},
             {"drawing", drawing(), ItemRole::Made}});
  stage->ResetCamera();
  const auto draw = [&] { painter.take(painter.begin(stage, size, 0)); };
  draw();
  addHandles(*stage, look);
  items.setCulling(true);
  draw();
  items.setSection(CutPlane{Vec3::UnitX(), 0.2});
  (void)items.followSection(*stage->GetActiveCamera(), 0.01);
  draw();
  painter.remove(stage);
}

}  // namespace blossom::ui
