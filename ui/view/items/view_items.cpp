#include "ui/view/items/view_items.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>
#include <set>

#include "scene/camera.h"
#include "scene/shading.h"
#include "ui/thread/refreshes.h"
#include "ui/view/items/item_paint.h"

namespace blossom::ui {

namespace {

/// Cuts of hints and of controls stay open, so that those of the results are seen.
bool isFilled(const SceneData& scene, Presence presence) {
  return scene.solid && scene.faces && presence != Presence::SteppedBack && presence != Presence::Beneath;
}

/// The faces of a study are those of the scene, and know their curvatures.
SceneData drawnData(const SceneData& scene, const SurfaceStudy* study) {
  SceneData data = scene;
  if (!study || !study->scene.faces) return data;
  data.faces = study->scene.faces;
  data.pieces = study->scene.pieces;
  return data;
}

/// Edges without numbers do not tell the form of a shape: a wireframe of it shows its triangles.
bool needsTriangles(const SceneData& scene) { return !scene.edges || subShapeData(scene, SubShapeKind::Edge, 0).empty(); }

/// Software OpenGL collects what is to be drawn until it is told to begin: told so before each piece, its threads draw one
/// while the next is prepared.
void flushBefore(vtkActor& piece) {
  vtkNew<vtkCallbackCommand> flush;
  flush->SetCallback([](vtkObject*, unsigned long, void*, void*) {
    if (const QOpenGLContext* context = QOpenGLContext::currentContext()) context->functions()->glFlush();
  });
  piece.GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, flush);
}

}  // namespace

ViewItems::ViewItems(vtkRenderer* renderer) : renderer_(renderer), clip_(vtkSmartPointer<vtkPlane>::New()) {}
ViewItems::~ViewItems() = default;

ItemsChange ViewItems::set(const std::vector<ViewItem>& items) {
  ItemsChange change;
  std::set<FeatureId> wanted;
  for (const ViewItem& item : items) wanted.insert(item.id);
  for (auto it = shown_.begin(); it != shown_.end();) {
    const bool gone = !wanted.contains(it->first);
    if (gone) {
      hide(it->second);
      change.shapes.push_back(it->first);
    }
    it = gone ? shown_.erase(it) : std::next(it);
  }
  for (const ViewItem& item : items) {
    Shown& shown = shown_[item.id];
    const bool recolored = shown.role != item.role || shown.presence != item.presence;
    shown.role = item.role;
    shown.presence = item.presence;
    shown.replaced = isReplaced(item.id);
    const bool renewed = renew(shown, item);
    const bool studied = !renewed && renewStudy(shown, item);
    if (renewed) change.shapes.push_back(item.id);
    if (recolored || renewed || studied) paint(item.id, shown);
    change.colors = change.colors || recolored || studied;
  }
  if (followRange())
    for (auto& [id, shown] : shown_) recolor(id, shown, true);
  return change;
}

/// False when the shape is the one that is shown already.
bool ViewItems::renew(Shown& shown, const ViewItem& item) {
  const bool same = shown.scene.faces == item.scene.faces && shown.scene.edges == item.scene.edges &&
                    shown.scene.points == item.scene.points;
  if (same && !shown.actors.empty()) return false;
  replace(shown);
  shown.scene = item.scene;
  shown.study = item.study;
  if (!shown.scene.picks) shown.scene.picks = std::make_shared<const PickIndex>(shown.scene);
  show(shown);
  return true;
}

/// True when the same shape comes with a study that it did not have before. Its triangles go to the card once more, with
/// their curvatures, and stay there whatever is displayed later.
bool ViewItems::renewStudy(Shown& shown, const ViewItem& item) {
  if (!item.study || item.study == shown.study) return false;
  replace(shown);
  shown.study = item.study;
  show(shown);
  return true;
}

