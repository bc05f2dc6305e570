#include "ui/document_tree.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <algorithm>

#include "ui/document_delegate.h"
#include "ui/document_model.h"
#include "ui/icons.h"
#include "ui/session.h"
#include "ui/text.h"

namespace blossom::ui {

DocumentTree::DocumentTree(Session& session, QWidget* parent)
    : QListView(parent), session_(session), model_(new DocumentModel(session, this)) {
  setModel(model_);
  setItemDelegate(new DocumentDelegate(this));
  setSelectionMode(ExtendedSelection);
  setEditTriggers(EditKeyPressed | DoubleClicked);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setUniformItemSizes(true);
  setMouseTracking(true);
  setAccessibleName(tr("Document"));
  viewport()->setAttribute(Qt::WA_Hover);
}

FeatureId DocumentTree::current() const { return model_->idAt(currentIndex()); }

std::vector<FeatureId> DocumentTree::selected() const {
  QModelIndexList indexes = selectionModel()->selectedIndexes();
  std::sort(indexes.begin(), indexes.end());
  std::vector<FeatureId> ids;
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

void DocumentTree::selectLast() {
  if (model_->rowCount() > 0) select(model_->idAt(model_->index(model_->rowCount() - 1)));
}

void DocumentTree::toggleVisible(const FeatureId& id) {
  Feature feature = session_.document().at(id);
  feature.visible = !feature.visible;
  session_.commit(session_.document().with(feature),
                  (feature.visible ? tr("Show %1") : tr("Hide %1")).arg(qt(feature.name)));
}

void DocumentTree::renameCurrent() {
  setFocus();
  edit(currentIndex());
}

// All of them become what the first one becomes: one edit, one step of undo.
void DocumentTree::toggleSelected() {
  const std::vector<FeatureId> ids = selected();
  if (ids.empty()) return;
  if (ids.size() == 1) return toggleVisible(ids.front());
  const bool visible = !session_.document().at(ids.front()).visible;
  Document document = session_.document();
  for (const FeatureId& id : ids) {
    Feature feature = document.at(id);
    feature.visible = visible;
    document = document.with(feature);
  }
  session_.commit(std::move(document), (visible ? tr("Show %1 features") : tr("Hide %1 features")).arg(ids.size()));
}

// From the last to the first, so that users go before what they use.
void DocumentTree::removeSelected() {
  std::vector<FeatureId> ids = selected();
  if (ids.empty()) return;
  const QString what = ids.size() == 1 ? tr("Delete %1").arg(qt(session_.document().at(ids.front()).name))
                                       : tr("Delete %1 features").arg(ids.size());
  try {
    Document document = session_.document();
    for (auto it = ids.rbegin(); it != ids.rend(); ++it) document = document.without(*it);
    session_.commit(std::move(document), what);
  } catch (const Error& error) {
    emit session_.failed(error, {});
  }
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
  const bool onRow = indexAt(event->position().toPoint()).isValid();
  emit hint(onRow ? tr("Click: select · Ctrl+click: select more · Double click: rename · Eye: show or hide") : QString());
  QListView::mouseMoveEvent(event);
}

void DocumentTree::leaveEvent(QEvent* event) {
  emit hint({});
  QListView::leaveEvent(event);
}

void DocumentTree::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !current().empty())
    toggleVisible(current());
  else
    QListView::keyPressEvent(event);
}

void DocumentTree::contextMenuEvent(QContextMenuEvent* event) {
  const QModelIndex index = indexAt(event->pos());
  if (!index.isValid()) return;
  const FeatureId id = model_->idAt(index);
  Feature feature = session_.document().at(id);
  QMenu menu(this);
  menu.addAction(tr("Rename"), this, [this, index] { edit(index); });
  menu.addAction(feature.visible ? tr("Hide") : tr("Show"), this, [this, id] { toggleVisible(id); });
  menu.addAction(feature.suppressed ? tr("Compute again") : tr("Suppress"), this, [this, feature]() mutable {
    feature.suppressed = !feature.suppressed;
    session_.commit(session_.document().with(feature),
                    (feature.suppressed ? tr("Suppress %1") : tr("Compute %1 again")).arg(qt(feature.name)));
  });
  menu.addSeparator();
  menu.addAction(icon(QStringLiteral("delete")), tr("Delete"), this, &DocumentTree::removeSelected);
  menu.exec(event->globalPos());
}

void DocumentTree::selectionChanged(const QItemSelection& now, const QItemSelection& before) {
  QListView::selectionChanged(now, before);
  emit selectionChangedTo();
}

}  // namespace blossom::ui
