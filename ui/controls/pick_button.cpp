#include "ui/controls/pick_button.h"

#include "ui/look/icons.h"

namespace blossom::ui {

PickButton::PickButton(const QString& iconName, const QString& what, QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("fieldButton"));
  setIcon(ui::icon(iconName));
  setCheckable(true);
  setToolTip(what);
  setAccessibleName(what);
}

}  // namespace blossom::ui
