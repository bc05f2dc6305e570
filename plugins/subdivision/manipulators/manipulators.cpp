#include "manipulators/cage_overlay.h"
#include "manipulators/curve_tool.h"
#include "manipulators/pull_tool.h"
#include "manipulators/stroke_tool.h"

namespace {

using namespace blossom;

/// A surface is pulled by other means than a curve.
std::unique_ptr<ui::Tool> pullHandles(ui::ToolHost& host, const FeatureId& id) {
  const auto place = subdivision::deformPlace(host, id);
  const bool surface = !place || host.result(place->base)->evaluated.shape.kind() == ShapeKind::Mesh;
  if (surface) return std::make_unique<subdivision::PullTool>(host, id);
  return std::make_unique<subdivision::CurveTool>(host, id);
}

}  // namespace

BLOSSOM_MANIPULATORS(registry) {
  using namespace blossom;
  using namespace blossom::subdivision;
  registry.addOverlay("subdivision.subdivide", cageOverlay);
  registry.addOverlay("subdivision.deform", cageOverlay);
  registry.addTool({"subdivision.stroke", "Target stroke",
                    "Draws a stroke in a plane over a shape; the smooth surface that is selected is pulled to it.",
                    "target-stroke", "subdivision.stroke",
                    [](ui::ToolHost& host, const FeatureId&) { return std::make_unique<StrokeTool>(host); }});
  registry.addHandles("subdivision.subdivide", pullHandles);
  registry.addHandles("subdivision.deform", pullHandles);
}
