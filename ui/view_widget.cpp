#include "ui/view_widget.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <algorithm>

#include "ui/view_cube.h"

namespace blossom::ui {

namespace {

constexpr int samplesAtRest = 4;
constexpr double fluentMs = 20;  // a smoothed frame that takes longer waits until the camera rests

}  // namespace

ViewWidget::ViewWidget(QWidget* parent)
    : QOpenGLWidget(parent),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      cube_(new ViewCube(this)) {
  quietVtk();
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  // Qt makes the context current before it calls us.
  window_->SetOwnContext(false);
  window_->SetReadyForRendering(true);
  window_->SetIsCurrent(true);
  window_->SetSupportsOpenGL(1);
  window_->SetFrameBlitModeToNoBlit();
  window_->AddRenderer(renderer_);
  renderer_->AddActor(grid_.actor());
  setUpRenderer(renderer_, look_);
  settle_.setSingleShot(true);
  settle_.setInterval(140);
  connect(&settle_, &QTimer::timeout, this, [this] {
    sharp_ = true;
    update();
  });
  connect(&camera_, &CameraControl::moved, this, [this] {
    if (sharpFrameMs_ > fluentMs) {
      sharp_ = false;
      settle_.start();
    }
    cube_->setTurn(camera_.turn());
    update();
  });
  connect(cube_, &ViewCube::sideChosen, this, [this](const QString& view) { lookFrom(view); });
  connect(cube_, &ViewCube::hint, this, &ViewWidget::hint);
}

ViewWidget::~ViewWidget() {
  releaseGl();
  if (context()) disconnect(context(), nullptr, this, nullptr);
}

void ViewWidget::releaseGl() {
  if (!isValid()) return;
  makeCurrent();
  window_->Finalize();
  doneCurrent();
}

void ViewWidget::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewWidget::releaseGl, Qt::UniqueConnection);
  settle_.start();
  if (!window_->InitializeFromCurrentContext()) {
    problem_ = tr("The graphics driver has no OpenGL 3.2, which the view needs.");
    for (const std::string& line : takeVtkMessages()) problem_ += QLatin1Char('\n') + QString::fromStdString(line);
  }
}

void ViewWidget::resizeGL(int, int) {
  scale_ = devicePixelRatioF();
  window_->SetSize(static_cast<int>(width() * scale_), static_cast<int>(height() * scale_));
  camera_.setViewSize(size());
  for (const auto& [id, shown] : shown_) paintRole(shown);  // the pixel ratio may have changed with the screen
}

void ViewWidget::paintGL() {
  if (!problem_.isEmpty()) return;
  QElapsedTimer timer;
  timer.start();
  camera_.applyTo(renderer_->GetActiveCamera());
  grid_.follow(camera_.target(), camera_.millimetresPerPixel(), std::max(width(), height()), look_);
  renderer_->ResetCameraClippingRange();
  keepGridInSight();
  window_->SetMultiSamples(sharp_ ? samplesAtRest : 0);
  window_->Render();
  auto* gl = context()->extraFunctions();
  const int w = window_->GetSize()[0], h = window_->GetSize()[1];
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, window_->GetDisplayFramebuffer()->GetFBOIndex());
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl->glFinish();
  lastFrameMs_ = static_cast<double>(timer.nsecsElapsed()) / 1e6;
  if (sharp_) sharpFrameMs_ = lastFrameMs_;
  ++framesDrawn_;
}

// The clipping range is made for the shapes; the ground reaches farther.
void ViewWidget::keepGridInSight() {
  vtkCamera& camera = *renderer_->GetActiveCamera();
  if (!grid_.actor()->GetVisibility() || camera.GetParallelProjection()) return;
  const double distance = camera.GetDistance();
  const double* range = camera.GetClippingRange();
  const double far = std::max(range[1], distance + grid_.reach() * 1.5);
  camera.SetClippingRange(std::max(std::min(range[0], distance * 0.2), far * 5e-4), far);
}

void ViewWidget::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  placeCube();
}

void ViewWidget::placeCube() { cube_->move(width() - cube_->width() - 14, 12); }

Look ViewWidget::scaledLook() const {
  Look look = look_;
  look.edgeWidth *= scale_;
  look.pointSize *= scale_;
  return look;
}

