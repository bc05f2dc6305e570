#pragma once
#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <QString>
#include <functional>
#include <vector>

namespace blossom::ui {

/// A command of the window.
struct Command {
  QString id;     ///< "file.open": stable, the key of custom shortcuts
  QString group;  ///< "File": shown in the palette before the text
  QString icon;   ///< of resources/icons; empty: none
  QAction* action = nullptr;
  QList<QKeySequence> standardKeys;
  QString help;
  QString whyNot;             ///< while it is disabled: why, in one sentence; may be empty
  QStringList keywords = {};  ///< other words by which the palette finds it
};

struct CommandSpec {
  QString id, group;
  QString icon;  ///< of resources/icons; empty: none
  QString text;  ///< menu text, with mnemonic and ellipsis
  QString help;  ///< one sentence, for tool tip, status line and palette
  QList<QKeySequence> keys = {};
  bool checkable = false;
  QStringList keywords = {};
};

/// All commands of the window, declared once; menus, tool bar, palette, shortcut editor and the manual's page of keys are
/// made from this list.
class Commands : public QObject {
  Q_OBJECT
 public:
  explicit Commands(QWidget* window);

  /// Adds a command. Its action has the user's custom keys, if any, and emits `hint` under the mouse.
  QAction* add(const CommandSpec&, std::function<void()> go);
  [[nodiscard]] const std::vector<Command>& all() const { return commands_; }
  [[nodiscard]] const Command* find(const QString& id) const;
  [[nodiscard]] QAction* action(const QString& id) const;                   ///< @pre there is one
  void setEnabled(const QString& id, bool on, const QString& whyNot = {});  ///< @pre there is one
  /// The command with these keys; nullptr when they are free.
  [[nodiscard]] const Command* holderOf(const QKeySequence&) const;
  /// Sets custom keys and stores them; an empty list leaves the command without keys.
  void setKeys(const QString& id, const QList<QKeySequence>&);
  void resetKeys(const QString& id);

 signals:
  void hint(const QString&);
  void keysChanged();

 private:
  void show(Command&, const QList<QKeySequence>&);
  QWidget* window_;
  std::vector<Command> commands_;
};

}  // namespace blossom::ui
