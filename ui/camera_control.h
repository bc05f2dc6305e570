#pragma once
#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <QVariantAnimation>
#include <vector>

#include "scene/camera.h"

class vtkCamera;

namespace blossom::ui {

/// The camera as the mouse moves it: a turntable about z that looks at `target`. Knows nothing of VTK but how to be applied.
/// Positions are in logical pixels of the view, from the upper left.
class CameraControl : public QObject {
  Q_OBJECT
 public:
  explicit CameraControl(QObject* parent = nullptr);

  void setViewSize(QSizeF size) { size_ = size; }
  void orbit(QPointF by);
  void pan(QPointF by);
  /// @param factor below 1 comes nearer; the point under `at` stays there.
  void zoom(QPointF at, double factor);
  void setParallel(bool);
  [[nodiscard]] bool parallel() const { return parallel_; }

  /// Frames the points from a turn; glides there when `animated`.
  void frame(const std::vector<Vec3>& points, const Turn&, bool animated);
  void lookFrom(const Turn&, bool animated);

  [[nodiscard]] const Turn& turn() const { return state_.turn; }
  [[nodiscard]] const Vec3& target() const { return state_.target; }
  [[nodiscard]] double millimetresPerPixel() const;
  struct Ray {
    Vec3 origin, direction;
  };
  [[nodiscard]] Ray rayThrough(QPointF at) const;
  void applyTo(vtkCamera*) const;

 signals:
  void moved();

 private:
  struct State {
    Turn turn{35, 28};
    Vec3 target = Vec3::Zero();
    double distance = 600;
  };
  void glideTo(const State&, bool animated);
  void stop() { animation_.stop(); }

  State state_, from_, to_;
  QSizeF size_{800, 600};
  bool parallel_ = false;
  QVariantAnimation animation_;
};

}  // namespace blossom::ui
