#include "geometry/tessellate.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/bounds.h"
#include "geometry/bspline.h"
#include "geometry/planar.h"
#include "geometry/point_merge.h"
#include "geometry/tessellate_parts.h"

namespace blossom {
namespace {

std::vector<Vec3> lifted(const std::vector<Vec2>& points) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec2& p : points) result.emplace_back(p.x(), p.y(), 0);
  return result;
}

/// Closed paths come back to their first point.
std::vector<Vec3> outline(const Path& path, double chord) {
  std::vector<Vec3> points = lifted(flatten(path, chord));
  if (path.closed && !points.empty()) points.push_back(points.front());
  return points;
}

Tessellation tessellateCurves(const Curves& curves, double chord, const Progress& progress) {
  Tessellation result;
  for (const Path& path : curves.paths) {
    progress.check();
    if (!path.segments.empty()) result.edges.push_back(outline(path, chord));
  }
  return result;
}

Tessellation tessellateCurve(const Curve& curve, double chord) {
  Tessellation result;
  result.edges.push_back(polyline(curve, chord));
  return result;
}

struct Visitor {
  const TessellationOptions& options;
  const Progress& progress;

  Tessellation operator()(std::monostate) const { return {}; }
  Tessellation operator()(const Region& region) const {
    Tessellation result = tessellateRegion(region, options, progress);
    for (const Path& loop : region.loops) result.edges.push_back(outline(loop, options.chord));
    return result;
  }
  Tessellation operator()(const Curves& curves) const { return tessellateCurves(curves, options.chord, progress); }
  Tessellation operator()(const Curve& curve) const { return tessellateCurve(curve, options.chord); }
  Tessellation operator()(const Surface& surface) const { return tessellateSurface(surface, options, progress); }
  Tessellation operator()(const Brep& brep) const { return tessellateBrep(brep, options, progress); }
  Tessellation operator()(const Mesh& mesh) const { return tessellateMesh(mesh, progress); }
  Tessellation operator()(const Motion& motion) const { return tessellateCurve(motion.trajectory, options.chord); }
  Tessellation operator()(const Sequence& sequence) const {
    return sequence.frames.empty() ? Tessellation() : tessellate(sequence.frames.back(), options, progress);
  }
};

TessellationOptions resolved(TessellationOptions options, const Shape& shape) {
  if (!(options.chord >= 0) || !(options.angle > 0))
    throw Error(ErrorCode::InvalidParameter, "The chord and the angle of a tessellation must be positive.");
  const double size = bounds(shape).diagonal();
  if (options.chord == 0) options.chord = size / 1000;
  options.chord = std::max({options.chord, 1e-9 * size, 1e-9});
  return options;
}

std::optional<Color> singleColor(const std::vector<Color>& colors) {
  const bool one =
      !colors.empty() && std::all_of(colors.begin(), colors.end(), [&](const Color& c) { return c == colors.front(); });
  return one ? std::optional(colors.front()) : std::nullopt;
}

}  // namespace

Tessellation tessellate(const Shape& shape, const TessellationOptions& options, const Progress& progress) {
  progress.check();
  return shape.visit(Visitor{resolved(options, shape), progress});
}

Mesh toMesh(const Tessellation& tessellation) {
  constexpr double samePoint = 1e-7;
  const std::vector<int> first = mergeClosePoints(tessellation.points, samePoint);
  std::vector<int> kept(first.size(), -1);
  Mesh mesh;
  const auto vertex = [&](int i) {
    int& index = kept[static_cast<std::size_t>(first[static_cast<std::size_t>(i)])];
    if (index < 0) {
      index = static_cast<int>(mesh.points.size());
      mesh.points.push_back(tessellation.points[static_cast<std::size_t>(first[static_cast<std::size_t>(i)])]);
    }
    return index;
  };
  for (const auto& [a, b, c] : tessellation.triangles) {
    const auto same = [&](int i, int j) { return first[static_cast<std::size_t>(i)] == first[static_cast<std::size_t>(j)]; };
    if (same(a, b) || same(b, c) || same(c, a)) continue;  // collapsed at a pole
    const std::array<int, 3> vertices{vertex(a), vertex(b), vertex(c)};
    mesh.addFace(vertices);
  }
  mesh.color = singleColor(tessellation.faceColors);
  return mesh;
}

Mesh meshOf(const Shape& shape, const TessellationOptions& options, const Progress& progress) {
  if (const Mesh* mesh = shape.get<Mesh>()) return *mesh;
  if (const Sequence* sequence = shape.get<Sequence>(); sequence && !sequence->frames.empty())
    return meshOf(sequence->frames.back(), options, progress);
  Mesh mesh = toMesh(tessellate(shape, options, progress));
  if (mesh.faceCount() == 0)
    throw Error(ErrorCode::InvalidInput,
                std::string("A shape of the kind \"") + std::string(shapeKindName(shape.kind())) +
                    "\" has no faces to make a mesh of.",
                "Make a surface or a solid of it first.");
  return mesh;
}

}  // namespace blossom
