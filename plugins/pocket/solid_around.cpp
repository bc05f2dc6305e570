#include "solid_around.h"

#include <BRepTools.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <limits>
#include <set>

#include "geometry/occt/sub_shape.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom::pocket {

namespace {

/// mm that a wall must rise or fall to be one.
constexpr double rises = 1e-4;

/// How far a face reaches above and below the face picked, and whether it lies level.
struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool level() const { return high - low < rises; }
};

using Edges = TopTools_IndexedDataMapOfShapeListOfShape;

/// The other faces at an edge, by their numbers.
std::vector<int> beside(const TopoDS_Shape& edge, const Edges& edges, const TopTools_IndexedMapOfShape& faces, int self) {
  std::vector<int> found;
  if (!edges.Contains(edge)) return found;
  for (const TopoDS_Shape& face : edges.FindFromKey(edge))
    if (const int index = faces.FindIndex(face) - 1; index >= 0 && index != self) found.push_back(index);
  return found;
}

/// The faces that rise from the outer boundary of a face, and those that lead on up from them until they lie level; empty
/// when not everything beside the boundary rises.
std::set<int> wallsAround(const TopoDS_Shape& solid, const TopoDS_Face& face, int index, const std::vector<Reach>& reach) {
  Edges edges;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, edges);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  std::set<int> walls;
  std::vector<int> open;
  for (TopExp_Explorer edge(BRepTools::OuterWire(face), TopAbs_EDGE); edge.More(); edge.Next()) {
    const std::vector<int> others = beside(edge.Current(), edges, faces, index);
    const auto climbs = [&](int i) {
      const Reach& r = reach[static_cast<std::size_t>(i)];
      return r.high > rises && r.low > -rises;
    };
    if (others.empty() || !std::all_of(others.begin(), others.end(), climbs)) return {};
    open.insert(open.end(), others.begin(), others.end());
  }
  while (!open.empty()) {
    const int wall = open.back();
    open.pop_back();
    if (!walls.insert(wall).second) continue;
    for (TopExp_Explorer edge(faces(wall + 1), TopAbs_EDGE); edge.More(); edge.Next())
      for (const int next : beside(edge.Current(), edges, faces, wall))
        if (const Reach& r = reach[static_cast<std::size_t>(next)]; next != index && !r.level() && r.low > -rises)
          open.push_back(next);
  }
  return walls;
}

}  // namespace

SolidAround solidAround(const Brep& brep, int face, const gp_Trsf& toFace, double chord, const Progress& progress) {
  const TopoDS_Face picked = faceOf(brep, face);
  const Tessellation mesh = tessellate(brep, {.chord = chord}, progress);
  std::vector<Vec3> points;
  for (const Vec3& p : mesh.points) {
    const gp_Pnt at = gp_Pnt(p.x(), p.y(), p.z()).Transformed(toFace);
    points.emplace_back(at.X(), at.Y(), at.Z());
  }
  SolidAround around;
  std::vector<Reach> reach;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const auto number = static_cast<std::size_t>(mesh.faceOfTriangle.at(i));
    if (number >= reach.size()) reach.resize(number + 1);
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = points.at(static_cast<std::size_t>(t[k]));
      around.box.add(corners[k]);
      reach[number].low = std::min(reach[number].low, corners[k].z());
      reach[number].high = std::max(reach[number].high, corners[k].z());
    }
    around.triangles.push_back(corners);
  }
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(brep.shape(), TopAbs_FACE, faces);
  reach.resize(static_cast<std::size_t>(faces.Extent()));
  const std::set<int> walls = wallsAround(brep.shape(), picked, face, reach);
  around.enclosed = !walls.empty();
  for (const int wall : walls) around.opening = std::max(around.opening, reach[static_cast<std::size_t>(wall)].high);
  return around;
}

}  // namespace blossom::pocket
