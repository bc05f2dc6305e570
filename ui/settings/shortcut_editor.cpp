#include "ui/settings/shortcut_editor.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/commands/commands.h"
#include "ui/look/icons.h"
#include "ui/settings/key_recorder.h"

namespace blossom::ui {

namespace {

constexpr int idRole = Qt::UserRole;

QString shown(const QList<QKeySequence>& keys) {
  QStringList texts;
  for (const QKeySequence& each : keys) texts << each.toString(QKeySequence::NativeText);
  return texts.join(QStringLiteral(", "));
}

// The menu's text may tell what is undone; the name stays.
QString nameOf(const Command& command) { return command.action->iconText(); }

}  // namespace

ShortcutEditor::ShortcutEditor(Commands& commands, QWidget* parent)
    : QWidget(parent), commands_(commands), search_(new QLineEdit), list_(new QTreeWidget) {
  search_->setPlaceholderText(tr("Search commands and keys"));
  search_->setClearButtonEnabled(true);
  search_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  list_->setObjectName(QStringLiteral("shortcuts"));
  list_->setColumnCount(2);
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->header()->setStretchLastSection(false);
  list_->setRootIsDecorated(false);
  list_->setItemsExpandable(false);
  list_->setIndentation(12);
  list_->setFrameShape(QFrame::NoFrame);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(24, 22, 24, 8);
  column->setSpacing(10);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addWidget(buildEditor());
  fill();
  connect(search_, &QLineEdit::textChanged, this, &ShortcutEditor::filter);
  connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutEditor::selectionChanged);
  connect(list_, &QTreeWidget::itemActivated, this, [this] { recorder_->click(); });
  connect(&commands_, &Commands::keysChanged, this, &ShortcutEditor::refresh);
  selectionChanged();
}

QWidget* ShortcutEditor::buildEditor() {
  name_ = new QLabel;
  message_ = new QLabel;
  message_->setObjectName(QStringLiteral("note"));
  message_->setWordWrap(true);
  recorder_ = new KeyRecorder;
  clear_ = new QPushButton(tr("&No keys"));
  reset_ = new QPushButton(tr("&Standard keys"));
  takeOver_ = new QPushButton(tr("&Take them from there"));
  for (QPushButton* button : {clear_, reset_, takeOver_}) button->setAutoDefault(false);
  connect(recorder_, &KeyRecorder::recorded, this, &ShortcutEditor::take);
  connect(clear_, &QPushButton::clicked, this, [this] { commands_.setKeys(current(), {}); });
  connect(reset_, &QPushButton::clicked, this, [this] {
    const Command* command = commands_.find(current());
    const Command* holder =
        command && !command->standardKeys.isEmpty() ? commands_.holderOf(command->standardKeys.first()) : nullptr;
    if (holder && holder->id != current()) return take(command->standardKeys.first());
    commands_.resetKeys(current());
  });
  connect(takeOver_, &QPushButton::clicked, this, [this] { giveTo(current(), wanted_); });
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  auto* row = new QHBoxLayout;
  row->addWidget(name_, 1);
  row->addWidget(recorder_);
  row->addWidget(clear_);
  row->addWidget(reset_);
  column->addLayout(row);
  auto* below = new QHBoxLayout;
  below->addWidget(message_, 1);
  below->addWidget(takeOver_);
  column->addLayout(below);
  return box;
}

void ShortcutEditor::fill() {
  QHash<QString, QTreeWidgetItem*> groups;
  for (const Command& command : commands_.all()) {
    QTreeWidgetItem*& group = groups[command.group];
    if (!group) {
      group = new QTreeWidgetItem(list_, {command.group.toUpper()});
      group->setFlags(Qt::ItemIsEnabled);
      group->setFirstColumnSpanned(true);
      QFont small = list_->font();
      small.setPixelSize(10);
      small.setWeight(QFont::DemiBold);
      group->setFont(0, small);
      group->setSizeHint(0, {0, 34});
      group->setTextAlignment(0, Qt::AlignBottom | Qt::AlignLeft);
      group->setExpanded(true);
    }
    auto* item = new QTreeWidgetItem(group, {nameOf(command)});
    item->setData(0, idRole, command.id);
    item->setIcon(0, command.action->icon());
    item->setToolTip(0, command.help);
  }
  refresh();
}

