#include "geometry/values/color.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace blossom {
namespace {

using Named = std::pair<std::string_view, unsigned>;

/// The sixteen basic keywords of CSS and their common second names.
constexpr std::array<Named, 20> names{
    {{"black", 0x000000},  {"silver", 0xc0c0c0}, {"gray", 0x808080},   {"grey", 0x808080},    {"white", 0xffffff},
     {"maroon", 0x800000}, {"red", 0xff0000},    {"purple", 0x800080}, {"fuchsia", 0xff00ff}, {"magenta", 0xff00ff},
     {"green", 0x008000},  {"lime", 0x00ff00},   {"olive", 0x808000},  {"yellow", 0xffff00},  {"navy", 0x000080},
     {"blue", 0x0000ff},   {"teal", 0x008080},   {"aqua", 0x00ffff},   {"cyan", 0x00ffff},    {"orange", 0xffa500}}};

int toByte(double channel) { return static_cast<int>(std::lround(std::clamp(channel, 0.0, 1.0) * 255)); }

Color fromRgb(unsigned rgb) { return {((rgb >> 16) & 0xff) / 255.0, ((rgb >> 8) & 0xff) / 255.0, (rgb & 0xff) / 255.0}; }

std::optional<unsigned> parseHex(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  if (digits.size() == 6) return value;
  if (digits.size() != 3) return std::nullopt;
  return 0x11 * (((value & 0xf00) << 8) | ((value & 0x0f0) << 4) | (value & 0x00f));
}

}  // namespace

std::string toHex(const Color& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", toByte(color.red), toByte(color.green), toByte(color.blue));
}

std::optional<Color> parseColor(std::string_view text) {
  if (text.starts_with('#')) {
    const auto rgb = parseHex(text.substr(1));
    return rgb ? std::optional(fromRgb(*rgb)) : std::nullopt;
  }
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const auto& [name, rgb] : names)
    if (name == lower) return fromRgb(rgb);
  return std::nullopt;
}

}  // namespace blossom
