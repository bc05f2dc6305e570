// Parts of any shape as OCCT shapes or triangles.
#include <fmt/format.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <Eigen/Geometry>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include "core/error.h"
#include "geometry/measure/part_form.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"

namespace blossom {

namespace {

[[noreturn]] void notAmong(const std::string& one, const std::string& many, std::size_t count, int index) {
  throw Error(ErrorCode::NotFound, fmt::format("The shape has {} {}; {} {} is not among them.", count, many, one, index),
              fmt::format("Pick the {} again: the shape may have changed. They are counted from 0.", one));
}

[[noreturn]] void cannot(const std::string& what) {
  throw Error(ErrorCode::InvalidInput, "Nothing can be measured of " + what + ".", "Pick a face, an edge or a point.");
}

TopoDS_Shape vertexAt(const Vec3& p) { return BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Vertex(); }

const Segment& segmentOf(const std::vector<Path>& paths, int index, const char* one, const char* many) {
  std::size_t count = 0;
  for (const Path& path : paths) {
    if (index >= 0 && static_cast<std::size_t>(index) < count + path.segments.size())
      return path.segments[static_cast<std::size_t>(index) - count];
    count += path.segments.size();
  }
  notAmong(one, many, count, index);
}

TopoDS_Shape edgeAlong(const Segment& segment) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(toWires({{Path{{segment}, false, {}, {}}}, FillRule::EvenOdd}), TopAbs_EDGE, edges);
  return edges(1);
}

TopoDS_Shape planarPart(const std::vector<Path>& paths, SubShapeKind kind, int index) {
  if (kind == SubShapeKind::Edge) return edgeAlong(segmentOf(paths, index, "edge", "edges"));
  const Vec2 start = startPoint(segmentOf(paths, index, "vertex", "vertices"));
  return vertexAt({start.x(), start.y(), 0});
}

std::vector<Triangle3> trianglesOfFace(const Mesh& mesh, int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= mesh.faceCount()) notAmong("face", "faces", mesh.faceCount(), index);
  const std::vector<Vec3> points = facePoints(mesh, static_cast<std::size_t>(index));
  std::vector<Triangle3> result;
  for (const auto& t : triangulate(points)) {
    const auto at = [&](int i) { return points[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
    result.push_back({at(0), at(1), at(2)});
  }
  return result;
}

PartForm formOfFace(const Mesh& mesh, int index) {
  const std::vector<Vec3> points = facePoints(mesh, static_cast<std::size_t>(index));
  const Vec3 normal = vectorArea(points);
  PartForm form;
  if (normal.norm() == 0) return form;
  form.origin = points.front();
  form.direction = normal.normalized();
  double size = 0, off = 0;
  for (const Vec3& p : points) {
    size = std::max(size, (p - form.origin).norm());
    off = std::max(off, std::abs((p - form.origin).dot(form.direction)));
  }
  if (off <= 1e-6 * size) form.kind = PartForm::Kind::Plane;
  return form;
}

std::vector<Triangle3> allTriangles(const Mesh& mesh) {
  std::vector<Triangle3> result;
  const Mesh triangles = triangulated(mesh).first;
  result.reserve(triangles.faceCount());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const std::vector<Vec3> p = facePoints(triangles, f);
    result.push_back({p[0], p[1], p[2]});
  }
  if (result.empty()) cannot("a mesh without faces");
  return result;
}

struct PartVisitor {
  SubShapeKind kind;
  int index;

  PartGeometry exact(const TopoDS_Shape& shape) const { return {shape, {}, formOf(shape)}; }

  PartGeometry operator()(std::monostate) const { cannot("a shape that is not there"); }
  PartGeometry operator()(const Motion&) const { cannot("a motion"); }
  PartGeometry operator()(const Sequence&) const { cannot("a sequence"); }
  PartGeometry operator()(const Brep& brep) const {
    switch (kind) {
      case SubShapeKind::Face:
        return exact(faceOf(brep, index));
      case SubShapeKind::Edge:
        return exact(edgeOf(brep, index));
      case SubShapeKind::Vertex:
        return exact(vertexOf(brep, index));
      case SubShapeKind::Whole:
        break;
    }
    return {brep.shape(), {}, {}};
  }
  PartGeometry operator()(const Surface& surface) const { return (*this)(Brep(toFace(surface))); }
  PartGeometry operator()(const Curve& curve) const {
    const Brep brep(BRepBuilderAPI_MakeEdge(toOcct(curve)).Edge());
    return kind == SubShapeKind::Whole ? exact(edgeOf(brep, 0)) : (*this)(brep);
  }
  PartGeometry operator()(const Region& region) const {
    if (kind == SubShapeKind::Edge || kind == SubShapeKind::Vertex) return exact(planarPart(region.loops, kind, index));
    if (kind == SubShapeKind::Face && index != 0) notAmong("face", "faces", 1, index);
    PartGeometry whole{toFaces(region), {}, {}};
    whole.form.kind = PartForm::Kind::Plane;
    return whole;
  }
  PartGeometry operator()(const Curves& curves) const {
    if (kind == SubShapeKind::Edge || kind == SubShapeKind::Vertex) return exact(planarPart(curves.paths, kind, index));
    if (kind == SubShapeKind::Face) notAmong("face", "faces", 0, index);
    return {toWires(curves), {}, {}};
  }
  PartGeometry operator()(const MedialAxis& axis) const { return (*this)(drawingOf(axis)); }
  PartGeometry operator()(const Toolpath&) const { cannot("a toolpath"); }
  PartGeometry operator()(const Setup&) const { cannot("a setup"); }
  PartGeometry operator()(const Mesh& mesh) const {
    switch (kind) {
      case SubShapeKind::Face: {
        std::vector<Triangle3> triangles = trianglesOfFace(mesh, index);
        return {{}, std::move(triangles), formOfFace(mesh, index)};
      }
      case SubShapeKind::Vertex: {
        if (index < 0 || static_cast<std::size_t>(index) >= mesh.points.size())
          notAmong("vertex", "vertices", mesh.points.size(), index);
        return exact(vertexAt(mesh.points[static_cast<std::size_t>(index)]));
      }
      case SubShapeKind::Edge:
        cannot("an edge of a mesh, for its edges have no numbers");
      case SubShapeKind::Whole:
        break;
    }
    return {{}, allTriangles(mesh), {}, meshTopology(mesh).closed()};
  }
};

}  // namespace

PartGeometry geometryOf(const MeasuredPart& part) { return part.shape.visit(PartVisitor{part.kind, part.index}); }

}  // namespace blossom
