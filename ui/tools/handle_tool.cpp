#include "ui/tools/handle_tool.h"

#include <QKeyEvent>
#include <utility>

namespace blossom::ui {

// Until the mouse tells better: grid lines are some twenty pixels apart.
HandleTool::HandleTool(ToolHost& toolHost, FeatureId feature)
    : Tool(toolHost), feature_(std::move(feature)), millimetresPerPixel_(toolHost.gridSpacing() / 20) {}

bool HandleTool::press(const ToolEvent& event) {
  noteScale(event);
  if (event.button != Qt::LeftButton) return false;
  const auto found = handleUnder(event);
  if (!found || !take(*found, event)) return false;
  hovered_ = held_ = found;
  emit changed();
  return true;
}

bool HandleTool::move(const ToolEvent& event) {
  noteScale(event);
  if (held_) {
    drag(event);
    emit changed();
    return true;
  }
  const auto found = handleUnder(event);
  if (found != hovered_) {
    hovered_ = found;
    emit changed();
  }
  return hovered_.has_value() && event.button == Qt::NoButton;
}

bool HandleTool::release(const ToolEvent& event) {
  if (!held_ || event.button != Qt::LeftButton) return false;
  place();
  letGo();
  emit changed();
  return true;
}

bool HandleTool::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Escape || !held_) return false;
  letGo();
  emit changed();
  return true;
}

void HandleTool::revert() {
  if (held_) letGo();
}

void HandleTool::letGo() {
  putBack();
  if (std::exchange(previewing_, false)) host().endPreview();
  held_.reset();
  if (std::exchange(outdated_, false)) documentChanged();
}

void HandleTool::documentChanged() {
  if (committing_) return;
  if (held_) return loadLater();  // most often it is the preview itself
  if (!host().document().contains(feature_)) {
    emit finished();
    return;
  }
  load();
  emit changed();
}

void HandleTool::preview(Document document) {
  previewing_ = true;
  host().preview(std::move(document));
}

void HandleTool::commit(Document document, const QString& what) {
  previewing_ = false;  // ended by the commit
  committing_ = true;   // the host tells of the change before it returns
  host().commit(std::move(document), what);
  committing_ = false;
  documentChanged();
}

}  // namespace blossom::ui
