#include "manipulators/live_mesh.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "kernel/grid/shown_normals.h"

namespace blossom::sweep {

namespace {

vtkIdType idOf(std::size_t index) { return static_cast<vtkIdType>(index); }

void addTriangle(vtkCellArray& cells, std::size_t a, std::size_t b, std::size_t c) {
  const vtkIdType ids[3] = {idOf(a), idOf(b), idOf(c)};
  cells.InsertNextCell(3, ids);
}

template <class Array>
vtkSmartPointer<Array> triples(std::size_t count) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(idOf(count));
  return array;
}

vtkSmartPointer<vtkPolyData> dataOver(vtkDoubleArray* places) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(places);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

void tellModified(vtkPolyData& data) {
  data.GetPoints()->GetData()->Modified();
  data.GetPoints()->Modified();
  data.Modified();
}

/// The first and the last section are the same curve: there is nothing to close.
bool meets(const MotionGrid& grid, std::size_t columnA, std::size_t columnB) {
  constexpr double same = 1e-9;  // of the size
  double apart = 0, size = 0;
  for (std::size_t k = 0; k < grid.countU; ++k) {
    apart = std::max(apart, (grid.pointAt(k, columnA) - grid.pointAt(k, columnB)).norm());
    size = std::max(size, (grid.pointAt(k, columnA) - grid.pointAt(0, columnA)).norm());
  }
  return apart <= same * size;
}

}  // namespace

LiveForm liveForm(const Motion& motion, bool capped) {
  const bool closed = motion.closedU != ClosedU::No;
  return {closed, capped && closed};
}

LiveMesh::LiveMesh(const MotionGrid& grid, const LiveForm& form) : form_(form), countU_(grid.countU), countV_(grid.countV) {
  form_.capped = form_.capped && countV_ > 1 && !meets(grid, 0, countV_ - 1);
  const std::size_t count = countU_ * countV_ + (form_.capped ? 2 * (countU_ + 1) : 0);
  points_ = triples<vtkDoubleArray>(count);
  normals_ = triples<vtkFloatArray>(count);
  borderPoints_ = triples<vtkDoubleArray>(2 * countU_ + (form_.closedU ? 1 : 2) * countV_);
  faces_ = connected(1);
  coarseFaces_ = connected(2);
  edges_ = dataOver(borderPoints_);
  connectBorders();
  const GridRectangle whole{{0, countU_}, {0, countV_}};
  update(grid, {&whole, 1});
}

/// Triangles between each `step`th row and column, wound about x_u cross x_v. Two fans close the ends, each about a point of
/// its own.
vtkSmartPointer<vtkPolyData> LiveMesh::connected(std::size_t step) const {
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto after = [step](std::size_t i, std::size_t count) { return std::min(i + step, count - 1); };
  for (std::size_t k = 0; k + 1 < countU_; k += step)
    for (std::size_t l = 0; l + 1 < countV_; l += step) {
      const std::size_t row = k * countV_, next = after(k, countU_) * countV_, end = after(l, countV_);
      addTriangle(*cells, row + l, next + l, next + end);
      addTriangle(*cells, row + l, next + end, row + end);
    }
  for (std::size_t cap = 0; form_.capped && cap < 2; ++cap) {
    const std::size_t first = countU_ * countV_ + cap * (countU_ + 1);
    for (std::size_t k = 0; k + 1 < countU_; k += step)
      addTriangle(*cells, first + countU_, first + k, first + after(k, countU_));
  }
  auto data = dataOver(points_);
  data->GetPointData()->SetNormals(normals_);
  data->SetPolys(cells);
  return data;
}

/// Along both ends in v, and along u where it begins and, of an open surface, where it ends.
void LiveMesh::connectBorders() {
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::size_t next = 0;
  const auto addLine = [&](std::size_t count) {
    cells->InsertNextCell(static_cast<int>(count));
    for (std::size_t i = 0; i < count; ++i) cells->InsertCellPoint(idOf(next++));
  };
  for (int line = 0; line < 2; ++line) addLine(countU_);
  for (int line = 0; line < (form_.closedU ? 1 : 2); ++line) addLine(countV_);
  edges_->SetLines(cells);
}

ui::StandIn LiveMesh::standIn(std::vector<FeatureId> insteadOf) const {
  return {std::move(insteadOf), faces_, edges_, coarseFaces_};
}

void LiveMesh::update(const MotionGrid& grid, std::span<const GridRectangle> changed) {
  if (changed.empty()) return;
  for (const GridRectangle& part : changed) write(grid, withBorrowers(grid, part));
  if (form_.capped) {
    writeCap(grid, 0, countU_ * countV_);
    writeCap(grid, countV_ - 1, countU_ * countV_ + countU_ + 1);
  }
  writeBorders(grid);
  normals_->Modified();
  for (const auto& data : {faces_, coarseFaces_, edges_}) tellModified(*data);
}

void LiveMesh::setPlace(std::size_t index, const Vec3& point, const Vec3& normal) {
  double* p = points_->GetPointer(idOf(3 * index));
  float* n = normals_->GetPointer(idOf(3 * index));
  for (Eigen::Index c = 0; c < 3; ++c) p[c] = point[c], n[c] = static_cast<float>(normal[c]);
}

void LiveMesh::write(const MotionGrid& grid, const GridRectangle& part) {
  for (std::size_t k = part.rows.begin; k < part.rows.end; ++k)
    for (std::size_t l = part.columns.begin; l < part.columns.end; ++l)
      setPlace(k * countV_ + l, grid.pointAt(k, l), shownNormal(grid, k, l));
}

/// Straight lines from the end to its centre, which lie in its plane where it has one.
void LiveMesh::writeCap(const MotionGrid& grid, std::size_t column, std::size_t first) {
  Vec3 centre = Vec3::Zero(), whole = Vec3::Zero();
  for (std::size_t k = 0; k + 1 < countU_; ++k) centre += grid.pointAt(k, column) / static_cast<double>(countU_ - 1);
  const auto triangle = [&](std::size_t k) -> Vec3 {
    const std::size_t at = k % (countU_ - 1);
    return (grid.pointAt(at, column) - centre).cross(grid.pointAt(at + 1, column) - centre);
  };
  for (std::size_t k = 0; k < countU_; ++k) {
    const Vec3 normal = triangle(k + countU_ - 2) + triangle(k);
    whole += normal;
    setPlace(first + k, grid.pointAt(k, column), normal.normalized());
  }
  setPlace(first + countU_, centre, whole.normalized());
}

void LiveMesh::writeBorders(const MotionGrid& grid) {
  double* to = borderPoints_->GetPointer(0);
  const auto put = [&](std::size_t k, std::size_t l) {
    for (std::size_t c = 0; c < 3; ++c) *to++ = grid.point[c][k * countV_ + l];
  };
  for (const std::size_t l : {std::size_t{0}, countV_ - 1})
    for (std::size_t k = 0; k < countU_; ++k) put(k, l);
  for (std::size_t l = 0; l < countV_; ++l) put(0, l);
  for (std::size_t l = 0; !form_.closedU && l < countV_; ++l) put(countU_ - 1, l);
}

}  // namespace blossom::sweep
