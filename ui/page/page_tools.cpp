// Tools of a page: one that the user has started, or the handles of the selected feature.
#include "ui/look/text.h"
#include "ui/page/page.h"
#include "ui/panel/property_panel.h"
#include "ui/tools/measure_tool.h"
#include "ui/tools/pick_tool.h"
#include "ui/tools/section_tool.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

void DocumentPage::follow(Tool& tool) {
  connect(&tool, &Tool::changed, this, [this, changed = &tool] {
    if (changed == this->tool()) emit hint(changed->hint());
  });
  connect(&tool, &Tool::finished, this, [this, finished = &tool] {
    if (tool_.get() != finished && handles_.get() != finished) return;
    std::unique_ptr<Tool>& place = tool_.get() == finished ? tool_ : handles_;
    view_->setTool(nullptr);
    place.release()->deleteLater();  // it is still on the stack
    refreshHandles();
    giveViewItsTool();
  });
}

void DocumentPage::giveViewItsTool() {
  view_->setTool(tool(), !tool_);
  emit hint(tool() ? tool()->hint() : ViewWidget::idleHint());
  emit toolChanged();
}

void DocumentPage::start(std::unique_ptr<Tool> started) {
  endTool();
  if (!started) return;
  handles_.reset();
  tool_ = std::move(started);
  follow(*tool_);
  giveViewItsTool();
  view_->setFocus();
}

// The same command again puts the tool away.
void DocumentPage::startMeasuring() {
  if (measuring()) return endTool();
  start(std::make_unique<MeasureTool>(*this, measurements_, view_));
}
void DocumentPage::startSection() {
  if (dynamic_cast<SectionTool*>(tool_.get())) return endTool();
  start(std::make_unique<SectionTool>(*this, view_));
}

bool DocumentPage::measuring() const { return dynamic_cast<MeasureTool*>(tool_.get()) != nullptr; }

void DocumentPage::connectPicking() {
  connect(view_, &ViewWidget::toolDismissed, this, &DocumentPage::endTool);
  const auto picking = [this] { return qobject_cast<PickTool*>(tool_.get()) != nullptr; };
  connect(properties_, &PropertyPanel::pickWanted, this, [this](const PickRequest& request) {
    auto tool = std::make_unique<PickTool>(*this, request);
    connect(tool.get(), &PickTool::answered, properties_, &PropertyPanel::offerPick);
    start(std::move(tool));
  });
  connect(properties_, &PropertyPanel::pickEnded, this, [this, picking] {
    if (picking()) endTool();
  });
  connect(this, &DocumentPage::toolChanged, properties_, [this, picking] {
    if (!picking() && properties_->wanted()) properties_->endPick();
  });
}

bool DocumentPage::startDrawing(const std::string& featureType, const FeatureId& edited) {
  const ToolSpec* spec = manipulators_.toolFor(featureType);
  if (!spec) return false;
  try {
    start(spec->make(*this, edited));
  } catch (const Error& problem) {
    showError(problem);
  }
  return true;
}

void DocumentPage::endTool() {
  if (!tool_) return;
  view_->setTool(nullptr);
  std::unique_ptr<Tool> ended = std::move(tool_);
  ended->revert();
  ended.release()->deleteLater();  // it may still be on the stack
  refreshHandles();
  giveViewItsTool();
}

// Handles stay while the same feature is selected: a drag under way must not lose them to its own preview.
void DocumentPage::refreshHandles() {
  const std::vector<FeatureId> selected = selection();
  const FeatureId wanted = selected.size() == 1 && !tool_ ? selected.front() : FeatureId();
  const bool usable = !wanted.empty() && document().contains(wanted) && document().at(wanted).visible && result(wanted);
  if (usable && handles_ && handled_ == wanted) return;
  if (!usable && !handles_) return;
  const bool before = handles_ != nullptr;
  if (handles_) {
    view_->setTool(nullptr);
    const std::unique_ptr<Tool> ended = std::move(handles_);
    ended->revert();  // may change the document, and so come here again
  }
  const MakeTool* make = usable && !handles_ ? manipulators_.handles(document().at(wanted).type) : nullptr;
  if (make) makeHandles(*make, wanted);
  if (before || handles_) giveViewItsTool();
}

// A feature with a parameter that is out of range, or that a newer plugin wrote, has an error of its own, and no handles.
void DocumentPage::makeHandles(const MakeTool& make, const FeatureId& wanted) {
  try {
    handles_ = make(*this, wanted);
  } catch (const std::exception&) {
    return;
  }
  handled_ = wanted;
  follow(*handles_);
}

}  // namespace blossom::ui