void ViewItems::show(Shown& shown) {
  countRefresh(WindowPart::Actors);
  shown.actors = makeActors(drawnData(shown.scene, shown.study.get()), look_);
  if (shown.study && shown.study->isoCurves) shown.actors.push_back(makeIsoCurveActor(shown.study->isoCurves, look_));
  applyMode(shown);
  applySection(shown);
  if (shown.scene.pieces.empty()) {
    for (const auto& actor : shown.actors) renderer_->AddActor(actor);
    finish(shown);
  } else {
    shown.coming.assign(shown.actors.rbegin(), shown.actors.rend());
  }
}

/// What is shown now makes room when the new shape is whole.
void ViewItems::replace(Shown& shown) {
  for (const auto& actor : shown.coming) shown.actors.erase(std::find(shown.actors.begin(), shown.actors.end(), actor));
  shown.coming.clear();
  shown.leaving.insert(shown.leaving.end(), shown.actors.begin(), shown.actors.end());
  shown.actors.clear();
}

void ViewItems::hide(Shown& shown) {
  (void)shown.cap.leave(*renderer_);
  replace(shown);
  finish(shown);
}

void ViewItems::finish(Shown& shown) {
  if (!shown.coming.empty()) return;
  for (const auto& actor : shown.leaving) renderer_->RemoveActor(actor);
  shown.leaving.clear();
}

bool ViewItems::incomplete() const {
  return std::any_of(shown_.begin(), shown_.end(), [](const auto& entry) { return !entry.second.coming.empty(); });
}

void ViewItems::bringNextPiece() {
  const auto it = std::find_if(shown_.begin(), shown_.end(), [](const auto& entry) { return !entry.second.coming.empty(); });
  if (it == shown_.end()) return;
  const vtkSmartPointer<vtkActor> piece = it->second.coming.back();
  flushBefore(*piece);
  renderer_->AddActor(piece);
  it->second.coming.pop_back();
  finish(it->second);
}

std::vector<Vec3> ViewItems::pointsToCome() const {
  std::vector<Vec3> points;
  for (const auto& [id, shown] : shown_)
    for (const auto& actor : shown.coming) addPointsOf(*actor, points);
  return points;
}

void ViewItems::setLook(const Look& look) {
  look_ = look;
  for (auto& [id, shown] : shown_) paint(id, shown);
  paint({}, standInShown_);
}

void ViewItems::setDisplayMode(DisplayMode mode) {
  const bool values = showsCurvature(surfaceDisplay(mode_)) || showsCurvature(surfaceDisplay(mode));
  mode_ = mode;
  (void)followRange();
  for (auto& [id, shown] : shown_) {
    recolor(id, shown, values);
    applyCulling(shown);
  }
  applyMode(standInShown_);
}

/// Other colours of points are other data on the card: those of large shapes go there piece by piece, as new shapes do.
/// @param values whether colours of points come, change or go
void ViewItems::recolor(const FeatureId& id, Shown& shown, bool values) {
  if (!values || !shown.study || shown.scene.pieces.empty()) return applyMode(shown);
  replace(shown);
  show(shown);
  paint(id, shown);
}

void ViewItems::setZebra(const ZebraLook& zebra) {
  zebra_ = zebra;
  if (mode_ != DisplayMode::Zebra) return;
  for (const auto& [id, shown] : shown_) applyMode(shown);
  applyMode(standInShown_);
}

std::optional<CurvatureRange> ViewItems::curvatureRange() const { return range_; }

/// One scale for all shapes. @returns whether it is another one
bool ViewItems::followRange() {
  const SurfaceDisplay display = surfaceDisplay(mode_);
  double bound = 0;
  for (const auto& [id, shown] : shown_)
    if (shown.study && shown.presence != Presence::SteppedBack)
      bound = std::max(bound, curvatureBound(*shown.study, display));
  const auto range = bound > 0 ? std::optional(blossom::curvatureRange(display, bound)) : std::nullopt;
  if (range == range_ && display == colorsOf_) return false;
  range_ = range;
  colorsOf_ = display;
  colors_ = range ? curvatureColors(display, *range) : nullptr;
  return true;
}

