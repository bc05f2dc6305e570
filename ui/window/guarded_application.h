#pragma once
#include <QApplication>

#include "core/error.h"

namespace blossom::ui {

/// Goes on after an exception that no handler of an event took: ending there would take every unsaved document along.
/// The receiver of the signal shows it to the user.
class GuardedApplication : public QApplication {
  Q_OBJECT
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent*) override;

 signals:
  void escaped(const blossom::Error&);
};

}  // namespace blossom::ui
