#include "ui/view/painter.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QCoreApplication>
#include <QOpenGLExtraFunctions>

#include "scene/scene.h"
#include "ui/view/ground_grid.h"
#include "ui/view/view_items.h"

namespace blossom::ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("blossom::ui::Painter", text); }

/// A tetrahedron with edges and corners.
SceneData smallSolid() {
  Tessellation t;
  t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vec3& p : t.points) t.normals.push_back((p - Vec3::Constant(0.25)).normalized());
  t.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  t.faceOfTriangle = {0, 1, 2, 3};
  t.edges = {{t.points[0], t.points[1]}, {t.points[1], t.points[2]}};
  t.edgeIndices = {0, 1};
  t.vertices = t.points;
  SceneData scene = toSceneData(t);
  scene.solid = true;
  return scene;
}

SceneData smallDrawing() {
  Tessellation t;
  t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  t.triangles = {{0, 1, 2}};
  t.faceOfTriangle = {0};
  t.edges = {{t.points[0], t.points[1], t.points[2]}};
  t.edgeIndices = {0};
  t.vertices = t.points;
  return toSceneData(t);
}

}  // namespace

std::shared_ptr<Painter> Painter::shared() {
  static std::weak_ptr<Painter> held;
  std::shared_ptr<Painter> painter = held.lock();
  if (!painter) held = painter = std::shared_ptr<Painter>(new Painter);
  return painter;
}

Painter::Painter() : window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
  window_->SetOwnContext(false);
  window_->SetReadyForRendering(true);
  window_->SetIsCurrent(true);
  window_->SetSupportsOpenGL(1);
  window_->SetFrameBlitModeToNoBlit();
  // Shapes that go release what the graphics card holds for them at any time.
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &Painter::makeContextCurrent);
  start();
}

Painter::~Painter() {
  window_->RemoveObservers(vtkCommand::WindowMakeCurrentEvent);
  if (makeCurrent()) window_->Finalize();
}

void Painter::start() {
  surface_.create();
  if (!context_.create() || !makeCurrent()) {
    problem_ = tr("The graphics driver offers no OpenGL, which the view needs.");
  } else if (!window_->InitializeFromCurrentContext()) {
    problem_ = tr("The graphics driver has no OpenGL 3.2, which the view needs.");
    for (const std::string& line : takeVtkMessages()) problem_ += QLatin1Char('\n') + QString::fromStdString(line);
  }
}

bool Painter::makeCurrent() { return context_.isValid() && context_.makeCurrent(&surface_); }

void Painter::add(vtkRenderer* renderer) { window_->AddRenderer(renderer); }

void Painter::remove(vtkRenderer* renderer) {
  // Only one at a time is in the collection, and those outside would keep what belongs to this window.
  if (!window_->HasRenderer(renderer)) window_->GetRenderers()->AddItem(renderer);
  window_->RemoveRenderer(renderer);
}

const std::vector<std::uint32_t>& Painter::draw(vtkRenderer* renderer, QSize size, int samples) {
  makeCurrent();
  window_->GetRenderers()->RemoveAllItems();
  window_->GetRenderers()->AddItem(renderer);
  window_->SetSize(size.width(), size.height());
  window_->SetMultiSamples(samples);
  window_->Render();
  readPixels(size);
  return pixels_;
}

void Painter::readPixels(QSize size) {
  pixels_.resize(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()));
  vtkOpenGLFramebufferObject& drawn = *window_->GetDisplayFramebuffer();
  drawn.Bind(GL_READ_FRAMEBUFFER);
  QOpenGLExtraFunctions& gl = *context_.extraFunctions();
  gl.glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  constexpr GLenum bgra = 0x80E1;  // with bytes: 0xAARRGGBB on little-endian machines
  gl.glReadPixels(0, 0, size.width(), size.height(), bgra, GL_UNSIGNED_BYTE, pixels_.data());
  drawn.UnBind(GL_READ_FRAMEBUFFER);
}

void Painter::rehearse() {
  if (rehearsed_ || !problem_.isEmpty()) return;
  rehearsed_ = true;
  const Look look = Look::dark();
  vtkNew<vtkRenderer> stage;
  setUpRenderer(stage, look);
  add(stage);
  {
    ViewItems items(stage);
    items.setLook(look);
    items.set({{"solid", smallSolid(), ItemRole::Plain}, {"drawing", smallDrawing(), ItemRole::Made}});
    GroundGrid grid;
    grid.follow(Vec3::Zero(), 0.01, 100, look);
    stage->AddActor(grid.actor());
    stage->ResetCamera();
    const QSize size(64, 64);
    draw(stage, size, 0);
    items.setSection(CutPlane{Vec3::UnitX(), 0.2});
    items.placeCaps(*stage->GetActiveCamera(), 0.01);
    draw(stage, size, 0);
    stage->RemoveActor(grid.actor());
  }
  remove(stage);
}

}  // namespace blossom::ui
