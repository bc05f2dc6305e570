#include <Eigen/Geometry>
#include <numbers>

#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/direct_manipulation.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/validity.h"
#include "sweep/kernel/vanishing.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

class SweepManipulationTest : public QObject {
  Q_OBJECT
 private slots:
  void scaleDragArrives() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 300; ++k) {
      Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
      const Vec3 target(uniform(random, -20, 20), uniform(random, -20, 20), uniform(random, -20, 20));
      dragScaling(motion, u, v, target);
      worst = std::max(worst, (evaluate(motion, u, v).point - target).norm());
      validate(motion);
    }
    QVERIFY2(worst < 1e-11, qPrintable(QString::number(worst)));
  }

  void twistTurnsTheFrameByItsAngle() {
    auto random = seededRandom();
    for (int k = 0; k < 300; ++k) {
      Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV()),
                   degrees = uniform(random, -170, 170);
      const Vec3 axis(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.2, 1)),
          centre = point(motion.trajectory, v);
      const Vec3 arm = evaluate(motion, u, v).point - centre;
      const double length = evaluate(motion.orientation, u, v).norm();
      twistOrientation(motion, u, v, axis, degrees);
      validate(motion);
      const Vec3 wanted = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()) * arm;
      QVERIFY((evaluate(motion, u, v).point - centre - wanted).norm() < 1e-11 * (1 + arm.norm()));
      // The quaternion keeps its length: no drift over many twists.
      COMPARE_NEAR(evaluate(motion.orientation, u, v).norm(), length, 1e-13 * length);
    }
  }

  /// Frames about one axis turn through zero quaternions where a place turns nearly once around, and its surroundings do
  /// not.
  void aTwistThatLetsTheOrientationVanishIsRefused() {
    const Motion motion =
        *motionFormat().read(sample("cylinder.json"), Value::object(), Progress::none()).shape.get<Motion>();
    const auto twisted = [](const Motion& given, double angle, int level) {
      return twist(given, {{{0.3, 0.5}}, Vec3::UnitZ(), angle, {}, {}, level}).motion;
    };
    for (const double angle : {330.0, 350.0, -350.0, 360.0}) {
      try {
        (void)twisted(motion, angle, 0);
        QFAIL("twisted");
      } catch (const Error& error) {
        QCOMPARE(error.code(), ErrorCode::Degenerate);
        QVERIFY2(error.message().find("near u = 0.") != std::string::npos, error.what());
        QVERIFY2(error.hint().find("coarser level") != std::string::npos, error.hint().c_str());
      }
      // What the hint says: two halves there are the same twist, on two levels they are another.
      VERIFY_ERROR(twisted(twisted(motion, angle / 2, 0), angle / 2, 0), ErrorCode::Degenerate);
      const Motion both = twisted(twisted(motion, angle / 2, -1), angle / 2, 1);
      QVERIFY(!vanishingPlace(both.orientation));
      const Vec3 arm = evaluate(motion, 0.3, 0.5).point - point(motion.trajectory, 0.5),
                 wanted = Eigen::AngleAxisd(angle * std::numbers::pi / 180, Vec3::UnitZ()) * arm;
      QVERIFY((evaluate(both, 0.3, 0.5).point - point(both.trajectory, 0.5) - wanted).norm() < 1e-11 * arm.norm());
    }
    // One that vanished already, where the twist does not reach, may be twisted: it may be about to be mended.
    Motion vanishing = motion;
    for (std::size_t i = 0; i < motion.orientation.countU(); ++i) vanishing.orientation.pole(i, 0).setZero();
    (void)twisted(vanishing, 30, 0);
  }

  void aDragIsLocal() {
    Motion motion = *motionFormat().read(sample("cylinder.json"), Value::object(), Progress::none()).shape.get<Motion>();
    const Vec3 far = evaluate(motion, 0.8, 0.5).point;
    dragScaling(motion, 0.25, 0.5, Vec3(0, 15, 20));
    QVERIFY((evaluate(motion, 0.25, 0.5).point - Vec3(0, 15, 20)).norm() < 1e-12);
    QVERIFY(evaluate(motion, 0.8, 0.5).point == far);
  }

  void whatScalingCannotReachIsSaid() {
    Motion motion = *motionFormat().read(sample("cylinder.json"), Value::object(), Progress::none()).shape.get<Motion>();
    VERIFY_ERROR(dragScaling(motion, 0.25, 0.5, Vec3(3, 15, 20)), ErrorCode::InvalidParameter);
    VERIFY_ERROR(twistOrientation(motion, 0.25, 0.5, Vec3::Zero(), 30), ErrorCode::InvalidParameter);
  }

  void validityFindsTheFold() {
    Motion motion = *motionFormat().read(sample("cylinder.json"), Value::object(), Progress::none()).shape.get<Motion>();
    QVERIFY(examine(motion).smallestShare > 0.99);
    // The radius runs to zero at the end v = 1.
    for (std::size_t i = 0; i < motion.scaling.countU(); ++i)
      motion.scaling.pole(i, motion.scaling.countV() - 1).head<3>().setZero();
    const Validity collapsed = examine(motion);
    QVERIFY(collapsed.smallestShare < 1e-12);
    COMPARE_NEAR(collapsed.v, 1, 0);
  }

  /// A double cone, whose radius goes from 10 to -10 (1 - c) / c: its tip is at v = c, wherever samples are.
  void validityFindsTipsBetweenSamples() {
    const Motion cylinder =
        *motionFormat().read(sample("cylinder.json"), Value::object(), Progress::none()).shape.get<Motion>();
    auto random = seededRandom();
    for (int k = 0; k < 40; ++k) {
      const double tip = uniform(random, 0.05, 0.95);
      Motion motion = cylinder;
      Surface& scaling = motion.scaling;
      for (std::size_t i = 0; i < scaling.countU(); ++i)
        for (std::size_t j = 0; j < scaling.countV(); ++j) {
          double greville = 0;
          for (int d = 1; d <= scaling.degreeV; ++d) greville += scaling.knotsV[j + static_cast<std::size_t>(d)];
          scaling.pole(i, j).head<3>() *= 1 - greville / scaling.degreeV / tip;
        }
      const Validity found = examine(motion);
      QVERIFY2(found.smallestShare < 1e-6, qPrintable(QString::number(found.smallestShare)));
      COMPARE_NEAR(found.v, tip, 1e-6);
    }
  }

  /// A torus whose section reaches beyond its axis runs through two points of the axis; one that does not has a least normal
  /// on the inside, (R - r) / (R + r) of the largest on the outside.
  void validityKnowsASpindleFromATorus() {
    auto random = seededRandom();
    for (int k = 0; k < 40; ++k) {
      const double profile = uniform(random, 0.2, 3);
      if (std::abs(profile - 1) < 1e-3) continue;
      Motion motion = primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 1, .profile = 0.5}).motion;
      motion.point *= profile / 0.5;
      const double share = examine(motion).smallestShare;
      if (profile > 1)
        QVERIFY2(share < 1e-6, qPrintable(QString::number(profile)));
      else
        QVERIFY2(share > 0.5 * (1 - profile) / (1 + profile), qPrintable(QString::number(profile)));
    }
  }
};

BLOSSOM_TEST(SweepManipulationTest)
#include "sweep_manipulation_test.moc"
