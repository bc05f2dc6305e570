#include "ui/tools/point_tool.h"

#include <vtkProp.h>

#include <algorithm>

#include "document/shown.h"
#include "ui/tools/view_props.h"

namespace blossom::ui {

namespace {

constexpr double reachPixels = 9;

/// What is shown, but for the feature whose place is asked for.
std::vector<SnapPlace> placesOf(const ToolHost& host) {
  const auto shapeOf = [&host](const FeatureId& id) -> const Shape* {
    const auto result = host.result(id);
    return result && !result->error ? &result->evaluated.shape : nullptr;
  };
  const std::vector<FeatureId> edited = host.selection();
  std::vector<SnapPlace> places{{Vec3::Zero(), SnapPlace::Kind::Point}};
  for (const FeatureId& id : shownFeatures(host.document(), host.registry(), shapeOf)) {
    if (std::find(edited.begin(), edited.end(), id) != edited.end()) continue;
    const std::vector<SnapPlace> more = snapPlaces(*shapeOf(id));
    places.insert(places.end(), more.begin(), more.end());
  }
  return places;
}

}  // namespace

PointTool::PointTool(ToolHost& given, PickRequest request)
    : PickTool(given, std::move(request)), places_(placesOf(host())) {}

void PointTool::documentChanged() { places_ = placesOf(host()); }

std::optional<SnapPlace> PointTool::placeAt(const ToolEvent& event) const {
  SnapAim aim;
  aim.ray = event.ray;
  const bool free = event.modifiers.testFlag(Qt::ControlModifier);
  if (!free) aim.reach = reachPixels * event.millimetresPerPixel;
  aim.grid = host().gridSpacing();
  if (!event.pick.feature.empty()) aim.hit = event.pick.part;
  // What is found of an edge or a vertex lies beside the ray.
  if (free && aim.hit) aim.hit->point = aim.ray.origin + aim.hit->distance * aim.ray.direction;
  return snappedPlace(places_, aim);
}

std::optional<Pick> PointTool::answerAt(const ToolEvent& event) const {
  const auto place = placeAt(event);
  if (!place) return std::nullopt;
  Pick answer = event.pick;
  answer.part.point = place->at;
  return answer;
}

bool PointTool::move(const ToolEvent& event) {
  hovered_ = placeAt(event);
  emit changed();
  return false;
}

QString PointTool::hint() const {
  const QString caught = hovered_ ? snapPlaceName(hovered_->kind) : QString();
  return PickTool::hint() + (caught.isEmpty() ? QString() : QStringLiteral(" · ") + caught) + QStringLiteral(" · ") +
         tr("Ctrl: no snapping");
}

std::vector<vtkSmartPointer<vtkProp>> PointTool::props() const {
  if (!hovered_) return {};
  constexpr double size = 8;
  const Color& color = host().look().control;
  std::vector<vtkSmartPointer<vtkProp>> props{pointsProp({hovered_->at}, color, size * host().pixelRatio())};
  const QString caught = snapPlaceName(hovered_->kind);
  if (!caught.isEmpty())
    props.push_back(labelProp(caught, hovered_->at, labelLook(host().look(), color, host().pixelRatio())));
  return props;
}

}  // namespace blossom::ui
