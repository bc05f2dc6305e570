#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/surface_study.h"

namespace blossom {

namespace {

using Points = vtkSmartPointer<vtkPoints>;

// Doubles, because a drawing may lie far from the origin; the mapper shifts them before they become floats on the card.
Points makePoints(std::size_t count) {
  auto points = Points::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  return points;
}

void setPoint(vtkPoints& points, std::size_t index, const Vec3& p) {
  points.SetPoint(static_cast<vtkIdType>(index), p.data());
}

vtkSmartPointer<vtkFloatArray> normalArray(const std::vector<Vec3>& normals) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("normal");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(normals.size()));
  for (std::size_t i = 0; i < normals.size(); ++i) array->SetTuple(static_cast<vtkIdType>(i), normals[i].data());
  return array;
}

unsigned char toByte(double channel) { return static_cast<unsigned char>(std::lround(std::clamp(channel, 0.0, 1.0) * 255)); }

template <class ColorOf>
vtkSmartPointer<vtkUnsignedCharArray> colorArray(std::size_t cells, ColorOf colorOf) {
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName("color");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(cells));
  for (std::size_t i = 0; i < cells; ++i) {
    const Color color = colorOf(i);
    const unsigned char rgb[3] = {toByte(color.red), toByte(color.green), toByte(color.blue)};
    array->SetTypedTuple(static_cast<vtkIdType>(i), rgb);
  }
  return array;
}

vtkSmartPointer<vtkUnsignedCharArray> faceColorArray(const Tessellation& t) {
  return colorArray(t.triangles.size(), [&](std::size_t i) {
    const auto face = i < t.faceOfTriangle.size() ? static_cast<std::size_t>(t.faceOfTriangle[i]) : 0;
    return face < t.faceColors.size() ? t.faceColors[face] : Color{};
  });
}

vtkSmartPointer<vtkIntArray> numberArray(const char* name, const std::vector<int>& numbers) {
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
  return array;
}

void addCurvatures(vtkPolyData& data, const std::vector<SurfaceCurvature>& curvatures) {
  for (const SurfaceDisplay display : {SurfaceDisplay::Gaussian, SurfaceDisplay::Mean, SurfaceDisplay::Largest}) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(curvatureArray(display));
    array->SetNumberOfTuples(static_cast<vtkIdType>(curvatures.size()));
    for (std::size_t i = 0; i < curvatures.size(); ++i)
      array->SetValue(static_cast<vtkIdType>(i), static_cast<float>(curvatureValue(curvatures[i], display)));
    data.GetPointData()->AddArray(array);
  }
}

