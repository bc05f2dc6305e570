#pragma once
#include <functional>

#include "ui/tools/pick_tool.h"

namespace blossom::ui {

/// Asks in the view for one of some features, with the question on a card; a click on one is the answer.
class ChooseTool final : public PickTool {
  Q_OBJECT
 public:
  /// @param view where the question stands; nullptr: in the status line alone
  ChooseTool(ToolHost&, const QString& question, std::vector<FeatureId> features, QWidget* view);
  ~ChooseTool() override;

 private:
  QWidget* card_ = nullptr;
};

}  // namespace blossom::ui
