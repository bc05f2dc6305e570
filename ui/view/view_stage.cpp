#include "ui/view/view_stage.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

#include "ui/tools/view_props.h"
#include "ui/view/camera_control.h"
#include "ui/view/kept_props.h"
#include "ui/view/prop_share.h"

namespace blossom::ui {

namespace {

constexpr double reachOfMouse = 6;  // pixels within which edges and points are met

}  // namespace

ViewStage::ViewStage()
    : renderer_(vtkSmartPointer<vtkRenderer>::New()),
      items_(renderer_),
      lit_(renderer_),
      selected_(renderer_),
      chosen_(renderer_),
      pointed_(renderer_) {
  renderer_->AddActor(grid_.actor());
  setLook(look_);
}

vtkRenderer& ViewStage::renderer() { return *renderer_; }

ItemsChange ViewStage::setItems(const std::vector<ViewItem>& items) {
  ItemsChange change = items_.set(items);
  if (!change.shapes.empty()) showMarks();
  if (change.any()) keepGridLast();
  return change;
}

void ViewStage::replace(Props& shown, Props now) {
  for (const auto& prop : now) drawAtShare(*prop, share_);
  replaceProps(*renderer_, shown, std::move(now));
}

void ViewStage::setOverlay(Props props) {
  replace(overlay_, std::move(props));
  cutOverlay();
}

void ViewStage::cutOverlay() {
  for (const auto& prop : overlay_) {
    auto* const actor = vtkActor::SafeDownCast(prop);
    if (!actor || !isCutBySection(*prop)) continue;
    actor->GetMapper()->RemoveAllClippingPlanes();
    if (items_.clip()) actor->GetMapper()->AddClippingPlane(items_.clip());
  }
}

void ViewStage::setToolProps(Props props) { replace(toolProps_, std::move(props)); }

void ViewStage::setShare(double share) {
  if (share == share_) return;
  share_ = share;
  for (const Props* props : {&overlay_, &toolProps_})
    for (const auto& prop : *props) drawAtShare(*prop, share);
}

void ViewStage::setStandIn(const std::optional<StandIn>& standIn) {
  if (items_.setStandIn(standIn)) keepGridLast();
}

void ViewStage::setLook(const Look& look) {
  look_ = look;
  setUpRenderer(renderer_, look_);
  applyLook();
}

void ViewStage::setScale(double scale) {
  scale_ = scale;
  applyLook();
}

void ViewStage::applyLook() {
  Look look = look_;
  look.edgeWidth *= scale_;
  look.pointSize *= scale_;
  items_.setLook(look);
  lit_.setLook(look, mixed(look.control, look.surface, 0.35), 0.55);
  selected_.setLook(look, look.control, 0.9);
  chosen_.setLook(look, look.control, 0.9);
  pointed_.setLook(look, look.made, 1);
}

void ViewStage::setGridVisible(bool visible) { grid_.actor()->SetVisibility(visible); }

bool ViewStage::gridVisible() const { return grid_.actor()->GetVisibility() != 0; }

void ViewStage::setSection(const std::optional<CutPlane>& section) {
  section_ = section;
  items_.setSection(section);
  lit_.setSection(items_.clip());
  selected_.setSection(items_.clip());
  chosen_.setSection(items_.clip());
  pointed_.setSection(items_.clip());
  cutOverlay();
}

void ViewStage::light(const Pick& pick, bool whole) {
  items_.setHovered(whole ? pick.feature : FeatureId());
  lit_.set(pick.part.index < 0 ? std::vector<Pick>() : std::vector<Pick>{pick}, items_);
  keepGridLast();
}

bool ViewStage::select(const std::vector<Pick>& parts) {
  if (!selected_.set(parts, items_)) return false;
  keepGridLast();
  return true;
}

bool ViewStage::mark(const MarkedParts& marks) {
  marks_ = marks;
  if (!showMarks()) return false;
  keepGridLast();
  return true;
}

bool ViewStage::showMarks() {
  const bool chosen = chosen_.set(marks_.chosen, items_);
  const bool pointed = pointed_.set(marks_.pointed ? std::vector<Pick>{*marks_.pointed} : std::vector<Pick>(), items_);
  return chosen || pointed;
}

Pick ViewStage::pick(const CameraControl& camera, QPointF at, PickMode mode) const {
  const double growth = camera.pixelGrowth();
  const PickOptions options{.tolerance = growth > 0 ? 0 : reachOfMouse * camera.millimetresPerPixel(),
                            .tolerancePerMm = reachOfMouse * growth,
                            .cut = section_};
  return items_.pick(camera.rayThrough(at), options, mode);
}

std::vector<Vec3> ViewStage::points() const {
  std::vector<Vec3> points = visiblePoints(renderer_);
  const std::vector<Vec3> coming = items_.pointsToCome();
  points.insert(points.end(), coming.begin(), coming.end());
  return points;
}

// It is blended over what is drawn before it.
void ViewStage::keepGridLast() {
  renderer_->RemoveActor(grid_.actor());
  renderer_->AddActor(grid_.actor());
}

void ViewStage::bringNextPiece() {
  items_.bringNextPiece();
  keepGridLast();
}

void ViewStage::prepare(const CameraControl& control, QSize view, QPointF offset, QSize picture) {
  vtkCamera& camera = *renderer_->GetActiveCamera();
  control.applyTo(&camera);
  grid_.follow(control.target(), control.millimetresPerPixel(), std::max(view.width(), view.height()), look_);
  camera.SetWindowCenter(0, 0);
  renderer_->ResetCameraClippingRange();
  keepGridInSight();
  items_.setCulling(!items_.extent().contains(Vec3(camera.GetPosition())));
  if (items_.followSection(camera, control.millimetresPerPixel())) keepGridLast();
  camera.SetWindowCenter(2 * offset.x() / picture.width(), 2 * offset.y() / picture.height());
}

// The clipping range is made for the shapes; the ground reaches farther.
void ViewStage::keepGridInSight() {
  vtkCamera& camera = *renderer_->GetActiveCamera();
  if (!grid_.actor()->GetVisibility() || camera.GetParallelProjection()) return;
  const double distance = camera.GetDistance();
  const double* range = camera.GetClippingRange();
  const double far = std::max(range[1], distance + grid_.reach() * 1.5);
  camera.SetClippingRange(std::max(std::min(range[0], distance * 0.2), far * 5e-4), far);
}

}  // namespace blossom::ui
