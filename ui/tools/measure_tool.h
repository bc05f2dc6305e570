#pragma once
#include <QPointer>
#include <optional>

#include "ui/plugin/tool.h"
#include "ui/tools/measurements.h"

namespace blossom::ui {

class MeasurePanel;

/// Measures clicked faces, edges and points: the first click measures the part, a second one its relation to another part.
/// Nothing is computed while the mouse only moves.
class MeasureTool : public Tool {
  Q_OBJECT
 public:
  /// @param measurements they remain when the tool has ended  @param view the panel floats over it
  MeasureTool(ToolHost& host, Measurements& measurements, QWidget* view);
  ~MeasureTool() override;

  [[nodiscard]] QString hint() const override;
  bool press(const ToolEvent&) override;
  bool move(const ToolEvent&) override;
  bool release(const ToolEvent&) override;
  bool key(const QKeyEvent&) override;

 private:
  void take(const PartReference&);
  Measurements& measurements_;
  QPointer<MeasurePanel> panel_;
  std::optional<PartReference> first_, hovered_;
  int open_ = 0;  // the measurement of `first_`, which a second part extends
  std::optional<QPointF> pressedAt_;
};

}  // namespace blossom::ui
