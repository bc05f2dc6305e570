#include "ui/window/open_documents.h"

#include <QPointer>
#include <QStackedWidget>
#include <algorithm>

#include "ui/files/document_tabs.h"
#include "ui/files/start_page.h"
#include "ui/look/text.h"
#include "ui/page/page.h"
#include "ui/panel/overlaid_bars.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

OpenDocuments::OpenDocuments(App app, const ManipulatorRegistry& manipulators, QObject* parent)
    : QObject(parent),
      app_(std::move(app)),
      manipulators_(manipulators),
      tabs_(new DocumentTabs),
      sides_(new QStackedWidget),
      canvases_(new QStackedWidget),
      start_(new StartPage) {
  start_->setParent(canvases_);
  connectTabs();
}

OpenDocuments::~OpenDocuments() = default;

void OpenDocuments::connectTabs() {
  connect(tabs_, &QTabBar::currentChanged, this, [this](int index) {
    if (has(index)) show(static_cast<std::size_t>(index));
  });
  connect(tabs_, &QTabBar::tabCloseRequested, this,
          [this](int index) { emit closeWanted(static_cast<std::size_t>(index)); });
  connect(tabs_, &DocumentTabs::closeOthersWanted, this,
          [this](int index) { emit closeOthersWanted(static_cast<std::size_t>(index)); });
  connect(tabs_, &DocumentTabs::saveWanted, this, [this](int index) {
    if (has(index)) emit saveWanted(&at(static_cast<std::size_t>(index)));
  });
  connect(start_, &StartPage::newWanted, this, &OpenDocuments::startNew);
  connect(start_, &StartPage::openWanted, this, &OpenDocuments::openWanted);
  connect(start_, &StartPage::importWanted, this, &OpenDocuments::importWanted);
  connect(start_, &StartPage::fileChosen, this, &OpenDocuments::fileChosen);
}

void OpenDocuments::begin() {
  startFor_ = &add();
  refreshStart();
}

void OpenDocuments::end() {
  for (const auto& page : pages_) {
    page->disconnect(this);
    emit removing(page.get());
  }
  pages_.clear();
}

std::vector<DocumentPage*> OpenDocuments::all() const {
  std::vector<DocumentPage*> pages;
  pages.reserve(pages_.size());
  for (const auto& each : pages_) pages.push_back(each.get());
  return pages;
}

std::size_t OpenDocuments::indexOf(const DocumentPage& page) const {
  const auto found = std::find_if(pages_.begin(), pages_.end(), [&](const auto& other) { return other.get() == &page; });
  return static_cast<std::size_t>(found - pages_.begin());
}

DocumentPage& OpenDocuments::add() {
  pages_.push_back(std::make_unique<DocumentPage>(app_, manipulators_));
  DocumentPage* const page = pages_.back().get();
  sides_->addWidget(page->side());
  canvases_->addWidget(page->canvas());
  connect(page, &DocumentPage::stateChanged, this, [this, page] {
    refreshTabs();
    if (page == &shown()) refreshStart();
  });
  connect(page, &DocumentPage::toolChanged, this, [this, page] {
    if (page == &shown()) refreshStart();
  });
  connect(&page->notes(), &OverlaidBars::coverageChanged, start_, &StartPage::follow);
  emit added(page);
  show(pages_.size() - 1);
  return *page;
}

DocumentPage& OpenDocuments::placeToOpen() { return shown().untouched() ? shown() : add(); }

void OpenDocuments::show(std::size_t index) {
  current_ = index;
  sides_->setCurrentWidget(shown().side());
  canvases_->setCurrentWidget(shown().canvas());
  refreshTabs();
  emit shownChanged();
  refreshStart();
}

void OpenDocuments::remove(std::size_t index) {
  if (index >= pages_.size()) return;
  const std::unique_ptr<DocumentPage> removed = std::move(pages_[index]);
  pages_.erase(pages_.begin() + static_cast<std::ptrdiff_t>(index));
  removed->disconnect(this);
  emit removing(removed.get());
  removed->session().abandon();
  if (startFor_ == removed.get()) startFor_ = nullptr;
  if (pages_.empty())
    begin();
  else
    show(std::min(current_ > index ? current_ - 1 : current_, pages_.size() - 1));
}

// A single document needs no tabs.
void OpenDocuments::refreshTabs() {
  std::vector<DocumentTab> tabs;
  for (const auto& each : pages_) {
    const Session& session = each->session();
    const QString file = qt(session.file().string());
    tabs.push_back({session.modified() ? session.title() + QStringLiteral(" •") : session.title(),
                    session.title() + u'\n' + (file.isEmpty() ? tr("Not saved yet") : file), file});
  }
  tabs_->setTabs(tabs, static_cast<int>(current_));
  tabs_->setVisible(pages_.size() > 1 || !shown().untouched());
}

void OpenDocuments::refreshStart() {
  const bool starts = startFor_ == &shown() && shown().untouched();
  shown().notes().leaveCorner(!starts);
  if (starts)
    start_->showOver(&shown().view(),
                     [page = QPointer<DocumentPage>(&shown())] { return page ? page->notes().covered() : 0; });
  else
    start_->putAway();
}

void OpenDocuments::showStartPage() {
  if (!shown().untouched()) add();
  startFor_ = &shown();
  refreshStart();
}

void OpenDocuments::startNew() {
  if (startFor_ != &shown() || !shown().untouched()) add();
  startFor_ = nullptr;
  refreshStart();
  shown().view().setFocus();
}

}  // namespace blossom::ui
