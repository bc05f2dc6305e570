#include "scene/offscreen.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scene/scene.h"

namespace blossom {

namespace {

constexpr int largestTile = 2560;  // pixels; every OpenGL 3.2 driver supports this with four samples

vtkSmartPointer<vtkGenericOpenGLRenderWindow> makeWindow(int width, int height) {
  auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  // The context is ours and current for as long as the window lives.
  auto yes = vtkSmartPointer<vtkCallbackCommand>::New();
  yes->SetCallback([](vtkObject*, unsigned long, void*, void* answer) { *static_cast<bool*>(answer) = true; });
  window->AddObserver(vtkCommand::WindowIsCurrentEvent, yes);
  auto supported = vtkSmartPointer<vtkCallbackCommand>::New();
  supported->SetCallback([](vtkObject*, unsigned long, void*, void* answer) { *static_cast<int*>(answer) = 1; });
  window->AddObserver(vtkCommand::WindowSupportsOpenGLEvent, supported);
  window->SetOwnContext(false);
  window->SetReadyForRendering(true);
  window->SetFrameBlitModeToNoBlit();
  window->SetOffScreenRendering(true);
  window->SetAlphaBitPlanes(true);
  window->SetMultiSamples(4);
  window->SetSize(width, height);
  window->InitializeFromCurrentContext();
  return window;
}

struct TilePlan {
  int tiles = 1;  // per direction
  int width = 0, height = 0;
};

TilePlan planTiles(int width, int height) {
  TilePlan plan;
  plan.tiles = (std::max(width, height) + largestTile - 1) / largestTile;
  plan.width = (width + plan.tiles - 1) / plan.tiles;
  plan.height = (height + plan.tiles - 1) / plan.tiles;
  return plan;
}

// Narrows the camera to tile (column, row), counted from the lower left.
void aimAtTile(vtkCamera& camera, const TilePlan& plan, int column, int row, double angle, double scale) {
  camera.SetWindowCenter(2 * column - plan.tiles + 1, 2 * row - plan.tiles + 1);
  camera.SetViewAngle(2 * std::atan(std::tan(angle * M_PI / 360) / plan.tiles) * 180 / M_PI);
  camera.SetParallelScale(scale / plan.tiles);
}

// Adds a tile (rows from bottom to top, colours multiplied by alpha) into sums of supersampling^2 pixels each.
class Accumulator {
 public:
  Accumulator(int width, int height, int supersampling)
      : width_(width),
        height_(height),
        scale_(supersampling),
        sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4) {}

  void add(const unsigned char* rgba, const TilePlan& plan, int column, int row) {
    for (int y = 0; y < plan.height; ++y) {
      const int imageY = height_ - 1 - (row * plan.height + y) / scale_;
      if (imageY < 0) break;
      for (int x = 0; x < plan.width; ++x) {
        const int imageX = (column * plan.width + x) / scale_;
        if (imageX >= width_) break;
        const unsigned char* from =
            rgba + (static_cast<std::size_t>(y) * static_cast<std::size_t>(plan.width) + static_cast<std::size_t>(x)) * 4;
        std::uint16_t* to =
            &sums_[(static_cast<std::size_t>(imageY) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(imageX)) *
                   4];
        for (int channel = 0; channel < 4; ++channel) to[channel] = static_cast<std::uint16_t>(to[channel] + from[channel]);
      }
    }
  }

  [[nodiscard]] Image image() const {
    Image result{width_, height_, std::vector<std::uint8_t>(sums_.size())};
    const int samples = scale_ * scale_;
    for (std::size_t i = 0; i < sums_.size(); i += 4) {
      const double alpha = static_cast<double>(sums_[i + 3]) / samples / 255;
      for (std::size_t c = 0; c < 3; ++c) {
        const double premultiplied = static_cast<double>(sums_[i + c]) / samples;
        result.rgba[i + c] =
            static_cast<std::uint8_t>(std::lround(std::min(255.0, alpha > 0 ? premultiplied / alpha : 0.0)));
      }
      result.rgba[i + 3] = static_cast<std::uint8_t>(std::lround(alpha * 255));
    }
    return result;
  }

 private:
  int width_, height_, scale_;
  std::vector<std::uint16_t> sums_;
};

/// The renderer of one picture, taken out of the window with all that it put on the card.
class OwnRenderer {
 public:
  explicit OwnRenderer(vtkRenderWindow& window) : window_(window) { window_.AddRenderer(renderer_); }
  ~OwnRenderer() { window_.RemoveRenderer(renderer_); }
  OwnRenderer(const OwnRenderer&) = delete;
  OwnRenderer& operator=(const OwnRenderer&) = delete;
  [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }

 private:
  vtkRenderWindow& window_;
  vtkSmartPointer<vtkRenderer> renderer_ = vtkSmartPointer<vtkRenderer>::New();
};

}  // namespace

OffscreenDrawer::OffscreenDrawer(int width, int height, int supersampling)
    : width_(width), height_(height), supersampling_(supersampling) {
  quietVtk();
  const TilePlan plan = planTiles(width * supersampling, height * supersampling);
  window_ = makeWindow(plan.width, plan.height);
}

OffscreenDrawer::~OffscreenDrawer() { window_->Finalize(); }

Image OffscreenDrawer::draw(const std::function<void(vtkRenderer*)>& fill, const Progress& progress) {
  const TilePlan plan = planTiles(width_ * supersampling_, height_ * supersampling_);
  const OwnRenderer own(*window_);
  vtkRenderer* renderer = own.renderer();
  fill(renderer);
  renderer->SetGradientBackground(false);
  renderer->SetBackground(0, 0, 0);
  renderer->SetBackgroundAlpha(0);

  vtkCamera& camera = *renderer->GetActiveCamera();
  const double angle = camera.GetViewAngle(), scale = camera.GetParallelScale();
  Accumulator sums(width_, height_, supersampling_);
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  for (int tile = 0; tile < plan.tiles * plan.tiles; ++tile) {
    progress.report(static_cast<double>(tile) / (plan.tiles * plan.tiles), "Drawing");
    aimAtTile(camera, plan, tile % plan.tiles, tile / plan.tiles, angle, scale);
    window_->Render();
    window_->GetRGBACharPixelData(0, 0, plan.width - 1, plan.height - 1, 0, pixels);
    sums.add(pixels->GetPointer(0), plan, tile % plan.tiles, tile / plan.tiles);
  }
  return sums.image();
}

Image drawOffscreen(int width, int height, int supersampling, const std::function<void(vtkRenderer*)>& fill,
                    const Progress& progress) {
  return OffscreenDrawer(width, height, supersampling).draw(fill, progress);
}

}  // namespace blossom
