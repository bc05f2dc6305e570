#include "ui/tools/pick_tool.h"

#include <algorithm>

namespace blossom::ui {

PickTool::PickTool(ToolHost& host, PickRequest request) : Tool(host), request_(std::move(request)) {}

PickMode PickTool::picks() const {
  if (request_.want == PickRequest::Want::Feature) return PickMode::Feature;
  if (request_.want == PickRequest::Want::Point) return PickMode::Any;
  if (request_.want == PickRequest::Want::Direction || request_.kind == SubShapeKind::Face) return PickMode::Face;
  if (request_.kind == SubShapeKind::Edge) return PickMode::Edge;
  return request_.kind == SubShapeKind::Vertex ? PickMode::Vertex : PickMode::Feature;
}

std::optional<Pick> PickTool::answerAt(const ToolEvent& event) const {
  const auto& features = request_.features;
  const bool suits = !event.pick.feature.empty() &&
                     (features.empty() || std::find(features.begin(), features.end(), event.pick.feature) != features.end());
  return suits ? std::optional(event.pick) : std::nullopt;
}

// The camera takes the press too, so that the view can be turned while picking.
bool PickTool::press(const ToolEvent& event) {
  pressedAt_ = event.at;
  return false;
}

bool PickTool::release(const ToolEvent& event) {
  const bool clicked = event.button == Qt::LeftButton && (event.at - pressedAt_).manhattanLength() < clickReach;
  if (clicked)
    if (const auto answer = answerAt(event)) emit answered(*answer);
  return clicked;  // also what does not suit: selecting it would take the form away
}

}  // namespace blossom::ui
