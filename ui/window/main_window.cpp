#include "ui/window/main_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>

#include "core/parallel.h"
#include "ui/files/document_tabs.h"
#include "ui/files/recovery_bar.h"
#include "ui/help/help_menu.h"
#include "ui/help/manual_pages.h"
#include "ui/help/manual_window.h"
#include "ui/jobs/jobs_list.h"
#include "ui/jobs/log_and_jobs.h"
#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/page/document_commands.h"
#include "ui/page/feature_menus.h"
#include "ui/page/view_commands.h"
#include "ui/palette/command_palette.h"
#include "ui/panel/fault_bar.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"
#include "ui/window/document_closing.h"
#include "ui/window/document_export.h"
#include "ui/window/document_files.h"
#include "ui/window/file_commands.h"
#include "ui/window/manipulator_loader.h"
#include "ui/window/palette_sources.h"
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
      documents_(app_, manipulators_),
      files_(new DocumentFiles(app_, documents_, this)),
      closing_(new DocumentClosing(documents_, *files_, this)),
      fileCommands_(new FileCommands(commands_, {documents_, *files_, *closing_, *new DocumentExport(app_, this)}, this)),
      featureMenus_(new FeatureMenus(app_, commands_, this)),
      status_(new StatusLine) {
  setAcceptDrops(true);
  setUnifiedTitleAndToolBarOnMac(true);
  QStringList problems = problemsOf(app_);
  for (const std::string& problem : loadManipulators(manipulators_, app_.plugins)) problems << qt(problem);
  buildActions();
  connectDocuments();
  buildLayout();
  buildStatus();
  buildPalette();
  const auto limitThreads = [] { setThreadLimit(Preferences::instance().get<int>("threads")); };
  limitThreads();
  connect(&Preferences::instance(), &Preferences::changed, this, limitThreads);
  documents_.begin();
  status_->setHint(ViewWidget::idleHint());
  if (!problems.isEmpty()) errors().showNote(tr("Not every plugin could be loaded."), problems.join(u'\n'));
}

// Pages look at the registries and send signals to the window: they go first. Before that all is hidden, because what hides
// tells so, and there has to be a window to be told.
MainWindow::~MainWindow() {
  hide();
  documents_.end();
}

void MainWindow::connectDocuments() {
  connect(&documents_, &OpenDocuments::added, this, [this](DocumentPage* page) { connectPage(*page); });
  connect(&documents_, &OpenDocuments::removing, this, [this](DocumentPage* page) { page->disconnect(this); });
  connect(&documents_, &OpenDocuments::shownChanged, this, &MainWindow::followShown);
  connect(&documents_, &OpenDocuments::closeWanted, closing_, &DocumentClosing::close);
  connect(&documents_, &OpenDocuments::closeOthersWanted, closing_, &DocumentClosing::closeOthers);
  connect(&documents_, &OpenDocuments::saveWanted, files_, [this](DocumentPage* page) { files_->save(*page); });
  connect(&documents_, &OpenDocuments::openWanted, files_, &DocumentFiles::chooseAndOpen);
  connect(&documents_, &OpenDocuments::importWanted, files_, &DocumentFiles::chooseAndImport);
  connect(&documents_, &OpenDocuments::fileChosen, files_, [this](const QString& file) { files_->open(file); });
  connect(closing_, &DocumentClosing::announced, status_, &StatusLine::announce);
}

void MainWindow::buildLayout() {
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* lost = new RecoveryBar;
  connect(lost, &RecoveryBar::recoverWanted, files_, &DocumentFiles::recover);
  connect(lost, &RecoveryBar::focusFreed, this, [this] { view().setFocus(); });
  column->addWidget(lost);
  column->addWidget(documents_.tabs());
  column->addWidget(documents_.canvases(), 1);

  auto* across = new QSplitter(Qt::Horizontal);
  across->addWidget(documents_.sides());
  across->addWidget(right);
  across->setSizes({sideWidth, 1100});
  across->setStretchFactor(1, 1);
  across->setHandleWidth(1);
  across->setChildrenCollapsible(false);

  setCentralWidget(across);
}

void MainWindow::buildStatus() {
  auto* bar = new QStatusBar;
  bar->setSizeGripEnabled(false);
  bar->addWidget(status_, 1);
  setStatusBar(bar);
  status_->setStandingHint(
      tr("%1: find a command · Drop files to open them")
          .arg(commands_.action(QStringLiteral("edit.find-command"))->shortcut().toString(QKeySequence::NativeText)));
  connect(&commands_, &Commands::hint, status_, &StatusLine::setHint);
  connect(status_, &StatusLine::cancelled, this, [this] {
    session().cancel();
    page().cancelStudies();
  });
  connect(status_, &StatusLine::jobsWanted, logAndJobs_, &LogAndJobs::toggleJobs);
  connect(&logAndJobs_->jobs(), &JobsList::runningChanged, status_, &StatusLine::setJobs);
  connect(logAndJobs_, &LogAndJobs::hint, status_, &StatusLine::setHint);
  logAndJobs_->restore();
}

