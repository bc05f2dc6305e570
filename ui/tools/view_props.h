#pragma once
#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "core/vector.h"
#include "geometry/values/color.h"
#include "scene/picking.h"
#include "scene/scene.h"

/// What tools draw over the scene: always in front of it. Widths are in device pixels.
namespace blossom::ui {

using PropPtr = vtkSmartPointer<vtkProp>;

PropPtr linesProp(const std::vector<std::vector<Vec3>>& lines, const Color&, double width);
PropPtr pointsProp(const std::vector<Vec3>& points, const Color&, double size);
/// Seen through; `opacity` from 0 to 1. It does not hide what stands before it.
PropPtr trianglesProp(const std::vector<std::array<Vec3, 3>>& triangles, const Color&, double opacity);

/// A text on a small card that keeps its size, faces the viewer and stands just above its place.
struct LabelLook {
  QColor text, card, border;
  double pixelRatio = 1;
};
PropPtr labelProp(const QString& text, const Vec3& at, const LabelLook&);

QColor qtColor(const Color&, double opacity = 1);
/// Text and border in one colour, on a card of the colour of the background.
LabelLook labelLook(const Look&, const Color&, double pixelRatio);

/// Where the line of sight meets the plane z = 0; nothing when it runs along it or the plane lies behind the eye.
std::optional<Vec2> inGround(const Ray&);

}  // namespace blossom::ui
