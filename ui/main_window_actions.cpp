// Menus, tool bar and shortcuts of the main window.
#include <QActionGroup>
#include <QFileInfo>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include "core/version.h"
#include "ui/document_tree.h"
#include "ui/error_bar.h"
#include "ui/feature_menus.h"
#include "ui/icons.h"
#include "ui/main_window.h"
#include "ui/start_page.h"
#include "ui/status_line.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/view_widget.h"

namespace blossom::ui {

QAction* MainWindow::action(QMenu* menu, const QString& iconName, const QString& text, const QKeySequence& keys,
                            const QString& help, std::function<void()> go) {
  auto* made = new QAction(text, this);
  if (!iconName.isEmpty()) made->setIcon(icon(iconName));
  made->setShortcut(keys);
  made->setIconText(QString(text).remove(u'&').remove(u'…'));
  const QString shown = keys.toString(QKeySequence::NativeText);
  made->setToolTip(shown.isEmpty() ? help : QStringLiteral("%1 (%2)").arg(help, shown));
  connect(made, &QAction::triggered, this, std::move(go));
  connect(made, &QAction::hovered, this, [this, help] { status_->setHint(help); });
  menu->addAction(made);
  return made;
}

void MainWindow::buildActions() {
  buildFileMenu();
  buildEditMenu();
  buildViewMenu();
  featureMenus_->addTo(menuBar());
  buildHelpMenu();
  buildToolBar();
}

void MainWindow::buildFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  action(menu, QStringLiteral("document"), tr("&New"), QKeySequence::New, tr("Start an empty document."),
         [this] { newDocument(); });
  open_ = action(menu, QStringLiteral("open"), tr("&Open…"), QKeySequence::Open,
                 tr("Open a document, or geometry in a new one."), [this] { chooseAndOpen(); });
  recentMenu_ = menu->addMenu(tr("Open &recent"));
  QMenu* samples = menu->addMenu(tr("Open a s&ample"));
  for (const QString& file : sampleFiles()) {
    const QString name = sentenceCase(QFileInfo(file).completeBaseName().replace(u'-', u' '));
    samples->addAction(name, this, [this, file] { openFile(file); });
  }
  samples->setEnabled(!samples->isEmpty());
  import_ = action(menu, QStringLiteral("import"), tr("&Import…"), QKeySequence(tr("Ctrl+I")),
                   tr("Add geometry from files to this document."), [this] { chooseAndImport(); });
  menu->addSeparator();
  save_ =
      action(menu, QStringLiteral("save"), tr("&Save"), QKeySequence::Save, tr("Save this document."), [this] { save(); });
  saveAs_ = action(menu, {}, tr("Save &as…"), QKeySequence(tr("Ctrl+Shift+S")), tr("Save this document under another name."),
                   [this] { saveAs(); });
  export_ = action(menu, QStringLiteral("export"), tr("&Export…"), QKeySequence(tr("Ctrl+E")),
                   tr("Write the selected result as STEP, STL, a picture, …"), [this] { chooseAndExport(); });
  menu->addSeparator();
  action(menu, {}, tr("&Quit"), QKeySequence::Quit, tr("Close the workbench."), [this] { close(); });
  connect(menu, &QMenu::aboutToShow, this, &MainWindow::refreshRecent);
}

void MainWindow::buildEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  undo_ = action(menu, QStringLiteral("undo"), tr("&Undo"), QKeySequence::Undo, tr("Take the last change back."),
                 [this] { session_.undo(); });
  redo_ = action(menu, QStringLiteral("redo"), tr("&Redo"), QKeySequence::Redo, tr("Do again what was taken back."),
                 [this] { session_.redo(); });
  redo_->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  menu->addSeparator();
  delete_ = action(menu, QStringLiteral("delete"), tr("&Delete"), QKeySequence::Delete, tr("Delete the selected features."),
                   [this] { tree_->removeSelected(); });
  rename_ = action(menu, {}, tr("Re&name"), QKeySequence(tr("F2")), tr("Give the selected feature another name."),
                   [this] { tree_->renameCurrent(); });
  visible_ = action(menu, QStringLiteral("eye"), tr("Show or &hide"), QKeySequence(tr("H")),
                    tr("Show or hide the selected features."), [this] { tree_->toggleSelected(); });
  menu->addSeparator();
  action(menu, {}, tr("Select &all"), QKeySequence::SelectAll, tr("Select every feature."), [this] { tree_->selectAll(); });
  action(menu, {}, tr("Select &nothing"), QKeySequence(tr("Ctrl+Shift+A")), tr("Select no feature."),
         [this] { tree_->clearSelection(); });
}

