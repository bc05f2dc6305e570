#pragma once
#include <QObject>
#include <QPointer>

class QMenu;
class QWidget;

namespace blossom::ui {

class Commands;
class PreferencesDialog;

/// The commands that open the preferences and the editor of keys.
class PreferencesCommands : public QObject {
  Q_OBJECT
 public:
  PreferencesCommands(Commands&, QMenu&, QWidget* window);

  PreferencesDialog& open();

 private:
  Commands& commands_;
  QWidget* window_;
  QPointer<PreferencesDialog> dialog_;
};

}  // namespace blossom::ui
