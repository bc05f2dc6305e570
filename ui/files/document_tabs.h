#pragma once
#include <QTabBar>
#include <vector>

namespace blossom::ui {

/// What the tab of a document shows.
struct DocumentTab {
  QString text, toolTip;
  QString file;  ///< empty: it has none
  bool operator==(const DocumentTab&) const = default;
};

/// The open documents. A middle click closes one; the context menu has the rest.
class DocumentTabs : public QTabBar {
  Q_OBJECT
 public:
  explicit DocumentTabs(QWidget* parent = nullptr);
  /// Shows these tabs unless they are shown already; emits no signal.
  void setTabs(const std::vector<DocumentTab>&, int current);

 signals:
  void closeOthersWanted(int index);
  void saveWanted(int index);

 protected:
  [[nodiscard]] QSize minimumTabSizeHint(int index) const override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;

 private:
  std::vector<DocumentTab> shown_;
  int pressed_ = -1;  // by the middle button
};

}  // namespace blossom::ui
