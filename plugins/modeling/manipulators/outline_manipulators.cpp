#include "manipulators/outline_manipulators.h"

#include "manipulators/draw_tool.h"
#include "manipulators/edit_tool.h"
#include "manipulators/move_tool.h"
#include "manipulators/shape_handles.h"
#include "manipulators/shape_tool.h"

namespace blossom::modeling {

void registerOutlineTools(ui::ManipulatorRegistry& registry) {
  const ui::MakeTool edit = [](ui::ToolHost& host, const FeatureId& id) { return std::make_unique<EditTool>(host, id); };
  const ui::MakeTool draw = [edit](ui::ToolHost& host, const FeatureId& id) -> std::unique_ptr<ui::Tool> {
    if (id.empty()) return std::make_unique<DrawTool>(host);
    return edit(host, id);
  };
  registry.addTool({"modeling.draw", "Draw outline",
                    "Draws an outline of lines, arcs and splines on the ground, with snapping and typed lengths.",
                    "polyline", "modeling.outline", draw});
  registry.addHandles("modeling.outline", edit);
  for (const std::string& type : typesWithHandles())
    registry.addHandles(type, [](ui::ToolHost& host, const FeatureId& id) { return std::make_unique<ShapeTool>(host, id); });
}

}  // namespace blossom::modeling

BLOSSOM_MANIPULATORS(registry) {
  blossom::modeling::registerOutlineTools(registry);
  registry.addHandles("modeling.transform", [](blossom::ui::ToolHost& host, const blossom::FeatureId& id) {
    return std::make_unique<blossom::modeling::MoveTool>(host, id);
  });
}
