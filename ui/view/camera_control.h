#pragma once
#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QVariantAnimation>
#include <optional>
#include <vector>

#include "scene/camera.h"
#include "scene/picking.h"

class vtkCamera;

namespace blossom::ui {

/// The camera as the mouse moves it: a turntable about z that looks at `target`. Knows nothing of VTK but how to be applied.
/// Positions are in logical pixels of the view, from the upper left.
class CameraControl : public QObject {
  Q_OBJECT
 public:
  explicit CameraControl(QObject* parent = nullptr);

  void setViewSize(QSizeF size) { size_ = size; }
  /// Turns about the target, or about a point, which stays where it is on the screen.
  void orbit(QPointF by, const std::optional<Vec3>& about = {});
  void pan(QPointF by);
  /// @param factor below 1 comes nearer; the point under `at` stays there.
  void zoom(QPointF at, double factor);
  void setParallel(bool);
  [[nodiscard]] bool parallel() const { return parallel_; }

  /// Frames the points from a turn; glides there when `animated`.
  void frame(const std::vector<Vec3>& points, const Turn&, bool animated);
  void lookFrom(const Turn&, bool animated);

  [[nodiscard]] const Turn& turn() const { return state_.turn; }
  /// The turn at the end of a glide.
  [[nodiscard]] const Turn& heading() const {
    return animation_.state() == QAbstractAnimation::Running ? to_.turn : state_.turn;
  }
  [[nodiscard]] const Vec3& target() const { return state_.target; }
  [[nodiscard]] double millimetresPerPixel() const;
  [[nodiscard]] Ray rayThrough(QPointF at) const;
  /// Where a point is seen; meaningless for points behind the eye.
  [[nodiscard]] QPointF project(const Vec3&) const;
  /// What is seen within a rectangle, as the planes that bound it; in front of the eye only.
  [[nodiscard]] std::vector<CutPlane> boundsOf(const QRectF&) const;
  /// Growth of the length of a pixel along a ray; 0 without perspective.
  [[nodiscard]] double pixelGrowth() const;
  void applyTo(vtkCamera*) const;

 signals:
  void moved();
  void jumped();  ///< follows `moved` where it is not one of many moves

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
