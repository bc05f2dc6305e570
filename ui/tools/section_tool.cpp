#include "ui/tools/section_tool.h"

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "ui/tools/section_panel.h"
#include "ui/tools/view_props.h"

namespace blossom::ui {

namespace {

constexpr double reach = 9;  // pixels around the handle

/// Distance of a ray to a segment.
double rayDistance(const Ray& ray, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a, between = a - ray.origin;
  const double slant = along.dot(ray.direction), square = along.squaredNorm();
  const double across = square - slant * slant;
  double t = across > 1e-12 * square ? (slant * between.dot(ray.direction) - between.dot(along)) / across : 0.5;
  t = std::clamp(t, 0.0, 1.0);
  const Vec3 p = between + t * along;
  return (p - std::max(0.0, p.dot(ray.direction)) * ray.direction).norm();
}

/// Perspective makes far things smaller: what a pixel is worth at a point, seen from the ray's origin.
bool within(const ToolEvent& event, const Vec3& a, const Vec3& b) {
  return rayDistance(event.ray, a, b) <= reach * event.millimetresPerPixel;
}

}  // namespace

SectionTool::SectionTool(ToolHost& host, QWidget* view)
    : Tool(host),
      plane_(host.section() ? SectionPlane::of(*host.section()) : SectionPlane::through(host.extent())),
      extent_(host.extent()),
      panel_(view ? new SectionPanel(view) : nullptr) {
  if (panel_) {
    connect(panel_, &SectionPanel::axisChosen, this, &SectionTool::choose);
    connect(panel_, &SectionPanel::offsetChosen, this, &SectionTool::moveTo);
    connect(panel_, &SectionPanel::flipped, this, [this] {
      plane_.flip();
      apply();
    });
    connect(panel_, &SectionPanel::turnedOff, this, &SectionTool::turnOff);
  }
  apply();
}

SectionTool::~SectionTool() { delete panel_; }

QString SectionTool::hint() const {
  if (pickingFace_) return tr("Click a face: the section becomes parallel to it · Esc: keep the direction");
  if (dragging_) return tr("Ctrl: in steps of the grid");
  if (hovered_) return tr("Drag: move the section along its direction");
  return tr("Drag the handle · X, Y, Z: direction · P: of a face · F: flip · Up, Down: a step · Del: off · Esc: finish");
}

SectionTool::Frame SectionTool::frame() const {
  const Vec3& n = plane_.direction();
  const Vec3 u = plane_.axis() == SectionAxis::Z ? Vec3(Vec3::UnitX())
                 : std::abs(n.z()) < 0.9         ? Vec3(Vec3::UnitZ().cross(n).normalized())
                                                 : Vec3(n.unitOrthogonal());
  const Vec3 v = n.cross(u), half = (extent_.high - extent_.low) / 2;
  const double size = std::max(extent_.diagonal(), 1e-3);
  const double a = half.dot(u.cwiseAbs()) + 0.06 * size, b = half.dot(v.cwiseAbs()) + 0.06 * size;
  Frame f;
  f.centre = plane_.onPlane(extent_.center());
  f.tip = f.centre + 0.2 * size * (plane_.flipped() ? -n : n);
  f.corners = {f.centre - a * u - b * v, f.centre + a * u - b * v, f.centre + a * u + b * v, f.centre - a * u + b * v};
  return f;
}

bool SectionTool::isOnHandle(const ToolEvent& event) const {
  const Frame f = frame();
  if (within(event, f.centre, f.tip)) return true;
  for (std::size_t i = 0; i < 4; ++i)
    if (within(event, f.corners[i], f.corners[(i + 1) % 4])) return true;
  return false;
}

bool SectionTool::press(const ToolEvent& event) {
  if (event.button != Qt::LeftButton) return false;
  if (pickingFace_ && event.pick.part.kind == SubShapeKind::Face) {
    plane_.setFace(event.pick.part.point, event.pick.part.normal);
    pickingFace_ = false;
    apply();
    return true;
  }
  if (pickingFace_ || !isOnHandle(event)) return false;
  dragging_ = true;
  lastAt_ = event.at;
  // Taken by the frame, the plane follows the point where it was taken.
  const Frame f = frame();
  taken_ = f.centre;
  const double slant = event.ray.direction.dot(plane_.direction());
  if (!within(event, f.centre, f.tip) && std::abs(slant) > 1e-6)
    taken_ = event.ray.origin + (f.centre - event.ray.origin).dot(plane_.direction()) / slant * event.ray.direction;
  const auto at = plane_.offsetAlong(event.ray, taken_);
  grabbed_ = at ? *at - plane_.offset() : 0;
  emit changed();
  return true;
}

bool SectionTool::move(const ToolEvent& event) {
  if (dragging_) {
    drag(event);
    return true;
  }
  const bool over = !pickingFace_ && isOnHandle(event);
  if (over != hovered_) {
    hovered_ = over;
    emit changed();
  }
  return false;
}

void SectionTool::drag(const ToolEvent& event) {
  double offset = plane_.offset();
  if (const auto at = plane_.offsetAlong(event.ray, taken_))
    offset = *at - grabbed_;
  else  // looked at end on: up is forward
    offset += (lastAt_.y() - event.at.y()) * event.millimetresPerPixel;
  lastAt_ = event.at;
  const double step = host().gridSpacing();
  if (event.modifiers.testFlag(Qt::ControlModifier) && step > 0) offset = std::round(offset / step) * step;
  moveTo(offset);
}

bool SectionTool::release(const ToolEvent&) {
  if (!dragging_) return false;
  dragging_ = false;
  emit changed();
  return true;
}

bool SectionTool::key(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;  // shortcuts
  const auto [low, high] = plane_.range(extent_);
  const double step = (high - low) / (event.modifiers().testFlag(Qt::ShiftModifier) ? 10 : 100);
  switch (event.key()) {
    case Qt::Key_X:
      choose(SectionAxis::X);
      return true;
    case Qt::Key_Y:
      choose(SectionAxis::Y);
      return true;
    case Qt::Key_Z:
      choose(SectionAxis::Z);
      return true;
    case Qt::Key_P:
      choose(SectionAxis::Face);
      return true;
    case Qt::Key_F:
      plane_.flip();
      apply();
      return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
      moveTo(plane_.offset() + (event.key() == Qt::Key_Up ? step : -step));
      return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      turnOff();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      emit finished();
      return true;
    case Qt::Key_Escape:
      if (!pickingFace_) return false;
      pickingFace_ = false;
      apply();
      return true;
    default:
      return false;
  }
}

void SectionTool::choose(SectionAxis axis) {
  pickingFace_ = axis == SectionAxis::Face;
  if (!pickingFace_) plane_.setAxis(axis, extent_);
  apply();
}

void SectionTool::moveTo(double offset) {
  // Beyond the model there is nothing to cut; a little margin shows that it is through.
  const auto [low, high] = plane_.range(extent_);
  const double margin = 0.02 * (high - low);
  const double rounding = 1e-9 * (high - low);  // of steps there and back
  plane_.setOffset(std::abs(offset) < rounding ? 0 : std::clamp(offset, low - margin, high + margin));
  apply();
}

void SectionTool::apply() {
  host().setSection(plane_.plane());
  if (panel_) panel_->show(plane_, plane_.range(extent_), pickingFace_);
  emit changed();
}

void SectionTool::turnOff() {
  host().setSection(std::nullopt);
  emit finished();
}

void SectionTool::documentChanged() {
  const Bounds now = host().extent();
  if (now.empty) return;
  extent_ = now;
  apply();
}

std::vector<vtkSmartPointer<vtkProp>> SectionTool::props() const {
  const Frame f = frame();
  const double scale = host().pixelRatio();
  const bool warm = dragging_ || hovered_;
  const Color color = warm ? host().look().made : host().look().control;
  const Vec3 back = (f.centre - f.tip) * 0.22;
  const Vec3 side = plane_.direction().unitOrthogonal() * back.norm() * 0.5, other = plane_.direction().cross(side);
  const std::vector<Vec3> border{f.corners[0], f.corners[1], f.corners[2], f.corners[3], f.corners[0]};
  const std::vector<Vec3> ring{f.tip + back + side, f.tip + back + other, f.tip + back - side, f.tip + back - other};
  std::vector<std::array<Vec3, 3>> head;
  for (std::size_t i = 0; i < 4; ++i) head.push_back({f.tip, ring[i], ring[(i + 1) % 4]});
  return {
      trianglesProp({{f.corners[0], f.corners[1], f.corners[2]}, {f.corners[0], f.corners[2], f.corners[3]}}, color, 0.07),
      linesProp({border}, color, (warm ? 2.2 : 1.4) * scale), linesProp({{f.centre, f.tip}}, color, 2.2 * scale),
      trianglesProp(head, color, 1), pointsProp({f.centre}, color, 9 * scale)};
}

}  // namespace blossom::ui
