#include "manipulators/radius_tool.h"
#include "manipulators/sum_overlay.h"
#include "ui/plugin/manipulator.h"

BLOSSOM_MANIPULATORS(registry) {
  using blossom::morphology::RadiusTool;
  registry.addOverlay("morphology.solid-sum", blossom::morphology::sumOverlay);
  registry.addHandles("morphology.inflate", [](blossom::ui::ToolHost& host, const blossom::FeatureId& id) {
    return std::make_unique<RadiusTool>(host, id, RadiusTool::Direction::Outwards);
  });
  registry.addHandles("morphology.solid-round", [](blossom::ui::ToolHost& host, const blossom::FeatureId& id) {
    return std::make_unique<RadiusTool>(host, id, RadiusTool::Direction::Inwards);
  });
  registry.addHandles("morphology.melt", [](blossom::ui::ToolHost& host, const blossom::FeatureId& id) {
    return std::make_unique<RadiusTool>(host, id, RadiusTool::Direction::Inwards);
  });
}
