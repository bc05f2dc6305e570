#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "geometry/mesh/closed_triangles.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/occt/occt.h"
#include "geometry/shape/compound.h"

namespace blossom {
namespace {

gp_Pnt toPnt(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
gp_Dir toDir(const Vec3& d) { return {d.x(), d.y(), d.z()}; }

double distanceFromPlane(const std::vector<Vec3>& polygon, const Vec3& normal) {
  double farthest = 0;
  for (const Vec3& p : polygon) farthest = std::max(farthest, std::abs((p - polygon[0]).dot(normal)));
  return farthest;
}

/// One vertex for points that coincide, no face of area zero, and only faces that are planar.
Mesh prepared(const Mesh& mesh) {
  const std::vector<int> first = mergeClosePoints(mesh.points, Precision::Confusion());
  Mesh result;
  result.points = mesh.points;
  const auto add = [&](const std::vector<int>& vertices) {
    std::vector<int> merged;
    for (const int v : vertices)
      if (const int m = first[static_cast<std::size_t>(v)]; merged.empty() || m != merged.back()) merged.push_back(m);
    while (merged.size() > 1 && merged.front() == merged.back()) merged.pop_back();
    if (merged.size() > 2) result.addFace(merged);
  };
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const std::vector<Vec3> polygon = facePoints(mesh, f);
    if (distanceFromPlane(polygon, vectorArea(polygon).normalized()) <= Precision::Confusion()) {
      add({face.begin(), face.end()});
      continue;
    }
    for (const auto& [a, b, c] : triangulate(polygon))
      add({face[static_cast<std::size_t>(a)], face[static_cast<std::size_t>(b)], face[static_cast<std::size_t>(c)]});
  }
  return result;
}

class ShapeBuilder {
 public:
  explicit ShapeBuilder(const Mesh& mesh) : mesh_(mesh), topology_(meshTopology(mesh)), triangles_(triangulated(mesh)) {}

  TopoDS_Shape build() {
    makeVertices();
    makeEdges();
    makeShells();
    return assembled();
  }

 private:
  struct Part {
    TopoDS_Shell shell;
    bool closed = false;
    double volume = 0;  ///< signed
    Vec3 somePoint = Vec3::Zero();
    std::vector<Triangle3> triangles;
  };

  void makeVertices() {
    vertices_.resize(mesh_.points.size());
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
      builder_.MakeVertex(vertices_[i], toPnt(mesh_.points[i]), Precision::Confusion());
  }

  void makeEdges() {
    edges_.reserve(topology_.edges.size());
    for (const MeshEdge& edge : topology_.edges) {
      const Vec3& from = mesh_.points[static_cast<std::size_t>(edge.low)];
      const Vec3 along = mesh_.points[static_cast<std::size_t>(edge.high)] - from;
      TopoDS_Edge result;
      builder_.MakeEdge(result, new Geom_Line(toPnt(from), toDir(along)), Precision::Confusion());
      builder_.Add(result, vertices_[static_cast<std::size_t>(edge.low)].Oriented(TopAbs_FORWARD));
      builder_.Add(result, vertices_[static_cast<std::size_t>(edge.high)].Oriented(TopAbs_REVERSED));
      builder_.Range(result, 0, along.norm());
      edges_.push_back(result);
    }
  }

  TopoDS_Edge edgeBetween(int from, int to) const {
    const auto key = std::pair(std::min(from, to), std::max(from, to));
    const auto found = std::lower_bound(topology_.edges.begin(), topology_.edges.end(), key,
                                        [](const MeshEdge& e, const auto& k) { return std::pair(e.low, e.high) < k; });
    TopoDS_Edge edge = edges_[static_cast<std::size_t>(found - topology_.edges.begin())];
    edge.Orientation(from < to ? TopAbs_FORWARD : TopAbs_REVERSED);
    return edge;
  }

  std::optional<TopoDS_Face> makeFace(std::size_t f) {
    const std::vector<Vec3> polygon = facePoints(mesh_, f);
    const Vec3 normal = vectorArea(polygon);
    if (!(normal.norm() > 0)) return std::nullopt;
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    const auto face = mesh_.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) builder_.Add(wire, edgeBetween(face[k], face[(k + 1) % face.size()]));
    wire.Closed(Standard_True);
    TopoDS_Face result;
    builder_.MakeFace(result, new Geom_Plane(toPnt(polygon[0]), toDir(normal)), Precision::Confusion());
    builder_.Add(result, wire);
    return result;
  }

  void makeShells() {
    parts_.resize(topology_.components.size());
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      builder_.MakeShell(parts_[c].shell);
      parts_[c].closed = topology_.components[c].closed;
    }
    const auto& [triangles, faceOf] = triangles_;
    for (std::size_t t = 0; t < triangles.faceCount(); ++t) {
      Part& part = parts_[static_cast<std::size_t>(topology_.componentOfFace[static_cast<std::size_t>(faceOf[t])])];
      const auto points = facePoints(triangles, t);
      part.triangles.push_back({points[0], points[1], points[2]});
    }
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      Part& part = parts_[static_cast<std::size_t>(topology_.componentOfFace[f])];
      part.somePoint = mesh_.points[static_cast<std::size_t>(mesh_.face(f)[0])];
      if (const auto face = makeFace(f)) {
        builder_.Add(part.shell, *face);
      } else {
        part.closed = false;
      }
    }
    for (Part& part : parts_) {
      part.volume = signedVolume(part.triangles);
      part.shell.Closed(part.closed);
    }
  }

  /// The smallest body around a hollow, if any.
  std::optional<std::size_t> bodyAround(const Part& hollow) const {
    std::optional<std::size_t> best;
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      const Part& body = parts_[c];
      if (!body.closed || body.volume <= -hollow.volume || (best && parts_[*best].volume <= body.volume)) continue;
      if (windingNumber(body.triangles, hollow.somePoint) > 0.5) best = c;
    }
    return best;
  }

  /// Closed shells are solids; those turned inwards are hollows of the body around them, or else bodies given inside out.
  TopoDS_Shape assembled() {
    std::vector<TopoDS_Shape> shapes;
    std::vector<std::optional<TopoDS_Solid>> solids(parts_.size());
    const auto addBody = [&](std::size_t c, const TopoDS_Shape& shell) {
      builder_.MakeSolid(solids[c].emplace());
      builder_.Add(*solids[c], shell);
    };
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      if (!parts_[c].closed) shapes.push_back(parts_[c].shell);
      if (parts_[c].closed && parts_[c].volume > 0) addBody(c, parts_[c].shell);
    }
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      if (!parts_[c].closed || parts_[c].volume > 0) continue;
      if (const auto body = bodyAround(parts_[c])) {
        builder_.Add(*solids[*body], parts_[c].shell);
      } else {
        addBody(c, parts_[c].shell.Reversed());
      }
    }
    for (const auto& solid : solids)
      if (solid) shapes.push_back(*solid);
    return compoundOf(shapes);
  }

  const Mesh& mesh_;
  MeshTopology topology_;
  std::pair<Mesh, std::vector<int>> triangles_;  ///< and the face each came from
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;
  std::vector<Part> parts_;
};

}  // namespace

TopoDS_Shape toShape(const Mesh& mesh) {
  if (mesh.faceCount() == 0) throw Error(ErrorCode::InvalidInput, "The mesh has no faces.");
  const Mesh clean = prepared(mesh);
  return ShapeBuilder(clean).build();
}

}  // namespace blossom
