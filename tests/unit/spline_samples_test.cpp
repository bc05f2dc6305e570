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
      const auto parts = planar::samplesOf(spline, tolerance, {});
      QCOMPARE(parts.size(), std::size_t{1});
      const std::vector<planar::CurveSample>& samples = parts.front();
      for (std::size_t i = 1; i < samples.size(); ++i) twice += cross(samples[i - 1].at, samples[i].at);
      const double missing = std::numbers::pi * a * b - std::abs(twice) / 2;
      QVERIFY2(missing > 0, qPrintable(QString::number(missing)));
      QVERIFY2(missing <= tolerance * perimeter, qPrintable(QString::number(missing / perimeter)));
    }
  }

  /// A cubic with short handles at 0.19 radians is a line but for its ends: no chord of it may turn by both at once.
  void chordsAreLikeArcs() {
    const double dx = 0.01 * std::cos(0.19), dy = 0.01 * std::sin(0.19);
    const Spline2 spline{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 1}, {dx, dy, 1}, {10 - dx, dy, 1}, {10, 0, 1}}};
    constexpr double tolerance = 0.01;
    const auto parts = planar::samplesOf(spline, tolerance, {});
    QCOMPARE(parts.size(), std::size_t{1});
    for (std::size_t i = 1; i < parts.front().size(); ++i) {
      const auto &from = parts.front()[i - 1], &to = parts.front()[i];
      const double rise = (to.at - from.at).norm() * std::abs(to.normal - from.normal) / 8;
      QVERIFY(rise <= 2 * tolerance);  // of the arc; that of the curve is within the tolerance
    }
  }

  /// Each part is a curve, however short, and a closed one with a kink where it begins has two.
  void partsHaveTwoPointsAtLeast() {
    for (const double size : {1e-6, 1e-3, 1.0})
      for (const double turn : {0.05, 0.3, 2.0}) {
        const double rise = size / 3 * std::tan(turn / 2);
        const Spline2 bow{
            3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 1}, {size / 3, rise, 1}, {2 * size / 3, rise, 1}, {size, 0, 1}}};
        for (const auto& part : planar::samplesOf(bow, 1e-2, {})) QVERIFY(part.size() >= 2);
      }
    const Spline2 drop{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 1}, {3, 3, 1}, {-3, 3, 1}, {0, 0, 1}}};
    const auto parts = planar::samplesOf(drop, 1e-2, {});
    QCOMPARE(parts.size(), std::size_t{2});
    for (const auto& part : parts) QVERIFY(part.size() >= 2);
    QCOMPARE(parts.front().back().at, parts.back().front().at);
  }

  void kinksDivideASpline() {
    const Spline2 corner{1, {0, 0, 1, 2, 2}, {{0, 0, 1}, {4, 3, 1}, {8, 0, 1}}};
    const auto parts = planar::samplesOf(corner, 1e-3, {});
    QCOMPARE(parts.size(), std::size_t{2});
    for (const std::size_t k : {0, 1}) {
      QCOMPARE(parts[k].size(), std::size_t{2});
      const Vec2 along = parts[k].back().at - parts[k].front().at;
      for (const planar::CurveSample& sample : parts[k])
        COMPARE_NEAR(std::remainder(sample.normal - std::atan2(-along.x(), along.y()), 2 * std::numbers::pi), 0, 1e-12);
    }
  }
};

BLOSSOM_TEST(SplineSamplesTest)
#include "spline_samples_test.moc"
