#include "ui/tree/find_field.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>

#include "ui/look/icons.h"

namespace blossom::ui {

namespace {

constexpr int leastFindWidth = 52, findWordsWidth = 145, findKeysWidth = 190, mostFindWidth = 210;

}  // namespace

FindField::FindField(QAction* opens, QWidget* parent) : QPushButton(parent), opens_(opens), keys_(new QLabel) {
  setObjectName(QStringLiteral("findCommand"));
  setIcon(ui::icon(QStringLiteral("search")));
  setAccessibleName(tr("Find a command"));
  setFocusPolicy(Qt::NoFocus);
  setCursor(Qt::PointingHandCursor);
  setMinimumWidth(leastFindWidth);
  setMaximumWidth(mostFindWidth);
  keys_->setObjectName(QStringLiteral("keys"));
  keys_->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 10, 0);
  row->addStretch();
  row->addWidget(keys_);
  connect(this, &QPushButton::clicked, opens, &QAction::trigger);
  connect(opens, &QAction::changed, this, &FindField::refresh);
  refresh();
}

void FindField::refresh() {
  keys_->setText(opens_->shortcut().toString(QKeySequence::NativeText));
  setToolTip(opens_->toolTip());
}

// In a narrow window the words go first, and the picture stays.
void FindField::resizeEvent(QResizeEvent* event) {
  QPushButton::resizeEvent(event);
  const QString words = width() < findWordsWidth ? QString() : tr("Find a command");
  if (text() != words) setText(words);
  keys_->setVisible(width() >= findKeysWidth);
}

void FindField::enterEvent(QEnterEvent* event) {
  QPushButton::enterEvent(event);
  opens_->hover();
}

}  // namespace blossom::ui
