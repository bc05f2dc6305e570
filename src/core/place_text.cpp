#include "core/place_text.h"

#include <fmt/format.h>

#include <cmath>

namespace blossom {

std::string placeText(const Vec3& p) {
  const auto clean = [](double v) { return std::abs(v) < 1e-9 ? 0.0 : v; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", clean(p.x()), clean(p.y()), clean(p.z()));
}

}  // namespace blossom
