#pragma once
#include "ui/fields/pick_request.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

/// Answers the request of a form for a feature, a sub-shape or a direction by clicks in the view.
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

 protected:
  /// What a click would answer; empty: nothing that suits.
  [[nodiscard]] virtual std::optional<Pick> answerAt(const ToolEvent&) const;

 private:
  PickRequest request_;
  QPointF pressedAt_;
};

}  // namespace blossom::ui
