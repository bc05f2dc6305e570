#pragma once
#include <QStyledItemDelegate>

namespace blossom::ui {

/// Paints a row of the document tree: icon, name, one line of state. What failed takes as many lines as it needs to say why
/// and what to do.
class DocumentDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
  void updateEditorGeometry(QWidget*, const QStyleOptionViewItem&, const QModelIndex&) const override;
  /// Where the eye is in a row.
  static QRect eyeRect(const QRect& row);
};

}  // namespace blossom::ui
