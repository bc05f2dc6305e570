#include "ui/tree/document_tree.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <algorithm>
#include <set>

#include "document/edits.h"
#include "ui/look/character_key.h"
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
  connect(model_, &DocumentModel::foldsChanged, this, [this] { applyFilter(); });
  // A state may take more lines than the one before.
  connect(model_, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex& first, const QModelIndex& last) {
    applyFilter(first.row(), last.row());
    scheduleDelayedItemsLayout();
  });
}

FeatureId DocumentTree::current() const { return model_->idAt(currentIndex()); }

std::vector<FeatureId> DocumentTree::selected() const {
  std::set<FeatureId> chosen;
  for (const QModelIndex& index : selectionModel()->selectedIndexes()) chosen.insert(model_->idAt(index));
  std::vector<FeatureId> ids;
  ids.reserve(chosen.size());
  for (const auto& feature : session_.document().features())
    if (chosen.contains(feature->id)) ids.push_back(feature->id);
  return ids;
}

std::vector<FeatureId> DocumentTree::selectedInTurn() const {
  std::vector<FeatureId> all = selected();
  return turn_.size() == all.size() ? turn_ : all;
}

void DocumentTree::selectAdded(const FeatureId& id) {
  const QScopedValueRollback automatic(byHand_, false);
  select(id);
}

void DocumentTree::select(const FeatureId& id, bool extend) {
  const QModelIndex index = model_->indexOf(id);
  if (!index.isValid()) {
    if (!extend) clearSelection();
    return;
  }
  model_->unfoldTo(id);
  selectionModel()->setCurrentIndex(index, extend ? QItemSelectionModel::Toggle : QItemSelectionModel::ClearAndSelect);
  scrollTo(index);
}

