#include "ui/controls/flow_layout.h"

#include <QWidget>
#include <algorithm>

namespace blossom::ui {

namespace {

constexpr int flowGap = 4;

}  // namespace

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) { setContentsMargins(0, 0, 0, 0); }

FlowLayout::~FlowLayout() {
  for (const QLayoutItem* item : items_) delete item;
}

void FlowLayout::addItem(QLayoutItem* item) { items_.push_back(item); }

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  QLayoutItem* item = itemAt(index);
  if (item) items_.erase(items_.begin() + index);
  return item;
}

int FlowLayout::heightForWidth(int width) const { return arranged(QRect(0, 0, width, 0), false); }

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  arranged(area, true);
}

QSize FlowLayout::minimumSize() const {
  QSize size(0, 0);
  for (const QLayoutItem* item : items_)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
  return size;
}

int FlowLayout::arranged(const QRect& area, bool place) const {
  int x = area.x(), y = area.y(), line = 0;
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const QSize wanted(std::min(item->sizeHint().width(), area.width()), item->sizeHint().height());
    if (x > area.x() && x + wanted.width() > area.right() + 1) {
      x = area.x();
      y += line + flowGap;
      line = 0;
    }
    if (place) item->setGeometry(QRect(QPoint(x, y), wanted));
    x += wanted.width() + flowGap;
    line = std::max(line, wanted.height());
  }
  return y + line - area.y();
}

}  // namespace blossom::ui