void MainWindow::buildViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  fit_ = action(menu, QStringLiteral("fit"), tr("&Fit"), QKeySequence(tr("F")), tr("Show everything."),
                [this] { view_->fit(); });
  home_ = action(menu, QStringLiteral("home"), tr("&Home"), QKeySequence(tr("0")),
                 tr("Look at everything as when it was opened."), [this] { view_->lookFrom(QStringLiteral("auto")); });
  home_->setIconText(tr("Home"));
  action(menu, {}, tr("Zoom &in"), QKeySequence::ZoomIn, tr("Come nearer."), [this] { view_->zoomBy(0.8); });
  action(menu, {}, tr("Zoom &out"), QKeySequence::ZoomOut, tr("Step back."), [this] { view_->zoomBy(1.25); });
  menu->addSeparator();
  int key = 1;
  for (const char* name : {"front", "back", "left", "right", "top", "bottom", "iso"}) {
    const QString view = QLatin1String(name);
    action(menu, {}, sentenceCase(view), QKeySequence(QString::number(key++)), tr("Look from: %1.").arg(view),
           [this, view] { view_->lookFrom(view); });
  }
  menu->addSeparator();
  parallel_ =
      action(menu, {}, tr("&Parallel projection"), QKeySequence(tr("P")),
             tr("Without perspective: equal lengths look equal."), [this] { view_->setParallel(parallel_->isChecked()); });
  parallel_->setCheckable(true);
  grid_ = action(menu, QStringLiteral("grid"), tr("&Grid"), QKeySequence(tr("G")), tr("Show the ground grid."),
                 [this] { view_->setGridVisible(grid_->isChecked()); });
  grid_->setCheckable(true);
  grid_->setChecked(true);
  menu->addSeparator();
  QMenu* themes = menu->addMenu(icon(QStringLiteral("sun")), tr("&Theme"));
  auto* group = new QActionGroup(this);
  for (const auto& [text, choice] : {std::pair{tr("As the &desktop"), ThemeChoice::System},
                                     {tr("&Dark"), ThemeChoice::Dark},
                                     {tr("&Light"), ThemeChoice::Light}}) {
    QAction* entry = themes->addAction(text, this, [wanted = choice] {
      ThemeManager::instance().apply(wanted);
      QSettings().setValue(QStringLiteral("theme"), static_cast<int>(wanted));
    });
    entry->setCheckable(true);
    entry->setChecked(ThemeManager::instance().choice() == choice);
    group->addAction(entry);
  }
}

void MainWindow::buildHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  action(menu, {}, tr("&Mouse and keys"), QKeySequence::HelpContents, tr("How to move around."), [this] {
    errors_->showNote(
        tr("Mouse and keys"),
        tr("Left or middle drag: orbit. Shift+drag or right drag: pan. Wheel: zoom to the cursor. Double click or F: fit. "
           "1 to 7: front, back, left, right, top, bottom, iso. 0: home. P: parallel projection. G: grid. "
           "H shows or hides what is selected, F2 renames it, Delete deletes it. Esc cancels what is being computed."));
  });
  action(menu, {}, tr("&About Blossom"), {}, tr("Version and licence."), [this] {
    errors_->showNote(
        tr("Blossom %1").arg(QLatin1String(versionText)),
        tr("A workbench for shapes that morph, sweep, grow and melt. Free software under the GNU GPL, version 3 or later."));
  });
}

void MainWindow::buildToolBar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  bar->setIconSize({20, 20});
  bar->addActions({open_, import_, save_, export_});
  bar->addSeparator();
  bar->addActions({undo_, redo_});
  bar->addSeparator();
  for (QAction* add : featureMenus_->actions()) bar->addAction(add);
  if (!featureMenus_->actions().empty()) bar->addSeparator();
  bar->addActions({fit_, home_, grid_});
  setContextMenuPolicy(Qt::PreventContextMenu);
}

void MainWindow::refreshActions() {
  setWindowTitle(QStringLiteral("%1[*] – Blossom").arg(session_.title()));
  setWindowModified(session_.modified());
  const QString undoText = qt(session_.history().undoText()), redoText = qt(session_.history().redoText());
  undo_->setEnabled(!undoText.isEmpty());
  redo_->setEnabled(!redoText.isEmpty());
  undo_->setText(undoText.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undoText));
  redo_->setText(redoText.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redoText));
  undo_->setIconText(tr("Undo"));
  redo_->setIconText(tr("Redo"));
  const bool something = !session_.document().features().empty();
  for (QAction* needing : {export_, saveAs_}) needing->setEnabled(something);
  save_->setEnabled(something && (session_.modified() || session_.file().empty()));
  for (QAction* needing : {delete_, visible_}) needing->setEnabled(!tree_->selected().empty());
  rename_->setEnabled(tree_->selected().size() == 1);
}

void MainWindow::refreshRecent() {
  recentMenu_->clear();
  for (const QString& file : recent()) {
    QAction* entry = recentMenu_->addAction(QFileInfo(file).fileName(), this, [this, file] { openFile(file); });
    entry->setToolTip(file);
  }
  recentMenu_->setEnabled(!recentMenu_->isEmpty());
}

}  // namespace blossom::ui
