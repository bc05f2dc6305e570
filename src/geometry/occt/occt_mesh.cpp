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
    Box3 box;
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
      part.box.extend(boxOf(part.triangles.back()));
    }
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      Part& part = parts_[static_cast<std::size_t>(topology_.componentOfFace[f])];
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

  /// Closed shells from the largest to the smallest.
  std::vector<std::size_t> closedBySize() const {
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < parts_.size(); ++c)
      if (parts_[c].closed) order.push_back(c);
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return std::abs(parts_[a].volume) > std::abs(parts_[b].volume);
    });
    return order;
  }

  /// The smallest of the larger closed shells around a closed shell, if any; whichever way they look.
  std::optional<std::size_t> around(std::size_t inner, const std::vector<std::size_t>& larger) const {
    const auto [front, back] = pointsBesideLargest(parts_[inner].triangles);
    const Vec3& inside = parts_[inner].volume > 0 ? back : front;
    for (auto c = larger.rbegin(); c != larger.rend(); ++c)
      if (parts_[*c].box.contains(parts_[inner].box) && std::abs(windingNumber(parts_[*c].triangles, inside)) > 0.5)
        return *c;
    return std::nullopt;
  }

  /// Closed shells are solids or hollows of them. An outermost shell is a body, even when given inside out; a shell within
  /// another that looks the other way is a hollow of a body, or a body in a hollow.
  TopoDS_Shape assembled() {
    std::vector<TopoDS_Solid> solids(parts_.size());
    std::vector<std::optional<std::size_t>> solidOf(parts_.size());  // the shell whose solid a hollow belongs to
    std::vector<std::size_t> bodies, seen;
    for (const std::size_t c : closedBySize()) {
      const Part& part = parts_[c];
      const auto outer = around(c, seen);
      const bool looksAway = outer && (part.volume > 0) != (parts_[*outer].volume > 0);
      const bool isHollow = outer && looksAway != solidOf[*outer].has_value();
      if (isHollow) {
        solidOf[c] = solidOf[*outer].value_or(*outer);
      } else {
        builder_.MakeSolid(solids[c]);
        bodies.push_back(c);
      }
      const bool asIs = isHollow == (part.volume <= 0);
      builder_.Add(solids[solidOf[c].value_or(c)], asIs ? TopoDS_Shape(part.shell) : part.shell.Reversed());
      seen.push_back(c);
    }
    std::vector<TopoDS_Shape> shapes;
    for (const Part& part : parts_)
      if (!part.closed) shapes.push_back(part.shell);
    std::sort(bodies.begin(), bodies.end());
    for (const std::size_t c : bodies) shapes.push_back(solids[c]);
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
