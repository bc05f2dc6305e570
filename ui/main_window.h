#pragma once
#include <QMainWindow>
#include <filesystem>

#include "ui/manipulator.h"
#include "ui/session.h"

class QActionGroup;

namespace blossom::ui {

class DocumentTree;
class ErrorBar;
class FeatureMenus;
class PropertyPanel;
class StartPage;
class StatusLine;
class ViewWidget;

/// The workbench: document and properties on the left, the canvas, what went wrong above it, and the status line below.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(App app, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] ViewWidget& view() { return *view_; }
  [[nodiscard]] DocumentTree& tree() { return *tree_; }
  [[nodiscard]] PropertyPanel& properties() { return *properties_; }
  [[nodiscard]] ErrorBar& errors() { return *errors_; }
  /// Opens what the extension says: a document, or geometry in a new document. Asks first when changes would be lost.
  void openFile(const QString& file);

 protected:
  void closeEvent(QCloseEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  // main_window.cpp
  void buildLayout();
  void connectSession();
  void connectView();
  void refreshView();
  void refreshOverlay();
  void refreshStart();
  void fitWhenFirstShown();
  void selectionChanged();
  void showError(const Error&, const QString& file);
  // main_window_actions.cpp
  void buildActions();
  void buildFileMenu();
  void buildEditMenu();
  void buildViewMenu();
  void buildHelpMenu();
  void buildToolBar();
  void refreshActions();
  void refreshRecent();
  QAction* action(QMenu*, const QString& iconName, const QString& text, const QKeySequence&, const QString& help,
                  std::function<void()>);
  // main_window_files.cpp
  void newDocument();
  void chooseAndOpen();
  void chooseAndImport();
  void save(std::function<void()> then = {});
  void saveAs(std::function<void()> then = {});
  void chooseAndExport();
  /// Calls `go` at once, after saving, or never, as the user decides about unsaved changes.
  void guarded(std::function<void()> go);
  void remember(const QString& file);
  [[nodiscard]] QStringList recent() const;
  /// Adds the extension; false when that file exists and shall stay.
  bool completed(QString& file, const QString& extension);

  Session session_;
  ManipulatorRegistry manipulators_;
  FeatureMenus* featureMenus_;
  DocumentTree* tree_;
  PropertyPanel* properties_;
  ViewWidget* view_;
  ErrorBar* errors_;
  StatusLine* status_;
  StartPage* start_;
  QMenu* recentMenu_ = nullptr;
  QAction *open_ = nullptr, *import_ = nullptr, *save_ = nullptr, *saveAs_ = nullptr, *export_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr, *delete_ = nullptr, *rename_ = nullptr, *visible_ = nullptr, *fit_ = nullptr,
          *home_ = nullptr, *parallel_ = nullptr, *grid_ = nullptr;
  bool fitPending_ = true;
  bool closing_ = false;
};

}  // namespace blossom::ui
