// The tabs of the main window, and the start page over an empty one.
#include <QStackedWidget>

#include "ui/files/document_tabs.h"
#include "ui/files/start_page.h"
#include "ui/look/text.h"
#include "ui/view/view_widget.h"
#include "ui/window/main_window.h"

namespace blossom::ui {

void MainWindow::connectTabs() {
  connect(tabs_, &QTabBar::currentChanged, this, [this](int index) {
    if (index >= 0 && static_cast<std::size_t>(index) < pages_.size()) showPage(static_cast<std::size_t>(index));
  });
  connect(tabs_, &QTabBar::tabCloseRequested, this, [this](int index) { closePage(static_cast<std::size_t>(index)); });
  connect(tabs_, &DocumentTabs::closeOthersWanted, this,
          [this](int index) { closeOthers(static_cast<std::size_t>(index)); });
  connect(tabs_, &DocumentTabs::saveWanted, this, [this](int index) {
    if (static_cast<std::size_t>(index) < pages_.size()) save(*pages_[static_cast<std::size_t>(index)]);
  });
  connect(start_, &StartPage::newWanted, this, &MainWindow::newDocument);
  connect(start_, &StartPage::openWanted, this, &MainWindow::chooseAndOpen);
  connect(start_, &StartPage::importWanted, this, &MainWindow::chooseAndImport);
  connect(start_, &StartPage::fileChosen, this, [this](const QString& file) { openFile(file); });
}

// A single document needs no tabs.
void MainWindow::refreshTabs() {
  std::vector<DocumentTab> tabs;
  for (const auto& each : pages_) {
    const Session& shown = each->session();
    const QString file = qt(shown.file().string());
    tabs.push_back({shown.modified() ? shown.title() + QStringLiteral(" •") : shown.title(),
                    shown.title() + u'\n' + (file.isEmpty() ? tr("Not saved yet") : file), file});
  }
  tabs_->setTabs(tabs, static_cast<int>(current_));
  tabs_->setVisible(pages_.size() > 1 || !page().untouched());
}

void MainWindow::refreshStart() {
  if (startFor_ == &page() && page().untouched())
    start_->showOver(&view());
  else
    start_->putAway();
}

void MainWindow::showStartPage() {
  if (!page().untouched()) addPage();
  startFor_ = &page();
  refreshStart();
}

void MainWindow::newDocument() {
  if (startFor_ != &page() || !page().untouched()) addPage();
  startFor_ = nullptr;
  refreshStart();
  view().setFocus();
}

}  // namespace blossom::ui
