#include "ui/view/display_mode.h"

namespace blossom::ui {

const QStringList& displayModeNames() {
  static const QStringList names{QStringLiteral("edges"),   QStringLiteral("shaded"),   QStringLiteral("wireframe"),
                                 QStringLiteral("zebra"),   QStringLiteral("gaussian"), QStringLiteral("mean"),
                                 QStringLiteral("largest"), QStringLiteral("iso")};
  return names;
}

std::optional<DisplayMode> displayModeOf(const QString& name) {
  if (name == QLatin1String("plain")) return DisplayMode::ShadedWithEdges;  // as `blossom render` calls it
  const auto place = displayModeNames().indexOf(name);
  if (place < 0) return std::nullopt;
  return static_cast<DisplayMode>(place);
}

SurfaceDisplay surfaceDisplay(DisplayMode mode) {
  switch (mode) {
    case DisplayMode::Zebra:
      return SurfaceDisplay::Zebra;
    case DisplayMode::GaussianCurvature:
      return SurfaceDisplay::Gaussian;
    case DisplayMode::MeanCurvature:
      return SurfaceDisplay::Mean;
    case DisplayMode::LargestCurvature:
      return SurfaceDisplay::Largest;
    case DisplayMode::IsoCurves:
      return SurfaceDisplay::IsoCurves;
    default:
      return SurfaceDisplay::Plain;
  }
}

bool needsStudy(DisplayMode mode) { return showsCurvature(surfaceDisplay(mode)) || mode == DisplayMode::IsoCurves; }

}  // namespace blossom::ui
