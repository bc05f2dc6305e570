#pragma once
#include "kernel/scheme.h"
#include "parameter/parameter.h"

namespace blossom::subdivision {

/// The scheme as chosen by the user. Catmull-Clark applied to a curve is the cubic scheme.
enum class SchemeChoice { CatmullClark, Loop, Cubic, Quadratic, FourPoint };

ParameterSpec schemeChoice();
inline constexpr const char* kSchemeHelp =
    "Meshes: Catmull-Clark for any polygons, Loop for triangles. Polygons: cubic or quadratic B-splines, or four-point, "
    "which passes through the points.";

inline Scheme surfaceScheme(SchemeChoice chosen) {
  return chosen == SchemeChoice::Loop ? Scheme::Loop : Scheme::CatmullClark;
}
inline CurveScheme curveScheme(SchemeChoice chosen) {
  if (chosen == SchemeChoice::Quadratic) return CurveScheme::Quadratic;
  return chosen == SchemeChoice::FourPoint ? CurveScheme::FourPoint : CurveScheme::Cubic;
}

}  // namespace blossom::subdivision
