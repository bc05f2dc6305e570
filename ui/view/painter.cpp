#include "ui/view/painter.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QOpenGLExtraFunctions>

#include "scene/scene.h"

namespace blossom::ui {

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
  if (!makeCurrent()) return;
  forgetFence();
  window_->Finalize();
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

Painter::Frame Painter::begin(vtkRenderer* renderer, QSize size, int samples) {
  ++last_;
  if (!makeCurrent()) {
    problem_ = tr("The graphics driver has taken OpenGL away. Save the document, then start Blossom again.");
    return last_;
  }
  forgetFence();
  size_ = size;
  window_->GetRenderers()->RemoveAllItems();
  window_->GetRenderers()->AddItem(renderer);
  window_->SetSize(size.width(), size.height());
  window_->SetMultiSamples(samples);
  resolved_ = samples > 0;
  window_->SetSwapBuffers(resolved_);
  window_->Render();
  QOpenGLExtraFunctions& gl = *context_.extraFunctions();
  fence_ = gl.glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.glFlush();
  return last_;
}

bool Painter::finished(Frame frame, std::chrono::microseconds wait) {
  if (frame != last_ || !fence_ || !makeCurrent()) return true;
  const auto nanoseconds = static_cast<GLuint64>(std::chrono::nanoseconds(wait).count());
  return context_.extraFunctions()->glClientWaitSync(fence_, 0, nanoseconds) != GL_TIMEOUT_EXPIRED;
}

const std::vector<std::uint32_t>* Painter::take(Frame frame) {
  if (frame != last_ || !fence_ || !makeCurrent()) return nullptr;
  forgetFence();
  readPixels();
  return &pixels_;
}

void Painter::forgetFence() {
  if (fence_) context_.extraFunctions()->glDeleteSync(fence_);
  fence_ = nullptr;
}

void Painter::readPixels() {
  pixels_.resize(static_cast<std::size_t>(size_.width()) * static_cast<std::size_t>(size_.height()));
  vtkOpenGLFramebufferObject& drawn = *(resolved_ ? window_->GetDisplayFramebuffer() : window_->GetRenderFramebuffer());
  drawn.Bind(GL_READ_FRAMEBUFFER);
  QOpenGLExtraFunctions& gl = *context_.extraFunctions();
  gl.glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  constexpr GLenum bgra = 0x80E1;  // with bytes: 0xAARRGGBB on little-endian machines
  gl.glReadPixels(0, 0, size_.width(), size_.height(), bgra, GL_UNSIGNED_BYTE, pixels_.data());
  drawn.UnBind(GL_READ_FRAMEBUFFER);
}

}  // namespace blossom::ui
