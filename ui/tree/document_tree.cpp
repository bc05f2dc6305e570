#include "ui/tree/document_tree.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <algorithm>

#include "document/edits.h"
#include "ui/look/text.h"
#include "ui/session/session.h"
#include "ui/tree/document_delegate.h"
#include "ui/tree/document_model.h"

namespace blossom::ui {

DocumentTree::DocumentTree(Session& session, QWidget* parent)
    : QListView(parent), session_(session), model_(new DocumentModel(session, this)) {
  setModel(model_);
  setItemDelegate(new DocumentDelegate(this));
  setSelectionMode(ExtendedSelection);
  setEditTriggers(EditKeyPressed | DoubleClicked);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setResizeMode(Adjust);
  setMouseTracking(true);
  setDragDropMode(InternalMove);
  setDefaultDropAction(Qt::MoveAction);
  setAccessibleName(tr("Document"));
  viewport()->setAttribute(Qt::WA_Hover);
  connect(model_, &QAbstractItemModel::layoutChanged, this, [this] { applyFilter(); });
  connect(model_, &QAbstractItemModel::rowsInserted, this, [this] { applyFilter(); });
  // A state may take more lines than the one before.
  connect(model_, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex& first, const QModelIndex& last) {
    applyFilter(first.row(), last.row());
    scheduleDelayedItemsLayout();
  });
}

FeatureId DocumentTree::current() const { return model_->idAt(currentIndex()); }

std::vector<FeatureId> DocumentTree::selected() const {
  QModelIndexList indexes = selectionModel()->selectedIndexes();
  std::sort(indexes.begin(), indexes.end());
  std::vector<FeatureId> ids;
  ids.reserve(static_cast<std::size_t>(indexes.size()));
  for (const QModelIndex& index : indexes) ids.push_back(model_->idAt(index));
  return ids;
}

void DocumentTree::select(const FeatureId& id, bool extend) {
  const QModelIndex index = model_->indexOf(id);
  if (!index.isValid()) {
    if (!extend) clearSelection();
    return;
  }
  selectionModel()->setCurrentIndex(index, extend ? QItemSelectionModel::Toggle : QItemSelectionModel::ClearAndSelect);
  scrollTo(index);
}

void DocumentTree::selectThese(const std::vector<FeatureId>& ids) {
  QItemSelection selection;
  for (const FeatureId& id : ids) selection.select(model_->indexOf(id), model_->indexOf(id));
  if (!ids.empty()) selectionModel()->setCurrentIndex(model_->indexOf(ids.back()), QItemSelectionModel::NoUpdate);
  selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

void DocumentTree::selectLast() {
  if (model_->rowCount() > 0) select(model_->idAt(model_->index(model_->rowCount() - 1)));
}

void DocumentTree::selectFirstShown() {
  for (int row = 0; row < model_->rowCount(); ++row)
    if (!isRowHidden(row)) return select(model_->idAt(model_->index(row)));
}

void DocumentTree::selectAll() {
  std::vector<FeatureId> shown;
  for (int row = 0; row < model_->rowCount(); ++row)
    if (!isRowHidden(row)) shown.push_back(model_->idAt(model_->index(row)));
  selectThese(shown);
}

void DocumentTree::setFilter(const QString& text) {
  filter_ = text.split(u' ', Qt::SkipEmptyParts);
  filtered_ = true;  // what is hidden may have to come back
  applyFilter();
  filtered_ = !filter_.isEmpty();
}

void DocumentTree::applyFilter() { applyFilter(0, model_->rowCount() - 1); }

void DocumentTree::applyFilter(int first, int last) {
  if (!filtered_) return;
  for (int row = first; row <= last; ++row) {
    const QModelIndex index = model_->index(row);
    const auto text = [&](int role) { return index.data(role).toString() + u'\n'; };
    const auto mark = [&](int role, const QString& word) { return index.data(role).toBool() ? word + u'\n' : QString(); };
    const QString all = text(Qt::DisplayRole) + text(DocumentModel::TypeRole) + text(DocumentModel::StateRole) +
                        mark(DocumentModel::FailedRole, tr("error failed")) +
                        mark(DocumentModel::WarnedRole, tr("warning")) +
                        (index.data(DocumentModel::VisibleRole).toBool() ? QString() : tr("hidden"));
    const bool hidden = !std::all_of(filter_.begin(), filter_.end(),
                                     [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
    if (hidden != isRowHidden(row)) setRowHidden(row, hidden);
  }
}

std::size_t DocumentTree::rowAt(QPoint at) const {
  const QModelIndex index = indexAt(at);
  if (!index.isValid()) return static_cast<std::size_t>(model_->rowCount());
  return static_cast<std::size_t>(index.row()) + (at.y() > visualRect(index).center().y() ? 1 : 0);
}

void DocumentTree::mousePressEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->position().toPoint());
  if (index.isValid() && event->button() == Qt::LeftButton &&
      DocumentDelegate::eyeRect(visualRect(index)).adjusted(-5, -5, 5, 5).contains(event->position().toPoint())) {
    toggleVisible(model_->idAt(index));
    return;
  }
  if (!index.isValid()) clearSelection();
  QListView::mousePressEvent(event);
}

void DocumentTree::mouseMoveEvent(QMouseEvent* event) {
  const QPoint at = event->position().toPoint();
  const QModelIndex index = indexAt(at);
  if (!index.isValid())
    emit hint({});
  else if (DocumentDelegate::eyeRect(visualRect(index)).adjusted(-5, -5, 5, 5).contains(at))
    emit hint(index.data(DocumentModel::VisibleRole).toBool() ? tr("Click: hide %1").arg(index.data().toString())
                                                              : tr("Click: show %1").arg(index.data().toString()));
  else
    emit hint(tr("%1 · Click: select · Ctrl+click: select more · Double click: rename · Drag: reorder · Right click: more")
                  .arg(index.data().toString()));
  QListView::mouseMoveEvent(event);
}

void DocumentTree::leaveEvent(QEvent* event) {
  emit hint({});
  QListView::leaveEvent(event);
}

void DocumentTree::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !current().empty())
    toggleSelected();
  else
    QListView::keyPressEvent(event);
}

// The menu is about what is selected; a row that is not gets selected first.
void DocumentTree::contextMenuEvent(QContextMenuEvent* event) {
  const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
  const QPoint at = byKey ? visualRect(currentIndex()).center() : event->pos();
  const QModelIndex index = byKey ? currentIndex() : indexAt(at);
  if (index.isValid() && !selectionModel()->isSelected(index)) select(model_->idAt(index));
  if (!index.isValid()) clearSelection();
  emit contextMenuWanted(viewport()->mapToGlobal(at));
}

// The reason against a place is told before the button is released.
void DocumentTree::dragMoveEvent(QDragMoveEvent* event) {
  QListView::dragMoveEvent(event);
  try {
    withMoved(session_.document(), selected(), rowAt(event->position().toPoint()));
    emit hint(tr("Release: move here"));
  } catch (const Error& error) {
    emit hint(qt(error.message()));
  }
}

void DocumentTree::dropEvent(QDropEvent* event) {
  if (!event->mimeData()->hasFormat(model_->mimeTypes().front())) return event->ignore();
  event->setDropAction(Qt::MoveAction);
  event->accept();
  moveSelectedBefore(rowAt(event->position().toPoint()));
  stopAutoScroll();
  setState(NoState);
  viewport()->update();
}

void DocumentTree::selectionChanged(const QItemSelection& now, const QItemSelection& before) {
  QListView::selectionChanged(now, before);
  emit selectionChangedTo();
}

}  // namespace blossom::ui
