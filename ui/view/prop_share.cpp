#include "ui/view/prop_share.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>

namespace blossom::ui {

namespace {

vtkInformationDoubleKey* shareKey() {
  static vtkInformationDoubleKey* const key = vtkInformationDoubleKey::MakeKey("DRAWN_SHARE", "blossom");
  return key;
}

double shareOf(vtkProp& prop) {
  vtkInformation* const known = prop.GetPropertyKeys();
  return known && known->Has(shareKey()) ? known->Get(shareKey()) : 1;
}

void noteShare(vtkProp& prop, double share) {
  if (!prop.GetPropertyKeys()) prop.SetPropertyKeys(vtkSmartPointer<vtkInformation>::New());
  prop.GetPropertyKeys()->Set(shareKey(), share);
}

/// Points of flat things are in device pixels. The data may be drawn by others, too.
void resize(vtkPolyDataMapper2D& mapper, double factor) {
  vtkPolyData* const given = mapper.GetInput();
  if (!given || !given->GetPoints()) return;
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (vtkIdType k = 0; k < given->GetNumberOfPoints(); ++k) {
    const double* p = given->GetPoint(k);
    points->InsertNextPoint(factor * p[0], factor * p[1], p[2]);
  }
  const auto resized = vtkSmartPointer<vtkPolyData>::New();
  resized->ShallowCopy(given);
  resized->SetPoints(points);
  mapper.SetInputData(resized);
}

void resize(vtkActor2D& flat, double factor) {
  if (auto* const mapper = vtkPolyDataMapper2D::SafeDownCast(flat.GetMapper())) resize(*mapper, factor);
  flat.GetProperty()->SetLineWidth(static_cast<float>(factor * flat.GetProperty()->GetLineWidth()));
  auto* const textured = vtkTexturedActor2D::SafeDownCast(&flat);
  // Its pixels are those of the picture only at full size.
  if (textured && textured->GetTexture()) textured->GetTexture()->SetInterpolate(shareOf(flat) < 1);
}

}  // namespace

void drawAtShare(vtkProp& prop, double share) {
  const double factor = share / shareOf(prop);
  if (factor == 1) return;
  noteShare(prop, share);
  if (auto* const flat = vtkActor2D::SafeDownCast(&prop)) return resize(*flat, factor);
  auto* const actor = vtkActor::SafeDownCast(&prop);
  if (!actor) return;
  vtkProperty& look = *actor->GetProperty();
  look.SetLineWidth(static_cast<float>(factor * look.GetLineWidth()));
  look.SetPointSize(static_cast<float>(factor * look.GetPointSize()));
}

}  // namespace blossom::ui
