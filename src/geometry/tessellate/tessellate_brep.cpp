#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/tessellate/brep_mesher.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

Vec3 moved(const gp_Trsf& place, const Vec3& p) {
  const gp_Pnt q = gp_Pnt(p.x(), p.y(), p.z()).Transformed(place);
  return {q.X(), q.Y(), q.Z()};
}

Vec3 turned(const gp_Trsf& place, const Vec3& direction) {
  const gp_Vec d = gp_Vec(direction.x(), direction.y(), direction.z()).Transformed(place);
  return Vec3(d.X(), d.Y(), d.Z()).normalized();
}

SurfaceCurvature scaledCurvature(const SurfaceCurvature& c, double factor) {
  return {c.gaussian * factor * factor, c.mean * factor, c.spread * factor};
}

/// Colours of the faces of a part: those of their own, else of the solid they belong to; nothing where the part's colour
/// counts.
std::vector<std::optional<Color>> ownColors(const BrepPart& part) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(part.shape, TopAbs_FACE, faces);
  std::vector<std::optional<Color>> colors(static_cast<std::size_t>(faces.Extent()));
  const auto paint = [&](bool onlyFaces) {
    for (const auto& [shape, color] : part.subShapeColors) {
      if (shape.IsNull() || (shape.ShapeType() == TopAbs_FACE) != onlyFaces) continue;
      for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
        if (const int index = faces.FindIndex(face.Current()); index > 0)
          colors[static_cast<std::size_t>(index - 1)] = color;
    }
  };
  paint(false);
  paint(true);
  return colors;
}

struct Placement {
  const BrepPart* part;
  gp_Trsf place;
  std::optional<Color> color;
};

/// @param imposed colour of an instance above, which wins  @param offered colour of a part above, for those without one
void collect(const BrepInstance& instance, const gp_Trsf& parent, std::optional<Color> imposed, std::optional<Color> offered,
             std::vector<Placement>& found) {
  if (!instance.part) return;
  const gp_Trsf place = parent * instance.location;
  if (!imposed) imposed = instance.color;
  if (instance.part->color) offered = instance.part->color;
  if (!instance.part->shape.IsNull()) found.push_back({instance.part.get(), place, imposed ? imposed : offered});
  for (const BrepInstance& child : instance.part->children) collect(child, place, imposed, offered, found);
}

/// Numbers of the parts of the whole shape. Instances may share faces or edges, which then count once.
class Numbering {
 public:
  Numbering(const TopoDS_Shape& whole, TopAbs_ShapeEnum type) : type_(type) { TopExp::MapShapes(whole, type, all_); }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(all_.Extent()); }
  /// By the numbers within one placed shape.
  [[nodiscard]] std::vector<int> of(const TopoDS_Shape& placed) const {
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(placed, type_, own);
    std::vector<int> numbers;
    numbers.reserve(static_cast<std::size_t>(own.Extent()));
    for (int i = 1; i <= own.Extent(); ++i) numbers.push_back(all_.FindIndex(own(i)) - 1);
    return numbers;
  }

 private:
  TopAbs_ShapeEnum type_;
  TopTools_IndexedMapOfShape all_;
};

/// A part that is used many times is meshed once.
class AssemblyTessellator {
 public:
  AssemblyTessellator(const Brep& brep, const TessellationOptions& options, const Progress& progress)
      : options_(options),
        progress_(progress),
        faces_(brep.shape(), TopAbs_FACE),
        edges_(brep.shape(), TopAbs_EDGE),
        vertices_(brep.shape(), TopAbs_VERTEX) {
    result_.faceColors.resize(faces_.count());
    result_.vertices.resize(vertices_.count());
  }

  void add(const Placement& placement, const TopoDS_Shape& placed) {
    const Tessellation& mesh = meshed(*placement.part);
    addTriangles(mesh, placement.place, faces_.of(placed));
    addEdges(mesh, placement.place, edges_.of(placed));
    const std::vector<int> vertices = vertices_.of(placed);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result_.vertices[static_cast<std::size_t>(vertices[i])] = moved(placement.place, mesh.vertices[i]);
    for (const Vec3& p : mesh.markers) result_.markers.push_back(moved(placement.place, p));
    addColors(placement, faces_.of(placed));
  }

  Tessellation result() && {
    if (!colored_) result_.faceColors.clear();
    return std::move(result_);
  }

 private:
  const Tessellation& meshed(const BrepPart& part) {
    const auto found = meshes_.find(&part);
    if (found != meshes_.end()) return found->second;
    return meshes_.emplace(&part, meshShape(part.shape, options_, progress_)).first->second;
  }

  void addTriangles(const Tessellation& mesh, const gp_Trsf& place, const std::vector<int>& numbers) {
    const auto offset = static_cast<int>(result_.points.size());
    for (const Vec3& p : mesh.points) result_.points.push_back(moved(place, p));
    for (const Vec3& n : mesh.normals) result_.normals.push_back(turned(place, n));
    for (const SurfaceCurvature& c : mesh.curvatures)
      result_.curvatures.push_back(scaledCurvature(c, 1 / std::abs(place.ScaleFactor())));
    for (auto [a, b, c] : mesh.triangles) {
      if (place.IsNegative()) std::swap(b, c);
      result_.triangles.push_back({a + offset, b + offset, c + offset});
    }
    for (const int face : mesh.faceOfTriangle) result_.faceOfTriangle.push_back(numbers[static_cast<std::size_t>(face)]);
  }

  void addEdges(const Tessellation& mesh, const gp_Trsf& place, const std::vector<int>& numbers) {
    for (const std::vector<Vec3>& edge : mesh.edges) {
      auto& image = result_.edges.emplace_back();
      image.reserve(edge.size());
      for (const Vec3& p : edge) image.push_back(moved(place, p));
    }
    for (const int edge : mesh.edgeIndices) result_.edgeIndices.push_back(numbers[static_cast<std::size_t>(edge)]);
  }

  void addColors(const Placement& placement, const std::vector<int>& numbers) {
    const std::vector<std::optional<Color>> own = ownColors(*placement.part);
    for (std::size_t i = 0; i < own.size(); ++i) {
      colored_ = colored_ || own[i] || placement.color;
      result_.faceColors[static_cast<std::size_t>(numbers[i])] = own[i] ? *own[i] : placement.color.value_or(Color());
    }
  }

  TessellationOptions options_;
  const Progress& progress_;
  Numbering faces_, edges_, vertices_;
  std::map<const BrepPart*, Tessellation> meshes_;
  Tessellation result_;
  bool colored_ = false;
};

}  // namespace

Tessellation tessellateBrep(const Brep& brep, const TessellationOptions& options, const Progress& progress) {
  std::vector<Placement> placements;
  for (const BrepInstance& root : brep.roots()) collect(root, gp_Trsf(), {}, {}, placements);
  if (placements.empty()) return {};
  AssemblyTessellator assembly(brep, options, progress);
  if (placements.size() == 1) {
    assembly.add(placements.front(), brep.shape());
    return std::move(assembly).result();
  }
  TopoDS_Iterator placed(brep.shape());  // Brep::shape() puts the instances together in the same order
  for (const Placement& placement : placements) {
    assembly.add(placement, placed.Value());
    placed.Next();
  }
  return std::move(assembly).result();
}

}  // namespace blossom
