#include "geometry/tessellate/tessellate.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/single_point.h"
#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

std::vector<Vec3> lifted(const std::vector<Vec2>& points) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec2& p : points) result.emplace_back(p.x(), p.y(), 0);
  return result;
}

/// Seen on the dark canvas as on the light one. A drawing's black or white is what its paper asks for.
std::optional<Color> colorOnCanvas(const Path& path) {
  if (!path.color) return std::nullopt;
  const auto [darkest, lightest] = std::minmax({path.color->red, path.color->green, path.color->blue});
  return lightest < 0.25 || darkest > 0.8 ? std::nullopt : path.color;
}

/// Beside coloured outlines those without a colour are grey. Where none has one, the canvas decides.
void addColors(const std::vector<Path>& paths, Tessellation& result) {
  if (std::none_of(paths.begin(), paths.end(), [](const Path& path) { return colorOnCanvas(path).has_value(); })) return;
  constexpr Color plain{0.55, 0.60, 0.66};
  for (const Path& path : paths)
    result.edgeColors.insert(result.edgeColors.end(), path.segments.size(), colorOnCanvas(path).value_or(plain));
}

/// A polyline for each segment: segments are what is picked. Their ends are made to meet exactly.
void addOutlines(const std::vector<Path>& paths, double chord, const Progress& progress, Tessellation& result) {
  for (const Path& path : paths) {
    progress.check();
    const std::size_t first = result.edges.size();
    for (const Segment& segment : path.segments) {
      result.edgeIndices.push_back(static_cast<int>(result.edges.size()));
      result.edges.push_back(lifted(flatten(segment, chord)));
      result.vertices.push_back(result.edges.back().front());
    }
    for (std::size_t i = first; i + 1 < result.edges.size(); ++i) result.edges[i].back() = result.edges[i + 1].front();
    if (path.closed && result.edges.size() > first) result.edges.back().back() = result.edges[first].front();
  }
  addColors(paths, result);
}

Tessellation tessellateCurves(const Curves& curves, double chord, const Progress& progress) {
  Tessellation result;
  addOutlines(curves.paths, chord, progress, result);
  for (const Path& path : curves.paths)
    if (const auto point = singlePoint({&path, 1})) result.markers.emplace_back(point->x(), point->y(), 0);
  return result;
}

Tessellation tessellateCurve(const Curve& curve, double chord) {
  Tessellation result;
  result.edges.push_back(polyline(curve, chord));
  result.edgeIndices.push_back(0);
  result.vertices = {result.edges.front().front(), result.edges.front().back()};
  return result;
}

Tessellation tessellateMedialAxis(const MedialAxis& axis) {
  Tessellation result;
  for (const MedialEdge& edge : axis.edges) {
    result.edgeIndices.push_back(static_cast<int>(result.edges.size()));
    std::vector<Vec3>& line = result.edges.emplace_back();
    for (const Vec3& p : edge.points) line.emplace_back(p.x(), p.y(), 0);
  }
  for (const MedialVertex& v : axis.vertices) result.vertices.emplace_back(v.at.x(), v.at.y(), 0);
  return result;
}

struct TessellationVisitor {
  const TessellationOptions& options;
  const Progress& progress;

  Tessellation operator()(std::monostate) const { return {}; }
  Tessellation operator()(const Region& region) const {
    Tessellation result = tessellateRegion(region, options, progress);
    addOutlines(region.loops, options.chord, progress, result);
    return result;
  }
  Tessellation operator()(const Curves& curves) const { return tessellateCurves(curves, options.chord, progress); }
  Tessellation operator()(const Curve& curve) const { return tessellateCurve(curve, options.chord); }
  Tessellation operator()(const Surface& surface) const { return tessellateSurface(surface, options, progress); }
  Tessellation operator()(const Brep& brep) const { return tessellateBrep(brep, options, progress); }
  Tessellation operator()(const Mesh& mesh) const { return tessellateMesh(mesh, options, progress); }
  Tessellation operator()(const Motion& motion) const { return tessellateCurve(motion.trajectory, options.chord); }
  Tessellation operator()(const MedialAxis& axis) const { return tessellateMedialAxis(axis); }
  Tessellation operator()(const Toolpath& path) const { return tessellateToolpath(path, options.chord, progress); }
  Tessellation operator()(const Setup& setup) const { return tessellateSetup(setup, options, progress); }
  Tessellation operator()(const Sequence& sequence) const {
    return sequence.frames.empty() ? Tessellation() : tessellate(sequence.frames.back(), options, progress);
  }
};

/// Lines cost little: no corner is to be seen in them when the view comes near.
bool isDrawing(const Shape& shape) {
  switch (shape.kind()) {
    case ShapeKind::Region:
    case ShapeKind::Curves:
    case ShapeKind::Curve:
    case ShapeKind::Motion:
    case ShapeKind::Toolpath:
      return true;
    case ShapeKind::Sequence: {
      const std::vector<Shape>& frames = shape.get<Sequence>()->frames;
      return !frames.empty() && isDrawing(frames.back());
    }
    default:
      return false;
  }
}

TessellationOptions resolved(TessellationOptions options, const Shape& shape) {
  if (!(options.chord >= 0) || !(options.angle > 0))
    throw Error(ErrorCode::InvalidParameter, "The chord and the angle of a tessellation must be positive.");
  const double size = bounds(shape).diagonal();
  if (options.chord == 0) options.chord = size / (isDrawing(shape) ? 8000 : 1000);
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
  return shape.visit(TessellationVisitor{resolved(options, shape), progress});
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
