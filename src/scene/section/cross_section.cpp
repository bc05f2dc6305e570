#include "scene/section/cross_section.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <array>
#include <map>

#include "geometry/planar/area_triangulation.h"
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

std::vector<double> heightsOf(vtkPoints& points, const CutPlane& cut) {
  std::vector<double> heights(static_cast<std::size_t>(points.GetNumberOfPoints()));
  for (std::size_t i = 0; i < heights.size(); ++i) {
    Vec3 p;
    points.GetPoint(static_cast<vtkIdType>(i), p.data());
    heights[i] = cut.height(p);
  }
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

/// The sides of a section: one for each triangle across the plane, with the material on its left as seen from the side that
/// is cut away. Two triangles at an edge find the same place on it, since both look from its lower end.
std::vector<SectionSide> sidesOf(vtkPolyData& faces, const CutPlane& cut, Places& places) {
  vtkPoints& points = *faces.GetPoints();
  const std::vector<double> heights = heightsOf(points, cut);
  const auto isAbove = [&](vtkIdType id) { return heights[static_cast<std::size_t>(id)] > 0; };
  const auto crossing = [&](vtkIdType low, vtkIdType high) {
    Vec3 a, b;
    points.GetPoint(low, a.data());
    points.GetPoint(high, b.data());
    const double below = heights[static_cast<std::size_t>(low)], above = heights[static_cast<std::size_t>(high)];
    return places.at(a + (b - a) * (below / (below - above)));
  };
  std::vector<SectionSide> sides;
  const auto cell = vtk::TakeSmartPointer(faces.GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    SectionSide side;
    for (vtkIdType k = 0; k < count; ++k) {
      const vtkIdType from = ids[k], to = ids[(k + 1) % count];
      if (isAbove(from) == isAbove(to)) continue;
      if (isAbove(from))
        side.from = crossing(to, from);
      else
        side.to = crossing(from, to);
    }
    if (side.from != side.to) sides.push_back(side);
  }
  return sides;
}

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

vtkSmartPointer<vtkPolyData> areaOf(const std::vector<SectionLoop>& loops, const Places& places, const PlaneFrame& frame) {
  std::vector<std::vector<Vec2>> polygons;
  for (const SectionLoop& loop : loops) {
    std::vector<Vec2>& polygon = polygons.emplace_back();
    for (const int place : loop) polygon.push_back(frame.toPlane(places.all()[static_cast<std::size_t>(place)]));
  }
  const AreaTriangles area = triangulateArea(polygons, Progress::none(), FillRule::NonZero);
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

CrossSection crossSection(vtkPolyData& faces, const CutPlane& cut) {
  if (!faces.GetPoints() || faces.GetNumberOfPolys() == 0) return {};
  Places places;
  const std::vector<SectionSide> sides = sidesOf(faces, cut, places);
  const std::vector<SectionLoop> loops = chained(sides, places.all());
  if (loops.empty()) return {};
  return {areaOf(loops, places, PlaneFrame(cut)), outlineOf(loops, places)};
}

}  // namespace blossom
