// The menu of files.
#include <QFileInfo>
#include <QMenuBar>

#include "ui/files/recent_files.h"
#include "ui/files/sample_pictures.h"
#include "ui/files/start_page.h"
#include "ui/look/icons.h"
#include "ui/window/main_window.h"

namespace blossom::ui {

void MainWindow::buildFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  const QString group = tr("File");
  add(menu, {"file.new", group, "new", tr("&New"), tr("Start an empty document."), {QKeySequence::New}},
      [this] { newDocument(); });
  add(menu, {"file.open", group, "open", tr("&Open…"), tr("Open documents, or geometry in new ones."), {QKeySequence::Open}},
      [this] { chooseAndOpen(); });
  recentMenu_ = menu->addMenu(icon(QStringLiteral("recent")), tr("Open &recent"));
  recentMenu_->setToolTipsVisible(true);
  QMenu* samples = menu->addMenu(icon(QStringLiteral("samples")), tr("Open a s&ample"));
  for (const QString& file : sampleFiles())
    samples->addAction(readableFileName(file), this, [this, file] { openFile(file); });
  samples->setEnabled(!samples->isEmpty());
  add(menu, {"file.start-page", group, "home", tr("S&tart page"), tr("Show samples and recent documents.")},
      [this] { showStartPage(); });
  menu->addSeparator();
  add(menu,
      {"file.import", group, "import", tr("&Import…"), tr("Add geometry from files to this document."), {tr("Ctrl+I")}},
      [this] { chooseAndImport(); });
  add(menu,
      {"file.export",
       group,
       "export",
       tr("&Export…"),
       tr("Write the selected results, or all that is visible, as STEP, STL, a picture, …"),
       {tr("Ctrl+E")}},
      [this] { chooseAndExport(); });
  menu->addSeparator();
  add(menu, {"file.save", group, "save", tr("&Save"), tr("Save this document."), {QKeySequence::Save}},
      [this] { save(page()); });
  add(menu,
      {"file.save-as",
       group,
       "save-as",
       tr("Save &as…"),
       tr("Save this document under another name."),
       {tr("Ctrl+Shift+S")}},
      [this] { saveAs(page()); });
  menu->addSeparator();
  buildTabCommands(menu);
  add(menu, {"file.quit", group, "quit", tr("&Quit"), tr("Close the workbench."), {QKeySequence::Quit}},
      [this] { close(); });
  connect(menu, &QMenu::aboutToShow, this, &MainWindow::refreshRecent);
}

void MainWindow::buildTabCommands(QMenu* menu) {
  const QString group = tr("File");
  add(menu,
      {"file.next-tab",
       group,
       "forward",
       tr("Ne&xt document"),
       tr("Show the document in the next tab."),
       {tr("Ctrl+Tab"), tr("Ctrl+PgDown")}},
      [this] { showPage((current_ + 1) % pages_.size()); });
  add(menu,
      {"file.previous-tab",
       group,
       "back",
       tr("&Previous document"),
       tr("Show the document in the tab before."),
       {tr("Ctrl+Shift+Tab"), tr("Ctrl+PgUp")}},
      [this] { showPage((current_ + pages_.size() - 1) % pages_.size()); });
  menu->addSeparator();
  add(menu, {"file.close", group, "close", tr("&Close"), tr("Close this document."), {tr("Ctrl+W")}},
      [this] { closePage(current_); });
  add(menu, {"file.close-others", group, {}, tr("Close ot&hers"), tr("Close every document but this one.")},
      [this] { closeOthers(current_); });
}

void MainWindow::refreshRecent() {
  recentMenu_->clear();
  for (const RecentFile& each : RecentFiles::instance().list()) {
    const QFileInfo info(each.file);
    const QPixmap picture(each.missing ? QString() : SamplePictures::cached(each.file));
    const QString text = each.missing ? tr("%1 (not there any more)").arg(info.fileName()) : info.fileName();
    QAction* entry = recentMenu_->addAction(picture.isNull() ? icon(QStringLiteral("document")) : QIcon(picture), text, this,
                                            [this, each] {
                                              if (!each.missing) return openFile(each.file);
                                              RecentFiles::instance().remove(each.file);
                                            });
    entry->setToolTip(each.missing ? tr("Takes it off this list") : each.file);
  }
  const bool any = !recentMenu_->isEmpty();
  if (any) {
    recentMenu_->addSeparator();
    recentMenu_->addAction(tr("Clear this list"), this, [] { RecentFiles::instance().clear(); });
  }
  recentMenu_->setEnabled(any);
}

}  // namespace blossom::ui
