#pragma once
#include <QMainWindow>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "ui/commands/commands.h"
#include "ui/page/page.h"
#include "ui/plugin/manipulator.h"
#include "ui/window/action_state.h"

class QStackedWidget;

namespace blossom::ui {

class CommandPalette;
class DocumentCommands;
class DocumentTabs;
class FeatureMenus;
class LogAndJobs;
class StartPage;
class StatusLine;
struct UnsavedDocument;
class ViewCommands;

/// The workbench: open documents as tabs, each with its side and its canvas; commands above, the status line below.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(App app, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] DocumentPage& page() { return *pages_.at(current_); }  ///< the one that is shown; there always is one
  [[nodiscard]] std::size_t pageCount() const { return pages_.size(); }
  [[nodiscard]] DocumentPage& page(std::size_t index) { return *pages_.at(index); }
  [[nodiscard]] Commands& commands() { return commands_; }
  [[nodiscard]] CommandPalette& palette() { return *palette_; }
  [[nodiscard]] LogAndJobs& logAndJobs() { return *logAndJobs_; }
  [[nodiscard]] Session& session() { return page().session(); }
  [[nodiscard]] ViewWidget& view() { return page().view(); }
  [[nodiscard]] DocumentTree& tree() { return page().tree(); }
  [[nodiscard]] PropertyPanel& properties() { return page().properties(); }
  [[nodiscard]] ErrorBar& errors() { return page().errors(); }
  /// Opens what the extension says, a document or geometry, in a tab of its own; shows the tab of a file that is open
  /// already.
  void openFile(const QString& file, bool salvage = false);
  /// Several at once, each in a tab; what cannot be opened is told together.
  void openFiles(const QStringList& files);
  DocumentPage& addPage();  ///< an empty document in a new tab, which is shown
  void showPage(std::size_t index);
  void closePage(std::size_t index);  ///< asks first when changes would be lost; the last one becomes an empty document

 protected:
  void closeEvent(QCloseEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  // main_window.cpp
  void buildLayout();
  [[nodiscard]] std::size_t indexOf(const DocumentPage&) const;
  // main_window_pages.cpp
  void connectPage(DocumentPage&);
  void removePage(std::size_t index);
  // main_window_tabs.cpp
  void connectTabs();
  void refreshTabs();
  void refreshStart();
  void showStartPage();
  void newDocument();
  // main_window_close.cpp
  /// Documents whose changes nobody wants, as they were when that was said.
  using Discarded = std::map<const DocumentPage*, std::uint64_t>;
  using AfterQuestion = std::function<void(const Discarded&)>;
  /// Calls `go` at once, after saving, or never, as the user decides about the unsaved changes of a document.
  void guarded(DocumentPage&, const AfterQuestion& go);
  [[nodiscard]] std::vector<UnsavedDocument> unsaved(const std::vector<DocumentPage*>&) const;
  void guardedAll(const std::vector<DocumentPage*>&, const AfterQuestion& go);  ///< the same for several, asked once
  /// False when none of them writes a file; else `then` comes when the first has.
  bool waitsForWriting(const std::vector<DocumentPage*>&, const std::function<void()>& then);
  void saveInTurn(std::vector<DocumentPage*>, std::function<void()> then);
  void closeOthers(std::size_t index);
  // main_window_file_menu.cpp
  void buildFileMenu();
  void buildTabCommands(QMenu*);
  void refreshRecent();
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
  // main_window_palette.cpp
  void buildPalette();
  void buildStatus();
  // main_window_files.cpp
  void chooseAndOpen();
  void chooseAndImport();
  void importFiles(const QStringList& files);
  void takeTyping();  ///< what stands in a field and was not entered yet counts, too
  void save(DocumentPage&, std::function<void()> then = {});
  void saveAs(DocumentPage&, std::function<void()> then = {});
  void write(DocumentPage&, const QString& file, std::function<void()> then);
  void recover(const LostDocument&);
  void remember(const QString& file);
  // main_window_export.cpp
  void chooseAndExport();
  [[nodiscard]] std::vector<struct ExportScope> exportScopes();
  /// Adds the extension; false when that file exists and shall stay.
  bool completed(QString& file, const QString& extension);

  App app_;
  Commands commands_;
  ManipulatorRegistry manipulators_;
  std::vector<std::unique_ptr<DocumentPage>> pages_;
  std::size_t current_ = 0;
  FeatureMenus* featureMenus_;
  DocumentCommands* documentCommands_ = nullptr;
  CommandPalette* palette_ = nullptr;
  LogAndJobs* logAndJobs_ = nullptr;
  DocumentTabs* tabs_;
  QStackedWidget *sides_, *canvases_;
  StatusLine* status_;
  StartPage* start_;
  QMenu* recentMenu_ = nullptr;
  DocumentPage* startFor_ = nullptr;  // the page that the start page lies over while it is untouched
  ViewCommands* viewCommands_ = nullptr;
  ActionState actionsShow_;
  Discarded discarded_;  // what was answered when the window was to be closed
};

}  // namespace blossom::ui
