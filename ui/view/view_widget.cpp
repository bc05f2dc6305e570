#include "ui/view/view_widget.h"

#include <QPaintEvent>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "ui/thread/refreshes.h"
#include "ui/view/curvature_legend.h"
#include "ui/view/mouse_navigation.h"
#include "ui/view/rehearsal.h"
#include "ui/view/view_cube.h"

namespace blossom::ui {

ViewWidget::ViewWidget(QWidget* parent)
    : QWidget(parent),
      picture_(new LivePicture(*this, *this)),
      cube_(new ViewCube(this)),
      legend_(new CurvatureLegend(this)),
      navigation_(new MouseNavigation(camera_, *this)) {
  quietVtk();
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  connectParts();
  picture_->redraw();
  QTimer::singleShot(0, this, [this] { rehearse(picture_->painter()); });
}

ViewWidget::~ViewWidget() = default;

void ViewWidget::connectParts() {
  connect(picture_.get(), &LivePicture::shown, this, [this] { cube_->setTurn(frameTurn_); });
  connect(picture_.get(), &LivePicture::painted, this, &ViewWidget::framePainted);
  connect(picture_.get(), &LivePicture::scaleChanged, this, [this] {
    stage_.setScale(picture_->scale());
    markTool();  // in the widths of this scale
  });
  connect(&camera_, &CameraControl::moved, picture_.get(), &LivePicture::redrawMoving);
  connect(&camera_, &CameraControl::jumped, picture_.get(), &LivePicture::redrawAtRest);
  connect(navigation_, &MouseNavigation::hint, this, &ViewWidget::hint);
  connect(cube_, &ViewCube::sideChosen, this, [this](const QString& view) { lookFrom(view); });
  connect(cube_, &ViewCube::hint, this, &ViewWidget::hint);
}

void ViewWidget::paintEvent(QPaintEvent* event) {
  if (!problem().isEmpty()) return paintProblem(*event);
  picture_->paint();
}

void ViewWidget::paintProblem(const QPaintEvent& event) {
  QPainter painter(this);
  painter.fillRect(event.rect(), palette().color(QPalette::Window));
  painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, problem());
}

void ViewWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeCube();
  camera_.setViewSize(size());
  picture_->redraw();
}

void ViewWidget::placeCube() {
  cube_->move(width() - cube_->width() - 14, 12);
  // At the left it would lie beneath the cards of tools.
  legend_->move(width() - legend_->width(), height() - legend_->height() - 14);
}

/// A shape that stands in for others has no curvature of its own.
void ViewWidget::followCurvature() {
  const ViewItems& items = stage_.items();
  legend_->showScale(surfaceDisplay(displayMode()), items.hasStandIn() ? std::nullopt : items.curvatureRange());
}

void ViewWidget::prepareFrame(QPointF offset, QSize picture, bool coarse, double share) {
  bringToolUpToDate();
  stage_.setShare(share);
  stage_.items().drawCoarsely(coarse);
  frameTurn_ = camera_.turn();
  stage_.prepare(camera_, size(), offset, picture);
}

void ViewWidget::markItems() {
  itemsStale_ = true;
  picture_->wantFrame();
}

void ViewWidget::markOverlay() {
  overlayStale_ = true;
  picture_->wantFrame();
}

void ViewWidget::bringUpToDate() {
  if (std::exchange(itemsStale_, false)) setItems(source_.items());
  if (std::exchange(overlayStale_, false)) setOverlay(source_.overlay());
}

void ViewWidget::setItems(const std::vector<ViewItem>& items) {
  countRefresh(WindowPart::View);
  const ItemsChange change = stage_.setItems(items);
  const auto isChanged = [&](const Pick& pick) {
    return std::find(change.shapes.begin(), change.shapes.end(), pick.feature) != change.shapes.end();
  };
  if (!hovered_.feature.empty() && isChanged(hovered_)) setHovered({});
  // The parts of a new shape are counted anew: what was selected may be another part now.
  const std::vector<Pick>& selected = stage_.selected();
  std::vector<Pick> kept;
  std::copy_if(selected.begin(), selected.end(), std::back_inserter(kept),
               [&](const Pick& pick) { return !isChanged(pick); });
  if (kept.size() != selected.size()) setSelectedParts(kept);
  followCurvature();
  if (change.any()) picture_->redraw();
}

void ViewWidget::setOverlay(std::vector<vtkSmartPointer<vtkProp>> overlay) {
  countRefresh(WindowPart::Handles);
  if (overlay.empty() && !stage_.hasOverlay()) return;
  stage_.setOverlay(std::move(overlay));
  picture_->redraw();
}

void ViewWidget::setLook(const Look& look) {
  stage_.setLook(look);
  markTool();  // in the colours of this look
}

void ViewWidget::setGridVisible(bool visible) {
  stage_.setGridVisible(visible);
  picture_->redraw();
}

bool ViewWidget::gridVisible() const { return stage_.gridVisible(); }

void ViewWidget::setParallel(bool parallel) { camera_.setParallel(parallel); }

void ViewWidget::setDisplayMode(DisplayMode mode) {
  stage_.items().setDisplayMode(mode);
  followCurvature();
  if (source_.items && needsStudy(mode)) markItems();  // with what the mode needs
  picture_->redraw();
}

void ViewWidget::setZebra(const ZebraLook& zebra) {
  stage_.items().setZebra(zebra);
  picture_->redraw();
}

void ViewWidget::setSection(const std::optional<CutPlane>& section) {
  stage_.setSection(section);
  picture_->redraw();
}

std::vector<Vec3> ViewWidget::everything() {
  bringUpToDate();
  bringToolUpToDate();
  std::vector<Vec3> points = stage_.points();
  const std::vector<Vec3> reach = source_.reach ? source_.reach() : std::vector<Vec3>();
  points.insert(points.end(), reach.begin(), reach.end());
  return points;
}

Bounds ViewWidget::extent() {
  bringUpToDate();
  return stage_.items().extent();
}

void ViewWidget::fit(bool animated) { camera_.frame(everything(), camera_.heading(), animated); }

void ViewWidget::lookFrom(const QString& view, bool animated) {
  const std::vector<Vec3> points = everything();
  if (view != QLatin1String("auto")) {
    camera_.frame(points, turnOf(view.toStdString()), animated);
    return;
  }
  const bool flat = stage_.items().planar();
  camera_.setParallel(flat);
  camera_.frame(points, turnOf(flat ? "top" : "iso"), animated);
}

void ViewWidget::zoomBy(double factor) { camera_.zoom(QPointF(width(), height()) / 2, factor); }

}  // namespace blossom::ui
