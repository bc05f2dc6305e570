#pragma once
#include <QMenu>

namespace blossom::ui {

/// A menu that is deleted when it is closed, or with its owner: while it is open, the end of an import may rebuild the panel
/// under it. Show it with popup(), which does not block.
inline QMenu& popupMenu(QWidget* owner) {
  auto* menu = new QMenu(owner);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  return *menu;
}

}  // namespace blossom::ui
