#pragma once
#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <QString>
#include <functional>
#include <vector>

namespace blossom::ui {

/// One thing the user can ask of the window.
struct Command {
  QString id;     ///< "file.open": stable, the key of a shortcut of the user's own
  QString group;  ///< "File": what the palette shows before the text
  QString icon;   ///< of resources/icons; empty: none
  QAction* action = nullptr;
  QList<QKeySequence> standardKeys;
  QString help;
  QString whyNot;  ///< while it is disabled: one sentence; empty when nobody said
};

struct CommandSpec {
  QString id, group;
  QString icon;  ///< of resources/icons; empty: none
  QString text;  ///< as the menu shows it, with mnemonic and ellipsis
  QString help;  ///< one sentence, for tool tip, status line and palette
  QList<QKeySequence> keys = {};
  bool checkable = false;
};

/// Every command of the window, declared once: menus, tool bar, palette, shortcut editor and the manual's page of keys are
/// made from this list.
class Commands : public QObject {
  Q_OBJECT
 public:
  explicit Commands(QWidget* window);

  /// The action carries the user's own keys when there are some, and tells `hint` when the mouse rests on it.
  QAction* add(const CommandSpec&, std::function<void()> go);
  [[nodiscard]] const std::vector<Command>& all() const { return commands_; }
  [[nodiscard]] const Command* find(const QString& id) const;
  [[nodiscard]] QAction* action(const QString& id) const;                   ///< @pre there is one
  void setEnabled(const QString& id, bool on, const QString& whyNot = {});  ///< @pre there is one
  /// The command that has these keys; nullptr when they are free.
  [[nodiscard]] const Command* holderOf(const QKeySequence&) const;
  /// Kept for the next start; an empty list leaves the command without keys.
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
