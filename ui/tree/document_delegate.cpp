#include "ui/tree/document_delegate.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QTextLayout>

#include "ui/look/icons.h"
#include "ui/look/theme.h"
#include "ui/tree/document_model.h"

namespace blossom::ui {

namespace {

constexpr int rowHeight = 42, sideMargin = 6, iconSize = 20, textRight = 16, besideEye = 42;
constexpr int foldLeft = 5, foldSize = 12, iconLeft = 19, textLeft = 47, indent = 14;
constexpr int nameTop = 5, nameHeight = 17, stateTop = 21, stateFontSize = 10, maximumLines = 3;

QFont stateFont(QFont font) {
  font.setPixelSize(stateFontSize);
  return font;
}

// Broken at words into at most `most` lines; the last one takes the rest and is elided.
QStringList wrapped(const QString& text, const QFont& font, int width, int most) {
  QStringList lines;
  QTextLayout layout(text, font);
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    if (lines.size() + 1 == most) {
      lines << QFontMetrics(font).elidedText(text.mid(line.textStart()).simplified(), Qt::ElideRight, width);
      break;
    }
    lines << text.mid(line.textStart(), line.textLength()).trimmed();
  }
  layout.endLayout();
  return lines;
}

struct StateLines {
  QStringList state, remedy;
  [[nodiscard]] int count() const { return static_cast<int>(state.size() + remedy.size()); }
};

StateLines stateLines(const QModelIndex& index, const QFont& font, int width) {
  const QString state = index.data(DocumentModel::StateRole).toString();
  if (!index.data(DocumentModel::FailedRole).toBool())
    return {{QFontMetrics(font).elidedText(state, Qt::ElideRight, width)}, {}};
  return {wrapped(state, font, width, maximumLines),
          wrapped(index.data(DocumentModel::RemedyRole).toString(), font, width, maximumLines)};
}

int indentOf(const QModelIndex& index) { return indent * index.data(DocumentModel::DepthRole).toInt(); }

const char* iconColor(const QModelIndex& index, bool selected) {
  if (index.data(DocumentModel::FailedRole).toBool()) return "error";
  if (index.data(DocumentModel::SuppressedRole).toBool()) return "faint";
  return selected ? "made" : "muted";
}

}  // namespace

QRect DocumentDelegate::foldRect(const QRect& row, const QModelIndex& index) {
  return {row.left() + foldLeft + indentOf(index), row.top() + (rowHeight - foldSize) / 2, foldSize, foldSize};
}

QRect DocumentDelegate::eyeRect(const QRect& row) { return {row.right() - 34, row.top() + rowHeight / 2 - 10, 18, 18}; }

QSize DocumentDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (!index.data(DocumentModel::FailedRole).toBool()) return {120, rowHeight};
  const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
  const QFont font = stateFont(option.font);
  const int width = (view ? view->viewport()->width() : option.rect.width()) - textLeft - textRight - indentOf(index);
  const int lines = stateLines(index, font, width).count();
  return {120, rowHeight + std::max(0, lines - 1) * QFontMetrics(font).height()};
}

void DocumentDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                            const QModelIndex& index) const {
  const int left = textLeft + indentOf(index);
  editor->setGeometry(option.rect.left() + left - 6, option.rect.top() + 7, option.rect.width() - left - 34, 26);
}

void DocumentDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Theme& colors = theme();
  const bool selected = option.state & QStyle::State_Selected, hovered = option.state & QStyle::State_MouseOver;
  const bool visible = index.data(DocumentModel::VisibleRole).toBool(),
             suppressed = index.data(DocumentModel::SuppressedRole).toBool(),
             failed = index.data(DocumentModel::FailedRole).toBool();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QRect row = option.rect.adjusted(sideMargin, 1, -sideMargin, -1);
  const bool current = (option.state & QStyle::State_HasFocus) && (option.state & QStyle::State_KeyboardFocusChange);
  if (selected || hovered || current) {
    painter->setPen(current ? QPen(colors.color("control"), 1) : QPen(Qt::NoPen));
    painter->setBrush(selected || hovered ? QBrush(colors.color(selected ? "raised" : "hover")) : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(row, 6, 6);
  }
  constexpr double steppedBack = 0.7;  // what is written in the colour of text is readable at that
  const bool present = visible && !suppressed;
  painter->setOpacity(present ? 1 : steppedBack);
  const int left = option.rect.left() + indentOf(index);
  if (index.data(DocumentModel::StepsRole).toBool())
    paintIcon(
        *painter, foldRect(option.rect, index),
        index.data(DocumentModel::FoldedRole).toBool() ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down"),
        colors.color("muted"));
  paintIcon(*painter, QRectF(left + iconLeft, option.rect.top() + (rowHeight - iconSize) / 2.0, iconSize, iconSize),
            index.data(DocumentModel::IconRole).toString(), colors.color(iconColor(index, selected)));

  const bool showEye = hovered || !visible;
  const int width = option.rect.width() - textLeft - textRight - indentOf(index);
  QRect text(left + textLeft, option.rect.top() + nameTop, width, nameHeight);
  QFont font = option.font;
  font.setStrikeOut(suppressed);
  painter->setFont(font);
  painter->setPen(colors.color("text"));
  const int nameWidth = showEye ? width - besideEye + textRight : width;
  painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                    painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, nameWidth));
  font = stateFont(option.font);
  painter->setFont(font);
  const bool warned = index.data(DocumentModel::WarnedRole).toBool();
  const StateLines lines = stateLines(index, font, showEye && !failed ? nameWidth : width);
  text.moveTop(option.rect.top() + stateTop);
  const auto write = [&](const QStringList& each, const char* color) {
    painter->setPen(colors.color(color));
    for (const QString& line : each) {
      painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter, line);
      text.translate(0, painter->fontMetrics().height());
    }
  };
  write(lines.state, failed ? "error" : warned ? "warning" : present ? "muted" : "text");
  write(lines.remedy, present ? "muted" : "text");
  painter->setOpacity(1);
  if (showEye)
    paintIcon(*painter, eyeRect(option.rect), visible ? QStringLiteral("eye") : QStringLiteral("eye-off"),
              colors.color("muted"));
  painter->restore();
}

}  // namespace blossom::ui
