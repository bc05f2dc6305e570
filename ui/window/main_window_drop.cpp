// Files dropped on the main window.
#include <QDragEnterEvent>
#include <QMimeData>

#include "ui/window/main_window.h"

namespace blossom::ui {

namespace {

QStringList filesOf(const QMimeData* data) {
  QStringList files;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  return files;
}

}  // namespace

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!filesOf(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

// Documents open in tabs of their own; geometry is added to the document that is shown.
void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList files = filesOf(event->mimeData());
  if (files.isEmpty()) return;
  event->acceptProposedAction();
  QStringList documents, geometry;
  for (const QString& file : files) (isDocument(file.toStdString()) ? documents : geometry) << file;
  const bool openAlone = geometry.size() == 1 && session().document().features().empty();
  if (!geometry.isEmpty() && !openAlone) importFiles(geometry);
  if (openAlone) documents << geometry;
  if (!documents.isEmpty()) openFiles(documents);
}

}  // namespace blossom::ui
