#include "ui/view/items/item_paint.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include "scene/scene.h"

namespace blossom::ui {

bool isDrawing(const SceneData& scene) { return !scene.faces || scene.planar; }

namespace {

struct Opacity {
  double faces = 1, edges = 1;
};

Opacity opacityOf(Presence presence) {
  switch (presence) {
    case Presence::Outdated:
      return {0.3, 0.3};
    case Presence::Failed:
      return {0.35, 0.9};
    case Presence::SteppedBack:
      return {0.1, 0.45};
    case Presence::Beneath:
      return {0.22, 0.8};
    case Presence::Whole:
      break;
  }
  return {};
}

void setColor(vtkActor& actor, const Color& color) { actor.GetProperty()->SetColor(color.red, color.green, color.blue); }

/// Lines alone fade into the background: a single translucent thing costs every frame two passes over the whole picture.
void fadeByColor(vtkActor& actor, const Look& look) {
  vtkProperty& property = *actor.GetProperty();
  const double* c = property.GetColor();
  const Color background = mixed(look.backgroundTop, look.backgroundBottom, 0.5);
  setColor(actor, mixed(background, {c[0], c[1], c[2]}, property.GetOpacity()));
  property.SetOpacity(1);
}

/// Drawings lie in one plane: controls under all else, what is made over it.
void layer(vtkActor& actor, const ItemPaint& shown) {
  if (!isDrawing(shown.scene)) return;
  const bool under = shown.presence == Presence::Beneath || shown.presence == Presence::SteppedBack;
  const int step = under ? 4 : shown.role == ItemRole::Made ? 0 : 2;
  vtkMapper& mapper = *actor.GetMapper();
  mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(1 + step, 1 + 2 * step);
  mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-3 + step, -6 + 2 * step);
}

void paintFaces(vtkActor& actor, const ItemPaint& shown) {
  const bool plain = shown.role == ItemRole::Plain, made = shown.role == ItemRole::Made;
  const Color accent = made ? shown.look.madeFaces : shown.look.control;
  Color color;
  if (shown.scene.planar)
    color = mixed(mixed(shown.look.backgroundTop, shown.look.backgroundBottom, 0.5), plain ? shown.look.curve : accent,
                  made ? 0.88 : 0.2);
  else
    color = plain ? shown.look.surface : mixed(shown.look.surface, accent, made ? 0.92 : 0.55);
  setColor(actor, shown.hovered ? mixed(color, plain ? shown.look.control : Color{1, 1, 1}, 0.2) : color);
}

/// A drawing has the colours of its outlines while nothing else is to be told by a colour.
void chooseOwnColors(vtkActor& actor, const ItemPaint& shown) {
  const bool undisturbed = shown.role == ItemRole::Plain && shown.presence == Presence::Whole && !shown.hovered;
  const bool own = shown.scene.colorsTellKinds || undisturbed;
  actor.GetMapper()->SetScalarVisibility(own && shown.scene.edges && shown.scene.edges->GetCellData()->GetScalars());
}

void paintEdges(vtkActor& actor, const ItemPaint& shown) {
  const bool drawing = isDrawing(shown.scene), plain = shown.role == ItemRole::Plain;
  const Color accent = shown.role == ItemRole::Made ? shown.look.made : shown.look.control;
  Color color;
  if (drawing)
    color = plain ? shown.look.curve : accent;
  else
    color = plain ? shown.look.edge : mixed(accent, shown.look.edge, 0.62);
  if (shown.presence == Presence::Failed) color = shown.look.fault;
  setColor(actor, shown.hovered ? mixed(color, plain ? shown.look.control : accent, 0.75) : color);
  const double width = shown.look.edgeWidth * (drawing ? 1.5 : 1.1) * (shown.hovered ? 1.35 : 1);
  actor.GetProperty()->SetLineWidth(static_cast<float>(width));
}

void paintIsoCurves(vtkActor& actor, const ItemPaint& shown) {
  const Color& accent = shown.role == ItemRole::Made ? shown.look.made : shown.look.control;
  const Color& face = shown.role == ItemRole::Plain ? shown.look.surface : accent;
  setColor(actor, mixed(shown.look.edge, face, 0.25));
  actor.GetProperty()->SetLineWidth(static_cast<float>(shown.look.edgeWidth));
}

}  // namespace

void paintActor(vtkActor& actor, const ItemPaint& paint) {
  const ActorRole part = roleOf(&actor);
  const Opacity opacity = opacityOf(paint.presence);
  actor.GetProperty()->SetOpacity(part == ActorRole::Faces ? opacity.faces : opacity.edges);
  layer(actor, paint);
  if (part == ActorRole::Faces) paintFaces(actor, paint);
  if (part == ActorRole::Edges) paintEdges(actor, paint);
  if (part == ActorRole::Edges && isDrawing(paint.scene)) chooseOwnColors(actor, paint);
  if (part == ActorRole::Edges && !paint.scene.faces) fadeByColor(actor, paint.look);
  if (part == ActorRole::IsoCurves) paintIsoCurves(actor, paint);
  if (part == ActorRole::Points) actor.GetProperty()->SetPointSize(static_cast<float>(paint.look.pointSize));
}

}  // namespace blossom::ui
