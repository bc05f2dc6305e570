#pragma once
#include <optional>

#include "ui/plugin/tool.h"
#include "ui/tools/drag_detail.h"

namespace blossom::ui {

/// A tool with handles of one feature. The handle under the mouse is highlighted, the left button drags it; Esc, undo and
/// the right button leave the drag. Only events on the handles are accepted; all others move the camera.
class HandleTool : public Tool {
  Q_OBJECT
  Q_PROPERTY(double frameBudget READ frameBudget WRITE setFrameBudget)
  Q_PROPERTY(int coarsePreviews READ coarsePreviews)
 public:
  HandleTool(ToolHost&, FeatureId);

  /// ms that a result may take during a drag; a coarser one follows the hand where it takes longer.
  [[nodiscard]] double frameBudget() const { return detail_.budget(); }
  void setFrameBudget(double milliseconds) { detail_.setBudget(milliseconds); }
  [[nodiscard]] int coarsePreviews() const { return detail_.coarseSent(); }  ///< computed so far

  bool press(const ToolEvent&) override;
  bool move(const ToolEvent&) override;
  bool release(const ToolEvent&) override;
  void mouseGone() override;
  bool key(const QKeyEvent&) override;
  void documentChanged() override;
  void revert() override;

 protected:
  /// Reads the handles from the current document. Call it once in the constructor of a tool.
  virtual void load() = 0;
  [[nodiscard]] virtual std::optional<std::size_t> handleUnder(const ToolEvent&) const = 0;
  /// Starts a drag; false when the handle cannot be dragged from there.
  virtual bool take(std::size_t handle, const ToolEvent&) = 0;
  virtual void drag(const ToolEvent&) = 0;
  /// Commits the change made by the drag, if any.
  virtual void place() = 0;
  /// Ends a drag. After a commit the handles are loaded again; otherwise restores their positions.
  virtual void putBack() = 0;

  /// Shows the result of the drag so far; ended by the base class when the drag is placed or cancelled. Where that takes
  /// longer than the frame budget, what `coarser` makes of the document is computed in its place until the hand rests; where
  /// there is none, what is made of the feature is previewed where it can be (document/evaluation/quick_preview.h).
  void preview(Document, const DragDetail::Coarser& coarser = {});
  /// Takes it back where nothing is held: what a card over the view previews.
  void endPreview();
  /// Commits one step of undo and loads the handles afterwards.
  void commit(Document, const QString& what);
  void noteScale(const ToolEvent& event) { millimetresPerPixel_ = event.millimetresPerPixel; }
  /// Postpones loading until the held handle is released, so that its index stays valid.
  void loadLater() { outdated_ = true; }
  void forgetHovered() { hovered_.reset(); }

  [[nodiscard]] const FeatureId& feature() const { return feature_; }
  [[nodiscard]] std::optional<std::size_t> hovered() const { return hovered_; }
  [[nodiscard]] std::optional<std::size_t> held() const { return held_; }
  [[nodiscard]] double millimetresPerPixel() const { return millimetresPerPixel_; }

 private:
  void letGo();
  void giveUp();
  bool loaded();
  void send(const Document&, std::optional<Document> coarser);

  FeatureId feature_;
  FeatureId watched_;  ///< of what is made of it, what can be previewed and comes last; empty: there is none
  std::optional<std::size_t> hovered_, held_;
  std::optional<ToolEvent> last_;  ///< movement of the mouse, since it is over the view
  bool previewing_ = false, committing_ = false;
  bool outdated_ = false;  ///< the document changed while a handle was held
  Document expected_;      ///< during a drag: the document as this tool left it, to detect other changes
  double millimetresPerPixel_;
  DragDetail detail_;
};

}  // namespace blossom::ui
