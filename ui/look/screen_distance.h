#pragma once
#include <QPointF>
#include <algorithm>
#include <cmath>

namespace blossom::ui {

/// Distance in pixels of a point from the segment between two others.
inline double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF along = b - a, from = p - a;
  const double square = QPointF::dotProduct(along, along);
  const double share = square > 0 ? std::clamp(QPointF::dotProduct(from, along) / square, 0.0, 1.0) : 0;
  const QPointF off = from - share * along;
  return std::hypot(off.x(), off.y());
}

}  // namespace blossom::ui
