#include "ui/files/unsaved_dialog.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace blossom::ui {

UnsavedDialog::UnsavedDialog(const std::vector<UnsavedDocument>& documents, QWidget* parent)
    : QDialog(parent), save_(new QPushButton(tr("Save all"))) {
  setObjectName(QStringLiteral("unsavedDialog"));
  setWindowTitle(tr("Unsaved changes"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(22, 20, 22, 18);
  all->setSpacing(10);
  auto* title = new QLabel(tr("%1 documents have changes that are not saved.").arg(documents.size()));
  title->setObjectName(QStringLiteral("featureName"));
  all->addWidget(title);
  auto* note = new QLabel(tr("Those that are ticked are saved; the changes of the others are lost."));
  note->setObjectName(QStringLiteral("note"));
  all->addWidget(note);
  all->addSpacing(4);
  for (const UnsavedDocument& each : documents) {
    auto* box = new QCheckBox(QString(each.name).replace(u'&', QStringLiteral("&&")));
    box->setChecked(each.wanted);
    connect(box, &QCheckBox::toggled, this, &UnsavedDialog::refresh);
    boxes_.push_back(box);
    all->addWidget(box);
  }
  all->addSpacing(10);
  auto* discard = new QPushButton(tr("Discard all"));
  discard->setObjectName(QStringLiteral("discardAll"));
  auto* cancel = new QPushButton(tr("Cancel"));
  save_->setObjectName(QStringLiteral("saveChosen"));
  save_->setProperty("primary", true);
  save_->setDefault(true);
  connect(discard, &QPushButton::clicked, this, [this] { finish(Answer::Discard); });
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, [this] { finish(Answer::Save); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(discard);
  buttons->addStretch();
  buttons->addWidget(cancel);
  buttons->addWidget(save_);
  all->addLayout(buttons);
  setMinimumWidth(440);
  refresh();
}

std::vector<std::size_t> UnsavedDialog::chosen() const {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    if (boxes_[i]->isChecked()) places.push_back(i);
  return places;
}

void UnsavedDialog::refresh() {
  const std::size_t count = chosen().size();
  save_->setEnabled(count > 0);
  save_->setText(count == boxes_.size() ? tr("Save all") : tr("Save %1 of %2").arg(count).arg(boxes_.size()));
}

void UnsavedDialog::finish(Answer answer) {
  answer_ = answer;
  accept();
}

}  // namespace blossom::ui
