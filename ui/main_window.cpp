#include "ui/main_window.h"

#include <QKeyEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/error_bar.h"
#include "ui/feature_menus.h"
#include "ui/manipulator_loader.h"
#include "ui/start_page.h"
#include "ui/status_line.h"
#include "ui/text.h"
#include "ui/view_widget.h"

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
      tabs_(new QTabBar),
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
  connect(start_, &StartPage::openWanted, this, &MainWindow::chooseAndOpen);
  connect(start_, &StartPage::importWanted, this, &MainWindow::chooseAndImport);
  connect(start_, &StartPage::fileChosen, this, [this](const QString& file) { openFile(file); });
  addPage();
  status_->setHint(ViewWidget::idleHint());
  if (!problems.isEmpty()) errors().showNote(tr("Not every plugin could be loaded."), problems.join(u'\n'));
}

// Pages look at the registries and send signals to the window: they go first.
MainWindow::~MainWindow() {
  for (const auto& page : pages_) page->disconnect(this);
  pages_.clear();
}

void MainWindow::buildLayout() {
  tabs_->setObjectName(QStringLiteral("documentTabs"));
  tabs_->setTabsClosable(true);
  tabs_->setMovable(false);
  tabs_->setExpanding(false);
  tabs_->setDrawBase(false);
  tabs_->setElideMode(Qt::ElideMiddle);
  tabs_->setFocusPolicy(Qt::NoFocus);
  connect(tabs_, &QTabBar::currentChanged, this, [this](int index) {
    if (index >= 0 && static_cast<std::size_t>(index) < pages_.size()) showPage(static_cast<std::size_t>(index));
  });
  connect(tabs_, &QTabBar::tabCloseRequested, this, [this](int index) { closePage(static_cast<std::size_t>(index)); });

  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
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

// A single document needs no tabs.
void MainWindow::refreshTabs() {
  const QSignalBlocker quiet(tabs_);
  while (tabs_->count() > static_cast<int>(pages_.size())) tabs_->removeTab(tabs_->count() - 1);
  while (tabs_->count() < static_cast<int>(pages_.size())) tabs_->addTab({});
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    const Session& shown = pages_[i]->session();
    const int tab = static_cast<int>(i);
    tabs_->setTabText(tab, shown.modified() ? shown.title() + QStringLiteral(" •") : shown.title());
    tabs_->setTabToolTip(tab, shown.file().empty() ? tr("Not saved yet") : qt(shown.file().string()));
  }
  tabs_->setCurrentIndex(static_cast<int>(current_));
  tabs_->setVisible(pages_.size() > 1 || !page().untouched());
}

void MainWindow::refreshStart() {
  const bool empty = page().untouched();
  if (empty) {
    start_->setRecent(recent());
    start_->move(std::max(12, (canvases_->width() - start_->width()) / 2),
                 std::max(12, (canvases_->height() - start_->height()) / 2));
    start_->raise();
  }
  start_->setVisible(empty);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  QMetaObject::invokeMethod(this, &MainWindow::refreshStart, Qt::QueuedConnection);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QMainWindow::keyPressEvent(event);
  if (page().toolStarted())
    page().endTool();
  else if (errors().isVisible())
    errors().hide();
  else if (session().evaluating() || session().job().running())
    session().cancel();
}

}  // namespace blossom::ui
