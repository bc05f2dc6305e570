#include "kernel/solid/wall_check.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepTools.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <limits>

#include "geometry/mesh/triangle_distance.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/tessellate/tessellate.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

/// The faces of a solid that are kept, as triangles.
class Skin {
 public:
  Skin(const TopoDS_Shape& solid, const std::vector<int>& open, double chord, const Progress& progress) {
    const Tessellation made = tessellate(Brep(solid), {.chord = chord, .angle = 0.5}, progress);
    std::vector<Box3> boxes;
    for (std::size_t k = 0; k < made.triangles.size(); ++k) {
      if (std::find(open.begin(), open.end(), made.faceOfTriangle[k]) != open.end()) continue;
      const auto at = [&](std::size_t corner) { return made.points[static_cast<std::size_t>(made.triangles[k][corner])]; };
      boxes.push_back(boxOf(triangles_.emplace_back(Triangle3{at(0), at(1), at(2)})));
    }
    tree_ = BoxTree<3>(boxes, 4, progress);
  }

  [[nodiscard]] double distanceTo(const Vec3& place) const {
    double nearest = std::numeric_limits<double>::infinity();
    tree_.walk([&](const Box3& box) { return boxDistance(box, place); },
               [&](std::size_t t) { nearest = std::min(nearest, (closestOnTriangle(place, triangles_[t]) - place).norm()); },
               [&](double distance) { return distance < nearest; });
    return nearest;
  }

 private:
  std::vector<Triangle3> triangles_;
  BoxTree<3> tree_;
};

/// Places of a grid in the parameters of a face that lie in it.
std::vector<Vec3> placesOn(const TopoDS_Face& face, int perSide) {
  constexpr double confusion = 1e-7;
  std::vector<Vec3> places;
  try {
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const BRepAdaptor_Surface surface(face, Standard_False);
    for (int i = 0; i < perSide; ++i)
      for (int j = 0; j < perSide; ++j) {
        const gp_Pnt2d at(u0 + (u1 - u0) * (i + 0.5) / perSide, v0 + (v1 - v0) * (j + 0.5) / perSide);
        if (BRepClass_FaceClassifier(face, at, confusion).State() != TopAbs_IN) continue;
        const gp_Pnt p = surface.Value(at.X(), at.Y());
        places.emplace_back(p.X(), p.Y(), p.Z());
      }
  } catch (const Standard_Failure&) {
    places.clear();  // a surface that cannot be evaluated there is judged by others
  }
  return places;
}

/// Of a face that lies at the distance of the walls all in all; rims and faces of the solid do not.
std::optional<ThinWall> thinPlace(const TopoDS_Face& face, int perSide, const Skin& skin, double thickness, double slack) {
  const std::vector<Vec3> places = placesOn(face, perSide);
  if (places.empty()) return std::nullopt;
  std::vector<double> distances;
  distances.reserve(places.size());
  for (const Vec3& place : places) distances.push_back(skin.distanceTo(place));
  std::vector<double> sorted = distances;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  if (*middle < thickness - slack) return std::nullopt;
  const auto least = std::min_element(distances.begin(), distances.end());
  if (*least >= thickness - slack) return std::nullopt;
  return ThinWall{places[static_cast<std::size_t>(least - distances.begin())], *least};
}

}  // namespace

std::optional<ThinWall> thinWall(const TopoDS_Shape& solid, const std::vector<int>& open, const TopoDS_Shape& made,
                                 double thickness, const Progress& progress) {
  constexpr double finest = 2e-4, share = 1.0 / 30;
  const double chord = std::max(thickness / 100, finest * diagonalOf(solid)), slack = share * thickness + 2 * chord;
  if (5 * chord > thickness) return std::nullopt;
  const Skin skin(solid, open, chord, progress);
  const std::vector<TopoDS_Shape> faces = subShapesOf(made, TopAbs_FACE);
  constexpr std::size_t few = 30;
  const int perSide = faces.size() < few ? 24 : 8;
  std::optional<ThinWall> thinnest;
  for (const TopoDS_Shape& face : faces) {
    progress.check();
    const auto here = thinPlace(TopoDS::Face(face), perSide, skin, thickness, slack);
    if (here && (!thinnest || here->thickness < thinnest->thickness)) thinnest = here;
  }
  return thinnest;
}

}  // namespace blossom::modeling
