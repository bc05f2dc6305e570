#include "ui/settings/preferences_commands.h"

#include <QMenu>

#include "ui/commands/commands.h"
#include "ui/settings/preferences_dialog.h"

namespace blossom::ui {

PreferencesCommands::PreferencesCommands(Commands& commands, QMenu& menu, QWidget* window)
    : QObject(window), commands_(commands), window_(window) {
  const QString group = tr("Edit");
  menu.addAction(commands_.add(
      {"edit.shortcuts", group, "keyboard", tr("&Keyboard shortcuts…"), tr("Choose the keys of every command."), {}},
      [this] { open().showShortcuts(); }));
  menu.addAction(commands_.add({"edit.preferences",
                                group,
                                "preferences",
                                tr("Pre&ferences…"),
                                tr("Look, units, navigation, autosave and threads."),
                                {tr("Ctrl+,")}},
                               [this] { open(); }));
}

PreferencesDialog& PreferencesCommands::open() {
  if (!dialog_) {
    dialog_ = new PreferencesDialog(commands_, window_);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
  return *dialog_;
}

}  // namespace blossom::ui
