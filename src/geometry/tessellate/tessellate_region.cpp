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

/// Adds the triangles at z = 0, as parts of the only face, which is the region itself.
void add(const AreaTriangles& area, Tessellation& result) {
  const int first = static_cast<int>(result.points.size());
  for (const Vec2& p : area.points) result.points.emplace_back(p.x(), p.y(), 0);
  for (const auto& [a, b, c] : area.triangles) result.triangles.push_back({first + a, first + b, first + c});
  result.faceOfTriangle.resize(result.triangles.size(), 0);
}

}  // namespace

Tessellation tessellateRegion(const Region& region, const TessellationOptions& options, const Progress& progress) {
  if (region.loops.empty()) return {};
  const double wanted = area(region);
  double perimeter = 0;
  for (const Path& loop : region.loops) perimeter += length(loop);
  // Where loops nearly touch, their polygons may cross at a coarse chord; the missing area shows it.
  double chord = options.chord;
  const std::vector<RegionComponent> parts = components(region);
  for (int attempt = 0; attempt < 5; ++attempt, chord /= 8) {
    Tessellation result;  // without normals, as drawings are shown flat, and without outlines, which are drawn as they are
    double filled = 0;
    for (const RegionComponent& part : parts) {  // of a drawing filled by the non-zero rule, parts may overlap
      std::vector<std::vector<Vec2>> polygons{flatten(region.loops[part.outer], chord)};
      for (const std::size_t hole : part.holes) polygons.push_back(flatten(region.loops[hole], chord));
      const AreaTriangles triangles = triangulateArea(polygons, progress);
      filled += areaOf(triangles);
      add(triangles, result);
    }
    if (std::abs(filled - wanted) <= perimeter * chord + 1e-6 * wanted) return result;
  }
  throw Error(ErrorCode::Degenerate, "The region cannot be divided into triangles.",
              "Look for loops that cross or touch one another.");
}

}  // namespace blossom
