#include "ui/view/view_widget.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QPaintEvent>
#include <QPainter>
#include <utility>

#include "ui/view/painter.h"
#include "ui/view/rehearsal.h"
#include "ui/view/view_band.h"
#include "ui/view/view_cube.h"

namespace blossom::ui {

namespace {

constexpr int lookMs = 2;  // between looks whether a frame is there

}  // namespace

ViewWidget::ViewWidget(QWidget* parent)
    : QWidget(parent),
      painter_(Painter::shared()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      items_(renderer_),
      hoverLight_(renderer_),
      selected_(renderer_),
      cube_(new ViewCube(this)),
      band_(new SelectionBand(this)) {
  quietVtk();
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  buildRenderer();
  for (QTimer* timer : {&settle_, &next_}) timer->setSingleShot(true);
  connect(&next_, &QTimer::timeout, this, &ViewWidget::beginFrame);
  connect(&settle_, &QTimer::timeout, this, &ViewWidget::comeToRest);
  arrival_.setInterval(lookMs);
  arrival_.setTimerType(Qt::PreciseTimer);
  connect(&arrival_, &QTimer::timeout, this, &ViewWidget::lookForFrame);
  connect(&camera_, &CameraControl::moved, this, &ViewWidget::redrawMoving);
  connect(cube_, &ViewCube::sideChosen, this, [this](const QString& view) { lookFrom(view); });
  connect(cube_, &ViewCube::hint, this, &ViewWidget::hint);
  QTimer::singleShot(0, this, [this] { rehearse(*painter_); });
}

ViewWidget::~ViewWidget() { painter_->remove(renderer_); }

void ViewWidget::buildRenderer() {
  painter_->add(renderer_);
  renderer_->AddActor(grid_.actor());
  setUpRenderer(renderer_, look_);
  applyLook();
}

QString ViewWidget::problem() const { return painter_->problem(); }

void ViewWidget::paintEvent(QPaintEvent* event) {
  if (!problem().isEmpty()) return paintProblem(*event);
  sizePicture();
  if (blank_ && before_.isNull()) drawNow();  // better late than empty
  if (outdated_ || stale()) wantFrame();
  QPainter(this).drawImage(rect(), blank_ ? before_ : picture_);
  // Painting is done, and the window is shown, when this event has been handled.
  if (std::exchange(changed_, false)) QMetaObject::invokeMethod(this, &ViewWidget::framePainted, Qt::QueuedConnection);
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
  redraw();
}

void ViewWidget::placeCube() { cube_->move(width() - cube_->width() - 14, 12); }

Look ViewWidget::scaledLook() const {
  Look look = look_;
  look.edgeWidth *= scale_;
  look.pointSize *= scale_;
  return look;
}

}  // namespace blossom::ui
