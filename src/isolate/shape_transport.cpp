#include "isolate/shape_transport.h"

#include <BinTools.hxx>
#include <Standard_Failure.hxx>
#include <fstream>

#include "core/error.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

template <class Vector>
Value numbers(const Vector& v) {
  Value list = Value::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(v[i]);
  return list;
}

template <class Vector>
Vector vectorOf(const Value& list) {
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = list.at(static_cast<std::size_t>(i)).template get<double>();
  return v;
}

template <class Vector>
Value lists(const std::vector<Vector>& vectors) {
  Value all = Value::array();
  for (const Vector& each : vectors) all.push_back(numbers(each));
  return all;
}

template <class Vector>
std::vector<Vector> vectorsOf(const Value& all) {
  std::vector<Vector> vectors;
  vectors.reserve(all.size());
  for (const Value& each : all) vectors.push_back(vectorOf<Vector>(each));
  return vectors;
}

Value saved(const Line2& line) { return {{"line", {numbers(line.from), numbers(line.to)}}}; }
Value saved(const Arc2& arc) { return {{"arc", {numbers(arc.center), arc.radius, arc.start, arc.sweep}}}; }
Value saved(const Spline2& s) { return {{"spline", {s.degree, s.knots, lists(s.poles)}}}; }

Segment segmentOf(const Value& value) {
  const auto entry = value.begin();
  const std::string& kind = entry.key();
  const Value& v = entry.value();
  if (kind == "line") return Line2{vectorOf<Vec2>(v.at(0)), vectorOf<Vec2>(v.at(1))};
  if (kind == "arc") return Arc2{vectorOf<Vec2>(v.at(0)), v.at(1), v.at(2), v.at(3)};
  return Spline2{v.at(0), v.at(1).get<std::vector<double>>(), vectorsOf<Vec3>(v.at(2))};
}

Value saved(const std::vector<Path>& paths) {
  Value all = Value::array();
  for (const Path& path : paths) {
    Value segments = Value::array();
    for (const Segment& segment : path.segments)
      segments.push_back(std::visit([](const auto& s) { return saved(s); }, segment));
    all.push_back({{"closed", path.closed}, {"segments", std::move(segments)}});
  }
  return all;
}

std::vector<Path> pathsOf(const Value& all) {
  std::vector<Path> paths;
  paths.reserve(all.size());
  for (const Value& each : all) {
    Path path;
    path.closed = each.at("closed");
    for (const Value& segment : each.at("segments")) path.segments.push_back(segmentOf(segment));
    paths.push_back(std::move(path));
  }
  return paths;
}

void finish(std::ofstream& stream, const fs::path& file) {
  stream.close();
  if (!stream)
    throw Error(ErrorCode::FileUnwritable,
                "There is no room for temporary files in \"" + file.parent_path().string() + "\".", "Free some disk space.");
}

[[noreturn]] void unreadable() { throw Error(ErrorCode::Internal, "The shapes of a helper process cannot be read."); }

void writeBrep(const TopoDS_Shape& shape, const fs::path& file) {
  std::ofstream stream(file, std::ios::binary);
  try {
    BinTools::Write(shape, stream);
  } catch (const Standard_Failure&) {
    throw Error(ErrorCode::InvalidInput, "The shape cannot be handed over to a helper process.");
  }
  finish(stream, file);
}

TopoDS_Shape readBrep(const fs::path& file) {
  TopoDS_Shape shape;
  std::ifstream stream(file, std::ios::binary);
  try {
    BinTools::Read(shape, stream);
  } catch (const Standard_Failure&) {
    unreadable();
  }
  if (shape.IsNull()) unreadable();
  return shape;
}

