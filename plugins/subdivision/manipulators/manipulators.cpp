#include "manipulators/cage_overlay.h"
#include "manipulators/pull_tool.h"
#include "manipulators/stroke_tool.h"

BLOSSOM_MANIPULATORS(registry) {
  using namespace blossom;
  using namespace blossom::subdivision;
  registry.addOverlay("subdivision.subdivide", cageOverlay);
  registry.addOverlay("subdivision.deform", cageOverlay);
  registry.addTool({"subdivision.stroke", "Target stroke",
                    "Draws a stroke in a plane over a shape; the smooth surface that is selected is pulled to it.",
                    "target-stroke", "subdivision.stroke",
                    [](ui::ToolHost& host, const FeatureId&) { return std::make_unique<StrokeTool>(host); }});
  const ui::MakeTool pull = [](ui::ToolHost& host, const FeatureId& id) { return std::make_unique<PullTool>(host, id); };
  registry.addHandles("subdivision.subdivide", pull);
  registry.addHandles("subdivision.deform", pull);
}
