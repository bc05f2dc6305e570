#pragma once
#include <QObject>
#include <QStringList>
#include <vector>

namespace blossom::ui {

struct RecentFile {
  QString file;  ///< absolute
  bool pinned = false;
  bool missing = false;
};

/// The recently opened documents, stored in QSettings. One instance per application.
class RecentFiles : public QObject {
  Q_OBJECT
 public:
  static RecentFiles& instance();

  /// Pinned ones first, then the latest.
  [[nodiscard]] std::vector<RecentFile> list() const;
  void add(const QString& file);
  void remove(const QString& file);
  void setPinned(const QString& file, bool);
  void clear();  ///< all but the pinned ones

 signals:
  void changed();
};

}  // namespace blossom::ui
