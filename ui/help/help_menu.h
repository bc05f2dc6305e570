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

/// The Help menu and what it opens: manual, keys, about box.
class HelpMenu : public QObject {
  Q_OBJECT
 public:
  HelpMenu(const App&, Commands&, QWidget* window);

  /// `selectedType` tells the feature type that is worked on, empty when there is none; `tour` what a walk through the
  /// window shows.
  void addTo(QMenu&, std::function<std::string()> selectedType, std::function<std::vector<TourStep>()> tour);
  /// The window of the manual with this page.
  ManualWindow& openManual(const QString& page, const QString& anchor = {});

 private:
  const App& app_;
  Commands& commands_;
  QWidget* window_;
  QPointer<ManualWindow> manual_;
};

}  // namespace blossom::ui
