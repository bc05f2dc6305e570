#include "manipulators/cage_overlay.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

#include "geometry/planar/planar.h"

namespace blossom::subdivision {
namespace {

using Polylines = std::vector<std::vector<Vec3>>;

vtkSmartPointer<vtkActor> actorOf(const vtkSmartPointer<vtkPolyData>& data, const Color& color) {
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.red, color.green, color.blue);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

vtkSmartPointer<vtkProp> scenePoints(const std::vector<Vec3>& places, const Color& color, double size) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Vec3& p : places) {
    cells->InsertNextCell(1);
    cells->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), p.z()));
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  const auto actor = actorOf(data, color);
  actor->GetProperty()->SetPointSize(static_cast<float>(size));
  actor->GetProperty()->RenderPointsAsSpheresOn();
  return actor;
}

Polylines edgesOf(const Mesh& mesh) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(mesh.faceVertices.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) edges.push_back(std::minmax(face[k], face[(k + 1) % face.size()]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Polylines lines;
  lines.reserve(edges.size());
  for (const auto& [low, high] : edges)
    lines.push_back({mesh.points[static_cast<std::size_t>(low)], mesh.points[static_cast<std::size_t>(high)]});
  return lines;
}

Polylines linesOf(const Shape& shape) {
  if (const Mesh* mesh = shape.get<Mesh>()) return edgesOf(*mesh);
  Polylines lines;
  if (const auto* curve = shape.get<Curve>()) {
    auto& line = lines.emplace_back();
    for (const Vec4& pole : curve->poles) line.emplace_back(pole.head<3>() / pole.w());
  }
  if (const auto* curves = shape.get<Curves>())
    for (const Path& path : curves->paths) {
      auto& line = lines.emplace_back();
      for (const Segment& segment : path.segments) {
        const Vec2 from = startPoint(segment), to = endPoint(segment);
        if (line.empty()) line.emplace_back(from.x(), from.y(), 0);
        line.emplace_back(to.x(), to.y(), 0);
      }
    }
  return lines;
}

}  // namespace

vtkSmartPointer<vtkProp> sceneLines(const Polylines& lines, const Color& color, double width) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Vec3& p : line) cells->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), p.z()));
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  const auto actor = actorOf(data, color);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  return actor;
}

std::vector<vtkSmartPointer<vtkProp>> cageOverlay(const ui::OverlayContext& context) {
  if (context.inputs.empty()) return {};
  const Shape& cage = context.inputs.front();
  constexpr std::size_t maximumPointsShown = 2000;  // more would hide the surface
  const Polylines lines = linesOf(cage);
  std::vector<vtkSmartPointer<vtkProp>> props{sceneLines(lines, context.look.control, 1)};
  std::vector<Vec3> points;
  if (const Mesh* mesh = cage.get<Mesh>())
    points = mesh->points;
  else
    for (const auto& line : lines) points.insert(points.end(), line.begin(), line.end());
  if (points.size() <= maximumPointsShown)
    props.push_back(scenePoints(points, context.look.control, context.look.pointSize));
  // The target of a deformation, where it is not shown by itself.
  for (std::size_t i = 1; i < context.inputs.size(); ++i) {
    if (const Mesh* cloud = context.inputs[i].get<Mesh>())
      props.push_back(scenePoints(cloud->points, context.look.made, context.look.pointSize));
  }
  return props;
}

}  // namespace blossom::subdivision
