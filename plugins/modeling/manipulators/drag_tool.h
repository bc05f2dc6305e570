#pragma once
#include <optional>

#include "manipulators/tool_scene.h"
#include "parameter/parameter.h"
#include "ui/tools/handle_tool.h"
#include "ui/tools/typed_text.h"

namespace blossom::modeling {

class ToolPaint;

/// Points of one feature that can be dragged in the plane z = 0. During a drag the document is previewed with the resulting
/// parameters; the whole drag is one step of undo.
class DragTool : public ui::HandleTool {
  Q_OBJECT
 public:
  DragTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool doubleClick(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] bool entering() const override { return typing_.has_value(); }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 protected:
  struct Point {
    Vec2 at = Vec2::Zero();
    QString what;                ///< "the centre", for the status line and the undo list
    std::optional<Vec2> anchor;  ///< start of guides during a drag
    bool round = false;          ///< drawn as a ring: a handle for a size, not a point of the shape
  };
  /// A size that is shown beside the shape, and typed there after a double click.
  struct Dimension {
    Vec2 at = Vec2::Zero();       ///< of the shape; the number stands `beside` it
    Vec2 beside = Vec2::UnitY();  ///< unit length: away from the shape
    double value = 0;             ///< mm
    QString what;                 ///< "the width"
    std::string parameter;        ///< that it is; empty: it is none of its own
    bool radius = false;
  };
  [[nodiscard]] virtual std::vector<Dimension> dimensions(const Value& parameters) const = 0;
  /// The parameters with another value of a dimension; empty when that is impossible.
  [[nodiscard]] virtual std::optional<Value> resized(const Value& parameters, std::size_t dimension, double to) const = 0;
  /// Of what a dimension is: its parameter, or a length.
  [[nodiscard]] ParameterSpec specOf(const Dimension&) const;
  /// The expression that a dimension is written as in the document; empty: it is a number.
  [[nodiscard]] virtual std::string expressionFor(std::size_t dimension) const;
  /// The parameters that the document keeps when a dimension was typed.
  /// @param kept those after the edit, as they were written where they stay
  /// @param next those after the edit, canonical
  /// @throws Error when what was typed cannot be kept.
  [[nodiscard]] virtual Value written(Value kept, const Value& next, std::size_t dimension, const Value& typed) const;
  /// The points for the current parameters of the feature.
  [[nodiscard]] virtual std::vector<Point> points(const Value& parameters) const = 0;
  /// The parameters after moving point `index`; empty when that is impossible.
  [[nodiscard]] virtual std::optional<Value> dragged(const Value& parameters, std::size_t index, const Vec2& to) const = 0;
  virtual void paint(ToolPaint&, const Value& parameters) const;
  [[nodiscard]] virtual QString idleHint() const;

  /// Complete and canonical, including the current drag.
  [[nodiscard]] const Value& parameters() const { return parameters_; }
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  /// The point that was clicked last.
  [[nodiscard]] std::optional<std::size_t> chosen() const { return chosen_; }
  void commit(const Value& parameters, const QString& what) { HandleTool::commit(with(parameters), what); }

 private:
  void load() override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override;
  [[nodiscard]] Document with(const Value& parameters) const;
  [[nodiscard]] std::optional<std::size_t> dimensionUnder(const ui::ToolEvent&) const;
  [[nodiscard]] static QPointF shiftOf(const Dimension&);
  [[nodiscard]] double pixelsPerMm(const Dimension&) const;
  [[nodiscard]] QString presentSize(std::size_t dimension) const;
  bool typingKey(const QKeyEvent&);
  void takeTyped();
  void stopTyping();
  void paintDimensions(ToolPaint&) const;

  Document base_;  ///< the document that a drag started from
  Value parameters_, before_;
  SnapScene scene_;
  std::optional<Snap> snap_;
  std::optional<std::size_t> chosen_;
  std::optional<std::size_t> pointed_, typing_;  ///< a dimension: under the mouse; whose value is being typed
  ui::TypedText entry_;
  QString refusal_;
};

}  // namespace blossom::modeling
