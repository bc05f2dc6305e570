#pragma once
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/progress.h"

class vtkRenderer;

namespace blossom {

/// An OpenGL context without display or surface, current on the calling thread from construction to destruction.
class EglContext {
 public:
  /// @throws Error Internal with the driver's message.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

/// Pixels from top to bottom, four bytes each (RGBA), alpha not premultiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Draws pictures of one size off screen, one after the other, in one OpenGL context: that is current on the thread that
/// made it from construction to destruction. The background is transparent.
class OffscreenDrawer {
 public:
  /// @param supersampling drawn pixels per image pixel in each direction @throws Error Internal when there is no context.
  OffscreenDrawer(int width, int height, int supersampling);
  ~OffscreenDrawer();
  OffscreenDrawer(const OffscreenDrawer&) = delete;
  OffscreenDrawer& operator=(const OffscreenDrawer&) = delete;

  /// `fill` is called once to add the actors and to place the camera, with the aspect of the render window already set.
  /// O(pixels). @throws Error Cancelled.
  Image draw(const std::function<void(vtkRenderer*)>& fill, const Progress&);

 private:
  int width_, height_, supersampling_;
  EglContext context_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
};

/// One picture.
Image drawOffscreen(int width, int height, int supersampling, const std::function<void(vtkRenderer*)>& fill,
                    const Progress&);

}  // namespace blossom
