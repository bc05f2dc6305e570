#include "manipulators/factors/factors_tool.h"
#include "manipulators/motion_overlay.h"
#include "manipulators/surface_pull_tool.h"
#include "type_ids.h"

BLOSSOM_MANIPULATORS(registry) {
  using namespace blossom;
  using namespace blossom::sweep;
  for (const char* type : {sweepType, pullType, twistType}) {
    registry.addOverlay(type, motionOverlay);
    registry.addHandles(type, [](ui::ToolHost& host, const FeatureId& id) -> std::unique_ptr<ui::Tool> {
      return std::make_unique<SurfacePullTool>(host, id);
    });
  }
  const auto editFactors = [](ui::ToolHost& host, const FeatureId& id) -> std::unique_ptr<ui::Tool> {
    return std::make_unique<FactorsTool>(host, id);
  };
  registry.addOverlay(factorsType, motionOverlay);
  for (const char* begin : {primitiveType, frameType, refineType}) registry.addOverlay(begin, sweptOverlay);
  registry.addHandles(factorsType, editFactors);
  registry.addTool({factorsType, "Factors", "Edits the poles of trajectory, orientation and scaling of a motion.", "factors",
                    factorsType, editFactors});
}
