#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <span>

#include "exchange/svg/svg_values.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"

namespace blossom::svg {

/// The window of a nested svg or a symbol, which crops what lies outside it; of splines the poles count.
struct CropWindow {
  Eigen::Affine2d place;  ///< of its corner at (0, 0) in mm
  Vec2 size;

  [[nodiscard]] bool holds(std::span<const Path> paths) const {
    const Eigen::Matrix<double, 2, 3> toWindow(place.inverse().affine());
    const double slack = 1e-6 * size.maxCoeff();
    return std::all_of(paths.begin(), paths.end(), [&](const Path& path) {
      const Bounds box = bounds(Shape(Curves{{transformed(path, toWindow)}, FillRule::NonZero}));
      return box.empty ||
             ((box.low.head<2>().array() >= -slack).all() && (box.high.head<2>().array() <= size.array() + slack).all());
    });
  }
};

}  // namespace blossom::svg
