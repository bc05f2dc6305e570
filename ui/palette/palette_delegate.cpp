#include "ui/palette/palette_delegate.h"

#include <QPainter>
#include <QTextLayout>

#include "ui/look/icons.h"
#include "ui/look/theme.h"
#include "ui/palette/palette_model.h"

namespace blossom::ui {

namespace {

constexpr int iconSize = 20, textLeft = 42, sideMargin = 10, smallFont = 10;

QFont small(QFont font) {
  font.setPixelSize(smallFont);
  return font;
}

// Returns where the text ends.
int drawLit(QPainter& painter, const QRect& rect, const QString& text, const QList<int>& letters, const QColor& plain,
            const QColor& lit) {
  QTextLayout layout(painter.fontMetrics().elidedText(text, Qt::ElideRight, rect.width()), painter.font());
  QList<QTextLayout::FormatRange> formats;
  QTextCharFormat format;
  format.setForeground(lit);
  format.setFontWeight(QFont::DemiBold);
  for (const int at : letters) formats << QTextLayout::FormatRange{at, 1, format};
  layout.setFormats(formats);
  layout.beginLayout();
  QTextLine line = layout.createLine();
  layout.endLayout();
  if (!line.isValid()) return rect.left();
  painter.setPen(plain);
  layout.draw(&painter, QPointF(rect.left(), rect.top() + (rect.height() - line.height()) / 2));
  return rect.left() + static_cast<int>(line.naturalTextWidth());
}

// Keys as small caps at the right; returns where they begin.
int drawKeys(QPainter& painter, const QRect& rect, const QString& keys, const Theme& colors) {
  if (keys.isEmpty()) return rect.right();
  const int width = painter.fontMetrics().horizontalAdvance(keys) + 12;
  const QRect cap(rect.right() - width, rect.top() + 1, width, rect.height() - 2);
  painter.setPen(colors.color("border"));
  painter.setBrush(colors.color("field"));
  painter.drawRoundedRect(QRectF(cap).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  painter.setPen(colors.color("muted"));
  painter.drawText(cap, Qt::AlignCenter, keys);
  return cap.left() - 8;
}

}  // namespace

void PaletteDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Theme& colors = theme();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const bool current = option.state & QStyle::State_Selected, enabled = index.data(PaletteModel::EnabledRole).toBool();
  if (current) {
    painter->setPen(Qt::NoPen);
    painter->setBrush(colors.color("raised"));
    painter->drawRoundedRect(option.rect.adjusted(0, 1, 0, -1), 6, 6);
  }
  const QRect row = option.rect.adjusted(sideMargin, 0, -sideMargin, 0);
  paintIcon(*painter, QRectF(row.left() + 2, row.center().y() - iconSize / 2.0, iconSize, iconSize),
            index.data(PaletteModel::IconRole).toString(),
            colors.color(!enabled  ? "faint"
                         : current ? "text"
                                   : "muted"));

  QRect line(row.left() + textLeft - sideMargin, row.top() + 5, row.width() - textLeft + sideMargin, 17);
  painter->setFont(small(option.font));
  const int end = drawKeys(*painter, line, index.data(PaletteModel::KeysRole).toString(), colors);
  const QString group = index.data(PaletteModel::GroupRole).toString();
  const int groupWidth = painter->fontMetrics().horizontalAdvance(group) + 10;
  painter->setFont(option.font);
  const int textEnd = drawLit(*painter, QRect(line.left(), line.top(), end - line.left() - groupWidth, line.height()),
                              index.data().toString(), index.data(PaletteModel::LettersRole).value<QList<int>>(),
                              colors.color(enabled ? "text" : "faint"), colors.color("made"));
  painter->setFont(small(option.font));
  painter->setPen(colors.color("faint"));
  painter->drawText(QRect(textEnd + 8, line.top(), groupWidth, line.height()), Qt::AlignLeft | Qt::AlignVCenter, group);
  painter->setPen(colors.color(enabled ? "muted" : "warning"));
  line.translate(0, 16);
  painter->drawText(
      line, Qt::AlignLeft | Qt::AlignVCenter,
      painter->fontMetrics().elidedText(index.data(PaletteModel::HelpRole).toString(), Qt::ElideRight, line.width()));
  painter->restore();
}

}  // namespace blossom::ui
