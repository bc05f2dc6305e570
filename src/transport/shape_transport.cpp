#include "transport/shape_transport.h"

#include "core/error.h"
#include "transport/brep_transport.h"
#include "transport/mesh_transport.h"
#include "transport/numbers.h"
#include "transport/path_transport.h"
#include "transport/planar_transport.h"
#include "transport/spline_transport.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

Value saveShapes(const std::vector<Shape>& shapes, const fs::path& folder, const std::string& name) {
  Value all = Value::array();
  for (std::size_t i = 0; i < shapes.size(); ++i)
    all.push_back(saveShape(shapes[i], folder, name + "-" + std::to_string(i)));
  return all;
}

std::vector<Shape> loadShapes(const Value& all, const fs::path& folder) {
  std::vector<Shape> shapes;
  for (const Value& each : all) shapes.push_back(loadShape(each, folder));
  return shapes;
}

Value saveSequence(const Sequence& sequence, const fs::path& folder, const std::string& name) {
  return {{"frames", saveShapes(sequence.frames, folder, name)}, {"times", sequence.times}};
}

Sequence loadSequence(const Value& value, const fs::path& folder) {
  return {loadShapes(value.at("frames"), folder), value.at("times").get<std::vector<double>>()};
}

Value saveSetup(const Setup& setup, const fs::path& folder, const std::string& name) {
  Value clamps = Value::array();
  for (const Bounds& clamp : setup.clamps) clamps.push_back(boundsValue(clamp));
  return {{"part", saveShapes(setup.part, folder, name + "-part")},
          {"stock", saveShapes(setup.stock, folder, name + "-stock")},
          {"clamps", std::move(clamps)},
          {"travel", boundsValue(setup.travel)},
          {"drawing", locationValue(setup.drawing)}};
}

Setup loadSetup(const Value& v, const fs::path& folder) {
  Setup setup;
  setup.part = loadShapes(v.at("part"), folder);
  setup.stock = loadShapes(v.at("stock"), folder);
  for (const Value& clamp : v.at("clamps")) setup.clamps.push_back(toBounds(clamp));
  setup.travel = toBounds(v.at("travel"));
  setup.drawing = toLocation(v.at("drawing"));
  return setup;
}

Value curvesValue(const Curves& curves) {
  return {{"even_odd", curves.fillRule == FillRule::EvenOdd}, {"paths", pathsValue(curves.paths)}};
}

Curves toCurves(const Value& v) {
  return {toPaths(v.at("paths")), v.at("even_odd").get<bool>() ? FillRule::EvenOdd : FillRule::NonZero};
}

}  // namespace

// The one key of the object tells the kind.
Value saveShape(const Shape& shape, const fs::path& folder, const std::string& name) {
  if (const auto* region = shape.get<Region>()) return {{"region", pathsValue(region->loops)}};
  if (const auto* curves = shape.get<Curves>()) return {{"curves", curvesValue(*curves)}};
  if (const auto* curve = shape.get<Curve>()) return {{"curve", curveValue(*curve)}};
  if (const auto* surface = shape.get<Surface>()) return {{"surface", surfaceValue(*surface)}};
  if (const auto* motion = shape.get<Motion>()) return {{"motion", motionValue(*motion)}};
  if (const auto* sequence = shape.get<Sequence>()) return {{"sequence", saveSequence(*sequence, folder, name)}};
  if (const auto* mesh = shape.get<Mesh>()) return {{"mesh", saveMesh(*mesh, folder, name)}};
  if (const auto* brep = shape.get<Brep>()) return {{"brep", saveBrep(*brep, folder, name)}};
  if (const auto* axis = shape.get<MedialAxis>()) return {{"medial_axis", saveMedialAxis(*axis, folder, name)}};
  if (const auto* path = shape.get<Toolpath>(); path && !path->gougeOf)
    return {{"toolpath", saveToolpath(*path, folder, name)}};
  if (const auto* setup = shape.get<Setup>()) return {{"setup", saveSetup(*setup, folder, name)}};
  throw Error(ErrorCode::InvalidInput, "A " + std::string(shapeKindName(shape.kind())) + " cannot be used here.");
}

Shape loadShape(const Value& value, const fs::path& folder) {
  const auto entry = value.begin();
  const std::string& kind = entry.key();
  const Value& v = entry.value();
  if (kind == "region") return Region{toPaths(v)};
  if (kind == "curves") return toCurves(v);
  if (kind == "curve") return toCurve(v);
  if (kind == "surface") return toSurface(v);
  if (kind == "motion") return toMotion(v);
  if (kind == "sequence") return loadSequence(v, folder);
  if (kind == "mesh") return loadMesh(v, folder);
  if (kind == "medial_axis") return loadMedialAxis(v, folder);
  if (kind == "toolpath") return loadToolpath(v, folder);
  if (kind == "setup") return loadSetup(v, folder);
  return loadBrep(v, folder);
}

}  // namespace blossom
