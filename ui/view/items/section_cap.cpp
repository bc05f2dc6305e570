#include "ui/view/items/section_cap.h"

#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <chrono>

#include "scene/section/cross_section.h"
#include "scene/section/deadline.h"
#include "scene/shading.h"

namespace blossom::ui {

namespace {

bool isSame(const CutPlane& a, const CutPlane& b) { return a.normal == b.normal && a.offset == b.offset; }

/// Gives an actor other data. @returns whether it has just come
bool show(vtkSmartPointer<vtkActor>& actor, const SceneData& data, vtkRenderer& renderer) {
  vtkPolyData* const drawn = data.faces ? data.faces : data.edges;
  if (actor) actor->SetVisibility(drawn != nullptr);
  if (!drawn) return false;
  if (actor) {
    vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(drawn);
    return false;
  }
  actor = makeActors(data, Look::dark()).front();
  renderer.AddActor(actor);
  return true;
}

}  // namespace

bool SectionCap::follow(vtkRenderer& renderer, vtkPolyData& solid, const CutPlane& plane) {
  if (faces_ == &solid && plane_ && isSame(*plane_, plane)) return false;
  faces_ = &solid;
  plane_ = plane;
  constexpr std::chrono::milliseconds budget(150);  // without filling, the view goes on to follow the hand
  const Deadline deadline(budget);
  const CrossSection section = crossSection(solid, plane, deadline.progress());
  SceneData area, outline;
  area.faces = section.area;
  outline.edges = section.outline;
  const bool areaCame = show(area_, area, renderer), outlineCame = show(outline_, outline, renderer);
  if (areaCame) shadeSection(*area_);
  hasArea_ = section.area != nullptr;
  hasOutline_ = section.outline != nullptr;
  return areaCame || outlineCame;
}

bool SectionCap::leave(vtkRenderer& renderer) {
  const bool had = area_ || outline_;
  for (const auto& actor : {area_, outline_})
    if (actor) renderer.RemoveActor(actor);
  *this = {};
  return had;
}

// All sections lie in one plane, and in it the frame that a tool draws: each is a hair in front of the one before.
void SectionCap::paint(const ItemPaint& paint, const Drawn& drawn, vtkCamera& camera) const {
  if (hasOutline_) {
    paintActor(*outline_, paint);
    outline_->SetVisibility(drawn.outlined);
  }
  if (!hasArea_) return;
  paintActor(*area_, paint);
  area_->SetVisibility(drawn.filled);
  area_->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  area_->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -2 - 3 * drawn.share);
  const double* c = area_->GetProperty()->GetColor();
  const Color color{c[0], c[1], c[2]}, fill = mixed(color, paint.look.backgroundBottom, 0.35);
  placeHatching(*area_, *plane_, {fill, mixed(fill, paint.look.edge, 0.3), drawn.spacing, drawn.angle}, camera);
}

}  // namespace blossom::ui
