#pragma once
#include <QStyledItemDelegate>

namespace blossom::ui {

/// Paints a row of the jobs: title and document, progress, time, and a cross that cancels a running job.
class JobsDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
  static QRect cancelRect(const QRect& row);
};

}  // namespace blossom::ui
