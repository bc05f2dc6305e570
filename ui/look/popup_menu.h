#pragma once
#include <QMenu>

namespace blossom::ui {

/// A menu that goes when it is closed, or with its owner: while it is open, an import that ends may rebuild the panel under
/// it. Show it with popup(), which returns at once.
inline QMenu& popupMenu(QWidget* owner) {
  auto* menu = new QMenu(owner);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  return *menu;
}

}  // namespace blossom::ui
