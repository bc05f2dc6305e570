#pragma once
#include <vtkSmartPointer.h>

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSize>
#include <QString>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace blossom::ui {

/// Draws off the screen what the views show: one OpenGL context and one window of VTK for all of them, so that a new view
/// finds its shaders translated. Views paint the pixels like any picture, and the window around them stays an ordinary one:
/// with a QOpenGLWidget in it, Qt has OpenGL put the whole window together again whenever a single letter of it changes,
/// which takes 30 to 50 ms where OpenGL is software.
class Painter {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::Painter)
 public:
  /// The same for all who hold it at the same time.
  static std::shared_ptr<Painter> shared();
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  [[nodiscard]] const QString& problem() const { return problem_; }  ///< why nothing can be drawn; empty when all is well
  /// What is drawn later has to be known from the beginning to the end, as it keeps data on the graphics card.
  void add(vtkRenderer*);
  void remove(vtkRenderer*);

  /// Names one frame.
  using Frame = std::uint64_t;
  /// Begins a frame and returns while the graphics card, or the threads that stand for it, still draw. One is drawn at a
  /// time: what was begun before and not taken is lost. @param size device pixels, not empty
  Frame begin(vtkRenderer*, QSize size, int samples);
  /// Whether nothing is to be waited for any more, after waiting that long.
  [[nodiscard]] bool finished(Frame, std::chrono::microseconds wait = {});
  /// Pixels 0xAARRGGBB, the lowest line first, valid until the next call; waits for them. nullptr when the frame was lost.
  const std::vector<std::uint32_t>* take(Frame);
  [[nodiscard]] bool fresh() const { return last_ == 0; }  ///< has drawn nothing yet

 private:
  Painter();
  void start();
  bool makeCurrent();
  void makeContextCurrent() { makeCurrent(); }  // for VTK
  void forgetFence();
  void readPixels();

  QOffscreenSurface surface_;
  QOpenGLContext context_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  QString problem_;

  // The frame being drawn.
  Frame last_ = 0;
  QSize size_;
  bool resolved_ = false;   // from several samples of each pixel into a second framebuffer; copying there would wait
  GLsync fence_ = nullptr;  // none: taken, or lost
  std::vector<std::uint32_t> pixels_;
};

}  // namespace blossom::ui
