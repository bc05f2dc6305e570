#pragma once
#include <QSortFilterProxyModel>
#include <QWidget>

class QComboBox;
class QLineEdit;
class QTreeView;

namespace blossom::ui {

class LogList;

/// Rows of the log from a level up in which a text occurs.
class LogFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void setLevel(int minimum);
  void setWords(const QString&);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  int least_ = 0;
  QString words_;
};

/// The log with what can be done with it: filter, copy, clear.
class LogPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LogPanel(LogList&, QWidget* parent = nullptr);
  /// The rows that are selected, or all that are shown, a line each.
  [[nodiscard]] QString text() const;
  [[nodiscard]] LogFilter& filter() { return *filter_; }

 protected:
  void showEvent(QShowEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  QWidget* bar(LogList&);
  void copy() const;
  void scrollToNewest();
  LogFilter* filter_;
  QTreeView* rows_;
  bool settling_ = false;  // the scroll bar is moved by the panel itself
  bool follows_ = true;    // what is new; not while something older is being read
};

}  // namespace blossom::ui
