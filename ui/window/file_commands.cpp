#include "ui/window/file_commands.h"

#include <QFileInfo>
#include <QMenu>

#include "ui/commands/commands.h"
#include "ui/files/recent_files.h"
#include "ui/files/sample_pictures.h"
#include "ui/files/start_page.h"
#include "ui/look/icons.h"
#include "ui/page/page.h"
#include "ui/window/document_closing.h"
#include "ui/window/document_export.h"
#include "ui/window/document_files.h"
#include "ui/window/open_documents.h"

namespace blossom::ui {

FileCommands::FileCommands(Commands& commands, Doers doers, QWidget* window)
    : QObject(window), commands_(commands), do_(doers), window_(window) {}

void FileCommands::add(QMenu& menu, const CommandSpec& spec, std::function<void()> go) {
  menu.addAction(commands_.add(spec, std::move(go)));
}

void FileCommands::addTo(QMenu& menu) {
  addOpening(menu);
  menu.addSeparator();
  addSaving(menu);
  menu.addSeparator();
  addTabs(menu);
  add(menu, {"file.quit", tr("File"), "quit", tr("&Quit"), tr("Close the workbench."), {QKeySequence::Quit}},
      [this] { window_->close(); });
  connect(&menu, &QMenu::aboutToShow, this, &FileCommands::fillRecent);
}

void FileCommands::addOpening(QMenu& menu) {
  const QString group = tr("File");
  add(menu, {"file.new", group, "new", tr("&New"), tr("Start an empty document."), {QKeySequence::New}},
      [this] { do_.documents.startNew(); });
  add(menu, {"file.open", group, "open", tr("&Open…"), tr("Open documents, or geometry in new ones."), {QKeySequence::Open}},
      [this] { do_.files.chooseAndOpen(); });
  recent_ = menu.addMenu(icon(QStringLiteral("recent")), tr("Open &recent"));
  recent_->setToolTipsVisible(true);
  QMenu* samples = menu.addMenu(icon(QStringLiteral("samples")), tr("Open a s&ample"));
  for (const QString& file : sampleFiles())
    samples->addAction(readableFileName(file), this, [this, file] { do_.files.open(file); });
  samples->setEnabled(!samples->isEmpty());
  add(menu, {"file.start-page", group, "home", tr("S&tart page"), tr("Show samples and recent documents.")},
      [this] { do_.documents.showStartPage(); });
}

void FileCommands::addSaving(QMenu& menu) {
  const QString group = tr("File");
  add(menu,
      {"file.import", group, "import", tr("&Import…"), tr("Add geometry from files to this document."), {tr("Ctrl+I")}},
      [this] { do_.files.chooseAndImport(); });
  add(menu,
      {"file.export",
       group,
       "export",
       tr("&Export…"),
       tr("Write the selected results, or all that is visible, as STEP, STL, a picture, …"),
       {tr("Ctrl+E")}},
      [this] { do_.exporting.choose(do_.documents.shown()); });
  menu.addSeparator();
  add(menu, {"file.save", group, "save", tr("&Save"), tr("Save this document."), {QKeySequence::Save}},
      [this] { do_.files.save(do_.documents.shown()); });
  add(menu,
      {"file.save-as",
       group,
       "save-as",
       tr("Save &as…"),
       tr("Save this document under another name."),
       {tr("Ctrl+Shift+S")}},
      [this] { do_.files.saveAs(do_.documents.shown()); });
}

void FileCommands::addTabs(QMenu& menu) {
  const QString group = tr("File");
  add(menu,
      {"file.next-tab",
       group,
       "forward",
       tr("Ne&xt document"),
       tr("Show the document in the next tab."),
       {tr("Ctrl+Tab"), tr("Ctrl+PgDown")}},
      [this] { do_.documents.show((do_.documents.current() + 1) % do_.documents.count()); });
  add(menu,
      {"file.previous-tab",
       group,
       "back",
       tr("&Previous document"),
       tr("Show the document in the tab before."),
       {tr("Ctrl+Shift+Tab"), tr("Ctrl+PgUp")}},
      [this] { do_.documents.show((do_.documents.current() + do_.documents.count() - 1) % do_.documents.count()); });
  menu.addSeparator();
  add(menu, {"file.close", group, "close", tr("&Close"), tr("Close this document."), {tr("Ctrl+W")}},
      [this] { do_.closing.close(do_.documents.current()); });
  add(menu, {"file.close-others", group, {}, tr("Close ot&hers"), tr("Close every document but this one.")},
      [this] { do_.closing.closeOthers(do_.documents.current()); });
}

void FileCommands::fillRecent() {
  recent_->clear();
  for (const RecentFile& each : RecentFiles::instance().list()) {
    const QFileInfo info(each.file);
    const QPixmap picture(each.missing ? QString() : SamplePictures::cached(each.file));
    const QString text = each.missing ? tr("%1 (not there any more)").arg(info.fileName()) : info.fileName();
    QAction* entry =
        recent_->addAction(picture.isNull() ? icon(QStringLiteral("document")) : QIcon(picture), text, this, [this, each] {
          if (!each.missing) return do_.files.open(each.file);
          RecentFiles::instance().remove(each.file);
        });
    entry->setToolTip(each.missing ? tr("Takes it off this list") : each.file);
  }
  const bool any = !recent_->isEmpty();
  if (any) {
    recent_->addSeparator();
    recent_->addAction(tr("Clear this list"), this, [] { RecentFiles::instance().clear(); });
  }
  recent_->setEnabled(any);
}

void FileCommands::refresh() {
  const Session& session = do_.documents.shown().session();
  const bool something = !session.document().features().empty(), unsaved = session.modified() || session.file().empty();
  const QString empty = tr("The document is empty.");
  commands_.setEnabled(QStringLiteral("file.export"), something, empty);
  commands_.setEnabled(QStringLiteral("file.save-as"), something, empty);
  commands_.setEnabled(QStringLiteral("file.save"), something && unsaved,
                       something ? tr("Nothing has changed since it was saved.") : empty);
}

}  // namespace blossom::ui
