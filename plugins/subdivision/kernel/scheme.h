#pragma once
#include <string_view>

namespace blossom::subdivision {

/// Subdivision scheme of surfaces. Catmull & Clark, CAD 10 (1978), for any polygons; Loop's thesis (1987), for triangles.
enum class Scheme { CatmullClark, Loop };

constexpr std::string_view schemeName(Scheme scheme) { return scheme == Scheme::Loop ? "Loop" : "Catmull-Clark"; }

/// Subdivision scheme of curves.
enum class CurveScheme { Cubic, Quadratic, FourPoint };

}  // namespace blossom::subdivision
