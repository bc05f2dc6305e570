#pragma once
#include <QString>
#include <QStringList>
#include <optional>

#include "scene/surface_display.h"

namespace blossom::ui {

/// How the view draws shapes with faces.
enum class DisplayMode {
  ShadedWithEdges,
  Shaded,
  Wireframe,
  Zebra,
  GaussianCurvature,
  MeanCurvature,
  LargestCurvature,
  IsoCurves
};

/// "edges", "shaded", "wireframe", "zebra", "gaussian", "mean", "largest", "iso": as the command line has them.
const QStringList& displayModeNames();
/// Empty for another name; "plain" is the first mode.
std::optional<DisplayMode> displayModeOf(const QString& name);

/// What the faces tell of their surfaces in a mode.
SurfaceDisplay surfaceDisplay(DisplayMode);
/// Whether a mode draws what is computed beside the triangles of a shape (scene/surface_study.h).
bool needsStudy(DisplayMode);

}  // namespace blossom::ui
