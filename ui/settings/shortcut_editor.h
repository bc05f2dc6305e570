#pragma once
#include <QKeySequence>
#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace blossom::ui {

class Commands;
class KeyRecorder;

/// Every command with its keys: find a command, press other keys, with a message when they belong to another command.
class ShortcutEditor : public QWidget {
  Q_OBJECT
 public:
  explicit ShortcutEditor(Commands&, QWidget* parent = nullptr);

  void select(const QString& commandId);
  /// Handles recorded keys: assigns them to the selected command, or names the command that has them and changes nothing.
  void take(const QKeySequence&);
  void resetAll();
  [[nodiscard]] QString message() const;
  [[nodiscard]] QLineEdit& searchField() { return *search_; }
  [[nodiscard]] QPushButton& takeOver() { return *takeOver_; }
  [[nodiscard]] int visibleCommands() const;

 private:
  QWidget* buildEditor();
  void fill();
  void refresh();
  void filter(const QString& words);
  void selectionChanged();
  void giveTo(const QString& id, const QKeySequence&);
  void say(const QString& text, bool wrong = false);
  [[nodiscard]] QString current() const;

  Commands& commands_;
  QLineEdit* search_;
  QTreeWidget* list_;
  QLabel *name_, *message_;
  KeyRecorder* recorder_;
  QPushButton *clear_, *reset_, *takeOver_;
  QKeySequence wanted_;  // keys that belong to another command
};

}  // namespace blossom::ui
