#pragma once
#include <QMainWindow>

#include "ui/commands/commands.h"
#include "ui/page/page.h"
#include "ui/plugin/manipulator.h"
#include "ui/window/action_state.h"
#include "ui/window/open_documents.h"

namespace blossom::ui {

class CommandPalette;
class DocumentClosing;
class DocumentCommands;
class DocumentExport;
class DocumentFiles;
class FeatureMenus;
class FileCommands;
class LogAndJobs;
class StatusLine;
class ViewCommands;

/// The workbench: open documents as tabs, each with its side and its canvas; commands above, the status line below.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(App app, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] DocumentPage& page() { return documents_.shown(); }  ///< the one that is shown; there always is one
  [[nodiscard]] std::size_t pageCount() const { return documents_.count(); }
  [[nodiscard]] DocumentPage& page(std::size_t index) { return documents_.at(index); }
  [[nodiscard]] Commands& commands() { return commands_; }
  [[nodiscard]] CommandPalette& palette() { return *palette_; }
  [[nodiscard]] LogAndJobs& logAndJobs() { return *logAndJobs_; }
  [[nodiscard]] Session& session() { return page().session(); }
  [[nodiscard]] ViewWidget& view() { return page().view(); }
  [[nodiscard]] DocumentTree& tree() { return page().tree(); }
  [[nodiscard]] PropertyPanel& properties() { return page().properties(); }
  [[nodiscard]] ErrorBar& errors() { return page().errors(); }
  void openFile(const QString& file, bool salvage = false);
  void openFiles(const QStringList& files);
  DocumentPage& addPage() { return documents_.add(); }
  void showPage(std::size_t index) { documents_.show(index); }
  void closePage(std::size_t index);

 protected:
  void closeEvent(QCloseEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  // main_window.cpp
  void connectDocuments();
  void buildLayout();
  void buildStatus();
  void buildPalette();
  void connectPage(DocumentPage&);
  void connectStatus(DocumentPage&);
  void connectFiles(DocumentPage&);
  void followShown();
  void openManual(const QString& page);
  // main_window_actions.cpp
  void buildActions();
  void buildEditMenu();
  void buildViewMenu();
  void buildThemeMenu(QMenu*);
  void buildHelpMenu();
  void buildToolBar();
  void refreshActions();
  void followState();
  QAction* add(QMenu*, const CommandSpec&, std::function<void()>);

  App app_;
  Commands commands_;
  ManipulatorRegistry manipulators_;
  OpenDocuments documents_;
  DocumentFiles* files_;
  DocumentClosing* closing_;
  FileCommands* fileCommands_;
  FeatureMenus* featureMenus_;
  DocumentCommands* documentCommands_ = nullptr;
  ViewCommands* viewCommands_ = nullptr;
  CommandPalette* palette_ = nullptr;
  LogAndJobs* logAndJobs_ = nullptr;
  StatusLine* status_;
  ActionState actionsShow_;
};

}  // namespace blossom::ui
