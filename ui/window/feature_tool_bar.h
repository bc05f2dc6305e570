#pragma once
#include <QIcon>
#include <QWidget>
#include <algorithm>
#include <vector>

#include "ui/page/feature_menus.h"

class QFrame;
class QToolButton;

namespace blossom::ui {

/// The feature types of all plugins in the tool bar, a group each, and the field that finds commands at its end. Groups
/// share the width there is; what finds no room is in the menu behind the group's last button. The field shrinks before a
/// group goes; groups that went are in one menu more.
class FeatureToolBar : public QWidget {
  Q_OBJECT
 public:
  FeatureToolBar(const FeatureMenus&, QWidget* field, QWidget* parent = nullptr);
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
    bool hasRoom = true;
  };
  [[nodiscard]] int widthOf(const Group&, std::size_t shown) const;
  [[nodiscard]] int leastWidth(const Group& group) const {
    return std::min(widthOf(group, 0), widthOf(group, group.buttons.size()));
  }
  [[nodiscard]] int leastOfAll() const;
  [[nodiscard]] int comfortable() const;
  void chooseGroups(int width);
  void share(int width);
  void hide(Group&);
  void offerRest();
  void place(Group&, int& x);
  void arrange();
  std::vector<Group> groups_;
  QToolButton* others_;  // groups without room
  QWidget* field_;
};

}  // namespace blossom::ui
