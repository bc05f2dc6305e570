#include "scene/section/cross_section.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/error.h"
#include "geometry/planar/area_triangulation.h"
#include "geometry/values/box.h"
#include "scene/section/section_chains.h"

namespace blossom {

namespace {

/// The directions in a plane, x to y counter-clockwise as seen from the side that is cut away.
struct PlaneFrame {
  Vec3 origin, x, y;

  explicit PlaneFrame(const CutPlane& cut) : origin(cut.normal * cut.offset), x(cut.axis()), y(cut.normal.cross(x)) {}
  [[nodiscard]] Vec2 toPlane(const Vec3& p) const { return {x.dot(p - origin), y.dot(p - origin)}; }
  [[nodiscard]] Vec3 toSpace(const Vec2& p) const { return origin + p.x() * x + p.y() * y; }
};

/// Those that are zero but for rounding are zero: faces in the plane are known to lie there.
std::vector<double> heightsOf(vtkPoints& points, const CutPlane& cut) {
  std::vector<double> heights(static_cast<std::size_t>(points.GetNumberOfPoints()));
  double farthest = std::abs(cut.offset);
  Bounds box;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    Vec3 p;
    points.GetPoint(static_cast<vtkIdType>(i), p.data());
    heights[i] = cut.height(p);
    farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    box.add(p);
  }
  const double rounding = std::max(1e-12 * farthest, 1e-7 * box.diagonal());  // that of a file's single precision
  for (double& height : heights)
    if (std::abs(height) <= rounding) height = 0;
  return heights;
}

/// Numbers places by their coordinates.
class Places {
 public:
  int at(const Vec3& p) {
    const auto [entry, isNew] = numbers_.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(all_.size()));
    if (isNew) all_.push_back(p);
    return entry->second;
  }
  [[nodiscard]] const std::vector<Vec3>& all() const { return all_; }

 private:
  std::map<std::array<double, 3>, int> numbers_;
  std::vector<Vec3> all_;
};

/// Finds the sides of a section just above the plane: one for each triangle across it, with the material on its left as seen
/// from the side that is cut away. Two triangles at an edge find the same place on it, since both look from its lower end.
/// Nothing is left below a face in the plane that faces down: its own sides take it out of the section again.
class SideFinder {
 public:
  SideFinder(vtkPolyData& faces, const CutPlane& cut, Places& places)
      : points_(*faces.GetPoints()), heights_(heightsOf(points_, cut)), normal_(cut.normal), places_(places) {
    const auto cell = vtk::TakeSmartPointer(faces.GetPolys()->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(count, ids);
      if (count == 3) take({ids[0], ids[1], ids[2]});
    }
    if (hasFacesDown_) cancelOpposite(sides_);
  }
  [[nodiscard]] const std::vector<SectionSide>& sides() const { return sides_; }

 private:
  using Corners = std::array<vtkIdType, 3>;

  [[nodiscard]] double height(vtkIdType id) const { return heights_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] Vec3 point(vtkIdType id) const {
    Vec3 p;
    points_.GetPoint(id, p.data());
    return p;
  }
  void add(int from, int to) {
    if (from != to) sides_.push_back({from, to});
  }

  void take(const Corners& ids) {
    SectionSide side;
    for (std::size_t k = 0; k < 3; ++k) {
      const vtkIdType from = ids[k], to = ids[(k + 1) % 3];
      if ((height(from) > 0) == (height(to) > 0)) continue;
      (height(from) > 0 ? side.from : side.to) = height(from) > 0 ? crossing(to, from) : crossing(from, to);
    }
    add(side.from, side.to);
    const bool isInPlane = height(ids[0]) == 0 && height(ids[1]) == 0 && height(ids[2]) == 0;
    if (isInPlane && facesDown(ids)) takeOut(ids);
  }

  int crossing(vtkIdType low, vtkIdType high) {
    const Vec3 a = point(low), b = point(high);
    return places_.at(a + (b - a) * (height(low) / (height(low) - height(high))));
  }

  [[nodiscard]] bool facesDown(const Corners& ids) const {
    const Vec3 a = point(ids[0]);
    return (point(ids[1]) - a).cross(point(ids[2]) - a).dot(normal_) < 0;
  }

  void takeOut(const Corners& ids) {
    hasFacesDown_ = true;
    for (std::size_t k = 0; k < 3; ++k) add(places_.at(point(ids[k])), places_.at(point(ids[(k + 1) % 3])));
  }

  vtkPoints& points_;
  std::vector<double> heights_;
  Vec3 normal_;
  Places& places_;
  std::vector<SectionSide> sides_;
  bool hasFacesDown_ = false;
};

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<Vec3>& all) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) points->SetPoint(static_cast<vtkIdType>(i), all[i].data());
  return points;
}

vtkSmartPointer<vtkPolyData> outlineOf(const std::vector<SectionLoop>& loops, const Places& places) {
  vtkNew<vtkCellArray> lines;
  for (const SectionLoop& loop : loops) {
    lines->InsertNextCell(static_cast<int>(loop.size()) + 1);
    for (const int place : loop) lines->InsertCellPoint(place);
    lines->InsertCellPoint(loop.front());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(places.all()));
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkPolyData> areaOf(const std::vector<SectionLoop>& loops, const Places& places, const PlaneFrame& frame,
                                    const Progress& progress) {
  std::vector<std::vector<Vec2>> polygons;
  for (const SectionLoop& loop : loops) {
    std::vector<Vec2>& polygon = polygons.emplace_back();
    for (const int place : loop) polygon.push_back(frame.toPlane(places.all()[static_cast<std::size_t>(place)]));
  }
  const AreaTriangles area = triangulateArea(polygons, progress, FillRule::NonZero);
  if (area.triangles.empty()) return nullptr;
  std::vector<Vec3> points;
  for (const Vec2& p : area.points) points.push_back(frame.toSpace(p));
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b, c] : area.triangles) cells->InsertNextCell({a, b, c});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(points));
  data->SetPolys(cells);
  return data;
}

}  // namespace

CrossSection crossSection(vtkPolyData& faces, const CutPlane& cut, const Progress& whileFilling) {
  if (!faces.GetPoints() || faces.GetNumberOfPolys() == 0) return {};
  Places places;
  const SideFinder found(faces, cut, places);
  const std::vector<SectionLoop> loops = chained(found.sides(), places.all());
  if (loops.empty()) return {};
  CrossSection section{outlineOf(loops, places), nullptr};
  try {
    section.area = areaOf(loops, places, PlaneFrame(cut), whileFilling);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Cancelled) throw;
  }
  return section;
}

}  // namespace blossom
