#include "ui/document_delegate.h"

#include <QPainter>

#include "ui/document_model.h"
#include "ui/icons.h"
#include "ui/theme.h"

namespace blossom::ui {

namespace {

constexpr int rowHeight = 42, sideMargin = 6, iconSize = 20, textLeft = 44;

}  // namespace

QRect DocumentDelegate::eyeRect(const QRect& row) { return {row.right() - 34, row.center().y() - 9, 18, 18}; }

QSize DocumentDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const { return {120, rowHeight}; }

void DocumentDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const {
  editor->setGeometry(option.rect.adjusted(textLeft - 6, 7, -40, -9));
}

void DocumentDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Theme& colors = theme();
  const bool selected = option.state & QStyle::State_Selected, hovered = option.state & QStyle::State_MouseOver;
  const bool failed = index.data(DocumentModel::FailedRole).toBool(),
             visible = index.data(DocumentModel::VisibleRole).toBool();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QRect row = option.rect.adjusted(sideMargin, 1, -sideMargin, -1);
  if (selected || hovered) {
    painter->setPen(Qt::NoPen);
    painter->setBrush(colors.color(selected ? "raised" : "hover"));
    painter->drawRoundedRect(row, 6, 6);
  }
  const char* iconColor = failed ? "error" : selected ? "made" : "muted";
  painter->setOpacity(visible ? 1 : 0.5);
  paintIcon(*painter, QRectF(option.rect.left() + 15, option.rect.center().y() - iconSize / 2.0, iconSize, iconSize),
            index.data(DocumentModel::IconRole).toString(), colors.color(iconColor));

  const bool showEye = hovered || !visible;
  const int right = showEye ? 42 : 16;
  const QRect text(option.rect.left() + textLeft, option.rect.top() + 5, option.rect.width() - textLeft - right, 17);
  QFont font = option.font;
  painter->setFont(font);
  painter->setPen(colors.color("text"));
  painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                    painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, text.width()));
  font.setPixelSize(10);
  painter->setFont(font);
  const bool warned = index.data(DocumentModel::WarnedRole).toBool();
  painter->setPen(colors.color(failed ? "error" : warned ? "warning" : "muted"));
  painter->drawText(
      text.translated(0, 16), Qt::AlignLeft | Qt::AlignVCenter,
      painter->fontMetrics().elidedText(index.data(DocumentModel::StateRole).toString(), Qt::ElideRight, text.width()));
  painter->setOpacity(1);
  if (showEye)
    paintIcon(*painter, eyeRect(option.rect), visible ? QStringLiteral("eye") : QStringLiteral("eye-off"),
              colors.color("muted"));
  painter->restore();
}

}  // namespace blossom::ui
