// Files of the main window: choosing, opening, importing, saving, recovering.
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "ui/files/document_picture.h"
#include "ui/files/recent_files.h"
#include "ui/files/start_page.h"
#include "ui/look/text.h"
#include "ui/page/feature_menus.h"
#include "ui/panel/error_bar.h"
#include "ui/session/file_places.h"
#include "ui/window/main_window.h"

namespace blossom::ui {

namespace {

QString documentFilter() { return MainWindow::tr("Blossom documents (*.blossom)"); }

/// As far as it can be told without reading it; empty when it may be opened.
QString problemWith(const App& app, const QString& file) {
  const QFileInfo info(file);
  if (!info.isFile()) return MainWindow::tr("%1 is not there.").arg(info.fileName());
  const Format* format = app.formats->find(info.suffix().toStdString());
  if (isDocument(file.toStdString()) || (format && format->read)) return {};
  return MainWindow::tr("%1 has no extension that Blossom reads.").arg(info.fileName());
}

std::vector<Shape> visibleShapes(const Session& session) {
  std::vector<Shape> shapes;
  for (const auto& feature : session.document().features()) {
    const auto view = session.view(feature->id);
    if (feature->visible && !feature->suppressed && view && !view->result->evaluated.shape.empty())
      shapes.push_back(view->result->evaluated.shape);
  }
  return shapes;
}

}  // namespace

void MainWindow::openFile(const QString& file, bool salvage) {
  const QString full = QFileInfo(file).absoluteFilePath();
  const std::filesystem::path path = full.toStdString();
  for (std::size_t i = 0; i < pages_.size() && !salvage; ++i)
    if (pages_[i]->session().file() == path) return showPage(i);
  if (!sampleFiles().contains(full)) rememberFolder(full);  // nobody saves beside the samples
  DocumentPage& target = page().untouched() ? page() : addPage();
  target.session().open(path, salvage);
  refreshStart();
}

void MainWindow::openFiles(const QStringList& files) {
  if (files.size() == 1) return openFile(files.first());  // its own page says what is wrong with it
  QStringList problems;
  for (const QString& file : files) {
    const QString problem = problemWith(app_, file);
    if (problem.isEmpty())
      openFile(file);
    else
      problems << problem;
  }
  if (problems.isEmpty()) return;
  const auto tell = [shown = &page(), text = tr("%1 of %2 files cannot be opened.").arg(problems.size()).arg(files.size()),
                     problems] { shown->errors().showError(text, problems.join(u'\n')); };
  if (session().job().running())  // what is read now will start with a clean slate
    connect(&page(), &DocumentPage::opened, this, tell, Qt::SingleShotConnection);
  else
    tell();
}

void MainWindow::chooseAndOpen() {
  QStringList filters = readFilters(app_);
  filters.first().replace(QStringLiteral("("), QStringLiteral("(*.blossom "));
  filters.insert(1, documentFilter());
  const QStringList files =
      QFileDialog::getOpenFileNames(this, tr("Open"), lastFolder(), filters.join(QStringLiteral(";;")));
  if (!files.isEmpty()) openFiles(files);
}

void MainWindow::chooseAndImport() {
  const QStringList files =
      QFileDialog::getOpenFileNames(this, tr("Import"), lastFolder(), readFilters(app_).join(QStringLiteral(";;")));
  if (!files.isEmpty()) importFiles(files);
}

void MainWindow::importFiles(const QStringList& files) {
  rememberFolder(files.first());
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files) paths.emplace_back(file.toStdString());
  session().import(paths);
  refreshStart();
}

void MainWindow::takeTyping() {
  QWidget* const typing = focusWidget();
  if (typing) typing->clearFocus();
}

void MainWindow::save(DocumentPage& page, std::function<void()> then) {
  takeTyping();
  const QString file = qt(page.session().file().string());
  if (file.isEmpty()) return saveAs(page, std::move(then));
  if (!page.session().changedOnDisk() || !QFileInfo::exists(file)) return write(page, file, std::move(then));
  QMessageBox question(this);
  question.setText(tr("%1 was changed by another program.").arg(QFileInfo(file).fileName()));
  question.setInformativeText(
      tr("Since it was opened here, somebody else has written it. Saving replaces what they wrote."));
  QPushButton* replace = question.addButton(tr("Replace"), QMessageBox::DestructiveRole);
  QPushButton* elsewhere = question.addButton(tr("Save as…"), QMessageBox::AcceptRole);
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(elsewhere);
  question.exec();
  if (question.clickedButton() == replace) return write(page, file, std::move(then));
  if (question.clickedButton() == elsewhere) saveAs(page, std::move(then));
}

void MainWindow::saveAs(DocumentPage& page, std::function<void()> then) {
  takeTyping();
  const QString suggested = page.session().suggestedName(), name = suggested.isEmpty() ? tr("untitled") : suggested;
  const QString current = qt(page.session().file().parent_path().string());
  QString file = QFileDialog::getSaveFileName(
      this, tr("Save as"), (current.isEmpty() ? lastFolder() : current) + u'/' + name + QStringLiteral(".blossom"),
      documentFilter());
  if (file.isEmpty()) return;
  if (!isDocument(file.toStdString()) && !completed(file, QStringLiteral(".blossom"))) return;
  rememberFolder(file);
  write(page, file, std::move(then));
}

void MainWindow::write(DocumentPage& page, const QString& file, std::function<void()> then) {
  page.session().save(file.toStdString(), [this, file, page = &page, then = std::move(then)] {
    remember(file);
    keepPicture(visibleShapes(page->session()), file);
    if (then) then();
  });
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

void MainWindow::remember(const QString& file) {
  if (!sampleFiles().contains(file)) RecentFiles::instance().add(file);
}

void MainWindow::recover(const LostDocument& lost) {
  DocumentPage& target = page().untouched() ? page() : addPage();
  target.session().recover(lost);
  refreshStart();
}

}  // namespace blossom::ui
