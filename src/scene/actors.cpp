#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkLight.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "scene/scene.h"
#include "scene/shading.h"
#include "scene/surface_study.h"

namespace blossom {

namespace {

using ActorPtr = vtkSmartPointer<vtkActor>;

ActorPtr makeActor(vtkPolyData* data, const Color& color) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  useOwnColors(*mapper);
  auto actor = ActorPtr::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.red, color.green, color.blue);
  return actor;
}

// Edges step forward in depth so that they are drawn whole where they lie on faces. Not the faces back: a shader that writes
// depths makes the card shade also what is hidden.
void pullForward(vtkActor& actor) {
  actor.GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  actor.GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-3, -6);
  actor.GetMapper()->SetRelativeCoincidentTopologyPointOffsetParameter(-10);
}

ActorPtr faceActor(const SceneData& data, vtkPolyData* faces, const Look& look) {
  const Color color = data.planar ? mixed(look.backgroundBottom, look.curve, 0.22) : look.surface;
  ActorPtr actor = makeActor(faces, color);
  if (data.planar) {
    actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
  }
  vtkProperty& property = *actor->GetProperty();
  if (data.planar) {
    property.SetLighting(false);  // a filled drawing keeps its colour from every side
    return actor;
  }
  property.SetInterpolationToPhong();
  property.SetAmbient(0.10);
  property.SetDiffuse(0.86);
  property.SetSpecular(0.28);
  shadeFaces(*actor);
  return actor;
}

ActorPtr edgeActor(const SceneData& data, const Look& look) {
  const bool onFaces = data.faces && !data.planar;
  ActorPtr actor = makeActor(data.edges, onFaces ? look.edge : look.curve);
  pullForward(*actor);
  actor->GetProperty()->SetLighting(false);
  actor->GetProperty()->SetLineWidth(static_cast<float>(onFaces ? look.edgeWidth : look.edgeWidth * 1.4));
  return actor;
}

ActorPtr pointActor(const SceneData& data, const Look& look) {
  ActorPtr actor = makeActor(data.points, look.control);
  pullForward(*actor);
  actor->GetProperty()->SetLighting(false);
  actor->GetProperty()->SetRenderPointsAsSpheres(true);
  actor->GetProperty()->SetPointSize(static_cast<float>(look.pointSize));
  return actor;
}

// Written out once more in shading.cpp.
// Lights are attached to the camera, so that every shape is lit from the upper left.
void addLight(vtkRenderer& renderer, double x, double y, double z, double intensity, const Color& color) {
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToCameraLight();
  light->SetPositional(false);
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  light->SetColor(color.red, color.green, color.blue);
  renderer.AddLight(light);
}

}  // namespace

std::vector<ActorPtr> makeActors(const SceneData& data, const Look& look) {
  std::vector<ActorPtr> actors;
  for (const auto& piece : data.pieces) actors.push_back(faceActor(data, piece, look));
  if (data.faces && data.pieces.empty()) actors.push_back(faceActor(data, data.faces, look));
  if (data.edges) actors.push_back(edgeActor(data, look));
  if (data.points) actors.push_back(pointActor(data, look));
  return actors;
}

// They lie on the surface itself, up to the chord of the picture behind the triangles of its faces.
ActorPtr makeIsoCurveActor(vtkPolyData* isoCurves, const Look& look) {
  ActorPtr actor = makeActor(isoCurves, mixed(look.edge, look.surface, 0.25));
  pullForward(*actor);
  actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-3, -60);
  actor->GetProperty()->SetLighting(false);
  actor->GetProperty()->SetLineWidth(static_cast<float>(look.edgeWidth));
  return actor;
}

ActorRole roleOf(vtkActor* actor) {
  const auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputAsDataSet());
  auto& polyData = const_cast<vtkPolyData&>(*data);
  if (polyData.GetNumberOfPolys() > 0) return ActorRole::Faces;
  if (polyData.GetCellData()->HasArray("iso")) return ActorRole::IsoCurves;
  return polyData.GetNumberOfLines() > 0 ? ActorRole::Edges : ActorRole::Points;
}

void setUpRenderer(vtkRenderer* renderer, const Look& look) {
  renderer->GradientBackgroundOn();
  renderer->SetBackground(look.backgroundBottom.red, look.backgroundBottom.green, look.backgroundBottom.blue);
  renderer->SetBackground2(look.backgroundTop.red, look.backgroundTop.green, look.backgroundTop.blue);
  renderer->SetAutomaticLightCreation(false);
  renderer->SetTwoSidedLighting(true);
  renderer->RemoveAllLights();
  addLight(*renderer, -0.5, 0.55, 0.9, 0.72, {1.0, 0.975, 0.94});  // key, warm
  addLight(*renderer, 0.1, -0.15, 1.0, 0.36, {1.0, 0.99, 0.98});   // from beside the eye: nothing that is seen stays dark
  addLight(*renderer, 0.9, 0.1, 0.5, 0.28, {0.90, 0.95, 1.0});     // fill, cool
  addLight(*renderer, 0.35, 0.55, -0.9, 0.30, {0.92, 0.96, 1.0});  // rim, from behind
}

}  // namespace blossom
