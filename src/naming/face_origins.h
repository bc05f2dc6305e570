#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"
#include "feature/input_image.h"
#include "geometry/occt/sub_shape.h"

namespace blossom {

/// A face or edge of an input that a face of a result came from.
struct FaceOrigin {
  std::size_t input = 0;
  SubShapeKind kind = SubShapeKind::Face;
  int index = 0;
  std::string tag = {};  ///< of the image that the result's face lies on; of an edge: empty
  friend auto operator<=>(const FaceOrigin&, const FaceOrigin&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Where the faces of a result come from, told by where they lie: a face that lies on a face of an input, or holds one, came
/// from it; any other face came from the edges of inputs that bound it, as the side of an extrusion does; faces that neither
/// holds for, as roundings, have no origin. By number; each list is sorted.
/// O(f g) for f and g faces, most of which their boxes tell apart.
/// @param inputs of the feature, in the order that the images count them in
/// @throws Error Cancelled.
std::vector<std::vector<FaceOrigin>> faceOrigins(const TopoDS_Shape& result, const std::vector<Shape>& inputs,
                                                 const std::vector<InputImage>&, const Progress& = Progress::none());

}  // namespace blossom
