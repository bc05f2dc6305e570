#include "manipulators/tool_scene.h"

#include <BRep_Tool.hxx>
#include <QCoreApplication>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>

namespace blossom::modeling {
namespace {

constexpr double level = 1e-6;                 // mm from the plane
constexpr std::size_t maximumPoints = 100000;  // looked through at each move of the mouse

void addCorners(SnapScene& scene, const Brep& brep) {
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(brep.shape(), TopAbs_VERTEX, vertices);
  for (int k = 1; k <= vertices.Extent() && scene.points.size() < maximumPoints; ++k) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices(k)));
    if (std::abs(p.Z()) <= level) scene.points.push_back({{p.X(), p.Y()}, SnapKind::Point});
  }
}

void addPaths(SnapScene& scene, const std::vector<Path>& paths) {
  for (const Path& path : paths)
    if (scene.points.size() < maximumPoints) addToScene(scene, path);
}

}  // namespace

SnapScene snapScene(const ui::ToolHost& host, const FeatureId& except) {
  SnapScene scene;
  scene.points.push_back({Vec2::Zero(), SnapKind::Point});
  for (const auto& feature : host.document().features()) {
    if (!feature->visible || feature->suppressed || feature->id == except) continue;
    const auto result = host.result(feature->id);
    if (!result) continue;
    const Shape& shape = result->evaluated.shape;
    if (const auto* region = shape.get<Region>()) addPaths(scene, region->loops);
    if (const auto* curves = shape.get<Curves>()) addPaths(scene, curves->paths);
    if (const auto* brep = shape.get<Brep>()) addCorners(scene, *brep);
  }
  return scene;
}

QString snapName(SnapKind kind) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("blossom::modeling", text); };
  switch (kind) {
    case SnapKind::None:
      return {};
    case SnapKind::Grid:
      return tr("grid");
    case SnapKind::OnCurve:
      return tr("on the curve");
    case SnapKind::Horizontal:
      return tr("horizontal");
    case SnapKind::Vertical:
      return tr("vertical");
    case SnapKind::Diagonal:
      return tr("45°");
    case SnapKind::Aligned:
      return tr("aligned with the start");
    case SnapKind::Tangent:
      return tr("straight on");
    case SnapKind::Square:
      return tr("at right angles");
    case SnapKind::Crossing:
      return tr("crossing of help lines");
    case SnapKind::Perpendicular:
      return tr("perpendicular");
    case SnapKind::Midpoint:
      return tr("midpoint");
    case SnapKind::Centre:
      return tr("centre");
    case SnapKind::Point:
      return tr("point");
    case SnapKind::Start:
      return tr("start");
  }
  return {};
}

}  // namespace blossom::modeling
