#pragma once
#include <QStyledItemDelegate>

namespace blossom::ui {

/// Paints a row of the command palette: icon, text with the matching letters highlighted, group, keys, and the help line
/// below.
class PaletteDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  static constexpr int rowHeight = 42;
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, rowHeight}; }
};

}  // namespace blossom::ui
