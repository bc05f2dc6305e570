#include "ui/window/main_window.h"

#include <QKeyEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/parallel.h"
#include "ui/files/document_tabs.h"
#include "ui/files/recovery_bar.h"
#include "ui/files/start_page.h"
#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/page/feature_menus.h"
#include "ui/panel/fault_bar.h"
#include "ui/view/view_widget.h"
#include "ui/window/manipulator_loader.h"
#include "ui/window/status_line.h"

namespace blossom::ui {

namespace {

constexpr int sideWidth = 290;

QStringList problemsOf(const App& app) {
  QStringList problems;
  for (const LoadedPlugin& plugin : app.plugins)
    if (!plugin.problem.empty()) problems << qt(plugin.problem);
  return problems;
}

}  // namespace

MainWindow::MainWindow(App app, QWidget* parent)
    : QMainWindow(parent),
      app_(std::move(app)),
      commands_(this),
      featureMenus_(new FeatureMenus(app_, commands_, this)),
      tabs_(new DocumentTabs),
      sides_(new QStackedWidget),
      canvases_(new QStackedWidget),
      status_(new StatusLine),
      start_(new StartPage) {
  setAcceptDrops(true);
  setUnifiedTitleAndToolBarOnMac(true);
  QStringList problems = problemsOf(app_);
  for (const std::string& problem : loadManipulators(manipulators_, app_.plugins)) problems << qt(problem);
  buildActions();
  buildLayout();
  buildStatus();
  buildPalette();
  const auto limitThreads = [] { setThreadLimit(Preferences::instance().get<int>("threads")); };
  limitThreads();
  connect(&Preferences::instance(), &Preferences::changed, this, limitThreads);
  startFor_ = &addPage();
  refreshStart();
  status_->setHint(ViewWidget::idleHint());
  if (!problems.isEmpty()) errors().showNote(tr("Not every plugin could be loaded."), problems.join(u'\n'));
}

// Pages look at the registries and send signals to the window: they go first. Before that all is hidden, because what hides
// tells so, and there has to be a window to be told.
MainWindow::~MainWindow() {
  hide();
  for (const auto& page : pages_) page->disconnect(this);
  pages_.clear();
}

void MainWindow::buildLayout() {
  connectTabs();
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* lost = new RecoveryBar;
  connect(lost, &RecoveryBar::recoverWanted, this, &MainWindow::recover);
  connect(lost, &RecoveryBar::focusFreed, this, [this] { view().setFocus(); });
  column->addWidget(lost);
  column->addWidget(tabs_);
  column->addWidget(canvases_, 1);
  start_->setParent(canvases_);

  auto* across = new QSplitter(Qt::Horizontal);
  across->addWidget(sides_);
  across->addWidget(right);
  across->setSizes({sideWidth, 1100});
  across->setStretchFactor(1, 1);
  across->setHandleWidth(1);
  across->setChildrenCollapsible(false);

  setCentralWidget(across);
}

std::size_t MainWindow::indexOf(const DocumentPage& page) const {
  const auto found = std::find_if(pages_.begin(), pages_.end(), [&](const auto& other) { return other.get() == &page; });
  return static_cast<std::size_t>(found - pages_.begin());
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  const QAction* saving = commands_.action(QStringLiteral("file.save"));
  if (!saving->isEnabled() && saving->shortcut() == QKeySequence(event->keyCombination())) {
    takeTyping();  // the shortcut comes by here while nothing is known to be unsaved
    if (session().modified()) save(page());
    return;
  }
  if (event->key() != Qt::Key_Escape) return QMainWindow::keyPressEvent(event);
  if (page().toolStarted())
    page().endTool();
  else if (errors().isVisible())
    errors().hide();
  else if (session().evaluating())
    session().cancelEvaluation();  // what is being saved beside it goes on
  else if (session().job().running())
    session().job().cancel();
  else
    page().faults().hide();
}

}  // namespace blossom::ui
