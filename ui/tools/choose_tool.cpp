#include "ui/tools/choose_tool.h"

#include <QHBoxLayout>
#include <QLabel>

#include "ui/tools/floating_panel.h"

namespace blossom::ui {

namespace {

class QuestionCard final : public FloatingPanel {
 public:
  QuestionCard(const QString& question, QWidget* view) : FloatingPanel(view, Place::UpperLeft) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 10, 14, 10);
    row->setSpacing(14);
    auto* said = new QLabel(question);
    said->setObjectName(QStringLiteral("question"));
    row->addWidget(said);
    auto* end = new QLabel(ChooseTool::tr("Esc ends"));
    end->setObjectName(QStringLiteral("note"));
    row->addWidget(end);
    show();
  }
};

PickRequest requestFor(const QString& question, std::vector<FeatureId> features) {
  PickRequest request;
  request.want = PickRequest::Want::Feature;
  request.features = std::move(features);
  request.hint = ChooseTool::tr("%1: click it in the view or in the document; Esc ends").arg(question);
  return request;
}

}  // namespace

ChooseTool::ChooseTool(ToolHost& host, const QString& question, std::vector<FeatureId> features, QWidget* view)
    : PickTool(host, requestFor(question, std::move(features))) {
  if (view) card_ = new QuestionCard(question, view);
}

ChooseTool::~ChooseTool() { delete card_; }

}  // namespace blossom::ui
