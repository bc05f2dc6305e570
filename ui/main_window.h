#pragma once
#include <QMainWindow>
#include <filesystem>
#include <memory>
#include <vector>

#include "ui/commands.h"
#include "ui/manipulator.h"
#include "ui/page.h"

class QStackedWidget;
class QTabBar;

namespace blossom::ui {

class CommandPalette;
class DocumentCommands;
class FeatureMenus;
class LogAndJobs;
class StartPage;
class StatusLine;

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
  DocumentPage& addPage();  ///< an empty document in a new tab, which is shown
  void showPage(std::size_t index);
  void closePage(std::size_t index);  ///< asks first when changes would be lost; the last one becomes an empty document

 protected:
  void closeEvent(QCloseEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  // main_window.cpp
  void buildLayout();
  void refreshStart();
  void refreshTabs();
  [[nodiscard]] std::size_t indexOf(const DocumentPage&) const;
  // main_window_pages.cpp
  void connectPage(DocumentPage&);
  void removePage(std::size_t index);
  // main_window_actions.cpp
  void buildActions();
  void buildFileMenu();
  void buildEditMenu();
  void buildViewMenu();
  void buildHelpMenu();
  void buildToolBar();
  void refreshActions();
  void refreshRecent();
  QAction* add(QMenu*, const CommandSpec&, std::function<void()>);
  // main_window_palette.cpp
  void buildPalette();
  void buildStatus();
  // main_window_files.cpp
  void chooseAndOpen();
  void chooseAndImport();
  void save(DocumentPage&, std::function<void()> then = {});
  void saveAs(DocumentPage&, std::function<void()> then = {});
  void chooseAndExport();
  /// Calls `go` at once, after saving, or never, as the user decides about the unsaved changes of a document.
  void guarded(DocumentPage&, std::function<void()> go);
  void remember(const QString& file);
  [[nodiscard]] QStringList recent() const;
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
  QTabBar* tabs_;
  QStackedWidget *sides_, *canvases_;
  StatusLine* status_;
  StartPage* start_;
  QMenu* recentMenu_ = nullptr;
  bool closing_ = false;
};

}  // namespace blossom::ui
