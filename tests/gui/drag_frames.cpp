#include "drag_frames.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>

namespace blossom::test {

DragFrames::DragFrames(ui::ViewWidget& view, int moves, const std::function<void(int)>& move) {
  QElapsedTimer since;
  const auto counting = QObject::connect(&view, &ui::ViewWidget::framePainted, &view, [&] {
    milliseconds_.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
    since.restart();
  });
  int done = 0;
  QTimer moving;
  QEventLoop loop;
  QObject::connect(&moving, &QTimer::timeout, &loop, [&] {
    move(++done);
    if (done == moves) loop.quit();
  });
  moving.setTimerType(Qt::PreciseTimer);
  since.start();
  moving.start(8);
  loop.exec();
  QObject::disconnect(counting);
  std::sort(milliseconds_.begin(), milliseconds_.end());
}

double DragFrames::shareWithin(double milliseconds) const {
  const auto end = std::upper_bound(milliseconds_.begin(), milliseconds_.end(), milliseconds);
  return milliseconds_.empty() ? 0 : 100.0 * static_cast<double>(end - milliseconds_.begin()) / static_cast<double>(count());
}

double DragFrames::slowestOf(double percent) const {
  return milliseconds_.at(static_cast<std::size_t>(static_cast<double>(count() - 1) * percent / 100));
}

}  // namespace blossom::test
