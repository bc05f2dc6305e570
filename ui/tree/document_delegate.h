#pragma once
#include <QStyledItemDelegate>

namespace blossom::ui {

/// Paints a row of the document tree: icon, name, one line of state. For a failed feature error and remedy take as many
/// lines as needed.
class DocumentDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
  void updateEditorGeometry(QWidget*, const QStyleOptionViewItem&, const QModelIndex&) const override;
  /// Rectangle of the arrow that folds the steps of a row.
  static QRect foldRect(const QRect& row, const QModelIndex&);
  /// Rectangle of the eye in a row.
  static QRect eyeRect(const QRect& row);
};

}  // namespace blossom::ui