vtkSmartPointer<vtkPolyData> makeFaces(const Tessellation& t) {
  if (t.triangles.empty()) return nullptr;
  auto points = makePoints(t.points.size());
  for (std::size_t i = 0; i < t.points.size(); ++i) setPoint(*points, i, t.points[i]);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(static_cast<vtkIdType>(t.triangles.size()), 3 * static_cast<vtkIdType>(t.triangles.size()));
  for (const auto& triangle : t.triangles) {
    const vtkIdType ids[3] = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  if (t.normals.size() == t.points.size()) data->GetPointData()->SetNormals(normalArray(t.normals));
  if (t.curvatures.size() == t.points.size()) addCurvatures(*data, t.curvatures);
  if (!t.faceColors.empty()) data->GetCellData()->SetScalars(faceColorArray(t));
  if (t.faceOfTriangle.size() == t.triangles.size()) data->GetCellData()->AddArray(numberArray("face", t.faceOfTriangle));
  return data;
}

constexpr std::size_t trianglesOfPiece = 32'768;

/// Some of the triangles with the points that they need.
Tessellation partOf(const Tessellation& t, std::size_t first, std::size_t last) {
  Tessellation part;
  part.faceColors = t.faceColors;
  std::vector<int> places(t.points.size(), -1);
  const bool normals = t.normals.size() == t.points.size(), curved = t.curvatures.size() == t.points.size();
  for (std::size_t i = first; i < last; ++i) {
    std::array<int, 3> triangle = t.triangles[i];
    for (int& corner : triangle) {
      int& place = places[static_cast<std::size_t>(corner)];
      if (place < 0) {
        place = static_cast<int>(part.points.size());
        part.points.push_back(t.points[static_cast<std::size_t>(corner)]);
        if (normals) part.normals.push_back(t.normals[static_cast<std::size_t>(corner)]);
        if (curved) part.curvatures.push_back(t.curvatures[static_cast<std::size_t>(corner)]);
      }
      corner = place;
    }
    part.triangles.push_back(triangle);
    if (i < t.faceOfTriangle.size()) part.faceOfTriangle.push_back(t.faceOfTriangle[i]);
  }
  return part;
}

std::vector<vtkSmartPointer<vtkPolyData>> makePieces(const Tessellation& t) {
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  if (t.triangles.size() <= 2 * trianglesOfPiece) return pieces;
  for (std::size_t first = 0; first < t.triangles.size(); first += trianglesOfPiece)
    pieces.push_back(makeFaces(partOf(t, first, std::min(t.triangles.size(), first + trianglesOfPiece))));
  return pieces;
}

vtkSmartPointer<vtkPolyData> makeEdges(const Tessellation& t) {
  std::size_t count = 0;
  for (const auto& line : t.edges) count += line.size();
  if (count == 0) return nullptr;
  auto points = makePoints(count);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::size_t next = 0;
  for (const auto& line : t.edges) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Vec3& p : line) {
      setPoint(*points, next, p);
      cells->InsertCellPoint(static_cast<vtkIdType>(next++));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  if (!t.edgeColors.empty())
    data->GetCellData()->SetScalars(colorArray(t.edges.size(), [&](std::size_t i) { return t.edgeColors.at(i); }));
  if (t.edgeIndices.size() == t.edges.size()) data->GetCellData()->AddArray(numberArray("edge", t.edgeIndices));
  return data;
}

vtkSmartPointer<vtkPolyData> makeMarkers(const Tessellation& t) {
  if (t.markers.empty()) return nullptr;
  auto points = makePoints(t.markers.size());
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t i = 0; i < t.markers.size(); ++i) {
    setPoint(*points, i, t.markers[i]);
    const vtkIdType id = static_cast<vtkIdType>(i);
    cells->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  if (!t.markerColors.empty())
    data->GetCellData()->SetScalars(colorArray(t.markers.size(), [&](std::size_t i) { return t.markerColors.at(i); }));
  return data;
}

vtkSmartPointer<vtkPoints> makeVertices(const Tessellation& t) {
  if (t.vertices.empty()) return nullptr;
  auto points = makePoints(t.vertices.size());
  for (std::size_t i = 0; i < t.vertices.size(); ++i) setPoint(*points, i, t.vertices[i]);
  return points;
}

bool isPlanar(const Tessellation& t) {
  const auto flat = [](const Vec3& p) { return p.z() == 0; };
  return t.normals.empty() && std::all_of(t.points.begin(), t.points.end(), flat) &&
         std::all_of(t.markers.begin(), t.markers.end(), flat) &&
         std::all_of(t.edges.begin(), t.edges.end(),
                     [&](const auto& line) { return std::all_of(line.begin(), line.end(), flat); });
}

}  // namespace

bool SceneData::empty() const { return !faces && !edges && !points; }

SceneData toSceneData(const Tessellation& t) {
  SceneData data;
  data.faces = makeFaces(t);
  data.pieces = makePieces(t);
  data.edges = makeEdges(t);
  data.points = makeMarkers(t);
  data.vertices = makeVertices(t);
  data.planar = isPlanar(t);
  data.colorsTellKinds = t.colorsTellKinds;
  return data;
}

}  // namespace blossom
