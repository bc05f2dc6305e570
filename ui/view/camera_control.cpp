#include "ui/view/camera_control.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace blossom::ui {

namespace {

constexpr double viewAngle = 22;  // degrees, as the pictures have it
constexpr double degreesPerPixel = 0.35;
const double tangent = std::tan(viewAngle * std::numbers::pi / 360);

// The same direction as `yaw`, at most half a turn away from `near`.
double nearestYaw(double yaw, double near) { return yaw - 360 * std::round((yaw - near) / 360); }

}  // namespace

CameraControl::CameraControl(QObject* parent) : QObject(parent) {
  animation_.setDuration(220);
  animation_.setStartValue(0.0);
  animation_.setEndValue(1.0);
  animation_.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&animation_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    const double t = value.toDouble();
    state_.turn.yaw = std::lerp(from_.turn.yaw, to_.turn.yaw, t);
    state_.turn.pitch = std::lerp(from_.turn.pitch, to_.turn.pitch, t);
    state_.target = from_.target + (to_.target - from_.target) * t;
    state_.distance = from_.distance * std::pow(to_.distance / from_.distance, t);
    emit moved();
  });
}

double CameraControl::millimetresPerPixel() const { return 2 * state_.distance * tangent / std::max(1.0, size_.height()); }

void CameraControl::orbit(QPointF by, const std::optional<Vec3>& about) {
  stop();
  const Vec3 arm = about ? Vec3(*about - state_.target) : Vec3(Vec3::Zero());
  const Vec3 seen(arm.dot(state_.turn.right()), arm.dot(state_.turn.up()), arm.dot(state_.turn.toCamera()));
  state_.turn.yaw -= by.x() * degreesPerPixel;
  state_.turn.pitch = std::clamp(state_.turn.pitch + by.y() * degreesPerPixel, -90.0, 90.0);
  state_.target += arm - (seen.x() * state_.turn.right() + seen.y() * state_.turn.up() + seen.z() * state_.turn.toCamera());
  emit moved();
}

void CameraControl::pan(QPointF by) {
  stop();
  const double scale = millimetresPerPixel();
  state_.target += state_.turn.up() * (by.y() * scale) - state_.turn.right() * (by.x() * scale);
  emit moved();
}

void CameraControl::zoom(QPointF at, double factor) {
  stop();
  const double scale = millimetresPerPixel();
  const QPointF off = at - QPointF(size_.width(), size_.height()) / 2;
  const Vec3 under = state_.turn.right() * (off.x() * scale) - state_.turn.up() * (off.y() * scale);
  const double distance = std::clamp(state_.distance * factor, 1e-4, 1e9);
  state_.target += under * (1 - distance / state_.distance);
  state_.distance = distance;
  emit moved();
}

void CameraControl::setParallel(bool parallel) {
  if (parallel == parallel_) return;
  parallel_ = parallel;
  emit moved();
}

void CameraControl::frame(const std::vector<Vec3>& points, const Turn& turn, bool animated) {
  const double aspect = size_.width() / std::max(1.0, size_.height());
  const Framing framing = frameAll(points, turn, aspect, viewAngle, 0.12);
  glideTo({turn, framing.target, parallel_ ? framing.parallelScale / tangent : framing.distance}, animated);
}

void CameraControl::lookFrom(const Turn& turn, bool animated) { glideTo({turn, state_.target, state_.distance}, animated); }

void CameraControl::glideTo(const State& goal, bool animated) {
  stop();
  to_ = goal;
  to_.turn.yaw = nearestYaw(goal.turn.yaw, state_.turn.yaw);
  if (animated) {
    from_ = state_;
    animation_.start();
    return;
  }
  state_ = goal;
  emit moved();
  emit jumped();
}

Ray CameraControl::rayThrough(QPointF at) const {
  const double scale = millimetresPerPixel();
  const QPointF off = at - QPointF(size_.width(), size_.height()) / 2;
  const Vec3 onPlane = state_.target + state_.turn.right() * (off.x() * scale) - state_.turn.up() * (off.y() * scale);
  const Vec3 back = state_.turn.toCamera();
  if (parallel_) return {onPlane + back * state_.distance, -back};
  const Vec3 eye = state_.target + back * state_.distance;
  return {eye, (onPlane - eye).normalized()};
}

QPointF CameraControl::project(const Vec3& p) const {
  const Vec3 arm = p - state_.target;
  const double depth = parallel_ ? state_.distance : state_.distance - arm.dot(state_.turn.toCamera());
  const double pixels = std::max(1.0, size_.height()) / (2 * depth * tangent);
  return QPointF(size_.width() / 2 + arm.dot(state_.turn.right()) * pixels,
                 size_.height() / 2 - arm.dot(state_.turn.up()) * pixels);
}

std::vector<CutPlane> CameraControl::boundsOf(const QRectF& rect) const {
  const std::array<QPointF, 4> corners{rect.topLeft(), rect.topRight(), rect.bottomRight(), rect.bottomLeft()};
  const Ray middle = rayThrough(rect.center());
  std::vector<CutPlane> bounds;
  for (std::size_t i = 0; i < 4; ++i) {
    const Ray a = rayThrough(corners[i]), b = rayThrough(corners[(i + 1) % 4]);
    const Vec3 aside = (b.origin + b.direction) - (a.origin + a.direction);
    Vec3 normal = a.direction.cross(aside).normalized();
    if (normal.dot(middle.origin + middle.direction - a.origin - a.direction) > 0) normal = -normal;
    bounds.push_back({normal, normal.dot(a.origin)});
  }
  if (parallel_) return bounds;
  const Vec3 back = state_.turn.toCamera();
  bounds.push_back({back, back.dot(middle.origin)});
  return bounds;
}

double CameraControl::pixelGrowth() const { return parallel_ ? 0 : 2 * tangent / std::max(1.0, size_.height()); }

void CameraControl::applyTo(vtkCamera* camera) const {
  camera->SetViewAngle(viewAngle);
  camera->SetParallelProjection(parallel_);
  place(camera, state_.turn, {state_.target, state_.distance, state_.distance * tangent});
}

}  // namespace blossom::ui
