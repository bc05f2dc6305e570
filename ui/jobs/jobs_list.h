#pragma once
#include <QAbstractListModel>
#include <QDateTime>
#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/error.h"

namespace blossom::ui {

class DocumentPage;

/// Computations, reads and writes of all open documents with their results. Very short evaluations are left out, because
/// every edit causes one.
class JobsList : public QAbstractListModel {
  Q_OBJECT
 public:
  enum class State { Running, Done, Cancelled, Failed };
  enum Role { DocumentRole = Qt::UserRole, StateRole, StageRole, FractionRole, TimeRole, MessageRole };

  explicit JobsList(QObject* parent = nullptr);
  ~JobsList() override;
  void watch(DocumentPage&);
  void cancel(int row);
  void clearFinished();
  [[nodiscard]] int running() const;
  int rowCount(const QModelIndex& parent = {}) const override;  ///< newest first
  QVariant data(const QModelIndex&, int role) const override;

 signals:
  void runningChanged(int count);

 private:
  enum class Kind { File, Evaluation };
  struct Record {
    QPointer<DocumentPage> page;
    Kind kind;
    QString document, title, stage, message;
    double fraction = 0;
    State state = State::Running;
    QElapsedTimer clock;
    qint64 ms = 0;
  };
  /// An evaluation too short so far to be listed.
  struct Starting {
    QElapsedTimer clock;
    QTimer patience;
    double fraction = 0;
    QString stage;
  };

  void watchFiles(DocumentPage&);
  void watchEvaluations(DocumentPage&);
  void begin(DocumentPage&, Kind, const QString& title, const QElapsedTimer&);
  void progress(const DocumentPage&, Kind, double fraction, const QString& stage);
  void end(const DocumentPage&, Kind, State, const QString& message = {});
  void finish(Record&, State, const QString& message);
  void endEvaluation(const DocumentPage&);
  void forgetStarted(const DocumentPage*);
  [[nodiscard]] Record* find(const DocumentPage&, Kind);
  void changed(const Record&);
  void countChanged();

  std::vector<Record> records_;  // oldest first
  std::map<const DocumentPage*, std::unique_ptr<Starting>> starting_;
  QTimer tick_;  // the time taken so far
};

/// "0.8 s", "2 min 05 s".
QString timeTaken(qint64 ms);

}  // namespace blossom::ui
