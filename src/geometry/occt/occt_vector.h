#pragma once
#include <gp_Pnt.hxx>

#include "core/vector.h"

namespace blossom {

inline Vec3 toVec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 toVec(const gp_Pnt& p) { return toVec(p.XYZ()); }

}  // namespace blossom
