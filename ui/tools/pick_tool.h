#pragma once
#include "ui/fields/pick_request.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

/// Answers the request of a form for a feature, a sub-shape, a point or a direction by clicks in the view.
class PickTool : public Tool {
  Q_OBJECT
 public:
  PickTool(ToolHost&, PickRequest);

  [[nodiscard]] QString hint() const override { return request_.hint; }
  [[nodiscard]] PickMode picks() const override;
  bool press(const ToolEvent&) override;
  bool release(const ToolEvent&) override;

 signals:
  void answered(const blossom::ui::Pick&);

 private:
  [[nodiscard]] bool suits(const Pick&) const;
  PickRequest request_;
  QPointF pressedAt_;
};

}  // namespace blossom::ui
