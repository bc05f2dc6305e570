#pragma once
#include <QObject>

class QDockWidget;
class QMainWindow;
class QMenu;

namespace blossom::ui {

class Commands;
class DocumentPage;
class JobsList;
class JobsPanel;
class LogList;
class LogPanel;

/// The docks at the lower edge of the window: jobs and log of all documents. Hidden at first; they remember their state.
class LogAndJobs : public QObject {
  Q_OBJECT
 public:
  LogAndJobs(QMainWindow&, Commands&);
  void addTo(QMenu& view);
  void watch(DocumentPage&);
  void restore();  ///< as they were when the window was closed last
  void toggleJobs();
  [[nodiscard]] JobsList& jobs() { return *jobs_; }
  [[nodiscard]] LogList& log() { return *log_; }
  [[nodiscard]] QDockWidget& jobsDock() { return *jobsDock_; }
  [[nodiscard]] QDockWidget& logDock() { return *logDock_; }

 signals:
  void hint(const QString&);

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  QDockWidget* dock(const char* name, const QString& title, QWidget* content, const QString& command);
  void toggle(QDockWidget&, const char* command);
  QMainWindow& window_;
  Commands& commands_;
  JobsList* jobs_;
  LogList* log_;
  QDockWidget *jobsDock_, *logDock_;
};

}  // namespace blossom::ui
