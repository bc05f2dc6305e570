#pragma once
#include <QListView>

namespace blossom::ui {

class JobsList;

/// The list of jobs; a click on the cross, or Delete, cancels one.
class JobsPanel : public QListView {
  Q_OBJECT
 public:
  explicit JobsPanel(JobsList&, QWidget* parent = nullptr);

 signals:
  void hint(const QString&);

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void paintEvent(QPaintEvent*) override;

 private:
  [[nodiscard]] bool onCancel(const QModelIndex&, QPoint) const;
  JobsList& jobs_;
};

}  // namespace blossom::ui
