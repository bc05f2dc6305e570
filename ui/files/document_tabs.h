#pragma once
#include <QTabBar>

namespace blossom::ui {

/// The open documents. A middle click closes one; the context menu has the rest.
class DocumentTabs : public QTabBar {
  Q_OBJECT
 public:
  explicit DocumentTabs(QWidget* parent = nullptr);

 signals:
  void closeOthersWanted(int index);
  void saveWanted(int index);

 protected:
  [[nodiscard]] QSize minimumTabSizeHint(int index) const override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;

 private:
  int pressed_ = -1;  // by the middle button
};

}  // namespace blossom::ui
