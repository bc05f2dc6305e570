#include "geometry/crossing/part_overlap.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/crossing/crossing_search.h"
#include "geometry/mesh/winding_field.h"
#include "geometry/shape/compound.h"

namespace blossom {
namespace {

Bnd_Box boxAroundPart(const TopoDS_Shape& part) {
  Bnd_Box box;
  BRepBndLib::Add(part, box, Standard_False);
  box.SetGap(0);
  return box;
}

int faceCount(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces.Extent();
}

class PartPair {
 public:
  PartPair(const TopoDS_Shape& a, const TopoDS_Shape& b, const Progress& progress)
      : progress_(progress),
        // Copies, so that parts which share their faces have faces of their own.
        whole_(compoundOf({BRepBuilderAPI_Copy(a, Standard_False, Standard_False).Shape(),
                           BRepBuilderAPI_Copy(b, Standard_False, Standard_False).Shape()})),
        facesOfFirst_(faceCount(a)) {
    const Bnd_Box box = boxAroundPart(whole_);
    chord_ = chordFor(options_) * std::sqrt(box.SquareExtent());
    mesh_ = sheetMesh(whole_, chord_, progress);
  }

  [[nodiscard]] std::optional<Vec3> crossing() const {
    MeetingTriangles found = meetingTriangles(mesh_, pairsKept, progress_);
    std::erase_if(found.pairs, [&](const TrianglePair& pair) { return isOfFirst(pair.first) == isOfFirst(pair.second); });
    if (found.pairs.empty()) return {};
    const auto deepest = searchCrossing(mesh_, SmoothSheets(whole_), found, options_, progress_).deepest;
    return deepest ? std::optional(deepest->point) : std::nullopt;
  }

  /// A place under the skin of one part that lies well inside the other.
  [[nodiscard]] std::optional<Vec3> inside() const {
    for (const bool first : {true, false}) {
      const std::vector<Triangle3> skin = trianglesOfPart(first), other = trianglesOfPart(!first);
      if (skin.empty() || other.empty()) continue;
      const WindingField own(skin, progress_), field(other, progress_);
      const TriangleTree tree(other);
      for (const Vec3& p : placesUnder(skin)) {
        progress_.check();
        // Under the skin of a thin part is its other side.
        if (own.at(p) > 0 && field.at(p) > 0 &&
            tree.closest(TriangleTree({Triangle3{p, p, p}}), progress_).distance() > 2 * chord_)
          return p;
      }
    }
    return {};
  }

 private:
  [[nodiscard]] bool isOfFirst(std::uint32_t triangle) const { return mesh_.triangles[triangle].face < facesOfFirst_; }

  [[nodiscard]] std::vector<Triangle3> trianglesOfPart(bool first) const {
    std::vector<Triangle3> triangles;
    for (const SheetTriangle& t : mesh_.triangles)
      if ((t.face < facesOfFirst_) == first) triangles.push_back(mesh_.at(t));
    return triangles;
  }

  /// Under the largest triangles and under others evenly chosen.
  [[nodiscard]] std::vector<Vec3> placesUnder(std::vector<Triangle3> skin) const {
    constexpr std::size_t largest = 100, others = 200;
    const auto area = [](const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).squaredNorm(); };
    std::stable_sort(skin.begin(), skin.end(), [&](const Triangle3& a, const Triangle3& b) { return area(a) > area(b); });
    std::vector<Vec3> places;
    const std::size_t stride = std::max<std::size_t>(1, skin.size() / others);
    for (std::size_t k = 0; k < skin.size(); k += k < largest ? 1 : stride) {
      const Triangle3& t = skin[k];
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
      // Not in the middle of the triangle: rays from a place of symmetry may run along edges.
      places.push_back(0.41 * t[0] + 0.33 * t[1] + 0.26 * t[2] - 4 * chord_ * normal);
    }
    return places;
  }

  CrossingOptions options_;
  const Progress& progress_;
  TopoDS_Shape whole_;
  int facesOfFirst_;
  double chord_ = 0;
  SheetMesh mesh_;
};

}  // namespace

std::optional<Vec3> overlapOf(const TopoDS_Shape& a, const TopoDS_Shape& b, const Progress& progress) {
  const Bnd_Box first = boxAroundPart(a), second = boxAroundPart(b);
  if (first.IsVoid() || second.IsVoid() || first.IsOut(second)) return {};
  const PartPair pair(a, b, progress);
  if (auto place = pair.crossing()) return place;
  return pair.inside();
}

}  // namespace blossom
