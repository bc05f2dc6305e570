#include "manipulators/sum_overlay.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/shape/bounds.h"
#include "ui/tools/view_props.h"

namespace blossom::morphology {

namespace {

using Outline = std::vector<Vec3>;
using Outlines = std::vector<Outline>;

constexpr double dashesOfSize = 80;  // along the diagonal of the sum
constexpr double reflexPixels = 8;

Outline outlineOf(const Value& points) {
  Outline outline;
  for (const Value& p : points) outline.emplace_back(p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<double>());
  return outline;
}

Outlines outlinesOf(const Value& facets) {
  Outlines outlines;
  for (const Value& facet : facets) outlines.push_back(outlineOf(facet));
  return outlines;
}

/// Lit polygons that lie on the faces of the sum, a little nearer than these; those inside of it are hidden by it.
/// @param layer of facets in one plane those of the highest layer are seen
ui::PropPtr facetsProp(const Outlines& facets, const Color& color, int layer) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Outline& facet : facets) {
    cells->InsertNextCell(static_cast<int>(facet.size()));
    for (const Vec3& p : facet) cells->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1 - layer, -8 * (1 + layer));
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty& property = *actor->GetProperty();
  property.SetColor(color.red, color.green, color.blue);
  property.SetInterpolationToFlat();
  property.BackfaceCullingOn();
  actor->PickableOff();
  ui::cutBySection(*actor);
  return actor;
}

void addDashes(const Vec3& from, const Vec3& to, double step, std::vector<std::vector<Vec3>>& dashes) {
  const double length = (to - from).norm();
  const Vec3 along = length > 0 ? Vec3((to - from) / length) : Vec3::Zero();
  for (double at = 0; at < length; at += step)
    dashes.push_back({from + at * along, from + std::min(at + step / 2, length) * along});
}

class SumOverlay {
  Q_DECLARE_TR_FUNCTIONS(blossom::morphology::SumOverlay)

 public:
  SumOverlay(const ui::OverlayContext& context, const Value& parts) : context_(context), parts_(parts) {}

  std::vector<ui::PropPtr> props(bool outlines) && {
    const Value& facets = parts_.at("facets");
    const Look& look = context_.look;
    constexpr Color third{0.45, 0.65, 0.35};
    // Where they cover each other, the smallest ones are seen.
    addFamily(outlinesOf(facets.at("edges")), third, third, tr("edge + edge"));
    addFamily(outlinesOf(facets.at("face_and_corner")), look.madeFaces, look.made, tr("face + corner"));
    addFamily(outlinesOf(facets.at("corner_and_face")), look.control, look.control, tr("corner + face"));
    if (outlines) addOutlines();
    const Outline reflex = outlineOf(parts_.at("reflex"));
    if (!reflex.empty()) props_.push_back(ui::pointsProp(reflex, look.fault, reflexPixels * context_.pixelRatio));
    return std::move(props_);
  }

 private:
  void addFamily(const Outlines& facets, const Color& color, const Color& ofName, const QString& name) {
    if (facets.empty()) return;
    props_.push_back(facetsProp(facets, color, layer_));
    const ui::LabelLook look = ui::labelLook(context_.look, ofName, context_.pixelRatio);
    props_.push_back(ui::labelProp(name, placeOfName(facets, layer_), look));
    ++layer_;
    for (const Outline& facet : facets) {
      all_.push_back(facet);
      for (const Vec3& p : facet) bounds_.add(p);
    }
  }
  /// The middle of the facet that lies farthest out to one side, where it bounds the sum: each family has its own side, of
  /// those that the usual view shows, so that no name covers another.
  static Vec3 placeOfName(const Outlines& facets, int layer) {
    const std::array<Vec3, 3> sides{Vec3(0.1, -0.1, 1), Vec3(1, -0.1, 0.1), Vec3(0.1, -1, 0.1)};
    const Vec3& side = sides.at(static_cast<std::size_t>(layer) % sides.size());
    Vec3 farthest = Vec3::Zero();
    for (const Outline& facet : facets) {
      Vec3 middle = Vec3::Zero();
      for (const Vec3& p : facet) middle += p / static_cast<double>(facet.size());
      if (&facet == &facets.front() || middle.dot(side) > farthest.dot(side)) farthest = middle;
    }
    return farthest;
  }
  void addOutlines() {
    std::vector<std::vector<Vec3>> dashes;
    const double step = bounds_.diagonal() / dashesOfSize;
    for (const Outline& outline : all_)
      for (std::size_t i = 0; i < outline.size(); ++i)
        addDashes(outline[i], outline[(i + 1) % outline.size()], step, dashes);
    props_.push_back(ui::linesProp(dashes, context_.look.edge, context_.pixelRatio));
    ui::cutBySection(*props_.back());
  }

  const ui::OverlayContext& context_;
  const Value& parts_;
  int layer_ = 0;
  Outlines all_;
  Bounds bounds_;
  std::vector<ui::PropPtr> props_;
};

}  // namespace

std::vector<vtkSmartPointer<vtkProp>> sumOverlay(const ui::OverlayContext& context) {
  const auto parts = context.stats.find("parts");
  const Value shown = context.feature.parameters.value("facets", Value("none"));
  if (parts == context.stats.end() || shown == "none") return {};
  return SumOverlay(context, *parts).props(shown == "outlines");
}

}  // namespace blossom::morphology
