#include "ui/tree/document_tree_panel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/look/icons.h"
#include "ui/tree/document_tree.h"

namespace blossom::ui {

DocumentTreePanel::DocumentTreePanel(DocumentTree* tree, QWidget* parent)
    : QWidget(parent), tree_(tree), search_(new QLineEdit), open_(new QToolButton) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 10, 0, 4);
  column->setSpacing(4);
  column->addWidget(heading());
  auto* row = new QHBoxLayout;
  row->setContentsMargins(12, 0, 12, 2);
  row->addWidget(search_);
  column->addLayout(row);
  column->addWidget(tree_, 1);
  search_->setObjectName(QStringLiteral("documentSearch"));
  search_->setPlaceholderText(tr("Name, type or state"));
  search_->setAccessibleName(tr("Find in the document"));
  search_->setClearButtonEnabled(true);
  search_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  search_->installEventFilter(this);
  search_->hide();
  connect(search_, &QLineEdit::textChanged, tree_, &DocumentTree::setFilter);
}

QWidget* DocumentTreePanel::heading() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(16, 0, 12, 0);
  auto* title = new QLabel(tr("DOCUMENT"));
  title->setObjectName(QStringLiteral("sectionTitle"));
  open_->setObjectName(QStringLiteral("quiet"));
  open_->setIcon(icon(QStringLiteral("search")));
  open_->setIconSize({14, 14});
  open_->setToolTip(tr("Find in the document"));
  open_->setAccessibleName(tr("Find in the document"));
  connect(open_, &QToolButton::clicked, this, [this] { search_->isHidden() ? startSearch() : endSearch(); });
  row->addWidget(title, 1);
  row->addWidget(open_);
  return box;
}

void DocumentTreePanel::startSearch() {
  search_->show();
  search_->setFocus();
  search_->selectAll();
}

void DocumentTreePanel::endSearch() {
  search_->clear();
  search_->hide();
  tree_->setFocus();
}

// Esc gives everything back; the arrows and Return go on to what was found.
bool DocumentTreePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != search_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Escape) {
    endSearch();
    return true;
  }
  if (key != Qt::Key_Down && key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  tree_->selectFirstShown();
  tree_->setFocus();
  return true;
}

}  // namespace blossom::ui
