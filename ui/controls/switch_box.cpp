#include "ui/controls/switch_box.h"

#include <QPainter>

#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr QRectF track(1, 0, 30, 16);
constexpr int switchGap = 9;

}  // namespace

SwitchBox::SwitchBox(QWidget* parent) : QCheckBox(parent) {
  setAttribute(Qt::WA_Hover);
  connect(&ThemeManager::instance(), &ThemeManager::changed, this, [this] { update(); });
}

QSize SwitchBox::sizeHint() const {
  const int words = std::max(fontMetrics().horizontalAdvance(tr("on")), fontMetrics().horizontalAdvance(tr("off")));
  return {static_cast<int>(track.right()) + switchGap + words + 2, 27};
}

bool SwitchBox::hitButton(const QPoint& at) const {
  return QRect(QPoint(), QSize(sizeHint().width(), height())).contains(at);
}

void SwitchBox::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& colors = theme();
  const QRectF slot = track.translated(0, (height() - track.height()) / 2);
  const QColor frame = hasFocus()     ? colors.color("control")
                       : underMouse() ? colors.color("faint")
                       : isChecked()  ? colors.color("made")
                                      : colors.color("border");
  painter.setPen(QPen(isEnabled() ? frame : colors.color("border"), hasFocus() ? 1.5 : 1));
  painter.setBrush(isChecked() && isEnabled() ? colors.color("made") : colors.color("field"));
  painter.drawRoundedRect(slot.adjusted(0.5, 0.5, -0.5, -0.5), slot.height() / 2, slot.height() / 2);
  const double size = slot.height() - 6;
  painter.setPen(Qt::NoPen);
  painter.setBrush(isChecked() ? colors.color("onMade") : colors.color(isEnabled() ? "muted" : "faint"));
  painter.drawEllipse(QRectF(isChecked() ? slot.right() - size - 3 : slot.left() + 3, slot.top() + 3, size, size));
  painter.setPen(colors.color(isEnabled() ? "text" : "faint"));
  painter.drawText(QRectF(slot.right() + switchGap, 0, width(), height()), Qt::AlignVCenter,
                   isChecked() ? tr("on") : tr("off"));
}

}  // namespace blossom::ui
