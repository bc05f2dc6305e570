#include "kernel/solid/arrange.h"

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <Geom_BSplineCurve.hxx>
#include <algorithm>

#include "core/error.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "kernel/parts/boolean.h"
#include "kernel/parts/guarded.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

using Map = Eigen::Affine3d;

enum class MapKind { Rigid, Similar, Any };

MapKind kindOf(const Map& map) {
  const Eigen::Matrix3d gram = map.linear().transpose() * map.linear();
  const double square = gram.trace() / 3;
  if (!gram.isApprox(square * Eigen::Matrix3d::Identity(), 1e-12)) return MapKind::Any;
  return std::abs(square - 1) < 1e-12 && map.linear().determinant() > 0 ? MapKind::Rigid : MapKind::Similar;
}

template <class Trsf>
Trsf toTrsf(const Map& map) {
  Trsf trsf;
  const auto& m = map.matrix();
  if constexpr (std::is_same_v<Trsf, gp_Trsf>) {
    trsf.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0), m(2, 1), m(2, 2),
                   m(2, 3));
  } else {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) trsf.SetValue(row + 1, column + 1, m(row, column));
  }
  return trsf;
}

/// Maps shapes and remembers what became of their parts.
class ShapeMapper {
 public:
  explicit ShapeMapper(const Map& map) : similar_(kindOf(map) != MapKind::Any) {
    if (similar_)
      trsf_ = toTrsf<gp_Trsf>(map);
    else
      general_ = toTrsf<gp_GTrsf>(map);
  }

  /// `location` is applied first.
  std::shared_ptr<const BrepPart> operator()(const BrepPart& part, const gp_Trsf& location) const {
    auto made = std::make_shared<BrepPart>(part);
    if (similar_) {
      BRepBuilderAPI_Transform maker(part.shape, trsf_ * location, Standard_True);
      fill(*made, part, maker);
    } else {
      BRepBuilderAPI_GTransform maker(part.shape, general_ * gp_GTrsf(location), Standard_True);
      fill(*made, part, maker);
    }
    return made;
  }

 private:
  template <class Maker>
  static void fill(BrepPart& made, const BrepPart& part, Maker& maker) {
    made.shape = maker.Shape();
    for (std::size_t i = 0; i < part.subShapeColors.size(); ++i)
      made.subShapeColors[i].first = maker.ModifiedShape(part.subShapeColors[i].first);
  }

  bool similar_;
  gp_Trsf trsf_;
  gp_GTrsf general_;
};

/// The leaves of an assembly in place, mapped: names and colours go down, the tree is lost.
void mapLeaves(const BrepInstance& instance, const gp_Trsf& parent, const ShapeMapper& mapper,
               std::vector<BrepInstance>& leaves) {
  if (!instance.part) return;
  const gp_Trsf location = parent * instance.location;
  if (!instance.part->shape.IsNull())
    leaves.push_back({instance.name, instance.color, gp_Trsf(), mapper(*instance.part, location)});
  for (const BrepInstance& child : instance.part->children) mapLeaves(child, location, mapper, leaves);
}

class Transformer {
 public:
  explicit Transformer(const Map& map) : map_(map) {}

  Shape operator()(const Region& region) const {
    if (!staysFlat()) return (*this)(Brep(toFaces(region)));
    return Region{paths(region.loops, true)};
  }
  Shape operator()(const Curves& curves) const {
    if (!staysFlat()) return (*this)(Brep(toWires(curves)));
    return Curves{paths(curves.paths, false), curves.fillRule};
  }
  Shape operator()(Curve curve) const {
    mapPoles(curve.poles);
    return curve;
  }
  Shape operator()(Surface surface) const {
    mapPoles(surface.poles);
    return surface;
  }
  Shape operator()(const Brep& brep) const {
    if (kindOf(map_) == MapKind::Rigid) {
      std::vector<BrepInstance> roots = brep.roots();
      for (BrepInstance& root : roots) root.location = toTrsf<gp_Trsf>(map_) * root.location;
      return Brep(std::move(roots));
    }
    std::vector<BrepInstance> leaves;
    const ShapeMapper mapper(map_);
    for (const BrepInstance& root : brep.roots()) mapLeaves(root, gp_Trsf(), mapper, leaves);
    return Brep(std::move(leaves));
  }
  Shape operator()(Mesh mesh) const {
    for (Vec3& point : mesh.points) point = map_ * point;
    if (reflects())
      for (std::size_t f = 0; f < mesh.faceCount(); ++f)
        std::reverse(mesh.faceVertices.begin() + mesh.faceStarts[f], mesh.faceVertices.begin() + mesh.faceStarts[f + 1]);
    return mesh;
  }
  Shape operator()(Sequence sequence) const {
    for (Shape& frame : sequence.frames) frame = transformed(frame, map_);
    return sequence;
  }
  Shape operator()(const MedialAxis& axis) const { return (*this)(drawingOf(axis)); }
  Shape operator()(const Toolpath&) const {
    throw Error(ErrorCode::InvalidInput, "A toolpath cannot be transformed.",
                "Transform the part, or move the work's zero.");
  }
  Shape operator()(const Setup&) const {
    throw Error(ErrorCode::InvalidInput, "A setup cannot be transformed.", "Transform the part, or move the work's zero.");
  }
  Shape operator()(const Motion&) const {
    throw Error(ErrorCode::InvalidInput, "A motion cannot be transformed.", "Transform the surface that it sweeps.");
  }
  Shape operator()(std::monostate) const { throw Error(ErrorCode::InvalidInput, "The input is empty."); }

 private:
  [[nodiscard]] bool reflects() const { return map_.linear().determinant() < 0; }

