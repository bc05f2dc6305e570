#include "ui/settings/preferences_dialog.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/fields/parameter_field.h"
#include "ui/settings/preferences_form.h"
#include "ui/settings/shortcut_editor.h"

namespace blossom::ui {

PreferencesDialog::PreferencesDialog(Commands& commands, QWidget* parent)
    : QDialog(parent), groups_(new QListWidget), pages_(new QStackedWidget), shortcuts_(new ShortcutEditor(commands)) {
  setWindowTitle(tr("Preferences"));
  setObjectName(QStringLiteral("preferences"));
  resize(820, 580);
  groups_->setObjectName(QStringLiteral("preferenceGroups"));
  groups_->setFixedWidth(190);
  groups_->setFrameShape(QFrame::NoFrame);
  groups_->ensurePolished();  // or its rows are measured before the style sheet has given them their padding
  for (const PreferenceGroup& group : preferenceGroups()) {
    forms_.push_back(new PreferencesForm(group));
    addPage(group.title, forms_.back());
  }
  addPage(tr("Keyboard shortcuts"), shortcuts_);
  connect(groups_, &QListWidget::currentRowChanged, pages_, &QStackedWidget::setCurrentIndex);
  groups_->setCurrentRow(0);

  auto* reset = new QPushButton(tr("&Reset this page"));
  auto* close = new QPushButton(tr("Close"));
  reset->setAutoDefault(false);
  close->setAutoDefault(false);
  connect(reset, &QPushButton::clicked, this, &PreferencesDialog::resetPage);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(24, 12, 24, 18);
  buttons->addWidget(reset);
  buttons->addStretch(1);
  buttons->addWidget(close);
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(pages_, 1);
  right->addLayout(buttons);
  auto* across = new QHBoxLayout(this);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  across->addWidget(groups_);
  across->addLayout(right, 1);
}

// The editor of keys scrolls its own list.
void PreferencesDialog::addPage(const QString& title, QWidget* page) {
  groups_->addItem(title);
  if (page == shortcuts_) {
    pages_->addWidget(page);
    return;
  }
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(page);
  pages_->addWidget(scroll);
}

void PreferencesDialog::showShortcuts() { groups_->setCurrentRow(groups_->count() - 1); }

void PreferencesDialog::resetPage() {
  const auto page = static_cast<std::size_t>(groups_->currentRow());
  if (page >= forms_.size()) return shortcuts_->resetAll();
  for (const ParameterField* field : forms_[page]->fields())
    Preferences::instance().set(field->spec().name, field->spec().fallback);
}

}  // namespace blossom::ui
