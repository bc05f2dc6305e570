#include "ui/page/page_tools.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/error.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {
namespace {

/// Seen itself, or in what is made of it: a motion is hidden beside its sweep.
bool isSeen(const Document& document, const FeatureId& id) {
  std::set<FeatureId> made{id};
  for (const auto& feature : document.features()) {
    const auto& inputs = feature->inputs;
    if (std::any_of(inputs.begin(), inputs.end(), [&](const FeatureId& input) { return made.contains(input); }))
      made.insert(feature->id);
    if (feature->visible && made.contains(feature->id)) return true;
  }
  return false;
}

}  // namespace

PageTools::PageTools(ToolHost& host, const ManipulatorRegistry& manipulators, ViewWidget& view)
    : host_(host), manipulators_(manipulators), view_(view) {}

void PageTools::drop() {
  view_.setTool(nullptr);
  tool_.reset();
  handles_.reset();
}

void PageTools::follow(Tool& tool) {
  connect(&tool, &Tool::changed, this, [this, sender = &tool] {
    if (sender != this->tool()) return;
    emit hint(sender->hint());
    tellSteps();
  });
  connect(&tool, &Tool::finished, this, [this, finished = &tool] {
    if (tool_.get() != finished && handles_.get() != finished) return;
    if (tool_.get() == finished) turnBack();
    if (tool_.get() == finished && finished->drawsIn()) emit drawn();
    std::unique_ptr<Tool>& place = tool_.get() == finished ? tool_ : handles_;
    view_.setTool(nullptr);
    place.release()->deleteLater();  // it is still on the stack
    refreshHandles();
    giveViewItsTool();
  });
}

// Of a tool that can take back steps of its own; asked at each of its changes, told when there is news.
void PageTools::tellSteps() {
  const QStringList now = tool_ ? QStringList{tool_->undoText(), tool_->redoText()} : QStringList();
  if (std::exchange(steps_, now) != now) emit stepsChanged();
}

void PageTools::giveViewItsTool() {
  view_.setTool(tool(), !tool_);
  emit hint(tool() ? tool()->hint() : ViewWidget::idleHint());
  emit changed();
  tellSteps();
}

void PageTools::start(std::unique_ptr<Tool> started) {
  conclude();
  if (!started) return;
  handles_.reset();
  tool_ = std::move(started);
  follow(*tool_);
  giveViewItsTool();
  if (const auto normal = tool_->drawsIn()) turnToPlane(*normal);
  view_.setFocus();
}

// A drawing is made where nothing is foreshortened. Who looks at the plane already, from above or from below, is not turned.
void PageTools::turnToPlane(const Vec3& normal) {
  const Turn now = view_.camera().heading();
  constexpr double alike = 0.999;
  if (std::abs(now.toCamera().dot(normal)) > alike) return;
  const Turn to = turnTowards(normal);
  turned_ = Turned{now, to};
  view_.camera().lookFrom(to, true);
}

// Only a view that has not been turned since.
void PageTools::turnBack() {
  const auto turned = std::exchange(turned_, std::nullopt);
  constexpr double alike = 1 - 1e-9;
  if (turned && view_.camera().heading().toCamera().dot(turned->during.toCamera()) > alike)
    view_.camera().lookFrom(turned->before, true);
}

bool PageTools::startDrawing(const std::string& featureType, const FeatureId& edited) {
  const ToolSpec* spec = manipulators_.toolFor(featureType);
  if (!spec) return false;
  try {
    start(spec->make(host_, edited));
  } catch (const Error& problem) {
    emit failed(problem);
  }
  return true;
}

void PageTools::end() {
  if (!tool_) return;
  turnBack();
  view_.setTool(nullptr);
  std::unique_ptr<Tool> ended = std::move(tool_);
  ended->revert();
  ended.release()->deleteLater();  // it may still be on the stack
  refreshHandles();
  giveViewItsTool();
}

void PageTools::conclude() {
  if (tool_) tool_->conclude();
  end();
}

// Handles stay while the same feature is selected: a drag under way must not lose them to its own preview.
void PageTools::refreshHandles() {
  const std::vector<FeatureId> selected = host_.selection();
  const FeatureId wanted = selected.size() == 1 && !tool_ ? selected.front() : FeatureId();
  const Document& document = host_.document();
  const bool usable = !wanted.empty() && document.contains(wanted) && isSeen(document, wanted) && host_.result(wanted);
  if (usable && handles_ && handled_ == wanted) return;
  if (!usable && !handles_) return;
  const bool before = handles_ != nullptr;
  if (handles_) {
    view_.setTool(nullptr);
    const std::unique_ptr<Tool> ended = std::move(handles_);
    ended->revert();  // may change the document, and so come here again
  }
  const MakeTool* make = usable && !handles_ ? manipulators_.handles(host_.document().at(wanted).type) : nullptr;
  if (make) makeHandles(*make, wanted);
  if (before || handles_) giveViewItsTool();
}

// A feature with a parameter that is out of range, or that a newer plugin wrote, has an error of its own, and no handles.
void PageTools::makeHandles(const MakeTool& make, const FeatureId& wanted) {
  try {
    handles_ = make(host_, wanted);
  } catch (const std::exception&) {
    return;
  }
  handled_ = wanted;
  follow(*handles_);
}

}  // namespace blossom::ui
