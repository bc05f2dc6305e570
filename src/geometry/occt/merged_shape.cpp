#include "geometry/occt/merged_shape.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <algorithm>

#include "core/error.h"
#include "geometry/occt/occt.h"

namespace blossom {
namespace {

bool isDrawing(ShapeKind kind) { return kind == ShapeKind::Region || kind == ShapeKind::Curves; }
bool isExact(ShapeKind kind) {
  return isDrawing(kind) || kind == ShapeKind::Curve || kind == ShapeKind::Surface || kind == ShapeKind::Brep;
}

Curves drawn(const std::vector<NamedShape>& shapes) {
  Curves all;
  for (const NamedShape& each : shapes) {
    const auto* region = each.shape.get<Region>();
    const auto& paths = region ? region->loops : each.shape.get<Curves>()->paths;
    all.paths.insert(all.paths.end(), paths.begin(), paths.end());
  }
  return all;
}

void append(Mesh& all, const Mesh& mesh) {
  const int first = static_cast<int>(all.points.size());
  const int firstCorner = static_cast<int>(all.faceVertices.size());
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  for (const int vertex : mesh.faceVertices) all.faceVertices.push_back(first + vertex);
  for (std::size_t f = 1; f < mesh.faceStarts.size(); ++f) all.faceStarts.push_back(firstCorner + mesh.faceStarts[f]);
  for (const Crease& crease : mesh.creases)
    all.creases.push_back({first + crease.from, first + crease.to, crease.sharpness});
  all.flatFaces = all.flatFaces || mesh.flatFaces;
  for (const Corner& corner : mesh.corners) all.corners.push_back({first + corner.vertex, corner.sharpness});
}

TopoDS_Shape exact(const Shape& shape) {
  if (const auto* region = shape.get<Region>()) return toFaces(*region);
  if (const auto* curves = shape.get<Curves>()) return toWires(*curves);
  if (const auto* curve = shape.get<Curve>()) return BRepBuilderAPI_MakeEdge(toOcct(*curve)).Shape();
  return toFace(*shape.get<Surface>());
}

Brep assembled(const std::vector<NamedShape>& shapes) {
  std::vector<BrepInstance> roots;
  for (const NamedShape& each : shapes) {
    const auto* brep = each.shape.get<Brep>();
    const Brep made = brep ? *brep : Brep(exact(each.shape), each.name);
    for (const BrepInstance& root : made.roots()) {
      roots.push_back(root);
      if (made.roots().size() == 1) roots.back().name = each.name;
    }
  }
  return Brep(std::move(roots));
}

/// What was imported has names of its own, what was computed has not.
Shape named(const NamedShape& single) {
  if (const auto* mesh = single.shape.get<Mesh>(); mesh && mesh->name.empty()) {
    Mesh copy = *mesh;
    copy.name = single.name;
    return copy;
  }
  if (const auto* sequence = single.shape.get<Sequence>()) {
    Sequence copy = *sequence;
    for (Shape& frame : copy.frames) frame = named({single.name, frame});
    return copy;
  }
  const auto* brep = single.shape.get<Brep>();
  if (!brep) return single.shape;
  std::vector<BrepInstance> roots = brep->roots();
  for (BrepInstance& root : roots)
    if (root.name.empty() && root.part && root.part->name.empty()) root.name = single.name;
  return Brep(std::move(roots));
}

}  // namespace

ShapeKind mergedKind(const std::vector<ShapeKind>& kinds) {
  if (kinds.size() == 1) return kinds.front();
  const auto all = [&](auto is) { return !kinds.empty() && std::all_of(kinds.begin(), kinds.end(), is); };
  if (all(isDrawing)) return ShapeKind::Curves;
  if (all([](ShapeKind kind) { return kind == ShapeKind::Mesh; })) return ShapeKind::Mesh;
  return all(isExact) ? ShapeKind::Brep : ShapeKind::None;
}

Shape mergedShape(const std::vector<NamedShape>& shapes) {
  std::vector<ShapeKind> kinds;
  kinds.reserve(shapes.size());
  for (const NamedShape& each : shapes) kinds.push_back(each.shape.kind());
  if (shapes.size() == 1) return named(shapes.front());
  switch (mergedKind(kinds)) {
    case ShapeKind::Curves:
      return drawn(shapes);
    case ShapeKind::Brep:
      return assembled(shapes);
    case ShapeKind::Mesh: {
      Mesh all;
      for (const NamedShape& each : shapes) append(all, *each.shape.get<Mesh>());
      return all;
    }
    default:
      throw Error(ErrorCode::InvalidInput, "These results are of kinds that do not go into one file.",
                  "Export meshes, and shapes with exact surfaces, each into a file of their own.");
  }
}

}  // namespace blossom
