#include "ui/files/document_tabs.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMouseEvent>
#include <algorithm>

#include "ui/files/show_in_folder.h"
#include "ui/thread/refreshes.h"

namespace blossom::ui {

namespace {

constexpr int narrowestTab = 150;  // leaves a dozen letters beside the cross

}  // namespace

DocumentTabs::DocumentTabs(QWidget* parent) : QTabBar(parent) {
  setObjectName(QStringLiteral("documentTabs"));
  setTabsClosable(true);
  setMovable(false);
  setExpanding(false);
  setDrawBase(false);
  setElideMode(Qt::ElideRight);
  setUsesScrollButtons(true);
  setFocusPolicy(Qt::NoFocus);
}

void DocumentTabs::setTabs(const std::vector<DocumentTab>& tabs, int current) {
  if (tabs == shown_ && current == currentIndex()) return;
  countRefresh(WindowPart::Tabs);
  shown_ = tabs;
  const QSignalBlocker quiet(this);
  const int wanted = static_cast<int>(tabs.size());
  while (count() > wanted) removeTab(count() - 1);
  while (count() < wanted) addTab({});
  for (int i = 0; i < wanted; ++i) {
    const DocumentTab& tab = tabs[static_cast<std::size_t>(i)];
    setTabText(i, tab.text);
    setTabToolTip(i, tab.toolTip);
    setTabData(i, tab.file);
  }
  setCurrentIndex(current);
}

// Qt makes tabs as narrow as a letter or two before it offers to scroll.
QSize DocumentTabs::minimumTabSizeHint(int index) const {
  const QSize whole = tabSizeHint(index);
  return {std::min(whole.width(), narrowestTab), whole.height()};
}

void DocumentTabs::mousePressEvent(QMouseEvent* event) {
  pressed_ = event->button() == Qt::MiddleButton ? tabAt(event->position().toPoint()) : -1;
  if (pressed_ < 0) QTabBar::mousePressEvent(event);
}

void DocumentTabs::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::MiddleButton) return QTabBar::mouseReleaseEvent(event);
  const int released = tabAt(event->position().toPoint());
  if (released >= 0 && released == pressed_) emit tabCloseRequested(released);
  pressed_ = -1;
}

// The data of a tab is the path of its file, or nothing.
void DocumentTabs::contextMenuEvent(QContextMenuEvent* event) {
  const int index = tabAt(event->pos());
  if (index < 0) return;
  const QString file = tabData(index).toString();
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Save"), this, [this, index] { emit saveWanted(index); });
  menu->addSeparator();
  menu->addAction(tr("Close"), this, [this, index] { emit tabCloseRequested(index); });
  menu->addAction(tr("Close others"), this, [this, index] { emit closeOthersWanted(index); })->setEnabled(count() > 1);
  menu->addSeparator();
  QAction* show = menu->addAction(tr("Show in folder"), this, [file] { showInFolder(file); });
  QAction* copy = menu->addAction(tr("Copy path"), this, [file] { QApplication::clipboard()->setText(file); });
  for (QAction* action : {show, copy}) action->setEnabled(!file.isEmpty());
  menu->popup(event->globalPos());
}

}  // namespace blossom::ui
