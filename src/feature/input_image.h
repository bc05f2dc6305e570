#pragma once
#include <Eigen/Geometry>
#include <cstddef>
#include <string>

namespace blossom {

/// A place in which an input lies in the result of a feature: copy k of a pattern, or the outline at the end of an
/// extrusion. A face of the result that lies on a face of an image came from it; a side face came from the edge that bounds
/// it.
struct InputImage {
  std::size_t input = 0;  ///< counted over all inputs in the order of declaration
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  std::string tag = {};  ///< tells the images of an input apart: "end", "3"; faces of one without a tag keep their names
};

}  // namespace blossom
