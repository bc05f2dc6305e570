#include "ui/view/view_cube.h"

#include <Eigen/Geometry>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <array>

#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr double halfEdge = 25;  // pixels

struct SideFrame {
  const char* view;
  Vec3 normal, right, up;  // right and up as one reads the label from outside
};

const std::array<SideFrame, 6>& frames() {
  static const std::array<SideFrame, 6> all{{{"top", Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()},
                                             {"bottom", -Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitY()},
                                             {"front", -Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()},
                                             {"back", Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ()},
                                             {"left", -Vec3::UnitX(), -Vec3::UnitY(), Vec3::UnitZ()},
                                             {"right", Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}}};
  return all;
}

}  // namespace

ViewCube::ViewCube(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFixedSize(sizeHint());
  setAttribute(Qt::WA_NoSystemBackground);
}

void ViewCube::setTurn(const Turn& turn) {
  if (turn.yaw == turn_.yaw && turn.pitch == turn_.pitch) return;
  turn_ = turn;
  update();
}

QPointF ViewCube::project(const Vec3& p) const {
  return QRectF(rect()).center() + QPointF(p.dot(turn_.right()), -p.dot(turn_.up()));
}

std::vector<ViewCube::Side> ViewCube::visibleSides() const {
  std::vector<Side> sides;
  for (const SideFrame& frame : frames()) {
    const double facing = frame.normal.dot(turn_.toCamera());
    if (facing < 0.02) continue;
    const Vec3 middle = frame.normal * halfEdge, right = frame.right * halfEdge, up = frame.up * halfEdge;
    QPolygonF outline;
    for (const Vec3& corner :
         {Vec3(middle - right + up), Vec3(middle + right + up), Vec3(middle + right - up), Vec3(middle - right - up)})
      outline << project(corner);
    sides.push_back({QLatin1String(frame.view), outline, facing});
  }
  return sides;
}

void ViewCube::drawAxes(QPainter& painter) const {
  const Vec3 origin(-halfEdge, -halfEdge, -halfEdge);
  const std::array<std::pair<QColor, QString>, 3> axes{{{QColor(220, 95, 95), QStringLiteral("x")},
                                                        {QColor(105, 178, 105), QStringLiteral("y")},
                                                        {QColor(105, 145, 230), QStringLiteral("z")}}};
  QFont font = painter.font();
  font.setPixelSize(9);
  painter.setFont(font);
  for (int i = 0; i < 3; ++i) {
    const Vec3 along = Vec3::Unit(i) * (2 * halfEdge + 9);
    if (Vec3::Unit(i).cross(turn_.toCamera()).norm() < 0.15) continue;  // seen end on
    painter.setPen(QPen(axes[static_cast<std::size_t>(i)].first, 1.6, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(project(origin), project(origin + along));
    const QPointF label = project(origin + along * 1.13);
    painter.drawText(QRectF(label.x() - 8, label.y() - 8, 16, 16), Qt::AlignCenter,
                     axes[static_cast<std::size_t>(i)].second);
  }
}

void ViewCube::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawAxes(painter);
  const Theme& colors = theme();
  for (const Side& side : visibleSides()) {
    QColor fill = side.view == hovered_ ? colors.color("madeSoft") : colors.color("raised");
    if (side.view != hovered_)
      fill = colors.dark ? fill.lighter(static_cast<int>(88 + 30 * side.facing))
                         : fill.darker(static_cast<int>(116 - 18 * side.facing));
    painter.setPen(
        QPen(colors.color(side.view == hovered_ ? "made" : "muted"), 1.1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(fill);
    painter.drawPolygon(side.outline);
    if (side.facing < 0.3) continue;
    // The label lies on the side, turned with it.
    const QPolygonF flat(QVector<QPointF>{{0, 0}, {100, 0}, {100, 100}, {0, 100}});
    QTransform onSide;
    if (!QTransform::quadToQuad(flat, side.outline, onSide)) continue;
    QFont font = painter.font();
    font.setPixelSize(22);
    font.setWeight(QFont::DemiBold);
    QPainterPath text;
    const QFontMetricsF metrics(font);
    const QString label = side.view.toUpper();
    text.addText(50 - metrics.horizontalAdvance(label) / 2, 50 + metrics.capHeight() / 2, font, label);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.color(side.view == hovered_ ? "made" : "muted"));
    painter.drawPath(onSide.map(text));
  }
}

QString ViewCube::sideAt(QPointF at) const {
  for (const Side& side : visibleSides())
    if (side.outline.containsPoint(at, Qt::OddEvenFill)) return side.view;
  return {};
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
  const QString side = sideAt(event->position());
  if (side == hovered_) return;
  hovered_ = side;
  setCursor(side.isEmpty() ? Qt::ArrowCursor : Qt::PointingHandCursor);
  emit hint(side.isEmpty() ? QString() : tr("Click: look from %1").arg(side));
  update();
}

void ViewCube::mousePressEvent(QMouseEvent* event) {
  const QString side = sideAt(event->position());
  if (event->button() == Qt::LeftButton && !side.isEmpty())
    emit sideChosen(side);
  else
    event->ignore();
}

void ViewCube::leaveEvent(QEvent*) {
  if (hovered_.isEmpty()) return;
  hovered_.clear();
  emit hint({});
  update();
}

}  // namespace blossom::ui
