#include "scene/surface_display.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "scene/scene.h"

namespace blossom {

namespace {

using ColorStops = std::array<Color, 5>;  // at equal steps

constexpr ColorStops aboutZero{
    {{0.13, 0.25, 0.62}, {0.44, 0.66, 0.88}, {0.80, 0.81, 0.82}, {0.93, 0.60, 0.40}, {0.67, 0.10, 0.12}}};
constexpr ColorStops fromZero{
    {{0.27, 0.13, 0.42}, {0.22, 0.35, 0.57}, {0.13, 0.57, 0.55}, {0.40, 0.79, 0.37}, {0.98, 0.90, 0.15}}};

}  // namespace

const std::vector<std::string>& surfaceDisplayNames() {
  static const std::vector<std::string> names{"plain", "zebra", "gaussian", "mean", "largest", "iso"};
  return names;
}

SurfaceDisplay surfaceDisplayOf(const std::string& name) {
  const std::vector<std::string>& names = surfaceDisplayNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(ErrorCode::InvalidParameter, "There is no display \"" + name + "\".",
                "Displays are plain, zebra, gaussian, mean, largest and iso.");
  return static_cast<SurfaceDisplay>(found - names.begin());
}

const char* curvatureUnit(SurfaceDisplay display) { return display == SurfaceDisplay::Gaussian ? "1/mm²" : "1/mm"; }

CurvatureRange curvatureRange(SurfaceDisplay display, double bound) {
  return {display == SurfaceDisplay::Largest ? 0 : -bound, bound};
}

Color curvatureColor(SurfaceDisplay display, double place) {
  const ColorStops& stops = display == SurfaceDisplay::Largest ? fromZero : aboutZero;
  const double at = std::clamp(place, 0.0, 1.0) * (stops.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return mixed(stops[before], stops[before + 1], at - static_cast<double>(before));
}

}  // namespace blossom