template <class T>
void writeArray(std::ofstream& stream, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  stream.write(reinterpret_cast<const char*>(&count), sizeof count);
  stream.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T>
std::vector<T> readArray(std::ifstream& stream) {
  std::uint64_t count = 0;
  stream.read(reinterpret_cast<char*>(&count), sizeof count);
  if (!stream) unreadable();
  std::vector<T> values(count);
  stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  if (!stream) unreadable();
  return values;
}

/// Both sides are one build on one machine: numbers travel as they lie in memory.
void writeMesh(const Mesh& mesh, const fs::path& file) {
  std::ofstream stream(file, std::ios::binary);
  writeArray(stream, mesh.points);
  writeArray(stream, mesh.faceStarts);
  writeArray(stream, mesh.faceVertices);
  writeArray(stream, mesh.creases);
  writeArray(stream, mesh.corners);
  finish(stream, file);
}

Mesh readMesh(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Mesh mesh;
  mesh.points = readArray<Vec3>(stream);
  mesh.faceStarts = readArray<int>(stream);
  mesh.faceVertices = readArray<int>(stream);
  mesh.creases = readArray<Crease>(stream);
  mesh.corners = readArray<Corner>(stream);
  return mesh;
}

Value saved(const Surface& s) { return Value::array({s.degreeU, s.degreeV, s.knotsU, s.knotsV, lists(s.poles)}); }
Surface surfaceOf(const Value& v) {
  return {v.at(0), v.at(1), v.at(2).get<std::vector<double>>(), v.at(3).get<std::vector<double>>(),
          vectorsOf<Vec4>(v.at(4))};
}
Value saved(const Curve& c) { return Value::array({c.degree, c.knots, lists(c.poles)}); }
Curve curveOf(const Value& v) { return {v.at(0), v.at(1).get<std::vector<double>>(), vectorsOf<Vec4>(v.at(2))}; }

Value saved(const Motion& m) {
  return {{"trajectory", saved(m.trajectory)},
          {"orientation", saved(m.orientation)},
          {"scaling", saved(m.scaling)},
          {"closed_u", static_cast<int>(m.closedU)},
          {"point", numbers(m.point)}};
}
Motion motionOf(const Value& v) {
  return {curveOf(v.at("trajectory")), surfaceOf(v.at("orientation")), surfaceOf(v.at("scaling")),
          static_cast<ClosedU>(v.at("closed_u").get<int>()), vectorOf<Vec3>(v.at("point"))};
}

Value saved(const Sequence& sequence, const fs::path& folder, const std::string& name) {
  Value frames = Value::array();
  for (std::size_t k = 0; k < sequence.frames.size(); ++k)
    frames.push_back(saveShape(sequence.frames[k], folder, name + "-" + std::to_string(k)));
  return {{"sequence", std::move(frames)}, {"times", sequence.times}};
}

}  // namespace

Value saveShape(const Shape& shape, const fs::path& folder, const std::string& name) {
  if (const auto* region = shape.get<Region>()) return {{"region", saved(region->loops)}};
  if (const auto* curves = shape.get<Curves>())
    return {{"curves", saved(curves->paths)}, {"even_odd", curves->fillRule == FillRule::EvenOdd}};
  if (const auto* curve = shape.get<Curve>()) return {{"curve", saved(*curve)}};
  if (const auto* motion = shape.get<Motion>()) return {{"motion", saved(*motion)}};
  if (const auto* sequence = shape.get<Sequence>()) return saved(*sequence, folder, name);
  if (const auto* mesh = shape.get<Mesh>()) {
    writeMesh(*mesh, folder / (name + ".mesh"));
    return {{"mesh", name + ".mesh"}};
  }
  const auto* brep = shape.get<Brep>();
  if (!brep || brep->shape().IsNull())
    throw Error(ErrorCode::InvalidInput,
                brep ? "The input is empty." : "A " + std::string(shapeKindName(shape.kind())) + " cannot be used here.");
  writeBrep(brep->shape(), folder / (name + ".bin"));
  return {{"brep", name + ".bin"}};
}

Shape loadShape(const Value& value, const fs::path& folder) {
  const auto entry = value.begin();
  const std::string& kind = entry.key();
  const Value& v = entry.value();
  if (kind == "region") return Region{pathsOf(v)};
  if (kind == "curves") return Curves{pathsOf(v), value.at("even_odd").get<bool>() ? FillRule::EvenOdd : FillRule::NonZero};
  if (kind == "curve") return curveOf(v);
  if (kind == "motion") return motionOf(v);
  if (kind == "mesh") return readMesh(folder / v.get<std::string>());
  if (kind == "sequence") {
    Sequence sequence;
    for (const Value& frame : v) sequence.frames.push_back(loadShape(frame, folder));
    sequence.times = value.at("times").get<std::vector<double>>();
    return sequence;
  }
  return Brep(readBrep(folder / v.get<std::string>()));
}

}  // namespace blossom
