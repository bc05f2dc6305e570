#include <cmath>

#include "core/error.h"
#include "geometry/planar/area_triangulation.h"
#include "geometry/planar/planar.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

double areaOf(const AreaTriangles& area) {
  double twice = 0;
  for (const auto& [a, b, c] : area.triangles) {
    const auto at = [&](int i) -> const Vec2& { return area.points[static_cast<std::size_t>(i)]; };
    const Vec2 first = at(b) - at(a), second = at(c) - at(a);
    twice += first.x() * second.y() - first.y() * second.x();
  }
  return twice / 2;
}

/// Without normals, as planar drawings are shown flat, and without outlines, which are drawn as they are and numbered by
/// their segments. The only face is the region itself.
Tessellation flatFace(const AreaTriangles& area) {
  Tessellation result;
  result.points.reserve(area.points.size());
  for (const Vec2& p : area.points) result.points.emplace_back(p.x(), p.y(), 0);
  result.triangles = area.triangles;
  result.faceOfTriangle.assign(area.triangles.size(), 0);
  return result;
}

}  // namespace

Tessellation tessellateRegion(const Region& region, const TessellationOptions& options, const Progress& progress) {
  if (region.loops.empty()) return {};
  const double wanted = area(region);
  double perimeter = 0;
  for (const Path& loop : region.loops) perimeter += length(loop);
  // Where loops nearly touch, their polygons may cross at a coarse chord; the missing area shows it.
  double chord = options.chord;
  for (int attempt = 0; attempt < 5; ++attempt, chord /= 8) {
    std::vector<std::vector<Vec2>> polygons;
    for (const Path& loop : region.loops) polygons.push_back(flatten(loop, chord));
    const AreaTriangles filled = triangulateArea(polygons, progress);
    if (std::abs(areaOf(filled) - wanted) <= perimeter * chord + 1e-6 * wanted) return flatFace(filled);
  }
  throw Error(ErrorCode::Degenerate, "The region cannot be divided into triangles.",
              "Look for loops that cross or touch one another.");
}

}  // namespace blossom
