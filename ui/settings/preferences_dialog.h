#pragma once
#include <QDialog>
#include <vector>

class QListWidget;
class QStackedWidget;

namespace blossom::ui {

class Commands;
class PreferencesForm;
class ShortcutEditor;

/// All preferences by group, and the keys. Nothing waits for an OK: what is changed holds at once.
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PreferencesDialog(Commands&, QWidget* parent = nullptr);

  void showShortcuts();
  [[nodiscard]] ShortcutEditor& shortcuts() { return *shortcuts_; }
  [[nodiscard]] const std::vector<PreferencesForm*>& forms() const { return forms_; }
  /// Everything on the page that is shown is as it was at first.
  void resetPage();

 private:
  void addPage(const QString& title, QWidget*);
  QListWidget* groups_;
  QStackedWidget* pages_;
  std::vector<PreferencesForm*> forms_;
  ShortcutEditor* shortcuts_;
};

}  // namespace blossom::ui
