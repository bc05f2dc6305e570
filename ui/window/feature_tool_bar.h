#pragma once
#include <QIcon>
#include <QWidget>
#include <vector>

#include "ui/page/feature_menus.h"

class QFrame;
class QToolButton;

namespace blossom::ui {

/// The feature types of all plugins in the tool bar, a group each. Groups share the width there is; what finds no room is in
/// the menu behind the group's last button.
class FeatureToolBar : public QWidget {
  Q_OBJECT
 public:
  explicit FeatureToolBar(const FeatureMenus&, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  void hint(const QString&);

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  bool event(QEvent*) override;

 private:
  struct Group {
    std::vector<QToolButton*> buttons;
    QToolButton* rest = nullptr;  ///< opens the menu of the whole group
    QIcon own;                    ///< of the group
    std::size_t twin = 0;         ///< the button that has the same one; the number of buttons: none
    QFrame* line = nullptr;
    std::size_t shown = 0;
  };
  [[nodiscard]] int widthOf(const Group&, std::size_t shown) const;
  void share(int width);
  void place(Group&, int& x);
  void arrange();
  std::vector<Group> groups_;
};

}  // namespace blossom::ui
