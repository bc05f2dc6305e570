#include "manipulators/comparison_labels.h"
#include "manipulators/morph_tool.h"
#include "ui/plugin/manipulator.h"

BLOSSOM_MANIPULATORS(registry) {
  registry.addHandles("minkowski.morph", [](blossom::ui::ToolHost& host, const blossom::FeatureId& id) {
    return std::make_unique<blossom::minkowski::MorphTool>(host, id);
  });
  registry.addOverlay("minkowski.morph-compare", blossom::minkowski::comparisonLabels);
}
