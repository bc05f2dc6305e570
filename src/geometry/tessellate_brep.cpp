#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <map>

#include "geometry/brep_mesher.h"
#include "geometry/tessellate_parts.h"

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

/// Walks an assembly; a part that is used many times is meshed once.
class AssemblyTessellator {
 public:
  AssemblyTessellator(const TessellationOptions& options, const Progress& progress)
      : options_(options), progress_(progress) {}

  /// @param imposed colour of an instance above, which wins  @param offered colour of a part above, for those without one
  void add(const BrepInstance& instance, const gp_Trsf& parent, std::optional<Color> imposed, std::optional<Color> offered) {
    if (!instance.part) return;
    const gp_Trsf place = parent * instance.location;
    if (!imposed) imposed = instance.color;
    if (instance.part->color) offered = instance.part->color;
    if (!instance.part->shape.IsNull()) addPart(*instance.part, place, imposed ? imposed : offered);
    for (const BrepInstance& child : instance.part->children) add(child, place, imposed, offered);
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

  void addPart(const BrepPart& part, const gp_Trsf& place, const std::optional<Color>& color) {
    const Tessellation& mesh = meshed(part);
    const auto offset = static_cast<int>(result_.points.size());
    const auto faceOffset = static_cast<int>(result_.faceColors.size());
    for (const Vec3& p : mesh.points) result_.points.push_back(moved(place, p));
    for (const Vec3& n : mesh.normals) result_.normals.push_back(turned(place, n));
    for (auto [a, b, c] : mesh.triangles) {
      if (place.IsNegative()) std::swap(b, c);
      result_.triangles.push_back({a + offset, b + offset, c + offset});
    }
    for (const int face : mesh.faceOfTriangle) result_.faceOfTriangle.push_back(face + faceOffset);
    for (const std::vector<Vec3>& edge : mesh.edges) {
      auto& image = result_.edges.emplace_back();
      for (const Vec3& p : edge) image.push_back(moved(place, p));
    }
    for (const Vec3& p : mesh.markers) result_.markers.push_back(moved(place, p));
    for (const std::optional<Color>& own : ownColors(part)) {
      colored_ = colored_ || own || color;
      result_.faceColors.push_back(own ? *own : color.value_or(Color()));
    }
  }

  TessellationOptions options_;
  const Progress& progress_;
  std::map<const BrepPart*, Tessellation> meshes_;
  Tessellation result_;
  bool colored_ = false;
};

}  // namespace

Tessellation tessellateBrep(const Brep& brep, const TessellationOptions& options, const Progress& progress) {
  AssemblyTessellator assembly(options, progress);
  for (const BrepInstance& root : brep.roots()) assembly.add(root, gp_Trsf(), {}, {});
  return std::move(assembly).result();
}

}  // namespace blossom
