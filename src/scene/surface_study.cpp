#include "scene/surface_study.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/tessellate/iso_curves.h"

namespace blossom {

namespace {

constexpr std::array<SurfaceDisplay, 3> curvatureDisplays{SurfaceDisplay::Gaussian, SurfaceDisplay::Mean,
                                                          SurfaceDisplay::Largest};

vtkSmartPointer<vtkPolyData> linesOf(const std::vector<IsoCurve>& curves) {
  std::size_t count = 0;
  for (const IsoCurve& curve : curves) count += curve.points.size();
  if (count == 0) return nullptr;
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->Allocate(static_cast<vtkIdType>(count));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  auto faces = vtkSmartPointer<vtkIntArray>::New();
  faces->SetName("iso");
  for (const IsoCurve& curve : curves) {
    cells->InsertNextCell(static_cast<int>(curve.points.size()));
    for (const Vec3& p : curve.points) cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    faces->InsertNextValue(curve.face);
  }
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetCellData()->AddArray(faces);
  return lines;
}

/// A value and the area that has it.
struct WeightedValue {
  double value, area;
};

std::vector<WeightedValue> absoluteValues(const Tessellation& t, SurfaceDisplay display) {
  std::vector<WeightedValue> values(t.points.size(), {0, 0});
  for (std::size_t i = 0; i < values.size(); ++i) values[i].value = std::abs(curvatureValue(t.curvatures[i], display));
  for (const auto& [a, b, c] : t.triangles) {
    const auto at = [&](int i) -> const Vec3& { return t.points[static_cast<std::size_t>(i)]; };
    const double area = (at(b) - at(a)).cross(at(c) - at(a)).norm() / 6;
    for (const int corner : {a, b, c}) values[static_cast<std::size_t>(corner)].area += area;
  }
  return values;
}

double sizeOf(const Tessellation& t) {
  if (t.points.empty()) return 1;
  Vec3 low = t.points.front(), high = low;
  for (const Vec3& p : t.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return std::max((high - low).norm(), 1e-9);
}

double roundedUp(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return unit * std::ceil(value / unit - 1e-6);
}

/// The place of a triangle nearest to p, as shares of its corners.
Vec3 nearestShares(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double square = n.squaredNorm();
  if (!(square > 0)) return {1, 0, 0};
  Vec3 shares((c - b).cross(p - b).dot(n), (a - c).cross(p - c).dot(n), (b - a).cross(p - a).dot(n));
  shares = (shares / square).cwiseMax(0);
  return shares / shares.sum();
}

}  // namespace

const char* curvatureArray(SurfaceDisplay display) {
  return display == SurfaceDisplay::Gaussian ? "gaussian" : display == SurfaceDisplay::Mean ? "mean" : "largest";
}

double curvatureValue(const SurfaceCurvature& curvature, SurfaceDisplay display) {
  if (display == SurfaceDisplay::Gaussian) return curvature.gaussian;
  return display == SurfaceDisplay::Mean ? curvature.mean : curvature.largest();
}

double curvatureBound(const Tessellation& t, SurfaceDisplay display) {
  constexpr double share = 0.98, flat = 1e-3;  // the radius of what counts as flat is a thousand times the size
  const double size = sizeOf(t);
  const double least = display == SurfaceDisplay::Gaussian ? flat * flat / (size * size) : flat / size;
  if (t.curvatures.size() != t.points.size()) return 0;
  std::vector<WeightedValue> values = absoluteValues(t, display);
  std::erase_if(values, [&](const WeightedValue& v) { return !(v.value > least) || !(v.area > 0); });
  if (values.empty()) return roundedUp(display == SurfaceDisplay::Gaussian ? 1 / (size * size) : 1 / size);
  std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  double total = 0, passed = 0;
  for (const WeightedValue& v : values) total += v.area;
  for (const WeightedValue& v : values)
    if ((passed += v.area) >= share * total) return roundedUp(v.value);
  return roundedUp(values.back().value);
}

double curvatureBound(const SurfaceStudy& study, SurfaceDisplay display) {
  const auto place = std::find(curvatureDisplays.begin(), curvatureDisplays.end(), display);
  if (place == curvatureDisplays.end() || !study.scene.faces) return 0;
  return study.bounds[static_cast<std::size_t>(place - curvatureDisplays.begin())];
}

SurfaceStudy studySurfaces(const Shape& shape, const TessellationOptions& options, int isoCurveCount,
                           const Progress& progress) {
  TessellationOptions curved = options;
  curved.curvature = true;
  const Tessellation t = tessellate(shape, curved, progress.part(0, 0.7));
  SurfaceStudy study;
  for (std::size_t i = 0; i < curvatureDisplays.size(); ++i) {
    progress.check();
    study.bounds[i] = curvatureBound(t, curvatureDisplays[i]);
  }
  study.scene = toSceneData(t);
  study.isoCurves = linesOf(isoCurves(shape, {.count = isoCurveCount, .chord = 0}, progress.part(0.75, 1)));
  progress.report(1);
  return study;
}

std::optional<double> drawnCurvature(const SurfaceStudy& study, SurfaceDisplay display, int face, const Vec3& point) {
  if (!study.scene.faces) return std::nullopt;
  vtkPolyData& data = *study.scene.faces;
  vtkDataArray* const numbers = data.GetCellData()->GetArray("face");
  vtkDataArray* const values = data.GetPointData()->GetArray(curvatureArray(display));
  if (!numbers || !values) return std::nullopt;
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<double> found;
  for (vtkIdType cell = 0; cell < data.GetNumberOfPolys(); ++cell) {
    if (static_cast<int>(numbers->GetComponent(cell, 0)) != face) continue;
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    data.GetPolys()->GetCellAtId(cell, count, ids);
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) data.GetPoint(ids[k], corners[k].data());
    const Vec3 shares = nearestShares(point, corners[0], corners[1], corners[2]);
    const double away = (shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2] - point).squaredNorm();
    if (!(away < nearest)) continue;
    nearest = away;
    found = shares[0] * values->GetComponent(ids[0], 0) + shares[1] * values->GetComponent(ids[1], 0) +
            shares[2] * values->GetComponent(ids[2], 0);
  }
  return found;
}

}  // namespace blossom
