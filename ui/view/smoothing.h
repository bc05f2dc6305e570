#pragma once
#include <QImage>
#include <QPointF>
#include <cstdint>
#include <vector>

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
  /// Takes one more frame, pixels 0xAARRGGBB with the lowest line first as OpenGL returns them. The picture, of the same
  /// size, becomes the mean of all frames whenever these are 1, 2, 4 or 8. Returns whether it did.
  bool take(const std::vector<std::uint32_t>& frame, QImage& picture);

 private:
  void add(const std::vector<std::uint32_t>& frame);
  void showMean(QImage& picture) const;

  // Sums of red and blue, and of green: two colours share a word, each with room for eight times 255.
  std::vector<std::uint32_t> redAndBlue_, green_;
  int taken_ = 0;
};

/// A frame of another size over the whole picture, with its pixels blended.
void showEnlarged(const std::vector<std::uint32_t>& frame, QSize size, QImage& picture);

}  // namespace blossom::ui
