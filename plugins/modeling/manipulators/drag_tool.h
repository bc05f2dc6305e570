#pragma once
#include <optional>

#include "manipulators/tool_scene.h"
#include "parameter/value.h"
#include "ui/tool.h"

namespace blossom::modeling {

class ToolPaint;

/// Points of one feature that can be dragged in the plane z = 0. While one is dragged the document is previewed with the
/// parameters that follow from it; letting go is one step of undo. Takes only what happens on its points.
class DragTool : public ui::Tool {
  Q_OBJECT
 public:
  DragTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;
  void revert() override;

 protected:
  struct Point {
    Vec2 at = Vec2::Zero();
    QString what;                ///< "the centre", for the status line and the undo list
    std::optional<Vec2> anchor;  ///< guides start here while it is dragged
    bool round = false;          ///< drawn as a ring: it sets a size and is no point of the shape
  };
  /// From the parameters of the feature as they are now.
  [[nodiscard]] virtual std::vector<Point> points(const Value& parameters) const = 0;
  /// The parameters with point `index` there; nothing when that is not possible.
  [[nodiscard]] virtual std::optional<Value> dragged(const Value& parameters, std::size_t index, const Vec2& to) const = 0;
  virtual void paint(ToolPaint&, const Value& parameters) const;
  [[nodiscard]] virtual QString idleHint() const;

  [[nodiscard]] const FeatureId& feature() const { return feature_; }
  /// Complete and canonical, with what is being dragged.
  [[nodiscard]] const Value& parameters() const { return parameters_; }
  [[nodiscard]] std::optional<std::size_t> under(const ui::ToolEvent&) const;
  [[nodiscard]] std::optional<std::size_t> hovered() const { return hovered_; }
  [[nodiscard]] std::optional<std::size_t> chosen() const { return chosen_; }
  [[nodiscard]] bool dragging() const { return dragging_; }
  [[nodiscard]] double millimetresPerPixel() const { return millimetresPerPixel_; }
  void noteScale(const ui::ToolEvent& event) { millimetresPerPixel_ = event.millimetresPerPixel; }
  void commit(const Value& parameters, const QString& what);

 private:
  void load();
  void drag(const ui::ToolEvent&);
  void endDrag();
  [[nodiscard]] Document with(const Value& parameters) const;

  FeatureId feature_;
  Document base_;  ///< the document that a drag started from
  Value parameters_, before_;
  SnapScene scene_;
  std::optional<Snap> snap_;
  std::optional<std::size_t> hovered_, chosen_;
  bool dragging_ = false, committing_ = false;
  double millimetresPerPixel_ = 1;
};

}  // namespace blossom::modeling
