#include "manipulators/morph_tool.h"
#include "ui/plugin/manipulator.h"

BLOSSOM_MANIPULATORS(registry) {
  registry.addHandles("minkowski.morph", [](blossom::ui::ToolHost& host, const blossom::FeatureId& id) {
    return std::make_unique<blossom::minkowski::MorphTool>(host, id);
  });
}
