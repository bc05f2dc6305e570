#include "ui/tools/handle_tool.h"

#include <QKeyEvent>
#include <QKeySequence>
#include <algorithm>
#include <utility>

#include "document/evaluation/quick_preview.h"
#include "feature/registry.h"

namespace blossom::ui {

namespace {

/// Documents share what is equal. Undone, or joined by an import, during a drag: the drag must not put the old one back.
bool sameFeatures(const Document& a, const Document& b) { return std::ranges::equal(a.features(), b.features()); }

}  // namespace

// Until the mouse tells better: grid lines are some twenty pixels apart.
HandleTool::HandleTool(ToolHost& toolHost, FeatureId feature)
    : Tool(toolHost),
      feature_(std::move(feature)),
      millimetresPerPixel_(toolHost.gridSpacing() / 20),
      detail_([this](const Document& document, std::optional<Document> coarser) { send(document, std::move(coarser)); },
              [this] { return host().result(watched_.empty() ? feature_ : watched_); }) {}

bool HandleTool::press(const ToolEvent& event) {
  noteScale(event);
  if (event.button != Qt::LeftButton) return false;
  const auto found = handleUnder(event);
  expected_ = host().document();
  if (!found || !take(*found, event)) return false;
  hovered_ = held_ = found;
  emit changed();
  return true;
}

bool HandleTool::move(const ToolEvent& event) {
  noteScale(event);
  last_ = event;
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

void HandleTool::mouseGone() {
  last_.reset();
  if (held_ || !hovered_) return;
  hovered_.reset();
  emit changed();
}

/// To undo what is not done yet is to leave it. The mouse has gone on since it took the handle.
bool HandleTool::key(const QKeyEvent& event) {
  const bool takesBack = event.key() == Qt::Key_Escape || event.matches(QKeySequence::Undo);
  if (!takesBack || !held_) return false;
  letGo();
  hovered_ = last_ ? handleUnder(*last_) : std::nullopt;
  emit changed();
  return true;
}

void HandleTool::revert() {
  if (held_) letGo();
}

void HandleTool::letGo() {
  putBack();
  held_.reset();
  endPreview();
  if (std::exchange(outdated_, false)) documentChanged();
}

/// Nothing of the preview may be sent any more, now or when the hand rests: it would put back what was undone.
void HandleTool::giveUp() {
  loadLater();
  revert();
  endPreview();
  if (std::exchange(outdated_, false)) documentChanged();
}

void HandleTool::documentChanged() {
  if (committing_) return;
  if (previewing_ && !sameFeatures(host().document(), expected_)) return giveUp();
  // What is sent next is not shown in the turn of what has come: the window is refreshed once a turn.
  QMetaObject::invokeMethod(
      this, [this] { detail_.resultsChanged(); }, Qt::QueuedConnection);
  if (held_) {
    loadLater();  // most often it is the preview itself
    if (!sameFeatures(host().document(), expected_)) letGo();
    return;
  }
  if (!loaded()) {
    emit finished();
    return;
  }
  emit changed();
}

// Handles of a parameter that is out of range, or of another version, cannot be made; the feature tells why.
bool HandleTool::loaded() {
  if (!host().document().contains(feature_)) return false;
  try {
    load();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void HandleTool::preview(Document document, const DragDetail::Coarser& coarser) {
  previewing_ = true;
  const auto quick = coarser ? std::nullopt : quickPreview(document, host().registry(), feature_);
  if (!quick) {
    if (!watched_.empty()) detail_.setBudget(DragDetail::frameBudget);
    watched_.clear();
    return detail_.show(std::move(document), coarser);
  }
  if (watched_.empty()) detail_.setBudget(previewPatience);
  watched_ = quick->last;
  detail_.show(std::move(document), [this](const Document& whole) {
    const auto again = quickPreview(whole, host().registry(), feature_);
    return again ? again->document : whole;
  });
}

void HandleTool::send(const Document& document, std::optional<Document> coarser) {
  expected_ = document;
  if (coarser)
    host().previewCoarsely(document, *std::move(coarser));
  else
    host().preview(document);
}

void HandleTool::endPreview() {
  detail_.end();
  if (std::exchange(previewing_, false)) host().endPreview();
}

void HandleTool::commit(Document document, const QString& what) {
  previewing_ = false;  // ended by the commit
  const auto quick = detail_.isBehind() ? quickPreview(document, host().registry(), feature_) : std::nullopt;
  detail_.end();
  committing_ = true;  // the host tells of the change before it returns
  if (quick)
    host().commitCoarselyFirst(std::move(document), what, quick->document);
  else
    host().commit(std::move(document), what);
  committing_ = false;
  expected_ = host().document();
  documentChanged();
}

}  // namespace blossom::ui
