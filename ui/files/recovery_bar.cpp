#include "ui/files/recovery_bar.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/look/icons.h"
#include "ui/look/text.h"
#include "ui/session/recovery.h"

namespace blossom::ui {

namespace {

QString timeOf(std::int64_t milliseconds) {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(milliseconds);
  return time.date() == QDate::currentDate() ? time.toString(QStringLiteral("HH:mm"))
                                             : time.toString(QStringLiteral("d MMM yyyy, HH:mm"));
}

}  // namespace

RecoveryBar::RecoveryBar(QWidget* parent)
    : PassingBar(parent), message_(new QLabel), rows_(new QVBoxLayout), all_(new QPushButton(tr("Recover all"))) {
  setObjectName(QStringLiteral("errorBar"));
  setProperty("kind", "note");
  message_->setObjectName(QStringLiteral("errorMessage"));
  auto* mark = new QLabel;
  mark->setPixmap(icon(QStringLiteral("recover")).pixmap(18, 18));
  auto* later = new QToolButton;
  later->setIcon(icon(QStringLiteral("close")));
  later->setIconSize({16, 16});
  later->setToolTip(tr("Not now: they are offered again at the next start"));
  connect(later, &QToolButton::clicked, this, &QWidget::hide);
  connect(all_, &QPushButton::clicked, this, [this] {
    const auto lost = Recovery::instance().lost();
    hide();
    for (const LostDocument& each : lost) emit recoverWanted(each);
  });
  auto* heading = new QHBoxLayout;
  heading->setSpacing(10);
  heading->addWidget(mark);
  heading->addWidget(message_, 1);
  heading->addWidget(all_);
  heading->addWidget(later);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(13, 8, 10, 8);
  column->setSpacing(6);
  rows_->setSpacing(4);
  column->addLayout(heading);
  column->addLayout(rows_);
  connect(&Recovery::instance(), &Recovery::changed, this, &RecoveryBar::refresh);
  refresh();
}

QWidget* RecoveryBar::row(const LostDocument& lost) {
  auto* made = new QWidget;
  auto* across = new QHBoxLayout(made);
  across->setContentsMargins(28, 0, 26, 0);
  across->setSpacing(10);
  auto* name = new QLabel(qt(lost.summary.origin.name));
  auto* state = new QLabel(tr("%1, last step: %2").arg(timeOf(lost.summary.milliseconds), qt(lost.summary.lastStep)));
  state->setObjectName(QStringLiteral("errorHint"));
  const QString file = qt(lost.summary.origin.file.string());
  name->setToolTip(file.isEmpty() ? tr("Was never saved") : file);
  auto* recover = new QPushButton(tr("Recover"));
  recover->setProperty("primary", true);
  auto* discard = new QPushButton(tr("Discard"));
  connect(recover, &QPushButton::clicked, this, [this, lost, made] {
    freeFocusOf(made);
    made->setEnabled(false);
    emit recoverWanted(lost);
  });
  connect(discard, &QPushButton::clicked, this, [lost] { Recovery::instance().discard(lost.folder); });
  across->addWidget(name);
  across->addWidget(state, 1);
  across->addWidget(recover);
  across->addWidget(discard);
  return made;
}

void RecoveryBar::refresh() {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    freeFocusOf(item->widget());
    item->widget()->deleteLater();
    delete item;
  }
  const auto& lost = Recovery::instance().lost();
  message_->setText(lost.size() == 1 ? tr("A document was not saved when Blossom last ended.")
                                     : tr("%1 documents were not saved when Blossom last ended.").arg(lost.size()));
  for (const LostDocument& each : lost) rows_->addWidget(row(each));
  all_->setVisible(lost.size() > 1);
  setVisible(!lost.empty());
}

}  // namespace blossom::ui
