#include "ui/tree/find_field.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>

#include "ui/look/icons.h"

namespace blossom::ui {

namespace {

constexpr int leastWidth = 52, wordsWidth = 145, keysWidth = 190, mostWidth = 210;

}  // namespace

FindField::FindField(QAction* opens, QWidget* parent) : QPushButton(parent), opens_(opens), keys_(new QLabel) {
  setObjectName(QStringLiteral("findCommand"));
  setIcon(ui::icon(QStringLiteral("search")));
  setAccessibleName(tr("Find a command"));
  setFocusPolicy(Qt::NoFocus);
  setCursor(Qt::PointingHandCursor);
  setMinimumWidth(leastWidth);
  setMaximumWidth(mostWidth);
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
  const QString words = width() < wordsWidth ? QString() : tr("Find a command");
  if (text() != words) setText(words);
  keys_->setVisible(width() >= keysWidth);
}

void FindField::enterEvent(QEnterEvent* event) {
  QPushButton::enterEvent(event);
  opens_->hover();
}

}  // namespace blossom::ui