void ShortcutEditor::refresh() {
  for (QTreeWidgetItemIterator it(list_); *it; ++it) {
    const Command* command = commands_.find((*it)->data(0, idRole).toString());
    if (!command) continue;
    const QList<QKeySequence> keys = command->action->shortcuts();
    QFont font = list_->font();
    font.setBold(keys != command->standardKeys);
    (*it)->setText(1, shown(keys));
    (*it)->setFont(1, font);
  }
  selectionChanged();
}

void ShortcutEditor::filter(const QString& words) {
  const QStringList wanted = words.split(u' ', Qt::SkipEmptyParts);
  for (int g = 0; g < list_->topLevelItemCount(); ++g) {
    QTreeWidgetItem* group = list_->topLevelItem(g);
    bool any = false;
    for (int i = 0; i < group->childCount(); ++i) {
      QTreeWidgetItem* item = group->child(i);
      const QString all = QStringList{group->text(0), item->text(0), item->text(1), item->toolTip(0)}.join(u' ');
      const bool fits = std::all_of(wanted.begin(), wanted.end(),
                                    [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
      item->setHidden(!fits);
      any = any || fits;
    }
    group->setHidden(!any);
  }
}

int ShortcutEditor::visibleCommands() const {
  int count = 0;
  for (QTreeWidgetItemIterator it(list_, QTreeWidgetItemIterator::NotHidden); *it; ++it)
    if (!(*it)->data(0, idRole).isNull()) ++count;
  return count;
}

QString ShortcutEditor::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item ? item->data(0, idRole).toString() : QString();
}

void ShortcutEditor::select(const QString& commandId) {
  for (QTreeWidgetItemIterator it(list_); *it; ++it)
    if ((*it)->data(0, idRole).toString() == commandId) list_->setCurrentItem(*it);
}

void ShortcutEditor::selectionChanged() {
  const Command* command = commands_.find(current());
  for (QWidget* each : std::initializer_list<QWidget*>{recorder_, clear_, reset_}) each->setEnabled(command != nullptr);
  name_->setText(command ? nameOf(*command) : QString());
  recorder_->showKeys(command ? command->action->shortcuts() : QList<QKeySequence>());
  if (command) clear_->setEnabled(!command->action->shortcuts().isEmpty());
  if (command) reset_->setEnabled(command->action->shortcuts() != command->standardKeys);
  say(command ? tr("Click the keys and press others, or press Enter in the list.")
              : tr("Select a command to change its keys."));
}

void ShortcutEditor::take(const QKeySequence& keys) {
  const Command* command = commands_.find(current());
  if (!command) return;
  const Command* holder = commands_.holderOf(keys);
  if (holder && holder->id != command->id) {
    wanted_ = keys;
    say(tr("%1 already belongs to \"%2\" in %3.")
            .arg(keys.toString(QKeySequence::NativeText), nameOf(*holder), holder->group),
        true);
    return;
  }
  commands_.setKeys(command->id, {keys});
}

// The holder keeps what other keys it has.
void ShortcutEditor::giveTo(const QString& id, const QKeySequence& keys) {
  if (const Command* holder = commands_.holderOf(keys)) {
    QList<QKeySequence> left = holder->action->shortcuts();
    left.removeAll(keys);
    commands_.setKeys(holder->id, left);
  }
  commands_.setKeys(id, {keys});
}

void ShortcutEditor::resetAll() {
  QStringList changed;
  for (const Command& command : commands_.all())
    if (command.action->shortcuts() != command.standardKeys) changed << command.id;
  for (const QString& id : changed) commands_.resetKeys(id);
}

void ShortcutEditor::say(const QString& text, bool wrong) {
  message_->setText(text);
  message_->setObjectName(wrong ? QStringLiteral("fieldError") : QStringLiteral("note"));
  message_->style()->unpolish(message_);  // the style sheet looks at the name
  message_->style()->polish(message_);
  takeOver_->setVisible(wrong);
}

QString ShortcutEditor::message() const { return message_->text(); }

}  // namespace blossom::ui
