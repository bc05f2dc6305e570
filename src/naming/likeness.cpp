#include "naming/likeness.h"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>

#include "core/error.h"
#include "geometry/occt/occt_vector.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"

namespace blossom {

namespace {

constexpr std::array surfaceForms{"plane",   "cylinder",   "cone",      "sphere", "torus", "bezier",
                                  "bspline", "revolution", "extrusion", "offset", "other"};
constexpr std::array curveForms{"line",   "circle",  "ellipse", "hyperbola", "parabola",
                                "bezier", "bspline", "offset",  "other"};

template <std::size_t N>
std::string formName(const std::array<const char*, N>& names, int type) {
  return names.at(std::min(static_cast<std::size_t>(type), N - 1));
}

std::string formOf(const TopoDS_Face& face) { return formName(surfaceForms, BRepAdaptor_Surface(face, false).GetType()); }

std::string formOf(const TopoDS_Edge& edge) {
  return BRep_Tool::Degenerated(edge) ? "point" : formName(curveForms, BRepAdaptor_Curve(edge).GetType());
}

Likeness likeness(const TopoDS_Face& face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties, 1e-6);
  return {formOf(face), toVec(properties.CentreOfMass()), properties.Mass()};
}

Likeness likeness(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return {formOf(edge), toVec(BRep_Tool::Pnt(TopExp::FirstVertex(edge))), 0};
  const BRepAdaptor_Curve curve(edge);
  return {formOf(edge), toVec(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2)),
          GCPnts_AbscissaPoint::Length(curve)};
}

Likeness likeness(const TopoDS_Vertex& vertex) { return {"point", toVec(BRep_Tool::Pnt(vertex)), 0}; }

Likeness likeness(const TopoDS_Shape& part) {
  switch (part.ShapeType()) {
    case TopAbs_FACE:
      return likeness(TopoDS::Face(part));
    case TopAbs_EDGE:
      return likeness(TopoDS::Edge(part));
    default:
      return likeness(TopoDS::Vertex(part));
  }
}

std::vector<TopoDS_Shape> partsOf(const Brep& brep, SubShapeKind kind) {
  return subShapesOf(brep.shape(), shapeTypeOf(kind));
}

Vec3 lifted(const Vec2& p) { return {p.x(), p.y(), 0}; }

constexpr std::array segmentForms{"line", "circle", "bspline"};

Likeness likeness(const Segment& segment, SubShapeKind kind) {
  if (kind == SubShapeKind::Vertex) return {"point", lifted(startPoint(segment)), 0};
  return {segmentForms.at(segment.index()), lifted((startPoint(segment) + endPoint(segment)) / 2), length(segment)};
}

std::vector<Likeness> ofPaths(const std::vector<Path>& paths, SubShapeKind kind) {
  std::vector<Likeness> all;
  for (const Path& path : paths)
    for (const Segment& segment : path.segments) all.push_back(likeness(segment, kind));
  return all;
}

std::vector<Likeness> ofRegion(const Region& region, SubShapeKind kind) {
  if (kind != SubShapeKind::Face) return ofPaths(region.loops, kind);
  return {{"plane", Vec3::Zero(), area(region)}};
}

std::vector<Likeness> ofMesh(const Mesh& mesh, SubShapeKind kind) {
  std::vector<Likeness> all;
  if (kind == SubShapeKind::Vertex)
    for (const Vec3& point : mesh.points) all.push_back({"point", point, 0});
  if (kind != SubShapeKind::Face) return all;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto corners = mesh.face(f);
    Likeness face{"polygon", Vec3::Zero(), static_cast<double>(corners.size())};
    for (const auto corner : corners) face.place += mesh.points[static_cast<std::size_t>(corner)];
    face.place /= static_cast<double>(std::max<std::size_t>(1, corners.size()));
    all.push_back(std::move(face));
  }
  return all;
}

