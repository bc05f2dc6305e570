#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <unordered_map>

#include "scene/picking.h"

namespace blossom {

namespace {

/// Takes over cells of one polydata with the points they need.
class CellCopy {
 public:
  explicit CellCopy(vtkPolyData& from) : from_(from), normals_(from.GetPointData()->GetNormals()) {
    points_->SetDataTypeToDouble();
    copiedNormals_->SetNumberOfComponents(3);
    copiedNormals_->SetName("normal");
  }

  void add(vtkIdType count, const vtkIdType* ids) {
    cells_->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i) cells_->InsertCellPoint(pointFor(ids[i]));
  }

  vtkSmartPointer<vtkPolyData> result(bool lines) {
    if (cells_->GetNumberOfCells() == 0) return nullptr;
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    if (lines)
      data->SetLines(cells_);
    else
      data->SetPolys(cells_);
    if (normals_) data->GetPointData()->SetNormals(copiedNormals_);
    return data;
  }

 private:
  vtkIdType pointFor(vtkIdType id) {
    const auto [place, fresh] = copies_.try_emplace(id, points_->GetNumberOfPoints());
    if (fresh) {
      points_->InsertNextPoint(from_.GetPoint(id));
      if (normals_) copiedNormals_->InsertNextTuple(normals_->GetTuple(id));
    }
    return place->second;
  }

  vtkPolyData& from_;
  vtkDataArray* normals_;
  std::unordered_map<vtkIdType, vtkIdType> copies_;
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkFloatArray> copiedNormals_ = vtkSmartPointer<vtkFloatArray>::New();
};

vtkSmartPointer<vtkPolyData> cellsWithNumber(vtkPolyData* data, const char* name, int number, bool lines) {
  if (!data) return nullptr;
  auto* numbers = vtkIntArray::SafeDownCast(data->GetCellData()->GetArray(name));
  if (!numbers) return nullptr;
  const int* values = numbers->GetPointer(0);
  const auto end = values + numbers->GetNumberOfTuples();
  if (!lines && std::all_of(values, end, [number](int value) { return value == number; })) return data;  // its only face
  CellCopy copy(*data);
  vtkCellArray* cells = lines ? data->GetLines() : data->GetPolys();
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i) {
    if (values[i] != number) continue;
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(i, count, ids);
    copy.add(count, ids);
  }
  return copy.result(lines);
}

vtkSmartPointer<vtkPolyData> marker(vtkPoints* vertices, int index) {
  if (!vertices || index < 0 || index >= vertices->GetNumberOfPoints()) return nullptr;
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->InsertNextPoint(vertices->GetPoint(index));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const vtkIdType id = 0;
  cells->InsertNextCell(1, &id);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  return data;
}

}  // namespace

SceneData subShapeData(const SceneData& scene, SubShapeKind kind, int index) {
  SceneData part;
  part.planar = scene.planar;
  if (kind == SubShapeKind::Whole) return scene;
  if (kind == SubShapeKind::Face) part.faces = cellsWithNumber(scene.faces, "face", index, false);
  if (kind == SubShapeKind::Edge) part.edges = cellsWithNumber(scene.edges, "edge", index, true);
  if (kind == SubShapeKind::Vertex) part.points = marker(scene.vertices, index);
  return part;
}

}  // namespace blossom
