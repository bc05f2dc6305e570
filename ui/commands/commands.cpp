#include "ui/commands/commands.h"

#include <QRegularExpression>
#include <QSettings>
#include <QWidget>
#include <algorithm>

#include "ui/look/icons.h"

namespace blossom::ui {

namespace {

QString keyOf(const QString& id) { return QStringLiteral("shortcuts/") + id; }

// Scripts without Latin letters put the mnemonic behind the word: "파일(&F)".
QString plainText(QString text) {
  static const QRegularExpression behind(QStringLiteral("\\(&\\w\\)"));
  return text.remove(behind).remove(u'&').remove(u'…');
}

}  // namespace

Commands::Commands(QWidget* window) : QObject(window), window_(window) {}

QAction* Commands::add(const CommandSpec& spec, std::function<void()> go) {
  auto* action = new QAction(spec.text, this);
  action->setObjectName(spec.id);
  if (!spec.icon.isEmpty()) action->setIcon(icon(spec.icon));
  action->setIconText(plainText(spec.text));
  action->setCheckable(spec.checkable);
  action->setIconVisibleInMenu(!spec.checkable);  // it would stand in the place of the tick
  connect(action, &QAction::triggered, this, std::move(go));
  connect(action, &QAction::hovered, this, [this, id = spec.id] {
    const Command* command = find(id);
    if (command) emit hint(command->whyNot.isEmpty() ? command->help : command->help + u' ' + command->whyNot);
  });
  window_->addAction(action);  // its keys work wherever it is shown, and where it is not
  commands_.push_back({spec.id, spec.group, spec.icon, action, spec.keys, spec.help, {}, spec.keywords});
  const QSettings settings;
  const QVariant own = settings.value(keyOf(spec.id));
  show(commands_.back(), own.isValid() ? QKeySequence::listFromString(own.toString()) : spec.keys);
  return action;
}

void Commands::show(Command& command, const QList<QKeySequence>& keys) {
  command.action->setShortcuts(keys);
  const QString shown = keys.isEmpty() ? QString() : keys.first().toString(QKeySequence::NativeText);
  command.action->setToolTip(shown.isEmpty() ? command.help : QStringLiteral("%1 (%2)").arg(command.help, shown));
}

const Command* Commands::find(const QString& id) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const Command& c) { return c.id == id; });
  return found == commands_.end() ? nullptr : &*found;
}

QAction* Commands::action(const QString& id) const {
  const Command* command = find(id);
  Q_ASSERT(command);
  return command->action;
}

void Commands::setEnabled(const QString& id, bool on, const QString& whyNot) {
  for (Command& command : commands_) {
    if (command.id != id) continue;
    command.action->setEnabled(on);
    command.whyNot = on ? QString() : whyNot;
  }
}

const Command* Commands::holderOf(const QKeySequence& keys) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(),
                                  [&](const Command& c) { return c.action->shortcuts().contains(keys); });
  return found == commands_.end() ? nullptr : &*found;
}

void Commands::setKeys(const QString& id, const QList<QKeySequence>& keys) {
  for (Command& command : commands_) {
    if (command.id != id) continue;
    QSettings().setValue(keyOf(id), QKeySequence::listToString(keys));
    show(command, keys);
    emit keysChanged();
  }
}

void Commands::resetKeys(const QString& id) {
  for (Command& command : commands_) {
    if (command.id != id) continue;
    QSettings().remove(keyOf(id));
    show(command, command.standardKeys);
    emit keysChanged();
  }
}

}  // namespace blossom::ui
