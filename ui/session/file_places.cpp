#include "ui/session/file_places.h"

#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace blossom::ui {

QString lastFolder() {
  QString folder = QSettings().value(QStringLiteral("folder")).toString();
  if (!folder.isEmpty() && QFileInfo(folder).isDir()) return folder;
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void rememberFolder(const QString& file) { QSettings().setValue(QStringLiteral("folder"), QFileInfo(file).absolutePath()); }

}  // namespace blossom::ui
