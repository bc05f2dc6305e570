#include "ui/view/kept_props.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>

#include "ui/tools/view_props.h"

namespace blossom::ui {

namespace {

using Props = std::vector<vtkSmartPointer<vtkProp>>;

vtkPolyData* dataOf(vtkProp& prop) {
  const auto actor = vtkActor::SafeDownCast(&prop);
  const auto mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper ? mapper->GetInput() : nullptr;
}

/// Lines, points and faces are drawn by shaders of their own.
bool areOfOneSort(vtkPolyData& a, vtkPolyData& b) {
  const auto bothHave = [&](vtkIdType inA, vtkIdType inB) { return (inA > 0) == (inB > 0); };
  return bothHave(a.GetNumberOfVerts(), b.GetNumberOfVerts()) && bothHave(a.GetNumberOfLines(), b.GetNumberOfLines()) &&
         bothHave(a.GetNumberOfPolys(), b.GetNumberOfPolys());
}

/// By how much lines and points are drawn before what lies where they lie.
std::array<double, 3> depthOf(vtkMapper& mapper) {
  std::array<double, 3> depth{};
  mapper.GetRelativeCoincidentTopologyLineOffsetParameters(depth[0], depth[1]);
  mapper.GetRelativeCoincidentTopologyPointOffsetParameter(depth[2]);
  return depth;
}

/// Flat things on the screen are drawn after everything, in an order of their own.
bool isFlat(vtkProp& prop) { return vtkActor2D::SafeDownCast(&prop) != nullptr; }

bool areAlike(vtkProp& a, vtkProp& b) {
  if (isFlat(a) || isFlat(b)) return isFlat(a) && isFlat(b);
  vtkPolyData *dataA = dataOf(a), *dataB = dataOf(b);
  if (!dataA || !dataB || !areOfOneSort(*dataA, *dataB) || isCutBySection(a) != isCutBySection(b)) return false;
  vtkActor &actorA = *vtkActor::SafeDownCast(&a), &actorB = *vtkActor::SafeDownCast(&b);
  vtkProperty &lookA = *actorA.GetProperty(), &lookB = *actorB.GetProperty();
  if (depthOf(*actorA.GetMapper()) != depthOf(*actorB.GetMapper())) return false;
  if (actorA.GetForceOpaque() != actorB.GetForceOpaque()) return false;
  return lookA.GetRenderPointsAsSpheres() == lookB.GetRenderPointsAsSpheres() &&
         lookA.GetLighting() == lookB.GetLighting() && (lookA.GetOpacity() == 1) == (lookB.GetOpacity() == 1);
}

/// What is shown holds data of its own, which can be overwritten: those it came with may be a result's, which is shown again
/// later.
void giveOwnData(vtkProp& prop) {
  vtkPolyData* const given = dataOf(prop);
  if (!given) return;
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->ShallowCopy(given);
  vtkPolyDataMapper::SafeDownCast(vtkActor::SafeDownCast(&prop)->GetMapper())->SetInputData(own);
}

/// Only what differs is set: any change of a look makes VTK look at the shader again.
void takeOver(vtkProp& kept, vtkProp& now) {
  dataOf(kept)->ShallowCopy(dataOf(now));
  vtkProperty &look = *vtkActor::SafeDownCast(&kept)->GetProperty(), &wanted = *vtkActor::SafeDownCast(&now)->GetProperty();
  look.SetColor(wanted.GetColor());
  look.SetOpacity(wanted.GetOpacity());
  look.SetLineWidth(wanted.GetLineWidth());
  look.SetPointSize(wanted.GetPointSize());
}

}  // namespace

void replaceProps(vtkRenderer& renderer, Props& shown, Props now) {
  // In order: what is drawn first is seen where lines lie in one place.
  const bool alike = std::equal(shown.begin(), shown.end(), now.begin(), now.end(),
                                [](const auto& a, const auto& b) { return areAlike(*a, *b); });
  if (!alike) {
    for (const auto& prop : shown) renderer.RemoveViewProp(prop);
    shown = std::move(now);
    for (const auto& prop : shown) {
      giveOwnData(*prop);
      renderer.AddViewProp(prop);
    }
    return;
  }
  for (std::size_t k = 0; k < shown.size(); ++k) {
    if (!isFlat(*shown[k])) {
      takeOver(*shown[k], *now[k]);
      continue;
    }
    renderer.RemoveViewProp(shown[k]);
    shown[k] = now[k];
    renderer.AddViewProp(shown[k]);
  }
}

}  // namespace blossom::ui
