#include "ui/panel/overlaid_bars.h"

#include <QEvent>
#include <QScopedValueRollback>
#include <QVBoxLayout>
#include <algorithm>

namespace blossom::ui {

namespace {

constexpr int cubeCorner = 128;
constexpr int leastBarsWidth = 400;

}  // namespace

OverlaidBars::OverlaidBars(QWidget& view, const std::vector<QWidget*>& bars)
    : QWidget(view.parentWidget()), view_(&view), bars_(bars) {
  setObjectName(QStringLiteral("overlaidBars"));
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  for (QWidget* bar : bars_) {
    column->addWidget(bar);
    bar->installEventFilter(this);
  }
  view_->installEventFilter(this);
  settle();
}

void OverlaidBars::leaveCorner(bool leaves) {
  leavesCorner_ = leaves;
  settle();
}

void OverlaidBars::settle() {
  if (settling_ || !view_) return;
  const QScopedValueRollback<bool> once(settling_, true);
  const int before = covered();
  const bool any = std::any_of(bars_.begin(), bars_.end(), [](const QWidget* bar) { return !bar->isHidden(); });
  if (any) {
    const int width = std::max(std::min(leastBarsWidth, view_->width()), view_->width() - (leavesCorner_ ? cubeCorner : 0));
    layout()->invalidate();
    const int high = layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : layout()->sizeHint().height();
    setGeometry(view_->x(), view_->y(), width, high);
    raise();
  }
  setVisible(any);
  if (covered() != before) emit coverageChanged();
}

bool OverlaidBars::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  const bool ofView = watched == view_ && (type == QEvent::Resize || type == QEvent::Move);
  if (ofView || type == QEvent::ShowToParent || type == QEvent::HideToParent) settle();
  return QWidget::eventFilter(watched, event);
}

// Longer words need more lines.
bool OverlaidBars::event(QEvent* event) {
  const bool done = QWidget::event(event);
  if (event->type() == QEvent::LayoutRequest) settle();
  return done;
}

}  // namespace blossom::ui
