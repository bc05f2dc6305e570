#pragma once
#include <QOpenGLTextureBlitter>
#include <QPointF>
#include <QSize>

class vtkGenericOpenGLRenderWindow;

namespace blossom::ui {

/// Smooth edges for slow graphics: frames that are each a fraction of a pixel aside, and the mean of them. Every frame is as
/// short as one while the camera moves, so that the window answers between them.
class Smoothing {
 public:
  static constexpr int frames = 8;

  void restart() { taken_ = 0; }
  [[nodiscard]] int taken() const { return taken_; }
  [[nodiscard]] bool complete() const { return taken_ >= frames; }
  /// By how many device pixels the next frame lies aside; the first lies in place.
  [[nodiscard]] QPointF offset() const;
  /// Takes what the window has drawn into the frame buffer given, which holds the mean of those before.
  void take(vtkGenericOpenGLRenderWindow&, unsigned int frameBuffer);
  void release();  ///< what belongs to the OpenGL context, which is current

 private:
  QOpenGLTextureBlitter blitter_;
  int taken_ = 0;
};

}  // namespace blossom::ui
