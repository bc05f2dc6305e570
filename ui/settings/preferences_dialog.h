#pragma once
#include <QDialog>
#include <vector>

class QListWidget;
class QStackedWidget;

namespace blossom::ui {

class Commands;
class PreferencesForm;
class ShortcutEditor;

/// All preferences by group, and the keys. Changes apply at once; there is no OK button.
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PreferencesDialog(Commands&, QWidget* parent = nullptr);

  void showShortcuts();
  [[nodiscard]] ShortcutEditor& shortcuts() { return *shortcuts_; }
  [[nodiscard]] const std::vector<PreferencesForm*>& forms() const { return forms_; }
  /// Resets everything on the current page.
  void resetPage();

 private:
  void addPage(const QString& title, QWidget*);
  QListWidget* groups_;
  QStackedWidget* pages_;
  std::vector<PreferencesForm*> forms_;
  ShortcutEditor* shortcuts_;
};

}  // namespace blossom::ui
