// The numbers beside a place under the mouse, and beside one that is dragged.
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/manipulators/marks/pull_numbers.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

class SweepNumbersTest : public QObject {
  Q_OBJECT
 private slots:
  void aPlaceIsToldInThousandthsOfItsRange() {
    Motion motion = primitiveMotion({.radius = 10, .rows = 16, .columns = 12}).motion;
    QCOMPARE(placeNumbers(motion, {0.87512, 0.5}), QStringLiteral("u 0.875  v 0.500"));
    QCOMPARE(placeNumbers(motion, {1.25, -1e-17}), QStringLiteral("u 0.250  v 0.000"));  // within the period
    for (std::vector<double>* knots : {&motion.trajectory.knots, &motion.orientation.knotsV, &motion.scaling.knotsV})
      for (double& knot : *knots) knot *= 200;
    QCOMPARE(placeNumbers(motion, {0.1, 123.4567}), QStringLiteral("u 0.100  v 123.5"));
  }

  void aDragIsToldAsFinelyAsTheMouseMoves() {
    QCOMPARE(dragNumbers(62.04, 52.0, {}, 0.2), QStringLiteral("r 62.0 mm, Δ 52.0"));
    QCOMPARE(dragNumbers(62.04, 52.0, {}, 0.02), QStringLiteral("r 62.04 mm, Δ 52.00"));
    QCOMPARE(dragNumbers(6204, 52.3, {}, 3), QStringLiteral("r 6204 mm, Δ 52"));
    QCOMPARE(dragNumbers(50.8, 25.4, {"in", 25.4}, 0.5), QStringLiteral("r 2.00 in, Δ 1.00"));
  }
};

BLOSSOM_TEST(SweepNumbersTest)
#include "sweep_numbers_test.moc"
