#include "ui/view/items/section_cap.h"

#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "scene/section/cross_section.h"
#include "scene/shading.h"

namespace blossom::ui {

namespace {

bool isSame(const CutPlane& a, const CutPlane& b) { return a.normal == b.normal && a.offset == b.offset; }

void setData(vtkActor& actor, vtkPolyData* data) {
  actor.SetVisibility(data != nullptr);
  if (data) vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

}  // namespace

bool SectionCap::follow(vtkRenderer& renderer, vtkPolyData& solid, const CutPlane& plane) {
  if (faces_ == &solid && plane_ && isSame(*plane_, plane)) return false;
  faces_ = &solid;
  plane_ = plane;
  const CrossSection section = crossSection(solid, plane);
  const bool isFirst = !area_ && section.area && section.outline;
  if (isFirst) {
    SceneData drawn;
    drawn.faces = section.area;
    drawn.edges = section.outline;
    const auto actors = makeActors(drawn, Look::dark());
    area_ = actors.front();
    outline_ = actors.back();
    shadeSection(*area_);
    renderer.AddActor(area_);
    renderer.AddActor(outline_);
  } else if (area_) {
    setData(*area_, section.area);
    setData(*outline_, section.outline);
  }
  return isFirst;
}

bool SectionCap::leave(vtkRenderer& renderer) {
  const bool had = area_ != nullptr;
  if (had) {
    renderer.RemoveActor(area_);
    renderer.RemoveActor(outline_);
  }
  *this = {};
  return had;
}

void SectionCap::paint(const ItemPaint& paint, double spacing, bool outlined, vtkCamera& camera) const {
  if (!area_ || !area_->GetVisibility()) return;
  paintActor(*area_, paint);
  paintActor(*outline_, paint);
  outline_->SetVisibility(outlined);
  const double* c = area_->GetProperty()->GetColor();
  const Color color{c[0], c[1], c[2]}, fill = mixed(color, paint.look.backgroundBottom, 0.35);
  placeHatching(*area_, *plane_, {fill, mixed(fill, color, 0.55), spacing}, camera);
}

}  // namespace blossom::ui
