// Documents as tabs: adding, showing and closing them.
#include <QStackedWidget>

#include "ui/help/help_menu.h"
#include "ui/jobs/log_and_jobs.h"
#include "ui/look/text.h"
#include "ui/page/document_commands.h"
#include "ui/page/feature_menus.h"
#include "ui/page/view_commands.h"
#include "ui/panel/error_bar.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"

namespace blossom::ui {

DocumentPage& MainWindow::addPage() {
  pages_.push_back(std::make_unique<DocumentPage>(app_, manipulators_));
  DocumentPage& added = *pages_.back();
  sides_->addWidget(added.side());
  canvases_->addWidget(added.canvas());
  connectPage(added);
  showPage(pages_.size() - 1);
  return added;
}

void MainWindow::connectPage(DocumentPage& page) {
  logAndJobs_->watch(page);
  DocumentPage* const sender = &page;
  const auto whenShown = [this, sender](auto act) {
    return [this, sender, act](const auto&... values) {
      if (sender == &this->page()) act(values...);
    };
  };
  connect(sender, &DocumentPage::hint, this, whenShown([this](const QString& text) { status_->setHint(text); }));
  connect(sender, &DocumentPage::whereabouts, this,
          whenShown([this](const QString& text) { status_->setWhereabouts(text); }));
  connect(sender, &DocumentPage::announced, this, whenShown([this](const QString& text) { status_->announce(text); }));
  connect(sender, &DocumentPage::workChanged, this,
          whenShown(
              [this](const QString& key, const QString& what, double fraction) { status_->setWork(key, what, fraction); }));
  connect(sender, &DocumentPage::workEnded, this, whenShown([this](const QString& key) { status_->endWork(key); }));
  connect(sender, &DocumentPage::selectionChanged, this, whenShown([this] {
            featureMenus_->setSelection(tree().selected());
            followState();
          }));
  connect(sender, &DocumentPage::stateChanged, this, [this, sender] {
    refreshTabs();
    if (sender != &this->page()) return;
    followState();
    refreshStart();
  });
  connect(sender, &DocumentPage::toolChanged, this, whenShown([this] {
            refreshStart();
            viewCommands_->refresh();
          }));
  connect(sender, &DocumentPage::contextMenuWanted, this,
          whenShown([this](const QPoint& global) { documentCommands_->popup(global); }));
  connect(sender, &DocumentPage::opened, this, [this, sender] {
    if (!sender->session().file().empty()) remember(qt(sender->session().file().string()));
  });
  connect(&sender->session(), &Session::saveFailed, this,
          [this, sender] { sender->errors().offer(tr("Save as…"), [this, sender] { saveAs(*sender); }); });
  connect(&sender->session(), &Session::unsafe, this, [sender](const Error& error) {
    sender->errors().showError(
        tr("No safety copy of %1 can be kept: %2").arg(sender->session().title(), qt(error.message())), qt(error.hint()));
  });
  connect(sender, &DocumentPage::manualWanted, this, [this](const QString& name) {
    if (auto* help = findChild<HelpMenu*>()) help->openManual(name);
  });
  connect(sender, &DocumentPage::salvageWanted, this, [this](const QString& file) { openFile(file, true); });
}

void MainWindow::showPage(std::size_t index) {
  current_ = index;
  DocumentPage& shown = page();
  sides_->setCurrentWidget(shown.side());
  canvases_->setCurrentWidget(shown.canvas());
  featureMenus_->setPage(&shown);
  documentCommands_->setPage(&shown);
  featureMenus_->setSelection(shown.tree().selected());
  for (const char* key : {"a", "b"}) status_->endWork(QLatin1String(key));
  status_->setHint(shown.tool() ? shown.tool()->hint() : ViewWidget::idleHint());
  refreshTabs();
  refreshActions();
  refreshStart();
}

void MainWindow::removePage(std::size_t index) {
  if (index >= pages_.size()) return;
  const std::unique_ptr<DocumentPage> removed = std::move(pages_[index]);
  pages_.erase(pages_.begin() + static_cast<std::ptrdiff_t>(index));
  removed->disconnect(this);
  removed->session().abandon();
  if (startFor_ == removed.get()) startFor_ = nullptr;
  if (pages_.empty()) {
    startFor_ = &addPage();
    refreshStart();
  } else {
    showPage(std::min(current_ > index ? current_ - 1 : current_, pages_.size() - 1));
  }
}

}  // namespace blossom::ui
