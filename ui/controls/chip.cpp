#include "ui/controls/chip.h"

#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/look/icons.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr int height_ = 27;
constexpr int side = 9;
constexpr int mark = 14;

}  // namespace

Chip::Chip(const QString& text, QWidget* parent) : QWidget(parent), text_(text) {
  setObjectName(QStringLiteral("chip"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setMouseTracking(true);
  setAccessibleName(text);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void Chip::setIconName(const QString& name) { icon_ = name; }
void Chip::setProblem(const QString& text) {
  problem_ = text;
  setAccessibleDescription(text);
  setIconName(text.isEmpty() ? QString() : QStringLiteral("warning"));
  updateGeometry();
  update();
}
void Chip::setRemovable(bool on) { removable_ = on; }
void Chip::setChevron(bool on) {
  chevron_ = on;
  setCursor(on ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

int Chip::besideText() const {
  return (icon_.isEmpty() ? 0 : mark + 6) + (removable_ ? mark + 4 : 0) + (chevron_ ? mark + 4 : 0) + 2 * side;
}

QSize Chip::sizeHint() const { return {fontMetrics().horizontalAdvance(text_) + besideText() + 2, height_}; }

QSize Chip::minimumSizeHint() const { return {48, height_}; }

QString Chip::shownText() const { return fontMetrics().elidedText(text_, Qt::ElideRight, width() - besideText()); }

QRect Chip::crossArea() const {
  return removable_ ? QRect(width() - side - mark, (height() - mark) / 2, mark, mark) : QRect();
}

void Chip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& colors = theme();
  const char* const calm = underMouse() ? "faint" : "border";
  painter.setPen(QPen(colors.color(hasFocus() ? "control" : problem_.isEmpty() ? calm : "error"), 1));
  painter.setBrush(colors.color("field"));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  int left = side, right = width() - side;
  const auto at = [&](int x) { return QRectF(x, (height() - mark) / 2.0, mark, mark); };
  if (!icon_.isEmpty()) {
    paintIcon(painter, at(left), icon_, colors.color(problem_.isEmpty() ? "control" : "error"));
    left += mark + 6;
  }
  if (removable_) {
    const bool under = crossArea().contains(mapFromGlobal(QCursor::pos()));
    paintIcon(painter, crossArea(), QStringLiteral("close"), colors.color(under ? "text" : "muted"));
    right -= mark + 4;
  }
  if (chevron_) {
    paintIcon(painter, at(right - mark), QStringLiteral("chevron-down"), colors.color("muted"));
    right -= mark + 4;
  }
  painter.setPen(colors.color(problem_.isEmpty() ? "text" : "error"));
  const QRect words(left, 0, right - left, height());
  painter.drawText(words, Qt::AlignVCenter, shownText());
}

bool Chip::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString& what = problem_.isEmpty() ? text_ : problem_;
    QToolTip::showText(help->globalPos(), crossArea().contains(help->pos()) ? tr("Remove") : what, this);
    return true;
  }
  if (event->type() == QEvent::HoverMove) update();
  return QWidget::event(event);
}

void Chip::enterEvent(QEnterEvent* event) {
  QWidget::enterEvent(event);
  emit pointedAt(true);
}

void Chip::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  emit pointedAt(false);
}

void Chip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  if (crossArea().adjusted(-4, -6, 4, 6).contains(event->position().toPoint()))
    emit removed();
  else
    emit clicked();
}

void Chip::keyPressEvent(QKeyEvent* event) {
  if (removable_ && (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace))
    emit removed();
  else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space)
    emit clicked();
  else
    QWidget::keyPressEvent(event);
}

}  // namespace blossom::ui
