#include "example.h"
#include "ui/plugin/manipulator.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"
#include "ui/tools/handle_tool.h"
#include "ui/tools/view_props.h"

using namespace blossom;

/// A handle on the pitch circle sets the module. The area that the gear would have is computed beside the window's own work.
class ModuleTool final : public ui::HandleTool {
 public:
  ModuleTool(ui::ToolHost& toolHost, FeatureId id) : HandleTool(toolHost, std::move(id)) { load(); }
  QString hint() const override { return QStringLiteral("Drag the handle to change the module · ") + area_; }
  std::vector<ui::PropPtr> props() const override {
    return {ui::pointsProp({handle()}, hovered() ? host().look().made : host().look().control, 10 * host().pixelRatio())};
  }

 private:
  Vec3 handle() const { return {gear_.module * gear_.teeth / 2, 0, 0}; }
  void load() override {
    changed_ = host().document().at(feature());
    const Value all = completed(host().registry().at(changed_.type)->parameters, changed_.parameters);
    before_ = {all.at("teeth"), all.at("module"), all.at("pressure-angle"), all.at("bore")};
    show(before_);
  }
  std::optional<std::size_t> handleUnder(const ui::ToolEvent& event) const override {
    const auto at = ui::inGround(event.ray);
    if (!at || (*at - handle().head<2>()).norm() > 9 * event.millimetresPerPixel) return std::nullopt;
    return 0;
  }
  bool take(std::size_t /*handle*/, const ui::ToolEvent& /*event*/) override { return true; }
  void drag(const ui::ToolEvent& event) override {
    if (const auto at = ui::inGround(event.ray)) gear_.module = std::max(0.1, 2 * at->norm() / gear_.teeth);
    changed_.parameters["module"] = gear_.module;
    show(gear_);
    preview(host().document().with(changed_));
  }
  void place() override {
    if (gear_.module != before_.module) commit(host().document().with(changed_), QStringLiteral("Drag the module"));
  }
  void putBack() override { show(before_); }
  void show(const example::Gear& gear) {
    gear_ = gear;
    background_.drop();  // what an earlier place of the mouse asked for
    background_.start([this, gear] {
      mailbox_.post([this, text = example::areaText(gear)] { area_ = QString::fromStdString(text), emit changed(); });
    });
  }
  Feature changed_;  ///< with the module as it is dragged
  example::Gear gear_, before_;
  QString area_;
  ui::Mailbox mailbox_;
  ui::Background background_;  ///< declared last: it ends before what it uses
};

BLOSSOM_MANIPULATORS(registry) {
  registry.addHandles("example.gear", [](auto& host, const auto& id) { return std::make_unique<ModuleTool>(host, id); });
}
