#include "core/place_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace blossom {

std::string placeText(const Vec3& p) {
  constexpr double nothing = 1e-9, share = 1e-8;
  const double noise = std::max(nothing, share * p.cwiseAbs().maxCoeff());
  const auto clean = [noise](double v) { return std::abs(v) < noise ? 0.0 : v; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", clean(p.x()), clean(p.y()), clean(p.z()));
}

std::string leastText(double value) {
  constexpr const char* twoDigits = "{:.2g}";
  std::string nearest = fmt::format(twoDigits, value);
  if (!std::isfinite(value) || std::strtod(nearest.c_str(), nullptr) <= value) return nearest;
  const double halfADigit = std::pow(10, std::floor(std::log10(value)) - 1) / 2;
  return fmt::format(twoDigits, value - halfADigit);
}

std::string placeText(const Vec3& p, double size, int digits) {
  constexpr double smallest = 1e-9;
  const double unit = std::pow(10, std::floor(std::log10(std::max(size, smallest))) - (digits - 1));
  return placeText((p / unit).array().round().matrix() * unit);
}

}  // namespace blossom