std::optional<double> ViewItems::curvatureAt(const Pick& pick) const {
  const auto it = shown_.find(pick.feature);
  if (!range_ || it == shown_.end() || !it->second.study || pick.part.kind != SubShapeKind::Face) return std::nullopt;
  return drawnCurvature(*it->second.study, surfaceDisplay(mode_), pick.part.index, pick.part.point);
}

void ViewItems::applyMode(const Shown& shown) const {
  const bool wires = mode_ == DisplayMode::Wireframe && !shown.scene.planar;
  const bool triangles = wires && needsTriangles(shown.scene);
  for (const auto& actor : shown.actors) {
    const ActorRole part = roleOf(actor);
    if (part == ActorRole::Faces) {
      actor->SetVisibility(!shown.replaced && (!wires || triangles));
      if (wires)
        actor->GetProperty()->SetRepresentationToWireframe();
      else
        actor->GetProperty()->SetRepresentationToSurface();
      shade(*actor, shown);
    }
    if (part == ActorRole::Edges) actor->SetVisibility(!shown.replaced && (showsEdges() || isDrawing(shown.scene)));
    if (part == ActorRole::IsoCurves) actor->SetVisibility(!shown.replaced && mode_ == DisplayMode::IsoCurves);
    if (part == ActorRole::Points) actor->SetVisibility(!shown.replaced);
  }
}

// Stripes show creases better.
bool ViewItems::showsEdges() const { return mode_ != DisplayMode::Shaded && mode_ != DisplayMode::Zebra; }

bool ViewItems::isReplaced(const FeatureId& id) const {
  return standIn_ && std::find(standIn_->insteadOf.begin(), standIn_->insteadOf.end(), id) != standIn_->insteadOf.end();
}

void ViewItems::markReplaced() {
  for (auto& [id, shown] : shown_) {
    if (shown.replaced == isReplaced(id)) continue;
    shown.replaced = !shown.replaced;
    applyMode(shown);
  }
}

// It is what is made, whatever becomes of the shapes it stands for; open, as both of its sides may be seen.
bool ViewItems::setStandIn(const std::optional<StandIn>& standIn) {
  const auto facesOf = [](const std::optional<StandIn>& each) { return each ? each->faces.Get() : nullptr; };
  const bool other = facesOf(standIn) != facesOf(standIn_);
  standIn_ = standIn;
  markReplaced();
  if (!other) return false;
  hide(standInShown_);
  standInShown_ = {};
  if (!standIn_) return true;
  standInShown_.scene.faces = standIn_->faces;
  standInShown_.scene.edges = standIn_->edges;
  standInShown_.role = ItemRole::Made;
  show(standInShown_);
  paint({}, standInShown_);
  coarsely_ = false;
  return true;
}

void ViewItems::drawCoarsely(bool coarsely) {
  if (coarsely == coarsely_ || !canBeCoarser()) return;
  coarsely_ = coarsely;
  for (const auto& actor : standInShown_.actors)
    if (roleOf(actor) == ActorRole::Faces)
      vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(coarsely ? standIn_->coarseFaces : standIn_->faces);
}

void ViewItems::shade(vtkActor& actor, const Shown& shown) const {
  if (shown.scene.planar) return;
  shadeFaces(actor, {surfaceDisplay(mode_), zebra_, colors_});
}

void ViewItems::setHovered(const FeatureId& id) {
  if (id == hovered_) return;
  const FeatureId before = std::exchange(hovered_, id);
  for (const FeatureId& touched : {before, id})
    if (const auto it = shown_.find(touched); it != shown_.end()) paint(it->first, it->second);
}

void ViewItems::setSection(const std::optional<CutPlane>& cut) {
  const bool switched = cut.has_value() != section_.has_value();
  section_ = cut;
  if (cut) {
    const Vec3 origin = cut->normal * cut->offset, kept = -cut->normal;
    clip_->SetOrigin(origin.data());
    clip_->SetNormal(kept.data());
  }
  if (!switched) return;
  for (const auto& [id, shown] : shown_) applySection(shown);
  applySection(standInShown_);
}

