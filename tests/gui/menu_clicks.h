#pragma once
#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include "ui/commands/commands.h"
#include "ui/window/main_window.h"
#include "x_mouse.h"

namespace blossom::test {

/// A command from the menu bar: two clicks.
inline void clickMenu(XMouse& mouse, ui::MainWindow& window, const QString& title, const char* command) {
  QMenuBar* bar = window.menuBar();
  for (QAction* top : bar->actions()) {
    if (top->text().remove(u'&') != title) continue;
    mouse.click(bar, bar->actionGeometry(top).center());
    QTRY_VERIFY(top->menu()->isVisible());
    QAction* wanted = window.commands().action(QLatin1String(command));
    QVERIFY2(top->menu()->actions().contains(wanted), command);
    mouse.click(top->menu(), top->menu()->actionGeometry(wanted).center());
    return;
  }
  QFAIL(qPrintable(title));
}

}  // namespace blossom::test