void DocumentTree::selectThese(const std::vector<FeatureId>& ids) {
  const QScopedValueRollback automatic(byHand_, false);
  QItemSelection selection;
  for (const FeatureId& id : ids) model_->unfoldTo(id);
  for (const FeatureId& id : ids) selection.select(model_->indexOf(id), model_->indexOf(id));
  if (!ids.empty()) selectionModel()->setCurrentIndex(model_->indexOf(ids.back()), QItemSelectionModel::NoUpdate);
  selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

void DocumentTree::selectLast() {
  const auto features = session_.document().features();
  if (!features.empty()) select(features.back()->id);
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
  applyFilter();
}

void DocumentTree::applyFilter() { applyFilter(0, model_->rowCount() - 1); }

// What a filter finds is shown, folded away or not.
void DocumentTree::applyFilter(int first, int last) {
  for (int row = first; row <= last; ++row) {
    const QModelIndex index = model_->index(row);
    const bool hidden = filter_.isEmpty() ? model_->isFoldedAway(model_->idAt(index)) : !passesFilter(index);
    if (hidden != isRowHidden(row)) setRowHidden(row, hidden);
  }
}

bool DocumentTree::passesFilter(const QModelIndex& index) const {
  const auto text = [&](int role) { return index.data(role).toString() + u'\n'; };
  const auto mark = [&](int role, const QString& word) { return index.data(role).toBool() ? word + u'\n' : QString(); };
  const QString all = text(Qt::DisplayRole) + text(DocumentModel::TypeRole) + text(DocumentModel::StateRole) +
                      mark(DocumentModel::FailedRole, tr("error failed")) + mark(DocumentModel::WarnedRole, tr("warning")) +
                      (index.data(DocumentModel::VisibleRole).toBool() ? QString() : tr("hidden"));
  return std::all_of(filter_.begin(), filter_.end(),
                     [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
}

// A selection that is folded away goes to the row it was folded into.
void DocumentTree::setFolded(const FeatureId& id, bool folded) {
  model_->setFolded(id, folded);
  const std::vector<FeatureId> chosen = selected();
  const auto hidden = [this](const FeatureId& each) { return model_->isFoldedAway(each); };
  if (folded && std::any_of(chosen.begin(), chosen.end(), hidden)) select(id);
}

std::size_t DocumentTree::rowAt(QPoint at) const {
  const QModelIndex index = indexAt(at);
  if (!index.isValid()) return static_cast<std::size_t>(model_->rowCount());
  if (at.y() <= visualRect(index).center().y()) return static_cast<std::size_t>(index.row());
  int next = index.row() + 1;
  while (next < model_->rowCount() && isRowHidden(next)) ++next;
  return static_cast<std::size_t>(next);
}

void DocumentTree::mousePressEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->position().toPoint());
  if (index.isValid() && event->button() == Qt::LeftButton && index.data(DocumentModel::StepsRole).toBool() &&
      DocumentDelegate::foldRect(visualRect(index), index).contains(event->position().toPoint())) {
    setFolded(model_->idAt(index), !index.data(DocumentModel::FoldedRole).toBool());
    return;
  }
  if (index.isValid() && event->button() == Qt::LeftButton &&
      DocumentDelegate::eyeRect(visualRect(index)).adjusted(-5, -5, 5, 5).contains(event->position().toPoint())) {
    toggleVisible(model_->idAt(index));
    return;
  }
  if (!index.isValid()) clearSelection();
  QListView::mousePressEvent(event);
  // A click on what is selected already, as a new feature is, changes nothing but that it is selected by hand now.
  if (turn_.empty() && index.isValid() && selected() == std::vector{model_->idAt(index)}) turn_ = {model_->idAt(index)};
}

void DocumentTree::mouseMoveEvent(QMouseEvent* event) {
  const QPoint at = event->position().toPoint();
  const QModelIndex index = indexAt(at);
  if (!index.isValid())
    emit hint({});
  else if (DocumentDelegate::eyeRect(visualRect(index)).adjusted(-5, -5, 5, 5).contains(at))
    emit hint(index.data(DocumentModel::VisibleRole).toBool() ? tr("Click: hide %1").arg(index.data().toString())
                                                              : tr("Click: show %1").arg(index.data().toString()));
  else if (index.data(DocumentModel::StepsRole).toBool() &&
           DocumentDelegate::foldRect(visualRect(index), index).contains(at))
    emit hint(index.data(DocumentModel::FoldedRole).toBool()
                  ? tr("Click: show the steps of %1").arg(index.data().toString())
                  : tr("Click: fold the steps of %1").arg(index.data().toString()));
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
  const bool fold = event->key() == Qt::Key_Left, unfold = event->key() == Qt::Key_Right;
  if (event->key() == Qt::Key_Space && !current().empty())
    toggleSelected();
  else if ((fold || unfold) && currentIndex().data(DocumentModel::StepsRole).toBool())
    setFolded(current(), fold);
  else if (isCharacterKey(*event))
    event->ignore();  // a key of the view: names are found by the filter
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
    withMoved(session_.document(), withSteps(selected()), placeBefore(rowAt(event->position().toPoint())));
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

/// With the steps of results, folded away or not: what moves in the tree moves as a whole.
std::vector<FeatureId> DocumentTree::withSteps(const std::vector<FeatureId>& ids) const {
  std::set<FeatureId> all(ids.begin(), ids.end());
  for (const FeatureId& id : ids) {
    if (!model_->parentOf(id).empty()) continue;
    const std::vector<FeatureId> steps = model_->stepsOf(id);
    all.insert(steps.begin(), steps.end());
  }
  std::vector<FeatureId> ordered;
  for (const auto& feature : session_.document().features())
    if (all.contains(feature->id)) ordered.push_back(feature->id);
  return ordered;
}

/// The place in the document before a row and its steps.
std::size_t DocumentTree::placeBefore(std::size_t row) const {
  const QModelIndex index = model_->index(static_cast<int>(row));
  if (!index.isValid()) return session_.document().features().size();
  return placeOf(withSteps({model_->idAt(index)}).front());
}

std::size_t DocumentTree::placeOf(const FeatureId& id) const {
  const auto features = session_.document().features();
  const auto found = std::find_if(features.begin(), features.end(), [&](const auto& feature) { return feature->id == id; });
  return static_cast<std::size_t>(found - features.begin());
}

void DocumentTree::selectionChanged(const QItemSelection& now, const QItemSelection& before) {
  QListView::selectionChanged(now, before);
  std::vector<FeatureId> fresh = selected();
  std::erase_if(turn_, [&](const FeatureId& id) { return std::erase(fresh, id) == 0; });
  if (byHand_)
    turn_.insert(turn_.end(), fresh.begin(), fresh.end());
  else
    turn_.clear();
  emit selectionChangedTo();
}

}  // namespace blossom::ui
