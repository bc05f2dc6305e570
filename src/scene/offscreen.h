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
  /// @throws Error Internal with the driver's words.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

/// Pixels from top to bottom, four bytes each, colour not multiplied by alpha.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Draws what `fill` puts into a renderer. `fill` is called once, with the render window's aspect already set, and must
/// place the camera. The background stays transparent; O(pixels).
/// @param supersampling pixels drawn per pixel of the image and direction
Image drawOffscreen(int width, int height, int supersampling, const std::function<void(vtkRenderer*)>& fill,
                    const Progress&);

}  // namespace blossom
