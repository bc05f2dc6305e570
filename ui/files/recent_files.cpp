#include "ui/files/recent_files.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace blossom::ui {

namespace {

constexpr int maximumRecent = 12;
const QString recentKey = QStringLiteral("recent");
const QString pinnedKey = QStringLiteral("recent-pinned");

QStringList stored(const QString& key) { return QSettings().value(key).toStringList(); }

}  // namespace

RecentFiles& RecentFiles::instance() {
  static RecentFiles files;
  return files;
}

std::vector<RecentFile> RecentFiles::list() const {
  std::vector<RecentFile> files;
  const QStringList pinned = stored(pinnedKey);
  for (const QString& file : stored(recentKey))
    files.push_back({file, static_cast<bool>(pinned.contains(file)), !QFileInfo::exists(file)});
  std::stable_partition(files.begin(), files.end(), [](const RecentFile& each) { return each.pinned; });
  return files;
}

void RecentFiles::add(const QString& file) {
  const QString full = QFileInfo(file).absoluteFilePath();
  QStringList files = stored(recentKey);
  files.removeAll(full);
  files.prepend(full);
  const QStringList pinned = stored(pinnedKey);
  for (qsizetype i = files.size() - 1; i > 0 && files.size() > maximumRecent; --i)
    if (!pinned.contains(files[i])) files.removeAt(i);
  QSettings().setValue(recentKey, files);
  emit changed();
}

void RecentFiles::remove(const QString& file) {
  for (const QString& key : {recentKey, pinnedKey}) {
    QStringList files = stored(key);
    if (files.removeAll(file) > 0) QSettings().setValue(key, files);
  }
  emit changed();
}

void RecentFiles::setPinned(const QString& file, bool wanted) {
  QStringList pinned = stored(pinnedKey);
  pinned.removeAll(file);
  if (wanted) pinned << file;
  QSettings().setValue(pinnedKey, pinned);
  emit changed();
}

void RecentFiles::clear() {
  QSettings().setValue(recentKey, stored(pinnedKey));
  emit changed();
}

}  // namespace blossom::ui
