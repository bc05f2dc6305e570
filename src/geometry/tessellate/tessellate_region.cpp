#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"
#include "geometry/tessellate/brep_mesher.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

double triangleArea(const Tessellation& t) {
  double sum = 0;
  for (const auto& [a, b, c] : t.triangles) {
    const auto at = [&](int i) -> const Vec3& { return t.points[static_cast<std::size_t>(i)]; };
    sum += (at(b) - at(a)).cross(at(c) - at(a)).z() / 2;
  }
  return sum;
}

}  // namespace

Tessellation tessellateRegion(const Region& region, const TessellationOptions& options, const Progress& progress) {
  if (region.loops.empty()) return {};
  const TopoDS_Shape faces = toFaces(region);
  const double wanted = area(region);
  double perimeter = 0;
  for (const Path& loop : region.loops) perimeter += length(loop);
  // Where loops nearly touch, their polygons may cross at a coarse chord; the missing area shows it.
  TessellationOptions finer = options;
  for (int attempt = 0; attempt < 5; ++attempt) {
    Tessellation result = meshShape(faces, finer, progress);
    if (std::abs(triangleArea(result) - wanted) <= perimeter * finer.chord + 1e-6 * wanted) {
      result.normals.clear();  // planar drawings are shown flat
      result.edges.clear();    // its outlines are drawn as they are, and numbered by their segments
      result.edgeIndices.clear();
      result.vertices.clear();
      std::fill(result.faceOfTriangle.begin(), result.faceOfTriangle.end(), 0);  // the only face is the region itself
      return result;
    }
    finer.chord /= 8;
    finer.angle = std::max(finer.angle / 2, 0.01);
  }
  throw Error(ErrorCode::Degenerate, "The region cannot be divided into triangles.",
              "Look for loops that cross or touch one another.");
}

}  // namespace blossom
