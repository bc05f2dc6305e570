#include "geometry/bspline/bspline.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/motion_knots.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// Largest difference of a factor's values over the magnitude of its poles.
double difference(Random& random, const Motion& a, const Motion& b) {
  double worst = 0;
  const auto compare = [&](const Vec4& x, const Vec4& y, const std::vector<Vec4>& poles) {
    worst = std::max(worst, (x - y).norm() / magnitude(poles));
  };
  for (int i = 0; i < 60; ++i) {
    const double u = randomParameter(random, a.domainU()), v = randomParameter(random, a.domainV());
    compare(evaluate(a.trajectory, v), evaluate(b.trajectory, v), a.trajectory.poles);
    compare(evaluate(a.orientation, u, v), evaluate(b.orientation, u, v), a.orientation.poles);
    compare(evaluate(a.scaling, u, v), evaluate(b.scaling, u, v), a.scaling.poles);
  }
  return worst;
}

std::vector<double> randomInserts(Random& random, int most) {
  std::vector<double> knots;
  for (int i = uniformInt(random, 0, most); i > 0; --i) knots.push_back(uniform(random, 0.001, 0.999));
  return knots;
}

/// A motion closed in u with very few rows.
Motion narrowRing(Random& random, std::size_t rows) {
  Motion motion = randomMotion(random, ClosedU::No, true);
  std::vector<double> period;
  for (std::size_t i = 0; i <= rows; ++i) period.push_back(static_cast<double>(i) / static_cast<double>(rows));
  const auto closed = [&](const Surface& like, double sign) {
    std::vector<Vec4> poles;
    for (std::size_t i = 0; i < rows * like.countV(); ++i)
      poles.push_back(sign < 0 ? randomQuaternion(random, uniform(random, 0, 3)) : randomScale(random));
    return unwrapped(3, 3, period, like.knotsV, poles, sign);
  };
  motion.closedU = ClosedU::AntiPeriodic;
  motion.orientation = closed(motion.orientation, -1);
  motion.scaling = closed(motion.scaling, 1);
  return motion;
}

}  // namespace

class SweepKnotsTest : public QObject {
  Q_OBJECT
 private slots:
  void valuesStay() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 300; ++k) {
      const Motion motion = k % 5 == 4 ? narrowRing(random, 1 + static_cast<std::size_t>(uniformInt(random, 0, 3)))
                                       : randomMotion(random, static_cast<ClosedU>(k % 3));
      const MotionKnots knots{.u = randomInserts(random, 6), .v = randomInserts(random, 6)};
      const Motion fine = withKnots(motion, knots);
      validate(fine);
      QCOMPARE(fine.orientation.countU(), motion.orientation.countU() + knots.u.size());
      QCOMPARE(fine.scaling.countV(), motion.scaling.countV() + knots.v.size());
      QCOMPARE(fine.trajectory.poles.size(), motion.trajectory.poles.size() + knots.v.size());
      QVERIFY(fine.domainU() == motion.domainU() && fine.domainV() == motion.domainV());
      worst = std::max(worst, difference(random, motion, fine));
    }
    std::printf("figure knots_share %.3g\n", worst);
    QVERIFY2(worst < 1e-13, qPrintable(QString::number(worst)));
  }

  void theSeamTakesKnots() {
    auto random = seededRandom();
    const Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus}).motion;
    for (const std::vector<double>& u : {std::vector<double>{0}, {1}, {0, 1}, {0.5, 0.5}, {0, 0.25, 1}}) {
      const Motion fine = withKnots(ring, {.u = u, .v = {}});
      validate(fine);
      QCOMPARE(fine.scaling.countU(), ring.scaling.countU() + u.size());
      QVERIFY(difference(random, ring, fine) < 1e-13);
      // And again: what was made can be refined further.
      const Motion finer = withKnots(fine, {.u = {0.1, 0.9}, .v = {0.3}});
      validate(finer);
      QVERIFY(difference(random, ring, finer) < 1e-13);
    }
    VERIFY_ERROR(withKnots(ring, {.u = {0, 0, 1}, .v = {}}), ErrorCode::InvalidParameter);
  }

  void onlyTheFactorsChosenGetThem() {
    const Motion motion = primitiveMotion({}).motion;
    const Motion fine = withKnots(motion, {.u = {0.3}, .v = {0.4}, .trajectory = false, .orientation = false});
    QVERIFY(fine.orientation == motion.orientation && fine.trajectory == motion.trajectory);
    QCOMPARE(fine.scaling.countU(), motion.scaling.countU() + 1);
    QCOMPARE(fine.scaling.countV(), motion.scaling.countV() + 1);
    QVERIFY(withKnots(motion, {}) == motion);
  }

  void whatWouldTearIsRefused() {
    const Motion motion = primitiveMotion({.kind = PrimitiveKind::Plane}).motion;
    VERIFY_ERROR(withKnots(motion, {.u = {1.5}, .v = {}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(withKnots(motion, {.u = {}, .v = {-0.1}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(withKnots(motion, {.u = {}, .v = {std::nan("")}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(withKnots(motion, {.u = {0.3, 0.3, 0.3, 0.3}, .v = {}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(withKnots(motion, {.u = {0}, .v = {}}), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(SweepKnotsTest)
#include "sweep_knots_test.moc"
