#include <algorithm>
#include <array>

#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

constexpr Color wood{0.72, 0.58, 0.36};

/// Told apart on the dark and on the light canvas: what crosses air, what goes down, what cuts.
Color colorOf(MoveKind kind) {
  switch (kind) {
    case MoveKind::Rapid:
      return {0.47, 0.53, 0.60};
    case MoveKind::Plunge:
      return {0.86, 0.27, 0.36};
    case MoveKind::Feed:
      break;
  }
  return {0.16, 0.62, 0.56};
}

Color colorOf(MarkKind kind) {
  switch (kind) {
    case MarkKind::Unreachable:
      return {0.95, 0.62, 0.10};
    case MarkKind::Left:
      return {0.30, 0.55, 0.95};
    case MarkKind::Gouge:
    case MarkKind::Missed:
      break;
  }
  return {0.93, 0.18, 0.18};
}

Vec3 cornerOf(const Bounds& box, int i) {
  return {(i & 1) != 0 ? box.high.x() : box.low.x(), (i & 2) != 0 ? box.high.y() : box.low.y(),
          (i & 4) != 0 ? box.high.z() : box.low.z()};
}

/// Lines that cannot be picked have no number.
void addLine(const std::vector<Vec3>& line, const Color& color, Tessellation& result) {
  result.edgeIndices.push_back(-1);
  result.edges.push_back(line);
  result.edgeColors.push_back(color);
}

void addBoxEdges(const Bounds& box, const Color& color, Tessellation& result) {
  for (int i = 0; i < 8; ++i)
    for (const int axis : {1, 2, 4})
      if ((i & axis) == 0) addLine({cornerOf(box, i), cornerOf(box, i | axis)}, color, result);
}

/// The cross of the work's zero.
void addZero(double size, Tessellation& result) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 reach = size / 20 * Vec3::Unit(axis);
    addLine({-reach, reach}, {0.90, 0.62, 0.15}, result);
  }
}

/// What has no colours yet gets one, because something that follows has another.
void colorAll(Tessellation& result) {
  constexpr Color part{0.62, 0.67, 0.73}, edge{0.32, 0.36, 0.42};
  const int faces =
      result.faceOfTriangle.empty() ? 0 : 1 + *std::max_element(result.faceOfTriangle.begin(), result.faceOfTriangle.end());
  if (result.faceColors.empty()) result.faceColors.assign(static_cast<std::size_t>(faces), part);
  if (result.edgeColors.empty()) result.edgeColors.assign(result.edges.size(), edge);
}

/// A face of its own, drawn flat.
void addSide(const Bounds& box, const std::array<int, 4>& corners, const Vec3& normal, const Color& color,
             Tessellation& result) {
  const int first = static_cast<int>(result.points.size());
  for (const int corner : corners) {
    result.points.push_back(cornerOf(box, corner));
    result.normals.push_back(normal);
    if (!result.curvatures.empty()) result.curvatures.emplace_back();
  }
  const int face = static_cast<int>(result.faceColors.size());
  result.triangles.push_back({first, first + 1, first + 2});
  result.triangles.push_back({first, first + 2, first + 3});
  result.faceOfTriangle.insert(result.faceOfTriangle.end(), 2, face);
  result.faceColors.push_back(color);
}

void addClamp(const Bounds& box, Tessellation& result) {
  constexpr Color steel{0.38, 0.49, 0.64}, rim{0.24, 0.31, 0.42};
  addBoxEdges(box, rim, result);
  addSide(box, {0, 2, 3, 1}, -Vec3::UnitZ(), steel, result);
  addSide(box, {4, 5, 7, 6}, Vec3::UnitZ(), steel, result);
  addSide(box, {0, 1, 5, 4}, -Vec3::UnitY(), steel, result);
  addSide(box, {2, 6, 7, 3}, Vec3::UnitY(), steel, result);
  addSide(box, {0, 4, 6, 2}, -Vec3::UnitX(), steel, result);
  addSide(box, {1, 3, 7, 5}, Vec3::UnitX(), steel, result);
}

}  // namespace

Tessellation tessellateToolpath(const Toolpath& path, double chord, const Progress& progress) {
  Tessellation result;
  result.colorsTellKinds = true;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (i % 1024 == 0) progress.check();
    result.edgeIndices.push_back(static_cast<int>(i));
    result.edges.push_back(polylineOf(startOf(path, i), path.moves[i], chord));
    result.edgeColors.push_back(colorOf(path.moves[i].kind));
    result.vertices.push_back(startOf(path, i));
  }
  if (!path.stock.empty) {
    addBoxEdges(path.stock, wood, result);
    addZero(path.stock.diagonal(), result);
  }
  for (const ToolMark& mark : path.marks) {
    result.markers.push_back(mark.at);
    result.markerColors.push_back(colorOf(mark.kind));
  }
  return result;
}

Tessellation tessellateSetup(const Setup& setup, const TessellationOptions& options, const Progress& progress) {
  Tessellation result = setup.part.empty() ? Tessellation() : tessellate(setup.part.front(), options, progress);
  colorAll(result);
  for (const Bounds& clamp : setup.clamps) addClamp(clamp, result);
  double size = bounds(setup).diagonal();
  for (const Shape& stock : setup.stock) {
    size = bounds(stock).diagonal();
    for (const std::vector<Vec3>& edge : tessellate(stock, options, progress).edges) addLine(edge, wood, result);
  }
  addZero(size, result);
  return result;
}

}  // namespace blossom
