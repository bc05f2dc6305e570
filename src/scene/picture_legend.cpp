#include "scene/picture_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/image_letters.h"
#include "scene/scene.h"

namespace blossom {

namespace {

class LegendPainter {
 public:
  LegendPainter(Image& image, const Look& look)
      : image_(image), look_(look), pixel_(std::max(1, std::min(image.width, image.height) / 400)) {}

  void draw(SurfaceDisplay display, const CurvatureRange& range) {
    const int width = 14 * pixel_, height = 150 * pixel_, left = 16 * pixel_, bottom = image_.height - 20 * pixel_;
    const int top = bottom - height;
    if (top < 20 * pixel_ || image_.width < 8 * width) return;
    for (int y = top; y < bottom; ++y) {
      const double place = (bottom - 1 - y) / (height - 1.0);
      for (int x = left; x < left + width; ++x) setPixel(image_, x, y, curvatureColor(display, place));
    }
    const double middle = (range.low + range.high) / 2;
    const int beside = left + width + 6 * pixel_, half = letterHeight * pixel_ / 2;
    write(beside, top - half, numberText(range.high));
    write(beside, (top + bottom) / 2 - half, numberText(middle));
    write(beside, bottom - half, numberText(range.low));
    write(left, top - (letterHeight + 7) * pixel_, display == SurfaceDisplay::Gaussian ? "1/mm^" : "1/mm");
  }

 private:
  static std::string numberText(double value) { return fmt::format("{:.3g}", value); }

  void write(int x, int y, const std::string& text) {
    writeLetters(image_, x, y, pixel_, text, mixed(look_.edge, look_.curve, 0.9));
  }

  Image& image_;
  const Look& look_;
  int pixel_;  // of a letter, in pixels of the picture
};

}  // namespace

void drawLegend(Image& image, SurfaceDisplay display, const CurvatureRange& range, const Look& look) {
  LegendPainter(image, look).draw(display, range);
}

}  // namespace blossom