void MainWindow::buildPalette() {
  palette_ = new CommandPalette(this);
  palette_->addSource(commandEntries(commands_, *featureMenus_));
  palette_->addSource(featureEntries([this]() -> DocumentPage& { return page(); }));
  palette_->addSource(fileEntries([this](const QString& file) { files_->open(file); }));
  palette_->addSource(
      manualEntries([this] { return ManualPages(app_, commands_); }, [this](const QString& name) { openManual(name); }));
  // When it has closed, the line tells again what it told before it opened.
  connect(palette_, &CommandPalette::hint, this, [this](const QString& text) {
    const bool ofView = text.isEmpty() && (page().toolStarted() || view().underMouse());
    status_->setHint(ofView ? view().restingHint() : text);
  });
}

void MainWindow::openManual(const QString& page) {
  if (auto* help = findChild<HelpMenu*>()) help->openManual(page);
}

void MainWindow::connectPage(DocumentPage& page) {
  logAndJobs_->watch(page);
  connectStatus(page);
  connectFiles(page);
  DocumentPage* const sender = &page;
  connect(sender, &DocumentPage::selectionChanged, this, [this, sender] {
    if (sender != &this->page()) return;
    featureMenus_->setSelection(tree().selectedInTurn());
    followState();
  });
  connect(sender, &DocumentPage::stateChanged, this, [this, sender] {
    if (sender == &this->page()) followState();
  });
  connect(sender, &DocumentPage::toolChanged, this, [this, sender] {
    if (sender == &this->page()) viewCommands_->refresh();
  });
  connect(sender, &DocumentPage::contextMenuWanted, this, [this, sender](const QPoint& global) {
    if (sender == &this->page()) documentCommands_->popup(global);
  });
  connect(sender, &DocumentPage::manualWanted, this, &MainWindow::openManual);
}

/// What the status line tells of the page that is shown.
void MainWindow::connectStatus(DocumentPage& page) {
  DocumentPage* const sender = &page;
  const auto whenShown = [this, sender](auto tell) {
    return [this, sender, tell](const auto&... values) {
      if (sender == &this->page()) (status_->*tell)(values...);
    };
  };
  connect(sender, &DocumentPage::hint, this, whenShown(&StatusLine::setHint));
  connect(sender, &DocumentPage::whereabouts, this, whenShown(&StatusLine::setWhereabouts));
  connect(sender, &DocumentPage::announced, this, whenShown(&StatusLine::announce));
  connect(sender, &DocumentPage::workChanged, this, whenShown(&StatusLine::setWork));
  connect(sender, &DocumentPage::workEnded, this, whenShown(&StatusLine::endWork));
}

void MainWindow::connectFiles(DocumentPage& page) {
  DocumentPage* const sender = &page;
  connect(sender, &DocumentPage::opened, this, [sender] {
    if (!sender->session().file().empty()) DocumentFiles::remember(qt(sender->session().file().string()));
  });
  connect(&sender->session(), &Session::saveFailed, this,
          [this, sender] { sender->errors().offer(tr("Save as…"), [this, sender] { files_->saveAs(*sender); }); });
  connect(&sender->session(), &Session::unsafe, this, [sender](const Error& error) {
    sender->errors().showError(
        tr("No safety copy of %1 can be kept: %2").arg(sender->session().title(), qt(error.message())), qt(error.hint()));
  });
  connect(sender, &DocumentPage::salvageWanted, this, [this](const QString& file) { files_->open(file, true); });
}

void MainWindow::followShown() {
  DocumentPage& shown = page();
  featureMenus_->setPage(&shown);
  documentCommands_->setPage(&shown);
  featureMenus_->setSelection(shown.tree().selectedInTurn());
  for (const char* key : {"a", "b", "c"}) status_->endWork(QLatin1String(key));
  status_->setHint(shown.tool() ? shown.tool()->hint() : ViewWidget::idleHint());
  refreshActions();
}

void MainWindow::openFile(const QString& file, bool salvage) { files_->open(file, salvage); }

void MainWindow::openFiles(const QStringList& files) { files_->open(files); }

void MainWindow::closePage(std::size_t index) { closing_->close(index); }

// Whatever is asked, the button that drags is let go over the question.
void MainWindow::closeEvent(QCloseEvent* event) {
  view().takeDragBack();
  event->setAccepted(closing_->mayCloseAll());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!DocumentFiles::filesIn(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (DocumentFiles::filesIn(*event->mimeData()).isEmpty()) return;
  event->acceptProposedAction();
  files_->drop(*event->mimeData());
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  const QAction* saving = commands_.action(QStringLiteral("file.save"));
  if (!saving->isEnabled() && saving->shortcut() == QKeySequence(event->keyCombination())) {
    files_->takeTyping();  // the shortcut comes by here while nothing is known to be unsaved
    if (session().modified()) files_->save(page());
    return;
  }
  if (event->key() != Qt::Key_Escape) {
    if (!page().view().takeKeyFromElsewhere(*event)) QMainWindow::keyPressEvent(event);
    return;
  }
  if (page().toolStarted())
    page().endTool();
  else if (errors().isVisible())
    errors().hide();
  else if (session().evaluating())
    session().cancelEvaluation();  // what is being saved beside it goes on
  else if (session().job().running())
    session().job().cancel();
  else if (page().studying())
    page().cancelStudies();
  else
    page().faults().hide();
}

}  // namespace blossom::ui
