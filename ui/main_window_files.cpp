// Files of the main window: choosing them, and not losing what is unsaved.
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

#include "ui/document_tree.h"
#include "ui/export_dialog.h"
#include "ui/feature_menus.h"
#include "ui/main_window.h"
#include "ui/start_page.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

constexpr int mostRecent = 10;

QString documentFilter() { return MainWindow::tr("Blossom documents (*.blossom)"); }

QString lastFolder() {
  const QString folder = QSettings().value(QStringLiteral("folder")).toString();
  if (!folder.isEmpty() && QFileInfo(folder).isDir()) return folder;
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}
void rememberFolder(const QString& file) { QSettings().setValue(QStringLiteral("folder"), QFileInfo(file).absolutePath()); }

QStringList filesOf(const QMimeData* data) {
  QStringList files;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  return files;
}

}  // namespace

void MainWindow::guarded(DocumentPage& page, std::function<void()> go) {
  if (!page.session().modified()) return go();
  QMessageBox question(this);
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("Save the changes of %1?").arg(page.session().title()));
  question.setInformativeText(tr("Without saving, they are lost."));
  question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  question.setDefaultButton(QMessageBox::Save);
  const int answer = question.exec();
  if (answer == QMessageBox::Save)
    save(page, std::move(go));
  else if (answer == QMessageBox::Discard)
    go();
}

void MainWindow::openFile(const QString& file, bool salvage) {
  const std::filesystem::path path = file.toStdString();
  for (std::size_t i = 0; i < pages_.size() && !salvage; ++i)
    if (pages_[i]->session().file() == path) return showPage(i);
  if (!sampleFiles().contains(file)) rememberFolder(file);  // nobody saves beside the samples
  DocumentPage& target = page().untouched() || salvage ? page() : addPage();
  target.session().open(path, salvage);
}

void MainWindow::chooseAndOpen() {
  QStringList filters = readFilters(app_);
  filters.first().replace(QStringLiteral("("), QStringLiteral("(*.blossom "));
  filters.insert(1, documentFilter());
  const QString file = QFileDialog::getOpenFileName(this, tr("Open"), lastFolder(), filters.join(QStringLiteral(";;")));
  if (!file.isEmpty()) openFile(file);
}

void MainWindow::chooseAndImport() {
  const QStringList files =
      QFileDialog::getOpenFileNames(this, tr("Import"), lastFolder(), readFilters(app_).join(QStringLiteral(";;")));
  if (files.isEmpty()) return;
  rememberFolder(files.first());
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files) paths.emplace_back(file.toStdString());
  session().import(paths);
}

// The file dialog has asked about the name without the extension only.
bool MainWindow::completed(QString& file, const QString& extension) {
  file += extension;
  if (!QFileInfo::exists(file)) return true;
  QMessageBox question(this);
  question.setText(tr("%1 already exists.").arg(QFileInfo(file).fileName()));
  question.setInformativeText(tr("Saving replaces it."));
  QPushButton* replace = question.addButton(tr("Replace"), QMessageBox::AcceptRole);
  question.setDefaultButton(question.addButton(QMessageBox::Cancel));
  question.exec();
  return question.clickedButton() == replace;
}

void MainWindow::save(DocumentPage& page, std::function<void()> then) {
  if (page.session().file().empty())
    saveAs(page, std::move(then));
  else
    page.session().save(page.session().file(), std::move(then));
}

void MainWindow::saveAs(DocumentPage& page, std::function<void()> then) {
  const QString suggested = page.session().suggestedName(), name = suggested.isEmpty() ? tr("untitled") : suggested;
  QString file = QFileDialog::getSaveFileName(this, tr("Save as"), lastFolder() + u'/' + name + QStringLiteral(".blossom"),
                                              documentFilter());
  if (file.isEmpty()) return;
  if (!isDocument(file.toStdString()) && !completed(file, QStringLiteral(".blossom"))) return;
  rememberFolder(file);
  page.session().save(file.toStdString(), [this, file, then = std::move(then)] {
    remember(file);
    if (then) then();
  });
}

// The selected result, or the last one of the document.
void MainWindow::chooseAndExport() {
  FeatureId id = tree().selected().empty() ? FeatureId() : tree().current();
  if (id.empty() && !session().document().features().empty()) id = session().document().features().back()->id;
  const auto view = session().view(id);
  if (!view) return;
  const ShapeKind kind = view->result->evaluated.shape.kind();
  QStringList filters;
  for (const Format& format : session().app().formats->formats()) {
    if (!format.write || std::find(format.writes.begin(), format.writes.end(), kind) == format.writes.end()) continue;
    filters << QStringLiteral("%1 (*.%2)")
                   .arg(qt(format.title).replace(u'(', u'[').replace(u')', u']'), qt(format.extensions.front()));
  }
  if (filters.isEmpty())
    return page().showError(Error(ErrorCode::OutputNotSupported, "No format can hold this kind of result yet."), {});
  const QString name = qt(session().document().at(id).name).toLower().replace(u' ', u'-');
  QString chosen;
  QString file = QFileDialog::getSaveFileName(this, tr("Export"), lastFolder() + u'/' + name,
                                              filters.join(QStringLiteral(";;")), &chosen);
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty() && !completed(file, chosen.section(u'*', -1).chopped(1))) return;
  rememberFolder(file);
  const Format* format = session().app().formats->find(QFileInfo(file).suffix().toStdString());
  if (!format || format->writeOptions.empty()) return session().exportFeature(id, file.toStdString(), Value::object());
  auto* dialog = new ExportDialog(*format, file, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog, id, file] { session().exportFeature(id, file.toStdString(), dialog->options()); });
  dialog->open();
}

QStringList MainWindow::recent() const {
  QStringList files;
  for (const QString& file : QSettings().value(QStringLiteral("recent")).toStringList())
    if (QFileInfo::exists(file)) files << file;
  return files;
}

void MainWindow::remember(const QString& file) {
  QStringList files = recent();
  const QString full = QFileInfo(file).absoluteFilePath();
  files.removeAll(full);
  files.prepend(full);
  QSettings().setValue(QStringLiteral("recent"), QStringList(files.mid(0, mostRecent)));
}

// One document after the other is asked about; the first that shall stay keeps the window open.
void MainWindow::closeEvent(QCloseEvent* event) {
  if (closing_) return event->accept();
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    if (!pages_[i]->session().modified()) continue;
    event->ignore();
    showPage(i);
    return guarded(*pages_[i], [this, asked = pages_[i].get()] {
      if (pages_.size() > 1)
        removePage(indexOf(*asked));
      else
        closing_ = true;
      close();
    });
  }
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!filesOf(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

// A document replaces what is shown; geometry is added to it.
void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList files = filesOf(event->mimeData());
  if (files.isEmpty()) return;
  event->acceptProposedAction();
  if (files.size() == 1 && (isDocument(files.first().toStdString()) || session().document().features().empty()))
    return openFile(files.first());
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files)
    if (!isDocument(file.toStdString())) paths.emplace_back(file.toStdString());
  if (!paths.empty()) session().import(paths);
}

}  // namespace blossom::ui
