#include <algorithm>
#include <cmath>

#include "geometry/tessellate/grid_curvature.h"
#include "geometry/tessellate/grid_fit.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

class SurfaceTessellator {
 public:
  explicit SurfaceTessellator(const SurfaceGrid& grid) {
    addCells(grid);
    addBoundary(grid);
  }

  Tessellation result() && { return std::move(result_); }

 private:
  void addTriangle(std::size_t a, std::size_t b, std::size_t c) {
    const auto& p = result_.points;
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;  // at a pole
    result_.triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    result_.faceOfTriangle.push_back(0);
  }

  void addCells(const SurfaceGrid& grid) {
    result_.points = grid.points;
    result_.normals = grid.normals;
    const std::size_t countV = grid.v.size();
    for (std::size_t i = 0; i + 1 < grid.u.size(); ++i) {
      if (!grid.connectedU(i)) continue;
      for (std::size_t j = 0; j + 1 < countV; ++j) {
        if (!grid.connectedV(j)) continue;
        const std::size_t p00 = i * countV + j, p10 = p00 + countV, p01 = p00 + 1, p11 = p10 + 1;
        if (mainDiagonal(grid.points[p00], grid.points[p10], grid.points[p01], grid.points[p11])) {
          addTriangle(p00, p10, p11);
          addTriangle(p00, p11, p01);
        } else {
          addTriangle(p00, p10, p01);
          addTriangle(p10, p11, p01);
        }
      }
    }
  }

  /// The four sides, but neither a seam nor a side that is one point.
  void addBoundary(const SurfaceGrid& grid) {
    const std::size_t lastU = grid.u.size() - 1;
    const std::size_t lastV = grid.v.size() - 1;
    std::vector<Vec3> u0, u1, v0, v1;
    for (std::size_t j = 0; j <= lastV; ++j) {
      u0.push_back(grid.point(0, j));
      u1.push_back(grid.point(lastU, j));
    }
    for (std::size_t i = 0; i <= lastU; ++i) {
      v0.push_back(grid.point(i, 0));
      v1.push_back(grid.point(i, lastV));
    }
    addSides(u0, u1);
    addSides(v0, v1);
  }

  void addSides(const std::vector<Vec3>& first, const std::vector<Vec3>& last) {
    const auto differ = [](const Vec3& a, const Vec3& b) { return (a - b).norm() > 1e-7; };
    if (std::equal(first.begin(), first.end(), last.begin(), [&](const Vec3& a, const Vec3& b) { return !differ(a, b); }))
      return;
    for (const auto& side : {first, last})
      if (std::any_of(side.begin(), side.end(), [&](const Vec3& p) { return differ(p, side.front()); })) addEdge(side);
  }

  void addEdge(const std::vector<Vec3>& side) {
    result_.edges.push_back(side);
    result_.edgeIndices.push_back(-1);
  }

  Tessellation result_;
};

}  // namespace

Tessellation tessellateSurface(const Surface& surface, const TessellationOptions& options, const Progress& progress) {
  const SurfaceGrid grid = fitGrid(surface, options, GridBorder::Own, progress);
  Tessellation result = SurfaceTessellator(grid).result();
  if (options.curvature) result.curvatures = gridCurvature(surface, grid, progress);
  return result;
}

}  // namespace blossom