void ViewWidget::setItems(const std::vector<ViewItem>& items) {
  for (auto it = shown_.begin(); it != shown_.end();) {
    const bool gone = std::none_of(items.begin(), items.end(), [&](const ViewItem& item) { return item.id == it->first; });
    if (gone) hide(it->second);
    it = gone ? shown_.erase(it) : std::next(it);
  }
  for (const ViewItem& item : items) {
    Shown& shown = shown_[item.id];
    shown.role = item.role;
    const bool same = shown.scene.faces == item.scene.faces && shown.scene.edges == item.scene.edges &&
                      shown.scene.points == item.scene.points;
    if (!same || shown.actors.empty()) {
      hide(shown);
      shown.scene = item.scene;
      show(shown);
    }
    paintRole(shown);
  }
  if (!sharp_) settle_.start();  // a shape appears at once, and smoothed a moment later
  update();
}

// The grid is blended over what is drawn before it, so it stays last.
void ViewWidget::show(Shown& shown) {
  shown.actors = makeActors(shown.scene, scaledLook());
  renderer_->RemoveActor(grid_.actor());
  for (const auto& actor : shown.actors) renderer_->AddActor(actor);
  renderer_->AddActor(grid_.actor());
}

void ViewWidget::hide(Shown& shown) {
  for (const auto& actor : shown.actors) renderer_->RemoveActor(actor);
  shown.actors.clear();
}

void ViewWidget::setOverlay(std::vector<vtkSmartPointer<vtkProp>> overlay) {
  for (const auto& prop : overlay_) renderer_->RemoveViewProp(prop);
  overlay_ = std::move(overlay);
  for (const auto& prop : overlay_) {
    prop->PickableOff();
    renderer_->AddViewProp(prop);
  }
  update();
}

void ViewWidget::setLook(const Look& look) {
  look_ = look;
  setUpRenderer(renderer_, look_);
  for (auto& [id, shown] : shown_) {
    hide(shown);
    show(shown);
    paintRole(shown);
  }
  update();
}

void ViewWidget::setGridVisible(bool visible) {
  grid_.actor()->SetVisibility(visible);
  update();
}

void ViewWidget::setParallel(bool parallel) { camera_.setParallel(parallel); }

// Only colours change: the geometry stays on the card.
void ViewWidget::paintRole(const Shown& shown) const {
  const Look look = scaledLook();
  const bool drawing = !shown.scene.faces || shown.scene.planar;
  const Color accent = shown.role == ItemRole::Made ? look.made : look.control;
  const bool plain = shown.role == ItemRole::Plain;
  for (const auto& actor : shown.actors) {
    vtkProperty& property = *actor->GetProperty();
    const auto paint = [&](const Color& color) { property.SetColor(color.red, color.green, color.blue); };
    const ActorRole part = roleOf(actor);
    if (part == ActorRole::Faces && shown.scene.planar)
      paint(mixed(mixed(look.backgroundTop, look.backgroundBottom, 0.5), plain ? look.curve : accent,
                  shown.role == ItemRole::Made ? 0.88 : 0.2));
    else if (part == ActorRole::Faces)
      paint(plain ? look.surface : mixed(look.surface, accent, shown.role == ItemRole::Made ? 0.92 : 0.55));
    else if (part == ActorRole::Edges && drawing)
      paint(plain ? look.curve : accent);
    else if (part == ActorRole::Edges)
      paint(plain ? look.edge : mixed(accent, look.edge, 0.62));
    if (part == ActorRole::Edges) property.SetLineWidth(static_cast<float>(look.edgeWidth * (drawing ? 1.5 : 1.1)));
    if (part == ActorRole::Points) property.SetPointSize(static_cast<float>(look.pointSize));
  }
}

std::vector<Vec3> ViewWidget::everything() const { return visiblePoints(renderer_); }

void ViewWidget::fit(bool animated) { camera_.frame(everything(), camera_.turn(), animated); }

void ViewWidget::lookFrom(const QString& view, bool animated) {
  const std::vector<Vec3> points = everything();
  if (view != QLatin1String("auto")) {
    camera_.frame(points, turnOf(view.toStdString()), animated);
    return;
  }
  const bool flat = !shown_.empty() &&
                    std::all_of(shown_.begin(), shown_.end(), [](const auto& entry) { return entry.second.scene.planar; });
  camera_.setParallel(flat);
  camera_.frame(points, turnOf(flat ? "top" : "iso"), animated);
}

void ViewWidget::zoomBy(double factor) { camera_.zoom(QPointF(width(), height()) / 2, factor); }

}  // namespace blossom::ui