void ViewItems::applySection(const Shown& shown) const {
  for (const auto& actor : shown.actors) {
    actor->GetMapper()->RemoveAllClippingPlanes();
    if (section_) actor->GetMapper()->AddClippingPlane(clip_);
  }
  applyCulling(shown);
}

void ViewItems::setCulling(bool culling) {
  if (culling == culling_) return;
  culling_ = culling;
  for (const auto& [id, shown] : shown_) applyCulling(shown);
}

// A cut opens the view on the far sides.
void ViewItems::applyCulling(const Shown& shown) const {
  for (const auto& actor : shown.actors)
    if (roleOf(actor) == ActorRole::Faces)
      actor->GetProperty()->SetBackfaceCulling(culling_ && shown.scene.solid && !section_ &&
                                               mode_ != DisplayMode::Wireframe);
}

bool ViewItems::followSection(vtkCamera& camera, double millimetresPerPixel) {
  bool changed = false;
  for (auto& [id, shown] : shown_) {
    const bool isCut = section_ && !shown.replaced && isFilled(shown.scene, shown.presence);
    if (isCut && !shown.coming.empty()) continue;  // what is replaced stays, with its section, until the new shape is whole
    if (isCut)
      changed = shown.cap.follow(*renderer_, *drawnData(shown.scene, shown.study.get()).faces, *section_) || changed;
    else
      changed = shown.cap.leave(*renderer_) || changed;
  }
  if (section_) paintCaps(camera, millimetresPerPixel);
  return changed;
}

// Where bodies overlap, what is being made is seen. Hatching has one of four directions, as that of neighbours in a drawing.
void ViewItems::paintCaps(vtkCamera& camera, double millimetresPerPixel) const {
  SectionCap::Drawn drawn;
  drawn.spacing = std::exp2(std::round(std::log2(millimetresPerPixel * 12)));
  drawn.filled = mode_ != DisplayMode::Wireframe;
  drawn.outlined = showsEdges();
  const auto count = static_cast<double>(shown_.size());
  int number = 0;
  for (const auto& [id, shown] : shown_) {
    drawn.share = ((shown.role == ItemRole::Made ? count : 0) + number + 1) / (2 * count);
    drawn.angle = (0.25 + 0.5 * (number % 2) + 0.125 * (number / 2 % 2)) * M_PI;
    ++number;
    shown.cap.paint(paintOf(id, shown), drawn, camera);
  }
}

vtkPlane* ViewItems::clip() const { return section_ ? clip_.Get() : nullptr; }

void ViewItems::paint(const FeatureId& id, const Shown& shown) const {
  const ItemPaint paint = paintOf(id, shown);
  for (const auto& actor : shown.actors) paintActor(*actor, paint);
}

ItemPaint ViewItems::paintOf(const FeatureId& id, const Shown& shown) const {
  return {shown.scene, shown.role, shown.presence, look_, !id.empty() && id == hovered_};
}

bool ViewItems::planar() const {
  return !shown_.empty() &&
         std::all_of(shown_.begin(), shown_.end(), [](const auto& entry) { return entry.second.scene.planar; });
}

const SceneData* ViewItems::scene(const FeatureId& id) const {
  const auto it = shown_.find(id);
  return it == shown_.end() ? nullptr : &it->second.scene;
}

Bounds ViewItems::extent() const {
  Bounds all;
  for (const auto& [id, shown] : shown_)
    for (vtkPolyData* data : {shown.scene.faces.Get(), shown.scene.edges.Get(), shown.scene.points.Get()}) {
      if (!data) continue;
      const double* b = data->GetBounds();
      all.add(Vec3(b[0], b[2], b[4]));
      all.add(Vec3(b[1], b[3], b[5]));
    }
  return all;
}

std::size_t ViewItems::triangles() const {
  std::size_t count = 0;
  for (const auto& [id, shown] : shown_)
    if (shown.scene.faces) count += static_cast<std::size_t>(shown.scene.faces->GetNumberOfPolys());
  return count;
}

}  // namespace blossom::ui
