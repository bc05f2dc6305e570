#pragma once
#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"
#include "support/support.h"

/// Points of planar curves, compared.
namespace blossom::test {

inline Vec2 pointOf(const Spline2& spline, double t) { return point(toCurve(spline), t).head<2>(); }

inline void comparePoints(const Vec2& actual, const Vec2& expected, double tolerance = 1e-12) {
  QVERIFY2(
      (actual - expected).norm() <= tolerance,
      qPrintable(QString("(%1, %2) is not (%3, %4)").arg(actual.x()).arg(actual.y()).arg(expected.x()).arg(expected.y())));
}

}  // namespace blossom::test
