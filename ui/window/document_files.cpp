#include "ui/window/document_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>

#include "document/shown.h"
#include "ui/files/document_picture.h"
#include "ui/files/recent_files.h"
#include "ui/files/start_page.h"
#include "ui/look/text.h"
#include "ui/page/feature_menus.h"
#include "ui/page/page.h"
#include "ui/panel/error_bar.h"
#include "ui/session/file_places.h"
#include "ui/window/open_documents.h"

namespace blossom::ui {

namespace {

QString documentFilter() { return DocumentFiles::tr("Blossom documents (*.blossom)"); }

/// As far as it can be told without reading it; empty when it may be opened.
QString problemWith(const App& app, const QString& file) {
  const QFileInfo info(file);
  if (info.isDir()) return DocumentFiles::tr("%1 is a folder. Open the files in it instead.").arg(QDir(file).absolutePath());
  if (!info.isFile()) return DocumentFiles::tr("%1 is not there.").arg(info.fileName());
  const Format* format = app.formats->find(info.suffix().toStdString());
  if (isDocument(file.toStdString()) || (format && format->read)) return {};
  return DocumentFiles::tr("%1 has no extension that Blossom reads.").arg(info.fileName());
}

std::vector<Shape> visibleShapes(const Session& session) {
  const auto shapeOf = [&](const FeatureId& id) { return session.shape(id); };
  std::vector<Shape> shapes;
  for (const FeatureId& id : shownFeatures(session.document(), *session.app().registry, shapeOf))
    shapes.push_back(*session.shape(id));
  return shapes;
}

}  // namespace

DocumentFiles::DocumentFiles(App app, OpenDocuments& documents, QWidget* window)
    : QObject(window), app_(std::move(app)), documents_(documents), window_(window) {}

void DocumentFiles::open(const QString& file, bool salvage) {
  const QString full = QFileInfo(file).absoluteFilePath();
  const std::filesystem::path path = full.toStdString();
  for (std::size_t i = 0; i < documents_.count() && !salvage; ++i)
    if (documents_.at(i).session().file() == path) return documents_.show(i);
  if (!sampleFiles().contains(full)) rememberFolder(full);  // nobody saves beside the samples
  documents_.placeToOpen().session().open(path, salvage);
  documents_.refreshStart();
}

void DocumentFiles::open(const QStringList& files) {
  if (files.size() == 1 && !QFileInfo(files.first()).isDir())
    return open(files.first());  // its own page says what is wrong with it
  QStringList problems;
  for (const QString& file : files) {
    const QString problem = problemWith(app_, file);
    if (problem.isEmpty())
      open(file);
    else
      problems << problem;
  }
  if (problems.isEmpty()) return;
  const QString text = files.size() == 1 ? tr("This cannot be opened.")
                                         : tr("%1 of %2 files cannot be opened.").arg(problems.size()).arg(files.size());
  const auto tell = [shown = &documents_.shown(), text, problems] { shown->errors().showError(text, problems.join(u'\n')); };
  if (documents_.shown().session().job().running())  // what is read now will start with a clean slate
    connect(&documents_.shown(), &DocumentPage::opened, this, tell, Qt::SingleShotConnection);
  else
    tell();
}

void DocumentFiles::chooseAndOpen() {
  QStringList filters = readFilters(app_);
  filters.first().replace(QStringLiteral("("), QStringLiteral("(*.blossom "));
  filters.insert(1, documentFilter());
  const QStringList files =
      QFileDialog::getOpenFileNames(window_, tr("Open"), lastFolder(), filters.join(QStringLiteral(";;")));
  if (!files.isEmpty()) open(files);
}

void DocumentFiles::chooseAndImport() {
  const QStringList files =
      QFileDialog::getOpenFileNames(window_, tr("Import"), lastFolder(), readFilters(app_).join(QStringLiteral(";;")));
  if (!files.isEmpty()) importFiles(files);
}

void DocumentFiles::importFiles(const QStringList& files) {
  rememberFolder(files.first());
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files) paths.emplace_back(file.toStdString());
  documents_.shown().endQuestion();
  documents_.shown().session().import(paths);
  documents_.refreshStart();
}

void DocumentFiles::takeTyping() {
  QWidget* const typing = window_->focusWidget();
  if (typing) typing->clearFocus();
}

void DocumentFiles::save(DocumentPage& page, std::function<void()> then) {
  takeTyping();
  const QString file = qt(page.session().file().string());
  if (file.isEmpty()) return saveAs(page, std::move(then));
  if (!page.session().changedOnDisk() || !QFileInfo::exists(file)) return write(page, file, std::move(then));
  QMessageBox question(window_);
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

void DocumentFiles::saveAs(DocumentPage& page, std::function<void()> then) {
  takeTyping();
  const QString suggested = page.session().suggestedName(), name = suggested.isEmpty() ? tr("untitled") : suggested;
  const QString current = qt(page.session().file().parent_path().string());
  QString file = QFileDialog::getSaveFileName(
      window_, tr("Save as"), (current.isEmpty() ? lastFolder() : current) + u'/' + name + QStringLiteral(".blossom"),
      documentFilter());
  if (file.isEmpty()) return;
  if (!isDocument(file.toStdString()) && !completed(file, QStringLiteral(".blossom"), window_)) return;
  rememberFolder(file);
  write(page, file, std::move(then));
}

void DocumentFiles::write(DocumentPage& page, const QString& file, std::function<void()> then) {
  page.session().save(file.toStdString(), [file, page = &page, then = std::move(then)] {
    remember(file);
    keepPicture(visibleShapes(page->session()), file);
    if (then) then();
  });
}

void DocumentFiles::remember(const QString& file) {
  if (!sampleFiles().contains(file)) RecentFiles::instance().add(file);
}

void DocumentFiles::recover(const LostDocument& lost) {
  documents_.placeToOpen().session().recover(lost);
  documents_.refreshStart();
}

QStringList DocumentFiles::filesIn(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  return files;
}

void DocumentFiles::drop(const QMimeData& data) {
  QStringList documents, geometry;
  for (const QString& file : filesIn(data)) (isDocument(file.toStdString()) ? documents : geometry) << file;
  const bool openAlone = geometry.size() == 1 && documents_.shown().document().features().empty();
  if (!geometry.isEmpty() && !openAlone) importFiles(geometry);
  if (openAlone) documents << geometry;
  if (!documents.isEmpty()) open(documents);
}

bool completed(QString& file, const QString& extension, QWidget* window) {
  file += extension;
  if (!QFileInfo::exists(file)) return true;
  QMessageBox question(window);
  question.setText(DocumentFiles::tr("%1 already exists.").arg(QFileInfo(file).fileName()));
  question.setInformativeText(DocumentFiles::tr("Saving replaces it."));
  QPushButton* replace = question.addButton(DocumentFiles::tr("Replace"), QMessageBox::AcceptRole);
  question.setDefaultButton(question.addButton(QMessageBox::Cancel));
  question.exec();
  return question.clickedButton() == replace;
}

}  // namespace blossom::ui
