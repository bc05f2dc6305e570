#include "manipulators/marks/pull_ring.h"

#include <Eigen/Geometry>
#include <QApplication>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace blossom::sweep {

namespace {

constexpr double radian = std::numbers::pi / 180;
constexpr double ringRadius = 26, letterRadius = 37.5, plateRadius = 9;  // pixels
constexpr double arcWidth = 3, idleWidth = 2, plateWidth = 7;
constexpr int letterPixels = 12;
constexpr double arcOfShare = 96;  // degrees; the rest of a third is a gap

constexpr std::array<char, 3> letters{'T', 'R', 'S'};
constexpr std::array<double, 3> middles{90, 330, 210};  // clockwise from the top, in the order in which they act

Vec3 onScreen(const Vec3& centre, const Facing& to, const Vec2& pixels) {
  return centre + to.pixel * (pixels.x() * to.right + pixels.y() * to.up);
}

Vec2 polar(double radius, double degrees) {
  return {radius * std::cos(degrees * radian), radius * std::sin(degrees * radian)};
}

/// Degrees counterclockwise from the right, as Qt has them but for its factor.
void drawArc(QPainter& painter, const QColor& color, double width, double from, double degrees) {
  if (!(degrees > 0)) return;
  constexpr double partsOfDegree = 16;
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
  painter.drawArc(QRectF(-ringRadius, -ringRadius, 2 * ringRadius, 2 * ringRadius),
                  static_cast<int>(std::lround(partsOfDegree * from)),
                  static_cast<int>(std::lround(partsOfDegree * degrees)));
}

void drawLetter(QPainter& painter, char letter, const QPointF& at, const QColor& color, const QColor& plate) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawEllipse(at, plateRadius, plateRadius);
  painter.setPen(color);
  const QPointF corner(plateRadius, plateRadius);
  painter.drawText(QRectF(at - corner, at + corner), Qt::AlignCenter, QString(QLatin1Char(letter)));
}

}  // namespace

Facing facing(const Vec3& towards, double millimetresPerPixel) {
  const Vec3 across = towards.cross(Vec3::UnitZ());
  constexpr double fromAbove = 1e-3;
  Facing to;
  to.right = across.norm() > fromAbove ? Vec3(across.normalized()) : Vec3::UnitX();
  to.up = to.right.cross(towards).normalized();
  to.pixel = millimetresPerPixel;
  return to;
}

QImage ringPicture(const PullWeights& weights, const Look& look, double pixelRatio) {
  const QColor active = ui::qtColor(look.made), plate = ui::qtColor(look.backgroundBottom),
               idle = ui::qtColor(mixed(look.control, look.backgroundBottom, 0.4));
  QImage image((QSizeF(2 * ringReach, 2 * ringReach) * pixelRatio).toSize(), QImage::Format_RGBA8888);
  image.setDevicePixelRatio(pixelRatio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(ringReach, ringReach);
  QFont font = QApplication::font();
  font.setPixelSize(letterPixels);
  font.setBold(true);
  painter.setFont(font);
  const std::array<double, 3> shares{weights.translate, weights.rotate, weights.scale};
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double from = middles[k] - arcOfShare / 2, filled = arcOfShare * shares[k];
    drawArc(painter, plate, plateWidth, from, arcOfShare);
    drawArc(painter, idle, idleWidth, from + filled, arcOfShare - filled);
    drawArc(painter, active, arcWidth, from, filled);
    const Vec2 middle = polar(letterRadius, middles[k]);
    drawLetter(painter, letters[k], {middle.x(), -middle.y()}, shares[k] > 0 ? active : idle, plate);
  }
  return image;
}

std::vector<std::vector<Vec3>> thickened(const std::vector<std::vector<Vec3>>& lines, const Facing& to, double width,
                                         double pixelRatio) {
  std::vector<std::vector<Vec3>> all;
  const long strokes = std::max(1L, std::lround(width * pixelRatio));
  const auto add = [&](const Vec2& pixels) {
    for (std::vector<Vec3> line : lines) {
      for (Vec3& p : line) p = onScreen(p, to, pixels);
      all.push_back(std::move(line));
    }
  };
  for (long k = 0; k < strokes; ++k) {
    const double off = (static_cast<double>(k) - static_cast<double>(strokes - 1) / 2) / pixelRatio;
    add({off, 0});  // a steep line needs copies beside it, a flat one above it
    if (off != 0) add({0, off});
  }
  return all;
}

std::vector<Vec3> arcOf(const TwistArc& twist, double radius) {
  const Vec3 foot = twist.centre + twist.arm.dot(twist.axis) * twist.axis;
  Vec3 radial = twist.arm - twist.arm.dot(twist.axis) * twist.axis;
  if (!(radial.norm() > radius * 1e-3)) radial = radius * twist.axis.unitOrthogonal();
  std::vector<Vec3> arc{foot};
  constexpr double step = 3;  // degrees
  const int steps = 1 + static_cast<int>(std::abs(twist.degrees) / step);
  for (int i = 0; i <= steps; ++i)
    arc.push_back(foot + Eigen::AngleAxisd(twist.degrees * radian * i / steps, twist.axis) * radial);
  arc.push_back(foot);
  return arc;
}

std::vector<Vec3> squareOnScreen(const Vec3& centre, const Facing& to, double half) {
  std::vector<Vec3> square;
  for (const Vec2& corner : {Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1)})
    square.push_back(onScreen(centre, to, half * corner));
  return square;
}

std::vector<std::vector<Vec3>> besides(const std::vector<std::vector<Vec3>>& lines, const Facing& to, double pixels) {
  std::vector<std::vector<Vec3>> all;
  for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
    for (std::vector<Vec3> line : lines) {
      for (Vec3& p : line) p = onScreen(p, to, pixels * side);
      all.push_back(std::move(line));
    }
  return all;
}

}  // namespace blossom::sweep
