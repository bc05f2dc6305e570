#pragma once
#include <gp_XYZ.hxx>

#include "core/vector.h"

namespace blossom {

inline Vec3 toVec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

}  // namespace blossom
