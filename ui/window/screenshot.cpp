#include "ui/window/screenshot.h"

#include <QCoreApplication>
#include <QPixmap>

#include "ui/page/page.h"
#include "ui/view/view_widget.h"
#include "ui/window/main_window.h"
#include "ui/window/startup_clock.h"

namespace blossom::ui {

Screenshot::Screenshot(MainWindow& window, QString file) : QObject(&window), window_(window), file_(std::move(file)) {
  const auto look = [this] { QMetaObject::invokeMethod(this, &Screenshot::whenComputed, Qt::QueuedConnection); };
  connect(&window.session(), &Session::evaluationFinished, this, look);
  connect(&window.session(), &Session::failed, this, look);
  connect(&window.session().job(), &Job::finished, this, look);
  look();
}

void Screenshot::whenComputed() {
  if (window_.session().evaluating() || window_.session().job().running()) return;
  disconnect(&window_.view(), &ViewWidget::framePainted, this, nullptr);
  connect(&window_.view(), &ViewWidget::framePainted, this, [this] {
    if (window_.session().evaluating() || window_.session().job().running() || window_.page().studying() ||
        !window_.view().sharp())
      return;
    disconnect(&window_.view(), &ViewWidget::framePainted, this, nullptr);
    reached("final picture");
    QCoreApplication::processEvents();  // layouts settle in several rounds
    emit taken(window_.grab().save(file_));
  });
  window_.view().update();
}

}  // namespace blossom::ui
