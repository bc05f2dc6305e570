#include "ui/panel/result_rows.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "ui/look/popup_menu.h"
#include "ui/look/theme.h"

namespace blossom::ui {
namespace {

constexpr int betweenColumns = 8, beforeUnit = 7, betweenRows = 5;
constexpr int narrowestText = 60;  // words wrap below that no more
constexpr int narrowestNames = 96;
constexpr int wrapped = Qt::AlignRight | Qt::AlignTop | Qt::TextWordWrap;

}  // namespace

ResultRows::ResultRows(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setMouseTracking(true);
  setAccessibleName(tr("Results"));
}

void ResultRows::setRows(std::vector<ResultRow> rows) {
  rows_ = std::move(rows);
  if (hovered_ && *hovered_ >= rows_.size()) hover({});
  QStringList spoken;
  for (const ResultRow& row : rows_) spoken << row.name + u' ' + row.value() + u' ' + row.unit;
  setAccessibleDescription(spoken.join(u'\n'));
  measureColumns();
  updateGeometry();
  update();
}

void ResultRows::setOutdated(bool outdated) {
  if (outdated == std::exchange(outdated_, outdated)) return;
  update();
}

void ResultRows::measureColumns() {
  const QFontMetrics metrics(font());
  names_ = numbers_ = units_ = 0;
  for (const ResultRow& row : rows_) {
    names_ = std::max(names_, metrics.horizontalAdvance(row.name));
    numbers_ = std::max(numbers_, row.text.isEmpty() ? metrics.horizontalAdvance(row.number) : 0);
    units_ = std::max(units_, metrics.horizontalAdvance(row.unit));
  }
}

int ResultRows::valueWidth() const { return std::max(narrowestText, numbers_ + beforeUnit + units_); }

// Numbers have to be read in full. One long name must not make the panel wider than what is seen of it.
int ResultRows::valueLeft(int width) const {
  return std::clamp(width - betweenColumns - valueWidth(), std::min(names_, narrowestNames), names_) + betweenColumns;
}

int ResultRows::heightOf(const ResultRow& row, int width) const {
  const QFontMetrics metrics(font());
  if (row.text.isEmpty()) return metrics.height();
  const QRect room(0, 0, std::max(narrowestText, width - valueLeft(width)), QWIDGETSIZE_MAX);
  return std::max(metrics.height(), metrics.boundingRect(room, wrapped, row.text).height());
}

int ResultRows::heightForWidth(int width) const {
  int height = -betweenRows;
  for (const ResultRow& row : rows_) height += heightOf(row, width) + betweenRows;
  return std::max(0, height);
}

QSize ResultRows::minimumSizeHint() const {
  const int width = std::min(names_, narrowestNames) + betweenColumns + valueWidth();
  return {width, heightForWidth(std::max(width, this->width()))};
}

QSize ResultRows::sizeHint() const {
  const int width = names_ + betweenColumns + valueWidth();
  return {width, heightForWidth(std::max(width, this->width()))};
}

QRect ResultRows::valueRect(std::size_t row) const {
  int top = 0;
  for (std::size_t i = 0; i < row; ++i) top += heightOf(rows_[i], width()) + betweenRows;
  const int left = valueLeft(width());
  return {left, top, width() - left, heightOf(rows_[row], width())};
}

QString ResultRows::shownName(std::size_t row) const {
  return QFontMetrics(font()).elidedText(rows_[row].name, Qt::ElideRight, valueLeft(width()) - betweenColumns + 1);
}

void ResultRows::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor quiet = theme().color(outdated_ ? "faint" : "muted"), ordinary = theme().color(outdated_ ? "faint" : "text"),
               active = theme().color("control");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ResultRow& row = rows_[i];
    const QRect value = valueRect(i);
    painter.setPen(quiet);
    painter.drawText(QRect(0, value.top(), names_ + 1, value.height()), Qt::AlignLeft | Qt::AlignTop, shownName(i));
    const QRect unit = value.adjusted(value.width() - units_, 0, 1, 0);
    painter.drawText(unit, Qt::AlignLeft | Qt::AlignTop, row.unit);
    painter.setPen(hovered_ == i ? active : ordinary);
    if (row.text.isEmpty())
      painter.drawText(value.adjusted(0, 0, -units_ - beforeUnit, 0), Qt::AlignRight | Qt::AlignTop, row.number);
    else
      painter.drawText(value, wrapped, row.text);
  }
}

std::optional<std::size_t> ResultRows::rowAt(QPoint at) const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (valueRect(i).contains(at)) return i;
  return std::nullopt;
}

void ResultRows::hover(std::optional<std::size_t> row) {
  if (hovered_ == row) return;
  hovered_ = row;
  if (row)
    setCursor(Qt::PointingHandCursor);
  else
    unsetCursor();
  update();
}

bool ResultRows::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (const auto row = rowAt(help->pos()))
    QToolTip::showText(help->globalPos(), tr("Click to copy"), this, valueRect(*row));
  else
    QToolTip::showText(help->globalPos(), fullNameAt(help->pos()), this);  // nothing: hidden
  return true;
}

/// Of a name that is cut short; else empty.
QString ResultRows::fullNameAt(QPoint at) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const QRect value = valueRect(i);
    if (at.y() >= value.top() && at.y() <= value.bottom() && at.x() < value.left())
      return shownName(i) == rows_[i].name ? QString() : rows_[i].name;
  }
  return {};
}

void ResultRows::mouseMoveEvent(QMouseEvent* event) { hover(rowAt(event->pos())); }
void ResultRows::leaveEvent(QEvent*) { hover({}); }

void ResultRows::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const auto row = rowAt(event->pos())) copy(rows_[*row].copy, tr("Copied %1").arg(rows_[*row].copy));
}

void ResultRows::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  measureColumns();
  updateGeometry();
}

void ResultRows::copy(const QString& text, const QString& told) {
  QApplication::clipboard()->setText(text);
  emit copied(told);
}

void ResultRows::contextMenuEvent(QContextMenuEvent* event) {
  const auto row = rowAt(event->pos());
  if (!row) return QWidget::contextMenuEvent(event);
  QStringList all;
  for (const ResultRow& each : rows_) all << QStringLiteral("%1\t%2\t%3").arg(each.name, each.copy, each.unit);
  QMenu& menu = popupMenu(this);
  const auto offer = [&](const QString& title, const QString& text) {
    menu.addAction(title, this, [this, text] { copy(text, tr("Copied")); });
  };
  offer(tr("Copy value"), rows_[*row].copy);
  offer(tr("Copy name and value"), rows_[*row].name + u'\t' + rows_[*row].copy);
  offer(tr("Copy all results"), all.join(u'\n'));
  menu.popup(event->globalPos());
}

}  // namespace blossom::ui
