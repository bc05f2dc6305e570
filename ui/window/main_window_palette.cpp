// Around the documents: the command palette and what it offers, the status line, jobs and log.
#include <QStatusBar>

#include "ui/help/help_menu.h"
#include "ui/help/manual_pages.h"
#include "ui/help/manual_window.h"
#include "ui/jobs/jobs_list.h"
#include "ui/jobs/log_and_jobs.h"
#include "ui/palette/command_palette.h"
#include "ui/window/main_window.h"
#include "ui/window/palette_sources.h"
#include "ui/window/status_line.h"

namespace blossom::ui {

void MainWindow::buildStatus() {
  auto* bar = new QStatusBar;
  bar->setSizeGripEnabled(false);
  bar->addWidget(status_, 1);
  setStatusBar(bar);
  status_->setStandingHint(
      tr("%1: find a command · Drop files to open them")
          .arg(commands_.action(QStringLiteral("edit.find-command"))->shortcut().toString(QKeySequence::NativeText)));
  connect(&commands_, &Commands::hint, status_, &StatusLine::setHint);
  connect(status_, &StatusLine::cancelled, this, [this] { session().cancel(); });
  connect(status_, &StatusLine::jobsWanted, logAndJobs_, &LogAndJobs::toggleJobs);
  connect(&logAndJobs_->jobs(), &JobsList::runningChanged, status_, &StatusLine::setJobs);
  connect(logAndJobs_, &LogAndJobs::hint, status_, &StatusLine::setHint);
  logAndJobs_->restore();
}

void MainWindow::buildPalette() {
  palette_ = new CommandPalette(this);
  palette_->addSource(commandEntries(commands_, *featureMenus_));
  palette_->addSource(featureEntries([this]() -> DocumentPage& { return page(); }));
  palette_->addSource(fileEntries([this](const QString& file) { openFile(file); }));
  palette_->addSource(manualEntries([this] { return ManualPages(app_, commands_); },
                                    [this](const QString& name) {
                                      if (auto* help = findChild<HelpMenu*>()) help->openManual(name);
                                    }));
  connect(palette_, &CommandPalette::hint, this, [this](const QString& text) { status_->setHint(text); });
}

}  // namespace blossom::ui