  [[nodiscard]] bool staysFlat() const {
    const auto& m = map_.matrix();
    const double size = map_.linear().norm();
    return std::abs(m(2, 0)) < 1e-12 * size && std::abs(m(2, 1)) < 1e-12 * size && std::abs(m(2, 3)) < 1e-9;
  }

  /// `oriented` loops run on the same way round their area after a reflection.
  [[nodiscard]] std::vector<Path> paths(const std::vector<Path>& given, bool oriented) const {
    Eigen::Matrix<double, 2, 3> flat;
    flat << map_.matrix().block<2, 2>(0, 0), map_.matrix().block<2, 1>(0, 3);
    const bool turn = oriented && flat.block<2, 2>(0, 0).determinant() < 0;
    std::vector<Path> mapped;
    mapped.reserve(given.size());
    for (const Path& path : given) {
      const Path image = blossom::transformed(path, flat);
      mapped.push_back(turn ? reversed(image) : image);
    }
    return mapped;
  }

  void mapPoles(std::vector<Vec4>& poles) const {
    for (Vec4& pole : poles) pole.head<3>() = map_.linear() * pole.head<3>() + map_.translation() * pole.w();
  }

  const Map& map_;
};

template <class T>
bool allAre(const std::vector<Shape>& shapes) {
  return std::all_of(shapes.begin(), shapes.end(), [](const Shape& each) { return each.get<T>() != nullptr; });
}

bool boxesMeet(const Bounds& a, const Bounds& b) {
  return (a.low.array() <= b.high.array() + 1e-6).all() && (b.low.array() <= a.high.array() + 1e-6).all();
}

bool anyBoxesMeet(const std::vector<Shape>& shapes) {
  std::vector<Bounds> boxes;
  boxes.reserve(shapes.size());
  for (const Shape& each : shapes) {
    const Bounds box = bounds(each);
    if (std::any_of(boxes.begin(), boxes.end(), [&](const Bounds& other) { return boxesMeet(box, other); })) return true;
    boxes.push_back(box);
  }
  return false;
}

Shape gatheredRegions(const std::vector<Shape>& shapes) {
  std::vector<Region> regions;
  regions.reserve(shapes.size());
  for (const Shape& each : shapes) regions.push_back(*each.get<Region>());
  if (anyBoxesMeet(shapes)) {
    if (auto all = combined(regions, BooleanOperation::Union)) return *std::move(all);
    std::vector<TopoDS_Shape> faces;
    faces.reserve(regions.size());
    for (const Region& each : regions) faces.push_back(toFaces(each));
    return asRegion(combine(faces, {}).shape);
  }
  Region all;
  for (Region& each : regions) std::move(each.loops.begin(), each.loops.end(), std::back_inserter(all.loops));
  return all;
}

Shape gatheredCurves(const std::vector<Shape>& shapes) {
  Curves all = *shapes.front().get<Curves>();
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    const auto& paths = shapes[i].get<Curves>()->paths;
    all.paths.insert(all.paths.end(), paths.begin(), paths.end());
  }
  return all;
}

void append(Mesh& all, const Mesh& mesh) {
  const int first = static_cast<int>(all.points.size());
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  std::vector<int> face;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    face.assign(mesh.face(f).begin(), mesh.face(f).end());
    for (int& vertex : face) vertex += first;
    all.addFace(face);
  }
  for (const Crease& c : mesh.creases) all.creases.push_back({c.from + first, c.to + first, c.sharpness});
  for (const Corner& c : mesh.corners) all.corners.push_back({c.vertex + first, c.sharpness});
}

Shape gatheredMeshes(const std::vector<Shape>& shapes) {
  Mesh all = *shapes.front().get<Mesh>();
  for (std::size_t i = 1; i < shapes.size(); ++i) append(all, *shapes[i].get<Mesh>());
  return all;
}

}  // namespace

Shape transformed(const Shape& shape, const Map& map) {
  const double size = map.linear().norm();
  if (!map.matrix().allFinite() || std::abs(map.linear().determinant()) < 1e-12 * size * size * size)
    throw Error(ErrorCode::Degenerate, "The transformation flattens the shape.", "Scale by numbers other than 0.");
  return guarded("The shape cannot be transformed.", "", [&] { return shape.visit(Transformer(map)); });
}

Shape gathered(const std::vector<Shape>& shapes) {
  if (shapes.empty()) throw Error(ErrorCode::InvalidInput, "There is nothing to put together.");
  if (shapes.size() == 1) return shapes.front();
  if (allAre<Region>(shapes)) return gatheredRegions(shapes);
  if (allAre<Curves>(shapes)) return gatheredCurves(shapes);
  if (allAre<Mesh>(shapes)) return gatheredMeshes(shapes);
  std::vector<BrepInstance> roots;
  for (const Shape& each : shapes) {
    const Brep brep = asBrep(each);
    roots.insert(roots.end(), brep.roots().begin(), brep.roots().end());
  }
  return Brep(std::move(roots));
}

Brep asBrep(const Shape& shape) {
  if (const auto* brep = shape.get<Brep>()) return *brep;
  if (const auto* region = shape.get<Region>()) return Brep(toFaces(*region));
  if (const auto* curves = shape.get<Curves>()) return Brep(toWires(*curves));
  if (const auto* curve = shape.get<Curve>())
    return Brep(BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(toOcct(*curve))).Shape());
  if (const auto* surface = shape.get<Surface>()) return Brep(toFace(*surface));
  throw Error(ErrorCode::InvalidInput, "A " + std::string(shapeKindName(shape.kind())) + " cannot be used here.");
}

Region asRegion(const TopoDS_Shape& faces) { return toRegion(planarCurves(faces)); }

}  // namespace blossom::modeling
