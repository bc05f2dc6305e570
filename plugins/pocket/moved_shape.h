#pragma once
#include <gp_Trsf.hxx>

#include "core/vector.h"
#include "geometry/shape/shape.h"

namespace blossom::pocket {

gp_Trsf movedBy(const Vec3&);
/// A solid, mesh or flat drawing elsewhere; of drawings only the place in their plane can change.
Shape movedShape(const Shape&, const gp_Trsf&);

}  // namespace blossom::pocket
