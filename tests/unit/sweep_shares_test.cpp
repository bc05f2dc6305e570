// The shares of a pull as keys and wheel set them, and the targets that they can bring a place to.
#include "geometry/bspline/bspline.h"
#include "support/motion_samples.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/manipulators/edit_region.h"
#include "sweep/manipulators/reachable_target.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

class SweepSharesTest : public QObject {
  Q_OBJECT

 private slots:
  void aKeyWithShiftAddsItsShareOrTakesItAway() {
    PullMode mode;
    QVERIFY((mode.weights() == PullWeights{0, 1, 1}));
    QVERIFY(mode.keyWithShift(Qt::Key_T));
    QVERIFY((mode.weights() == PullWeights{0.5, 1, 1}));  // all of the way would leave nothing to the others
    QVERIFY(mode.keyWithShift(Qt::Key_S));
    QVERIFY((mode.weights() == PullWeights{0.5, 1, 0}));
    QVERIFY(mode.keyWithShift(Qt::Key_R));
    QVERIFY((mode.weights() == PullWeights{1, 0, 0}));  // the last one goes all the way
    QVERIFY(mode.keyWithShift(Qt::Key_T));
    QVERIFY((mode.weights() == PullWeights{1, 0, 0}));  // one of them stays
    QVERIFY(mode.key(Qt::Key_T));
    QVERIFY((mode.weights() == PullWeights{0, 1, 1}));
    QVERIFY(mode.key(Qt::Key_T) && mode.keyWithShift(Qt::Key_R));
    QVERIFY((mode.weights() == PullWeights{0.5, 1, 0}));
    QVERIFY(mode.key(Qt::Key_W) && mode.twists());
    QVERIFY((mode.weights() == PullWeights{0, 0, 0}));
    QVERIFY(mode.keyWithShift(Qt::Key_T) && !mode.twists());
    QVERIFY((mode.weights() == PullWeights{0.5, 1, 1}));
    QVERIFY(!mode.keyWithShift(Qt::Key_W) && !mode.keyWithShift(Qt::Key_4) && !mode.keyWithShift(Qt::Key_M));
  }

  void theWheelSetsTheShareOfTheKeyPressedLast() {
    PullMode mode;
    QCOMPARE(mode.adjustable(), QString("R"));
    QVERIFY(mode.addTenths(-3));
    QVERIFY((mode.weights() == PullWeights{0, 0.7, 1}));
    mode.keyWithShift(Qt::Key_T);
    QCOMPARE(mode.adjustable(), QString("T"));
    QVERIFY(mode.addTenths(2));
    QVERIFY((mode.weights() == PullWeights{0.7, 0.7, 1}));
    QVERIFY2(mode.wayText().contains("70 %"), qPrintable(mode.wayText()));
    QVERIFY(mode.addTenths(50));
    QVERIFY((mode.weights() == PullWeights{0.9, 0.7, 1}));
    QVERIFY(mode.addTenths(-50));
    QVERIFY((mode.weights() == PullWeights{0.1, 0.7, 1}));
    mode.key(Qt::Key_S);
    QVERIFY(mode.adjustable().isEmpty());
    QVERIFY(!mode.addTenths(-1));
    QVERIFY((mode.weights() == PullWeights{0, 0, 1}));
  }

  void whatIsReachableArrives() {
    auto random = seededRandom();
    for (int k = 0; k < 300; ++k) {
      Motion motion = randomMotion(random, ClosedU::No);
      if (k % 3 == 1) motion.point.x() = 0;
      const MotionPlace at{randomIn(random, motion.domainU()), randomIn(random, motion.domainV())};
      const bool turns = k % 2 == 0;
      const PullWeights weights{k % 5 == 0 ? 0 : uniform(random, 0.1, 0.9), turns ? 1.0 : 0.0, turns ? 0.0 : 1.0};
      const Vec3 x = evaluate(motion, at.u, at.v).point;
      const Vec3 wanted = x + Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      const Vec3 target = reachableTarget(motion, at, weights, wanted);
      const EditResult result = pull(motion, {{at}, {target}, weights});
      QVERIFY2(result.obstacles.empty(), qPrintable(QString("%1: %2 left").arg(k).arg(result.remainder)));
      const double off = (evaluate(result.motion, at.u, at.v).point - target).norm();
      QVERIFY2(off < 1e-8, qPrintable(QString("%1: %2").arg(k).arg(off)));
      // It is the nearest one: a target that is reachable is left where it is.
      const double moved = (reachableTarget(motion, at, weights, target) - target).norm();
      QVERIFY2(moved < 1e-9, qPrintable(QString::number(moved)));
      if (!turns && (motion.point.array() != 0).all()) QVERIFY((target - wanted).norm() < 1e-9);
    }
  }

  void whereNothingIsMissingTheWishIsTheTarget() {
    const Motion motion = readMotionOf("cylinder.json");
    const Vec3 wanted(14, 3, 25);
    for (const PullWeights& weights : {PullWeights{0, 1, 1}, PullWeights{1, 0, 0}, PullWeights{0.5, 0.3, 1}})
      QVERIFY(reachableTarget(motion, {0, 0.5}, weights, wanted) == wanted);
  }

  /// Sections that move are moved all around, however small their share.
  void theRegionOfSeveralSharesIsThatOfAllOfThem() {
    const Motion motion = readMotionOf("cylinder.json");
    PullMode mode;
    mode.key(Qt::Key_S);
    const EditRegion alone = editRegion(motion, {0.4, 0.5}, mode);
    QVERIFY(!alone.around);
    mode.keyWithShift(Qt::Key_T);
    const EditRegion both = editRegion(motion, {0.4, 0.5}, mode);
    QVERIFY(both.around);
    QVERIFY(both.firstV <= alone.firstV && both.lastV >= alone.lastV);
  }
};

BLOSSOM_TEST(SweepSharesTest)
#include "sweep_shares_test.moc"
