#pragma once
#include <QObject>
#include <QPointer>
#include <functional>

#include "app/app.h"
#include "ui/help/tour.h"

class QMenu;
class QWidget;

namespace blossom::ui {

class Commands;
class ManualWindow;

/// The Help menu and its windows: manual, keys, about box.
class HelpMenu : public QObject {
  Q_OBJECT
 public:
  HelpMenu(const App&, Commands&, QWidget* window);

  /// Adds the menu. `selectedType` returns the selected feature type, empty when there is none; `tour` returns the steps of
  /// the tour; `home` what has the keyboard where nothing else asks for it.
  void addTo(QMenu&, std::function<std::string()> selectedType, std::function<std::vector<TourStep>()> tour,
             std::function<QWidget*()> home);
  /// Opens the manual at a page.
  ManualWindow& openManual(const QString& page, const QString& anchor = {});

 private:
  const App& app_;
  Commands& commands_;
  QWidget* window_;
  QPointer<ManualWindow> manual_;
};

}  // namespace blossom::ui
