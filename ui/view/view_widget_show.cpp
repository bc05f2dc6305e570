// What the view shows, and from where.
#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

#include "ui/thread/refreshes.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

void ViewWidget::markItems() {
  itemsStale_ = true;
  wantFrame();
}

void ViewWidget::markOverlay() {
  overlayStale_ = true;
  wantFrame();
}

void ViewWidget::bringUpToDate() {
  if (std::exchange(itemsStale_, false)) setItems(source_.items());
  if (std::exchange(overlayStale_, false)) setOverlay(source_.overlay());
}

void ViewWidget::setItems(const std::vector<ViewItem>& items) {
  countRefresh(WindowPart::View);
  const ItemsChange change = items_.set(items);
  const auto isChanged = [&](const Pick& pick) {
    return std::find(change.shapes.begin(), change.shapes.end(), pick.feature) != change.shapes.end();
  };
  if (!hovered_.feature.empty() && isChanged(hovered_)) setHovered({});
  // The parts of a new shape are counted anew: what was selected may be another part now.
  std::vector<Pick> kept;
  std::copy_if(selected_.picks().begin(), selected_.picks().end(), std::back_inserter(kept),
               [&](const Pick& pick) { return !isChanged(pick); });
  if (kept.size() != selected_.picks().size()) setSelectedParts(kept);
  if (!change.shapes.empty()) keepGridLast();
  if (change.any()) redraw();
}

// It is blended over what is drawn before it.
void ViewWidget::keepGridLast() {
  renderer_->RemoveActor(grid_.actor());
  renderer_->AddActor(grid_.actor());
}

void ViewWidget::setOverlay(std::vector<vtkSmartPointer<vtkProp>> overlay) {
  countRefresh(WindowPart::Handles);
  if (overlay.empty() && overlay_.empty()) return;
  for (const auto& prop : overlay_) renderer_->RemoveViewProp(prop);
  overlay_ = std::move(overlay);
  for (const auto& prop : overlay_) renderer_->AddViewProp(prop);
  redraw();
}

void ViewWidget::setLook(const Look& look) {
  look_ = look;
  setUpRenderer(renderer_, look_);
  applyLook();
}

void ViewWidget::applyLook() {
  const Look look = scaledLook();
  items_.setLook(look);
  hoverLight_.setLook(look, mixed(look.control, look.surface, 0.35), 0.55);
  selected_.setLook(look, look.control, 0.9);
  showToolProps();  // in the colours and widths of this look
}

void ViewWidget::setGridVisible(bool visible) {
  grid_.actor()->SetVisibility(visible);
  redraw();
}

bool ViewWidget::gridVisible() const { return grid_.actor()->GetVisibility() != 0; }

void ViewWidget::setParallel(bool parallel) { camera_.setParallel(parallel); }

void ViewWidget::setDisplayMode(DisplayMode mode) {
  items_.setDisplayMode(mode);
  redraw();
}

void ViewWidget::setSection(const std::optional<CutPlane>& section) {
  section_ = section;
  items_.setSection(section);
  hoverLight_.setSection(items_.clip());
  selected_.setSection(items_.clip());
  redraw();
}

std::vector<Vec3> ViewWidget::everything() {
  bringUpToDate();
  std::vector<Vec3> points = visiblePoints(renderer_);
  const std::vector<Vec3> coming = items_.pointsToCome();
  points.insert(points.end(), coming.begin(), coming.end());
  return points;
}

Bounds ViewWidget::extent() {
  bringUpToDate();
  return items_.extent();
}

void ViewWidget::fit(bool animated) { camera_.frame(everything(), camera_.turn(), animated); }

void ViewWidget::lookFrom(const QString& view, bool animated) {
  const std::vector<Vec3> points = everything();
  if (view != QLatin1String("auto")) {
    camera_.frame(points, turnOf(view.toStdString()), animated);
    return;
  }
  const bool flat = items_.planar();
  camera_.setParallel(flat);
  camera_.frame(points, turnOf(flat ? "top" : "iso"), animated);
}

void ViewWidget::zoomBy(double factor) { camera_.zoom(QPointF(width(), height()) / 2, factor); }

}  // namespace blossom::ui