/// FNV-1a: the same on every machine, since documents hold it.
class Digest {
 public:
  void add(std::string_view text) {
    for (const char c : text) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  void add(std::size_t number) { add(std::to_string(number) + ","); }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

void addPaths(Digest& digest, const std::vector<Path>& paths) {
  for (const Path& path : paths) {
    digest.add(path.closed ? "closed" : "open");
    for (const Segment& segment : path.segments) digest.add(segment.index());
  }
}

void addBrep(Digest& digest, const Brep& brep) {
  TopTools_IndexedMapOfShape edges;
  if (!brep.shape().IsNull()) TopExp::MapShapes(brep.shape(), TopAbs_EDGE, edges);
  for (const TopoDS_Shape& face : partsOf(brep, SubShapeKind::Face)) {
    digest.add(formOf(TopoDS::Face(face)));
    for (const TopoDS_Shape& edge : subShapesOf(face, TopAbs_EDGE))
      digest.add(static_cast<std::size_t>(edges.FindIndex(edge)));
  }
  for (const TopoDS_Shape& edge : partsOf(brep, SubShapeKind::Edge)) digest.add(formOf(TopoDS::Edge(edge)));
  digest.add(partsOf(brep, SubShapeKind::Vertex).size());
}

}  // namespace

bool Likeness::isLike(const Likeness& other, double tolerance) const {
  const double reach = std::max(1.0, std::max(size, other.size));  // sizes are integrals: their error grows with them
  return form == other.form && (place - other.place).norm() <= tolerance && std::abs(size - other.size) <= tolerance * reach;
}

std::vector<Likeness> likenesses(const Shape& shape, SubShapeKind kind) {
  if (kind == SubShapeKind::Whole) return {};
  if (const auto* region = shape.get<Region>()) return ofRegion(*region, kind);
  if (const auto* curves = shape.get<Curves>())
    return kind == SubShapeKind::Face ? std::vector<Likeness>() : ofPaths(curves->paths, kind);
  if (const auto* mesh = shape.get<Mesh>()) return ofMesh(*mesh, kind);
  std::vector<Likeness> all;
  if (const auto* brep = shape.get<Brep>())
    for (const TopoDS_Shape& part : partsOf(*brep, kind)) all.push_back(likeness(part));
  return all;
}

Likeness likenessOf(const Shape& shape, SubShapeKind kind, int index) {
  if (const auto* brep = shape.get<Brep>()) {
    if (kind == SubShapeKind::Face) return likeness(faceOf(*brep, index));
    return kind == SubShapeKind::Edge ? likeness(edgeOf(*brep, index)) : likeness(vertexOf(*brep, index));
  }
  const std::vector<Likeness> all = likenesses(shape, kind);
  if (index < 0 || static_cast<std::size_t>(index) >= all.size())
    throw Error(ErrorCode::NotFound, fmt::format("The shape has no {} {}.", subShapeKindName(kind), index));
  return all[static_cast<std::size_t>(index)];
}

std::string structureOf(const Shape& shape) {
  Digest digest;
  digest.add(shapeKindName(shape.kind()));
  if (const auto* region = shape.get<Region>()) addPaths(digest, region->loops);
  if (const auto* curves = shape.get<Curves>()) addPaths(digest, curves->paths);
  if (const auto* brep = shape.get<Brep>()) addBrep(digest, *brep);
  if (const auto* mesh = shape.get<Mesh>()) {
    digest.add(mesh->points.size());
    for (std::size_t f = 0; f < mesh->faceCount(); ++f)
      for (const auto corner : mesh->face(f)) digest.add(static_cast<std::size_t>(corner));
  }
  return digest.text();
}

double samePlace(const Shape& shape) {
  const Bounds all = bounds(shape);
  return 1e-6 * std::max(1e-3, all.diagonal());
}

Value toJson(const Likeness& l) {
  return {{"form", l.form}, {"place", {l.place.x(), l.place.y(), l.place.z()}}, {"size", l.size}};
}

Likeness likenessFrom(const Value& json) {
  const Value& place = json.at("place");
  return {json.at("form").get<std::string>(),
          {place.at(0).get<double>(), place.at(1).get<double>(), place.at(2).get<double>()},
          json.at("size").get<double>()};
}

}  // namespace blossom
