#include "geometry/crossing/part_overlap.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
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

/// Triangles of one part: those of planes lie on them, the others only near their face.
struct PartSkin {
  std::vector<Triangle3> flat, curved;
};

std::vector<Triangle3> allOf(const PartSkin& skin) {
  std::vector<Triangle3> all = skin.flat;
  all.insert(all.end(), skin.curved.begin(), skin.curved.end());
  return all;
}

/// The space that one part takes.
class PartSpace {
 public:
  PartSpace(const PartSkin& skin, const Progress& progress)
      : progress_(progress), triangles_(allOf(skin)), field_(triangles_, progress) {
    if (!skin.flat.empty()) flat_.emplace(skin.flat);
    if (!skin.curved.empty()) curved_.emplace(skin.curved);
  }

  [[nodiscard]] const std::vector<Triangle3>& triangles() const { return triangles_; }
  [[nodiscard]] bool holds(const Vec3& p) const { return field_.at(p) > 0; }
  [[nodiscard]] double distanceToFlat(const Vec3& p) const { return distance(flat_, p); }
  [[nodiscard]] double distanceToCurved(const Vec3& p) const { return distance(curved_, p); }

 private:
  [[nodiscard]] double distance(const std::optional<TriangleTree>& tree, const Vec3& p) const {
    if (!tree) return std::numeric_limits<double>::infinity();
    return tree->closest(TriangleTree({Triangle3{p, p, p}}), progress_).distance();
  }

  const Progress& progress_;
  std::vector<Triangle3> triangles_;
  WindingField field_;
  std::optional<TriangleTree> flat_, curved_;
};

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

  /// Where the parts pass through one another, or share their skin and what is under it.
  [[nodiscard]] std::optional<Vec3> crossing() const {
    MeetingTriangles found = meetingTriangles(mesh_, pairsKept, progress_);
    for (const TrianglePair& pair : found.alike)
      if (!isOfOnePart(pair)) return pair.place;
    std::erase_if(found.pairs, [&](const TrianglePair& pair) { return isOfOnePart(pair); });
    if (found.pairs.empty()) return {};
    const auto deepest = searchCrossing(mesh_, SmoothSheets(whole_), found, options_, progress_).deepest;
    return deepest ? std::optional(deepest->point) : std::nullopt;
  }

  /// A place under the skin of one part that lies inside the other.
  [[nodiscard]] std::optional<Vec3> inside() const {
    const PartSkin skins[2] = {skinOf(true), skinOf(false)};
    if (allOf(skins[0]).empty() || allOf(skins[1]).empty()) return {};
    const PartSpace first(skins[0], progress_), second(skins[1], progress_);
    for (const auto& [own, other] : {std::pair(&first, &second), std::pair(&second, &first)})
      for (const double share : {4.0, 1.0, 0.1})  // under the skin of a thin part is its other side
        for (const Vec3& p : placesUnder(own->triangles(), share * chord_)) {
          progress_.check();
          if (!own->holds(p) || !other->holds(p)) continue;
          // Either the place is clear of all errors, or what is beside it is flat and has none.
          const double curved = other->distanceToCurved(p), flat = other->distanceToFlat(p);
          const bool clear = curved > 2 * chord_ && flat > 2 * chord_;
          if (clear || (curved > 2 * chord_ && flat > 0.01 * chord_ && own->distanceToCurved(p) > 2 * chord_)) return p;
        }
    return {};
  }

 private:
  [[nodiscard]] bool isOfFirst(std::uint32_t triangle) const { return mesh_.triangles[triangle].face < facesOfFirst_; }
  [[nodiscard]] bool isOfOnePart(const TrianglePair& pair) const { return isOfFirst(pair.first) == isOfFirst(pair.second); }

  [[nodiscard]] PartSkin skinOf(bool first) const {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(whole_, TopAbs_FACE, faces);
    std::vector<bool> isFlat;
    for (int i = 1; i <= faces.Extent(); ++i)
      isFlat.push_back(BRepAdaptor_Surface(TopoDS::Face(faces(i)), Standard_False).GetType() == GeomAbs_Plane);
    PartSkin skin;
    for (const SheetTriangle& t : mesh_.triangles)
      if ((t.face < facesOfFirst_) == first)
        (isFlat[static_cast<std::size_t>(t.face)] ? skin.flat : skin.curved).push_back(mesh_.at(t));
    return skin;
  }

  /// Under the largest triangles and under others evenly chosen.
  [[nodiscard]] static std::vector<Vec3> placesUnder(std::vector<Triangle3> skin, double deep) {
    constexpr std::size_t largest = 100, others = 200;
    const auto area = [](const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).squaredNorm(); };
    std::stable_sort(skin.begin(), skin.end(), [&](const Triangle3& a, const Triangle3& b) { return area(a) > area(b); });
    std::vector<Vec3> places;
    const std::size_t stride = std::max<std::size_t>(1, skin.size() / others);
    for (std::size_t k = 0; k < skin.size(); k += k < largest ? 1 : stride) {
      const Triangle3& t = skin[k];
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
      // Not in the middle of the triangle: rays from a place of symmetry may run along edges.
      places.push_back(0.41 * t[0] + 0.33 * t[1] + 0.26 * t[2] - deep * normal);
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
