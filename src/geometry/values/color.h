#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace blossom {

/// sRGB, each channel 0..1.
struct Color {
  double red = 0.8;
  double green = 0.8;
  double blue = 0.8;
  friend bool operator==(const Color&, const Color&) = default;
};

/// "#rrggbb". Channels are rounded to 1/255.
std::string toHex(const Color&);
/// Inverse of toHex; also "#rgb" and the CSS basic names. Empty when the text is not a colour.
std::optional<Color> parseColor(std::string_view text);

}  // namespace blossom
