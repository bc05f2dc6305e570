#pragma once
#include <QStyledItemDelegate>

namespace blossom::ui {

/// Paints a row of the jobs: what and where, how far, how long, and a cross that cancels what is running.
class JobsDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
  static QRect cancelRect(const QRect& row);
};

}  // namespace blossom::ui
