#include "scene/image_letters.h"

#include <algorithm>
#include <cmath>

namespace blossom {

namespace {

/// Five columns of seven pixels for each letter, the lowest bit on top. A picture needs no more than numbers and a unit; a
/// library of fonts would be start-up time of the command line.
struct Letter {
  char sign;
  unsigned char columns[5];
};
constexpr Letter letters[] = {
    {'0', {0x3e, 0x51, 0x49, 0x45, 0x3e}}, {'1', {0x00, 0x42, 0x7f, 0x40, 0x00}}, {'2', {0x42, 0x61, 0x51, 0x49, 0x46}},
    {'3', {0x21, 0x41, 0x45, 0x4b, 0x31}}, {'4', {0x18, 0x14, 0x12, 0x7f, 0x10}}, {'5', {0x27, 0x45, 0x45, 0x45, 0x39}},
    {'6', {0x3c, 0x4a, 0x49, 0x49, 0x30}}, {'7', {0x01, 0x71, 0x09, 0x05, 0x03}}, {'8', {0x36, 0x49, 0x49, 0x49, 0x36}},
    {'9', {0x06, 0x49, 0x49, 0x29, 0x1e}}, {'.', {0x00, 0x60, 0x60, 0x00, 0x00}}, {'-', {0x08, 0x08, 0x08, 0x08, 0x08}},
    {'/', {0x20, 0x10, 0x08, 0x04, 0x02}}, {'m', {0x7c, 0x04, 0x18, 0x04, 0x78}}, {'e', {0x38, 0x54, 0x54, 0x54, 0x18}},
    {'^', {0x00, 0x09, 0x0d, 0x0a, 0x00}},  // a small 2 above the line
};
}  // namespace

void setPixel(Image& image, int x, int y, const Color& color) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* const to =
      &image.rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4];
  const auto byte = [](double channel) { return static_cast<std::uint8_t>(std::lround(channel * 255)); };
  to[0] = byte(color.red), to[1] = byte(color.green), to[2] = byte(color.blue), to[3] = 255;
}

void writeLetters(Image& image, int x, int y, int pixel, std::string_view text, const Color& ink) {
  const auto square = [&](int left, int top) {
    for (int dy = 0; dy < pixel; ++dy)
      for (int dx = 0; dx < pixel; ++dx) setPixel(image, left + dx, top + dy, ink);
  };
  for (const char sign : text) {
    const auto* const letter =
        std::find_if(std::begin(letters), std::end(letters), [&](const Letter& each) { return each.sign == sign; });
    if (letter != std::end(letters))
      for (int column = 0; column < 5; ++column)
        for (int row = 0; row < letterHeight; ++row)
          if ((letter->columns[column] >> row & 1) != 0) square(x + column * pixel, y + row * pixel);
    x += letterWidth * pixel;
  }
}

}  // namespace blossom
