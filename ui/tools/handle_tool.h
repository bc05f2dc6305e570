#pragma once
#include <optional>

#include "ui/plugin/tool.h"

namespace blossom::ui {

/// A tool of handles that belong to one feature. The handle under the mouse lights up, the left button takes hold of it,
/// letting go places it, Esc takes it back. Takes only what happens on its handles; all else moves the camera as always.
class HandleTool : public Tool {
  Q_OBJECT
 public:
  HandleTool(ToolHost&, FeatureId);

  bool press(const ToolEvent&) override;
  bool move(const ToolEvent&) override;
  bool release(const ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  void documentChanged() override;
  void revert() override;

 protected:
  /// Reads the handles from the document as it is now. The constructor of a tool calls it once.
  virtual void load() = 0;
  [[nodiscard]] virtual std::optional<std::size_t> handleUnder(const ToolEvent&) const = 0;
  /// A drag begins; false when the handle cannot be dragged from there.
  virtual bool take(std::size_t handle, const ToolEvent&) = 0;
  virtual void drag(const ToolEvent&) = 0;
  /// Commits what the drag has changed, if it has changed anything.
  virtual void place() = 0;
  /// The drag is over. After a commit the handles are loaded again; else they are to stand where they stood before.
  virtual void putBack() = 0;

  /// Shows what the drag would make; ended by the base, whether it is placed or given up.
  void preview(Document);
  /// One step of undo; loads afterwards what has come of it.
  void commit(Document, const QString& what);
  void noteScale(const ToolEvent& event) { millimetresPerPixel_ = event.millimetresPerPixel; }
  /// What is held keeps its number: the tool loads again once it is let go.
  void loadLater() { outdated_ = true; }
  void forgetHovered() { hovered_.reset(); }

  [[nodiscard]] const FeatureId& feature() const { return feature_; }
  [[nodiscard]] std::optional<std::size_t> hovered() const { return hovered_; }
  [[nodiscard]] std::optional<std::size_t> held() const { return held_; }
  [[nodiscard]] double millimetresPerPixel() const { return millimetresPerPixel_; }

 private:
  void letGo();
  bool loaded();

  FeatureId feature_;
  std::optional<std::size_t> hovered_, held_;
  bool previewing_ = false, committing_ = false;
  bool outdated_ = false;  ///< the document changed while a handle was held
  Document expected_;      ///< during a drag: what is there unless somebody else changes it
  double millimetresPerPixel_;
};

}  // namespace blossom::ui
