#pragma once
#include <QColor>
#include <array>

#include "geometry/values/color.h"

namespace blossom::sweep {

/// Of the axes x, y and z, as on the view cube.
inline QColor axisColor(int axis) {
  static const std::array<QColor, 3> colors{QColor(220, 95, 95), QColor(105, 178, 105), QColor(105, 145, 230)};
  return colors.at(static_cast<std::size_t>(axis));
}
inline Color axisSceneColor(int axis) {
  const QColor color = axisColor(axis);
  return {color.redF(), color.greenF(), color.blueF()};
}

}  // namespace blossom::sweep
