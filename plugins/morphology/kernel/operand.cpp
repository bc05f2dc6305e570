#include "kernel/operand.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/planar/outline_crossing.h"
#include "geometry/planar/planar.h"
#include "geometry/tessellate/tessellate.h"
#include "kernel/solid_check.h"

namespace blossom::morphology {

namespace {

constexpr double widestTurn = 0.8;  // radians between facets of a round that is smaller than the deviation

Bounds boundsOf(const std::vector<Vec3>& points) {
  Bounds bounds;
  for (const Vec3& p : points) bounds.add(p);
  return bounds;
}

/// All points within rounding of one plane.
bool isFlat(const Mesh& mesh) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const Vec3 here = vectorArea(facePoints(mesh, f));
    if (here.squaredNorm() > normal.squaredNorm()) normal = here;
  }
  if (!(normal.squaredNorm() > 0)) return true;
  normal.normalize();
  const Bounds bounds = boundsOf(mesh.points);
  const double slack = 1e-9 * bounds.diagonal();
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [&](const Vec3& p) { return std::abs((p - mesh.points.front()).dot(normal)) <= slack; });
}

void addSegments(const std::vector<Vec3>& line, Operand& out) {
  for (std::size_t k = 0; k + 1 < line.size(); ++k) out.pieces.push_back({line[k], line[k + 1]});
}

/// @param isSheet an open mesh is a surface, not a solid with a hole in its skin
Operand fromMesh(Mesh mesh, bool isSheet, Operand out) {
  if (mesh.faceCount() == 0) {
    out.form = Operand::Form::Points;
    for (const Vec3& p : mesh.points) out.pieces.push_back({p});
    return out;
  }
  refuseUnusable(mesh, {out.name});
  if (!meshTopology(mesh).closed() && (isSheet || isFlat(mesh))) {
    out.form = Operand::Form::Sheet;
    const Mesh triangles = triangulated(mesh).first;
    for (std::size_t f = 0; f < triangles.faceCount(); ++f) out.pieces.push_back(facePoints(triangles, f));
    return out;
  }
  out.mesh = std::move(mesh);
  return out;
}

Operand fromTessellation(const Tessellation& made, bool isSheet, Operand out) {
  if (!made.triangles.empty()) return fromMesh(toMesh(made), isSheet, std::move(out));
  if (!made.edges.empty()) {
    out.form = Operand::Form::Lines;
    for (const auto& line : made.edges) addSegments(line, out);
    return out;
  }
  out.form = Operand::Form::Points;
  for (const Vec3& p : made.markers) out.pieces.push_back({p});
  return out;
}

bool isSheet(const Shape& shape) {
  const Brep* brep = shape.get<Brep>();
  return shape.kind() == ShapeKind::Surface || (brep && subShapesOf(brep->shape(), TopAbs_SOLID).empty());
}

/// A drawing of closed outlines is the area they enclose.
bool isOutline(const Curves& drawing) {
  return !drawing.paths.empty() &&
         std::all_of(drawing.paths.begin(), drawing.paths.end(), [](const Path& path) { return path.closed; });
}

Region enclosed(const Curves& drawing, const std::string& name, const Progress& progress) {
  Region region = toRegion(drawing);
  if (const auto place = misfilledCrossing(drawing, region, progress))
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("{} has outlines that cross near ({:.6g}, {:.6g}), and its fill rule leaves empty what they have "
                    "in common.",
                    name, place->x() + 0.0, place->y() + 0.0),
        "Move them apart, trim what crosses, or unite them first.");
  return region;
}

void refuseUnusable(const Operand& operand, bool solidOnly) {
  for (const auto& piece : operand.pieces)
    for (const Vec3& p : piece)
      if (!p.allFinite() || p.cwiseAbs().maxCoeff() > 1e9)
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("{} has coordinates that are not numbers, or beyond 1e9 mm.", operand.name),
                    "Export it again.");
  if (operand.form == Operand::Form::Body) return;
  if (operand.pieces.empty() || (solidOnly && operand.form == Operand::Form::Points))
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is empty: it has no faces.", operand.name),
                "Choose a solid or a closed mesh.");
  if (solidOnly)
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is not a solid: it has no volume.", operand.name),
                "Extrude it first, or choose a solid or a closed mesh.");
}

}  // namespace

Bounds Operand::bounds() const {
  if (form == Form::Body) return boundsOf(mesh.points);
  Bounds bounds;
  for (const auto& piece : pieces) bounds.add(boundsOf(piece));
  return bounds;
}

Operand operandOf(const Shape& shape, const OperandOptions& options, const Progress& progress) {
  const Curves* drawing = shape.get<Curves>();
  if (drawing && isOutline(*drawing)) return operandOf(enclosed(*drawing, options.name, progress), options, progress);
  Operand out;
  out.name = options.name;
  if (const Mesh* mesh = shape.get<Mesh>())
    out = fromMesh(*mesh, false, std::move(out));
  else
    out = fromTessellation(tessellate(shape, {.chord = options.deviation, .angle = widestTurn}, progress), isSheet(shape),
                           std::move(out));
  refuseUnusable(out, options.solidOnly);
  return out;
}

}  // namespace blossom::morphology
