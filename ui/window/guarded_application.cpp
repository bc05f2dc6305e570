#include "ui/window/guarded_application.h"

#include <exception>

namespace blossom::ui {

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const Error& error) {
    emit escaped(error);
  } catch (const std::exception& error) {
    emit escaped(
        Error(ErrorCode::Internal,
              tr("Blossom met a fault of its own: %1.").arg(QString::fromLocal8Bit(error.what())).toStdString(),
              tr("What you did last may be undone. Save under another name and start Blossom anew.").toStdString()));
  }
  return true;
}

}  // namespace blossom::ui
