#pragma once
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "exchange/svg/svg_values.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"

namespace blossom::svg {

/// The window of a nested svg or a symbol, which crops what lies outside it; of splines the poles count.
struct CropWindow {
  Eigen::Affine2d place;  ///< of its corner at (0, 0) in mm
  Vec2 size;

  [[nodiscard]] bool holds(const std::vector<Path>& paths) const {
    const Eigen::Matrix<double, 2, 3> toWindow(place.inverse().affine());
    Curves seen;
    for (const Path& path : paths) seen.paths.push_back(transformed(path, toWindow));
    const Bounds box = bounds(Shape(std::move(seen)));
    const double slack = 1e-6 * size.maxCoeff();
    return box.empty ||
           ((box.low.head<2>().array() >= -slack).all() && (box.high.head<2>().array() <= size.array() + slack).all());
  }
};

}  // namespace blossom::svg
