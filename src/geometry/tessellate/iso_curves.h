#pragma once
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/shape/shape.h"

namespace blossom {

struct IsoCurveOptions {
  int count = 8;     ///< curves of each direction on a whole face, at equal steps of the parameter; 0 or more
  double chord = 0;  ///< mm, largest distance of the polylines from the curves; 0: 1/4000 of the shape's diagonal
};

/// A piece of a curve of constant parameter. Its points lie on the surface up to rounding, its ends on the border of the
/// face as far as the face's own parameter curves do.
struct IsoCurve {
  std::vector<Vec3> points;
  int face = 0;            ///< number of the face (see geometry/occt/sub_shape.h); 0 for a patch
  bool constantU = false;  ///< of constant u, else of constant v
  double parameter = 0;    ///< of the face's surface
};

/// The curves of constant u and v of every face of a B-rep, cut off at its edges, or of a patch; of a sequence, those of its
/// last frame. Other shapes have none: a mesh has no parameters. In a direction in which a face closes onto itself they are
/// evenly spread, none on the seam; else the borders are at equal steps, too. A face is cut by the lines of its parameter
/// plane that lie inside its loops (even-odd rule). Faces without parameter curves that close are left out. O(faces * curves
/// * points), faces in parallel.
/// @throws Error InvalidParameter for a negative count or chord; Cancelled.
std::vector<IsoCurve> isoCurves(const Shape&, const IsoCurveOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom
