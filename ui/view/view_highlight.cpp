#include "ui/view/view_highlight.h"

#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace blossom::ui {

bool samePart(const Pick& a, const Pick& b) {
  return a.feature == b.feature && a.part.kind == b.part.kind && a.part.index == b.part.index;
}

bool PartHighlight::set(const std::vector<Pick>& picks, const ViewItems& items) {
  if (picks.empty() && picks_.empty()) return false;
  for (const auto& actor : actors_) renderer_->RemoveActor(actor);
  actors_.clear();
  picks_ = picks;
  for (const Pick& pick : picks_) {
    const SceneData* scene = pick.part.index >= 0 ? items.scene(pick.feature) : nullptr;
    if (!scene) continue;
    for (const auto& actor : makeActors(subShapeData(*scene, pick.part.kind, pick.part.index), look_)) {
      // A step towards the eye: it lies where the part itself lies.
      actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
      actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -1);
      actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-4, -10);
      actor->GetMapper()->SetRelativeCoincidentTopologyPointOffsetParameter(-16);
      actor->GetMapper()->ScalarVisibilityOff();
      if (clip_) actor->GetMapper()->AddClippingPlane(clip_);
      actor->PickableOff();
      actor->UseBoundsOff();
      renderer_->AddActor(actor);
      actors_.push_back(actor);
    }
  }
  paint();
  return true;
}

void PartHighlight::setLook(const Look& look, const Color& accent, double strength) {
  look_ = look;
  accent_ = accent;
  strength_ = strength;
  paint();
}

void PartHighlight::setSection(vtkPlane* clip) {
  clip_ = clip;
  for (const auto& actor : actors_) {
    actor->GetMapper()->RemoveAllClippingPlanes();
    if (clip) actor->GetMapper()->AddClippingPlane(clip);
  }
}

void PartHighlight::paint() const {
  for (const auto& actor : actors_) {
    vtkProperty& property = *actor->GetProperty();
    const Color color = roleOf(actor) == ActorRole::Faces ? mixed(look_.surface, accent_, strength_) : accent_;
    property.SetColor(color.red, color.green, color.blue);
    property.SetLineWidth(static_cast<float>(look_.edgeWidth * (2 + strength_)));
    property.SetPointSize(static_cast<float>(look_.pointSize * (1.2 + 0.4 * strength_)));
  }
}

}  // namespace blossom::ui
