#include "ui/help/manual_contents.h"

#include <QHeaderView>

#include "ui/help/manual_text.h"

namespace blossom::ui {

namespace {

enum ContentsRole { PageRole = Qt::UserRole, AnchorRole };

}  // namespace

ManualContents::ManualContents(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("manualContents"));
  setHeaderHidden(true);
  setIndentation(14);
  setRootIsDecorated(false);
  setItemsExpandable(false);
  setUniformRowHeights(false);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTextElideMode(Qt::ElideRight);
  const auto follow = [this](QTreeWidgetItem* item) {
    if (item && !item->data(0, PageRole).isNull())
      emit wanted(item->data(0, PageRole).toString(), item->data(0, AnchorRole).toString());
  };
  connect(this, &QTreeWidget::itemClicked, this, follow);
  connect(this, &QTreeWidget::itemActivated, this, follow);
}

void ManualContents::setPages(const ManualPages& pages) {
  clear();
  items_.clear();
  QHash<QString, QTreeWidgetItem*> groups;
  for (const ManualPage& page : pages.all()) {
    QTreeWidgetItem*& group = groups[page.group];
    if (!group && !page.group.isEmpty()) {
      group = new QTreeWidgetItem(this, {page.group.toUpper()});
      group->setFlags(Qt::ItemIsEnabled);
      group->setExpanded(true);
      QFont small = font();
      small.setPixelSize(10);
      small.setWeight(QFont::DemiBold);
      group->setFont(0, small);
      group->setSizeHint(0, {0, 34});
      group->setTextAlignment(0, Qt::AlignBottom | Qt::AlignLeft);
    }
    auto* item = group ? new QTreeWidgetItem(group, {page.title}) : new QTreeWidgetItem(this, {page.title});
    item->setData(0, PageRole, page.name);
    item->setToolTip(0, page.title);
    items_.insert(page.name, item);
  }
}

void ManualContents::showPage(const QString& page, const std::vector<ManualHeading>& headings) {
  for (QTreeWidgetItem* item : std::as_const(items_)) qDeleteAll(item->takeChildren());
  QTreeWidgetItem* item = items_.value(page);
  if (!item) return setCurrentItem(nullptr);
  for (const ManualHeading& heading : headings) {
    if (heading.level != 2) continue;
    auto* child = new QTreeWidgetItem(item, {heading.text});
    child->setData(0, PageRole, page);
    child->setData(0, AnchorRole, heading.anchor);
    child->setToolTip(0, heading.text);
  }
  item->setExpanded(true);
  const QTreeWidgetItem* current = currentItem();
  if (!current || current->data(0, PageRole) != page) setCurrentItem(item);
  scrollToItem(item);
}

}  // namespace blossom::ui
