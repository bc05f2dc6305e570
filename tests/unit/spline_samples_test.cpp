#include "geometry/planar/fitting/spline_samples.h"

#include <numbers>

#include "geometry/planar/planar.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

/// Points of splines whose chords keep a tolerance.
class SplineSamplesTest : public QObject {
  Q_OBJECT

 private slots:
  /// An inscribed polygon misses less than the tolerance times the perimeter of an ellipse, and needs so many chords.
  void chordsKeepEveryTolerance() {
    const double a = 3, b = 1, perimeter = 13.364893220555258;
    const Spline2 spline = ellipticArc({0, 0}, {a, 0}, b / a, 0, 2 * std::numbers::pi);
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-10}) {
      double twice = 0;
      const std::vector<planar::CurveSample> samples = planar::samplesOf(spline, tolerance, {});
      for (std::size_t i = 1; i < samples.size(); ++i) twice += cross(samples[i - 1].at, samples[i].at);
      const double missing = std::numbers::pi * a * b - std::abs(twice) / 2;
      QVERIFY2(missing > 0, qPrintable(QString::number(missing)));
      QVERIFY2(missing <= tolerance * perimeter, qPrintable(QString::number(missing / perimeter)));
    }
  }
};

BLOSSOM_TEST(SplineSamplesTest)
#include "spline_samples_test.moc"
