#pragma once
#include <QAbstractTableModel>
#include <QDateTime>
#include <map>
#include <vector>

#include "core/error.h"
#include "document/document.h"

namespace blossom::ui {

class DocumentPage;

/// What happened in every open document since the start: opened, saved, warnings, errors.
class LogList : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum class Level { Note, Warning, Error };
  enum Column { TimeColumn, DocumentColumn, MessageColumn, columns };
  enum Role { LevelRole = Qt::UserRole };

  using QAbstractTableModel::QAbstractTableModel;
  void watch(DocumentPage&);
  void add(Level, const QString& document, const QString& text);
  void clear();
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex&, int role) const override;

 private:
  struct Entry {
    QDateTime time;
    Level level;
    QString document, text;
  };
  /// What was said about a feature last, so that it is said once.
  using Said = std::map<FeatureId, QString>;
  void addResults(const DocumentPage&);

  std::vector<Entry> entries_;
  std::map<const DocumentPage*, Said> said_;
};

}  // namespace blossom::ui
