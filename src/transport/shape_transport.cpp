#include "transport/shape_transport.h"

#include "core/error.h"
#include "transport/brep_transport.h"
#include "transport/mesh_transport.h"
#include "transport/path_transport.h"
#include "transport/planar_transport.h"
#include "transport/spline_transport.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

Value saveSequence(const Sequence& sequence, const fs::path& folder, const std::string& name) {
  Value frames = Value::array();
  for (std::size_t k = 0; k < sequence.frames.size(); ++k)
    frames.push_back(saveShape(sequence.frames[k], folder, name + "-" + std::to_string(k)));
  return {{"frames", std::move(frames)}, {"times", sequence.times}};
}

Sequence loadSequence(const Value& value, const fs::path& folder) {
  Sequence sequence;
  for (const Value& frame : value.at("frames")) sequence.frames.push_back(loadShape(frame, folder));
  sequence.times = value.at("times").get<std::vector<double>>();
  return sequence;
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
  return loadBrep(v, folder);
}

}  // namespace blossom
