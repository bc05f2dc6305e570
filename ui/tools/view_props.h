#pragma once
#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <QImage>
#include <QPointF>
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
/// Transparent triangles; `opacity` from 0 to 1. They do not hide objects in front of them.
PropPtr trianglesProp(const std::vector<std::array<Vec3, 3>>& triangles, const Color&, double opacity);

/// A text on a small card of constant size that faces the viewer, just above its position. It lies whole within the view
/// as long as its position does.
struct LabelLook {
  QColor text, card, border;
  double pixelRatio = 1;
  QPointF shift = {};   ///< logical pixels, to the right and up
  bool follow = false;  ///< seen at the border of the view when its position is beyond it
};
inline constexpr double labelGap = 6;  ///< logical pixels from the position to the card above it
PropPtr labelProp(const QString& text, const Vec3& at, const LabelLook&);

/// A picture of constant size that faces the viewer, its middle at a position. Its device pixels are those of the view.
PropPtr pictureProp(const QImage&, const Vec3& at);

/// For what shows parts of a shape: the section plane of the view cuts it as it cuts shapes.
void cutBySection(vtkProp&);
bool isCutBySection(vtkProp&);

QColor qtColor(const Color&, double opacity = 1);
/// Text and border in one colour, on a card of the colour of the background.
LabelLook labelLook(const Look&, const Color&, double pixelRatio);

/// Intersection of the line of sight with the plane z = 0; empty when it is parallel or the plane lies behind the eye.
std::optional<Vec2> inGround(const Ray&);

}  // namespace blossom::ui
