#include "manipulators/control_colors.h"

#include <QColor>
#include <cmath>

namespace blossom::minkowski {
namespace {

/// Relative luminance of sRGB (WCAG 2), by which contrast is measured.
double luminanceOf(const Color& color) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

Color ofHue(double hue, double lightness) {
  constexpr float saturation = 0.65F;
  const QColor color = QColor::fromHslF(static_cast<float>(hue), saturation, static_cast<float>(lightness));
  return {color.redF(), color.greenF(), color.blueF()};
}

}  // namespace

Color controlColor(const Look& look, std::size_t shape) {
  // Steps of the golden ratio: any number of hues are well apart. The first one is the cool one of controls.
  constexpr double firstHue = 0.57, step = 0.6180339887498949;
  const double turns = firstHue + step * static_cast<double>(shape), hue = turns - std::floor(turns);
  const double wanted = luminanceOf(look.backgroundBottom) < 0.2 ? 0.4 : 0.14;
  double low = 0, high = 1;
  constexpr int halvings = 16;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (luminanceOf(ofHue(hue, middle)) < wanted ? low : high) = middle;
  }
  return ofHue(hue, high);
}

}  // namespace blossom::minkowski
