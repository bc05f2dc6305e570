#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "support/motion_samples.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

bool says(const EditResult& result, Unreached why) {
  return std::any_of(result.obstacles.begin(), result.obstacles.end(), [&](const Obstacle& each) {
    const Explanation reason = explain(each);
    return each.why == why && reason.what.find("u = ") != std::string::npos && !reason.remedy.empty();
  });
}

/// Radius 10 about the z axis, from z = 0 to 40; x(0, 1/2) = (10, 0, 20). p has only an x component.
const MotionPlace middle{0, 0.5};

EditResult pullMiddle(const Vec3& to, const PullWeights& weights, const Vec3& axis = Vec3::Zero()) {
  return pull(readMotionOf("cylinder.json"), {{middle}, {to}, weights, axis});
}

}  // namespace

class SweepUnreachedTest : public QObject {
  Q_OBJECT

 private slots:
  void componentsThatAreZeroCannotBeScaled() {
    const EditResult result = pullMiddle({15, 3, 20}, {0, 0, 1});
    QVERIFY(says(result, Unreached::FrameAxis));
    COMPARE_NEAR(result.remainder, 3, 1e-12);
    // The rest of the way was gone.
    QVERIFY((evaluate(result.motion, 0, 0.5).point - Vec3(15, 0, 20)).norm() < 1e-12);
    QVERIFY(pullMiddle({15, 0, 20}, {0, 0, 1}).obstacles.empty());
    QVERIFY(pullMiddle({15, 3, 20}, {0, 1, 1}).obstacles.empty());
  }

  /// Whatever the shares could not do for one target alone, that there are two is the reason.
  void twoTargetsOfOnePlaceAreNamed() {
    for (const PullWeights& weights :
         {PullWeights{1, 0, 0}, PullWeights{0, 1, 0}, PullWeights{0, 0, 1}, PullWeights{0, 1, 1}}) {
      const EditResult result = pull(readMotionOf("cylinder.json"), {{middle, middle}, {{15, 0, 20}, {0, 15, 20}}, weights});
      QVERIFY(says(result, Unreached::TwoTargets));
      QVERIFY(result.obstacles.size() == 1);
    }
    QVERIFY(
        pull(readMotionOf("cylinder.json"), {{middle, middle}, {{15, 0, 20}, {15, 0, 20}}, {0, 0, 1}}).obstacles.empty());
  }

  /// Rotation could turn the place, but a pin or a copy holds the poles: neither axes nor shares are to blame.
  void whatHoldsAPlaceIsNamed() {
    const Motion motion = readMotionOf("cylinder.json");
    const MotionPlace at{0.125, 0.5};
    MotionPull pinned{{at}, {{20, 15, 20}}};
    pinned.pins = {at};
    const EditResult held = pull(motion, pinned);
    QVERIFY(says(held, Unreached::Pinned));
    QVERIFY(!says(held, Unreached::FrameAxis));
    MotionPull mirrored{{{0, 0.5}}, {{9, 9, 24}}};
    mirrored.symmetry.mirror = true;
    const EditResult copied = pull(motion, mirrored);
    QVERIFY(says(copied, Unreached::Symmetry));
    QVERIFY(!says(copied, Unreached::FrameAxis));
    const EditResult close = pull(motion, {{at, {0.1250001, 0.5}}, {{20, 15, 20}, {5, 5, 20}}});
    QVERIFY(says(close, Unreached::TooClose));
    QVERIFY(!says(close, Unreached::FrameAxis));
  }

  /// A place that is pulled beside a pin arrives, and what that costs elsewhere is told.
  void howFarPolesMoveIsTold() {
    const Motion motion = readMotionOf("cylinder.json");
    MotionPull one{{{0, 0.5}}, {{12, 0, 20}}, {1, 0, 0}};
    const EditResult alone = pull(motion, one);
    QVERIFY(alone.obstacles.empty() && alone.swing >= 1 && alone.swing < 4);
    double before = alone.swing;
    for (const double apart : {0.2, 0.05, 0.01}) {
      one.pins = {{0, 0.5 + apart}};
      const EditResult beside = pull(motion, one);
      QVERIFY(beside.obstacles.empty());
      double farthest = 0;
      for (std::size_t k = 0; k < motion.trajectory.poles.size(); ++k)
        farthest = std::max(farthest, (beside.motion.trajectory.poles[k] - motion.trajectory.poles[k]).head<3>().norm());
      COMPARE_NEAR(beside.swing, farthest / 2, 1e-9 * farthest);
      QVERIFY(beside.swing > before);
      before = beside.swing;
    }
    QVERIFY(before > wildSwing);
  }

  /// Of places far from each other each is judged for itself.
  void aWildEditIsToldBesideALargeOne() {
    const Motion motion = readMotionOf("cylinder.json");
    const auto on = [&](double u, double v) { return evaluate(motion, u, v).point; };
    MotionPull close{{{0.5, 0.5}, {0.5, 0.503}}, {on(0.5, 0.5) + Vec3(1, 0, 0), on(0.5, 0.503) - Vec3(1, 0, 0)}, {0, 0, 1}};
    const EditResult alone = pull(motion, close);
    QVERIFY(alone.swing > wildSwing);
    close.at.push_back({0, 0.5});
    close.to.push_back(on(0, 0.5) + Vec3(100, 0, 0));
    const EditResult beside = pull(motion, close);
    COMPARE_NEAR(beside.swing, alone.swing, 1e-6 * alone.swing);
    QVERIFY(beside.obstacles.empty());
  }

  /// Two places that go the same way by one factor ask nothing of the others.
  void roundingIsNoWish() {
    const Motion motion = readMotionOf("cylinder.json");
    const Vec3 by(7.3, 1.1, 2.7);
    for (const double apart : {0.005, 0.001}) {
      const MotionPlace a{0.125, 0.5}, b{0.125 + apart, 0.5};
      const MotionPull both{
          {a, b}, {evaluate(motion, a.u, a.v).point + by, evaluate(motion, b.u, b.v).point + by}, {1, 1, 1}};
      const EditResult moved = pull(motion, both);
      QVERIFY(moved.obstacles.empty() && moved.swing < 4);
      QVERIFY(moved.motion.orientation == motion.orientation && moved.motion.scaling == motion.scaling);
    }
    // Nor do they get knots for nothing.
    MotionPull finer{{{0.13, 0.47}}, {evaluate(motion, 0.13, 0.47).point + by}, {1, 1, 1}};
    finer.level = 3;
    const EditResult fine = pull(motion, finer);
    QVERIFY(fine.obstacles.empty());
    QVERIFY(fine.motion.trajectory.poles.size() > motion.trajectory.poles.size());
    QVERIFY(fine.motion.orientation == motion.orientation && fine.motion.scaling == motion.scaling);
    finer.to = {evaluate(motion, 0.13, 0.47).point};
    QVERIFY(pull(motion, finer).motion == motion);
  }

  void rotationKeepsTheRadius() {
    const EditResult result = pullMiddle({0, 25, 20}, {0, 1, 0});
    QVERIFY(says(result, Unreached::Radius));
    COMPARE_NEAR(result.remainder, 15, 1e-12);
    QVERIFY((evaluate(result.motion, 0, 0.5).point - Vec3(0, 10, 20)).norm() < 1e-12);
  }

  void nothingRotatesOnTheTrajectory() {
    Motion motion = readMotionOf("cylinder.json");
    for (Vec4& pole : motion.scaling.poles) pole.head<3>().setZero();
    const EditResult result = pull(motion, {{middle}, {{3, 4, 20}}, {0, 1, 0}});
    QVERIFY(says(result, Unreached::OnTrajectory));
    COMPARE_NEAR(result.remainder, 5, 1e-12);
    QCOMPARE(result.movedPoles, std::size_t(0));
    QVERIFY(result.motion == motion);
    const EditResult onto = pullMiddle({0, 0, 20}, {0, 1, 0});
    QVERIFY(says(onto, Unreached::TargetOnTrajectory));
    COMPARE_NEAR(onto.remainder, 10, 1e-12);
    // Scaling brings it there.
    QVERIFY(pullMiddle({0, 0, 20}, {0, 1, 1}).obstacles.empty());
  }

  /// Wherever a shape lies and however small it is, a place that stays behind by a 2000th of its radius has not arrived.
  void smallPullsFarFromTheOriginAreNotTakenForDone() {
    for (const double far : {0.0, 1e3, 1e6})
      for (const double size : {10.0, 1e-2}) {
        Motion motion = readMotionOf("cylinder.json");
        motion.point *= size / 10;
        for (Vec4& pole : motion.trajectory.poles) pole.head<3>() = size / 10 * pole.head<3>() + pole[3] * Vec3(far, far, 0);
        const Vec3 x = evaluate(motion, 0, 0.5).point;
        const EditResult turned = pull(motion, {{middle}, {x + Vec3(size / 2000, 0, 0)}, {0, 1, 0}});
        QVERIFY(says(turned, Unreached::Radius));
        COMPARE_NEAR(turned.remainder, size / 2000, 1e-15 * far + 1e-12 * size);
        const EditResult scaled = pull(motion, {{middle}, {x + Vec3(0, size / 2000, 0)}, {0, 0, 1}});
        QVERIFY(says(scaled, Unreached::FrameAxis));
        // What can be reached still arrives.
        QVERIFY(pull(motion, {{middle}, {x + Vec3(size / 3, -size / 2, size / 2000)}, {0.3, 1, 1}}).obstacles.empty());
      }
  }

  void theOppositeSideNeedsAnAxis() {
    const EditResult result = pullMiddle({-10, 0, 20}, {0, 1, 0});
    QVERIFY(says(result, Unreached::Opposite));
    COMPARE_NEAR(result.remainder, 20, 1e-12);
    auto random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      const Vec3 axis(uniform(random, -1, 1), uniform(random, 0.2, 1), uniform(random, -1, 1));
      const EditResult turned = pullMiddle({-10, 0, 20}, {0, 1, 0}, axis);
      QVERIFY(turned.obstacles.empty());
      QVERIFY((evaluate(turned.motion, 0, 0.5).point - Vec3(-10, 0, 20)).norm() < 1e-12 * 10);
    }
    QVERIFY(says(pullMiddle({-10, 0, 20}, {0, 1, 0}, Vec3::UnitX()), Unreached::AxisAlongArm));
    QVERIFY(says(pullMiddle({-10, 0, 20}, {0, 1, 0}, -3 * Vec3::UnitX()), Unreached::AxisAlongArm));
    // However nearly opposite, as long as it is not quite.
    for (double off = 1e-1; off > 1e-9; off /= 10) {
      const Vec3 near = Vec3(-10, 10 * off, 0).normalized() * 10 + Vec3(0, 0, 20);
      const EditResult close = pullMiddle(near, {0, 1, 0});
      QVERIFY(close.obstacles.empty());
      QVERIFY((evaluate(close.motion, 0, 0.5).point - near).norm() < 1e-12 * 10);
    }
  }

  void basisFunctionsThatCancelAreNamed() {
    // One row that comes back negated, piecewise linear: r(u) = (1 - 2 u) q, gone half-way.
    Motion motion = readMotionOf("cylinder.json");
    std::vector<Vec4> row(motion.orientation.countV(), Vec4(1, 0, 0, 0));
    motion.orientation = unwrapped(1, 3, {0, 1}, motion.orientation.knotsV, row, -1);
    validate(motion);
    const MotionTwist near{{{0.4, 0.5}}, Vec3::UnitZ(), 30}, at{{{0.5, 0.5}}, Vec3::UnitZ(), 30},
        close{{{0.5 + 1e-8, 0.5}}, Vec3::UnitZ(), 30};
    QVERIFY(twist(motion, near).obstacles.empty());
    VERIFY_ERROR(twist(motion, at), ErrorCode::Degenerate);
    const EditResult result = twist(motion, close);
    QVERIFY(says(result, Unreached::Cancelled));
    COMPARE_NEAR(result.remainder, 30, 1e-6);
    QVERIFY(result.motion == motion);
  }

  void placesThatContradictEachOtherAreNamed() {
    const Motion motion = readMotionOf("cylinder.json");
    const Vec3 a = evaluate(motion, 0.1, 0.5).point, b = evaluate(motion, 0.6, 0.5).point;
    // The trajectory is the same for all u.
    const EditResult apart = pull(motion, {{{0.1, 0.5}, {0.6, 0.5}}, {a + Vec3(0, 0, 4), b}, {1, 0, 0}});
    QVERIFY(says(apart, Unreached::TooClose));
    COMPARE_NEAR(apart.remainder, 2, 1e-12);
    QCOMPARE(apart.remainders.size(), std::size_t(2));
    const EditResult pinned = pull(motion, {{{0.1, 0.5}}, {a + Vec3(0, 0, 4)}, {1, 0, 0}, Vec3::Zero(), {{0.6, 0.5}}});
    QVERIFY(says(pinned, Unreached::Pinned));
    COMPARE_NEAR(pinned.remainder, 4, 1e-12);
    QVERIFY((evaluate(pinned.motion, 0.6, 0.5).point - b).norm() < 1e-12);
    MotionPull folded{{{0.1, 0.5}}, {a + Vec3(1, 0, 4)}, {1, 0, 0}};
    folded.symmetry.fold = 4;
    const EditResult copies = pull(motion, folded);
    QVERIFY(says(copies, Unreached::Symmetry));
    // What is along the axis all four want.
    COMPARE_NEAR(copies.remainder, 1, 1e-12);
  }

  void wrongEditsAreRefused() {
    const Motion motion = readMotionOf("cylinder.json");
    const auto refused = [&](const MotionPull& edit) { return pull(motion, edit); };
    VERIFY_ERROR(refused({{}, {}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(refused({{middle}, {}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(refused({{middle}, {Vec3::Zero()}, {0, 0, 0}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(refused({{middle}, {Vec3::Zero()}, {0, 2, 0}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(refused({{middle}, {Vec3::Zero()}, {0, std::nan(""), 1}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(refused({{{0.5, 1.5}}, {Vec3::Zero()}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(refused({{{std::nan(""), 0.5}}, {Vec3::Zero()}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(refused({{middle}, {Vec3(0, 0, std::nan(""))}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pull(readMotionOf("helicoid.json"), {{{1.5, 0.5}}, {Vec3::Zero()}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(twist(motion, {{middle}, Vec3::Zero(), 30}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(twist(motion, {{middle}, Vec3::UnitX(), 361}), ErrorCode::InvalidParameter);
    const std::vector<MotionPlace> many(401, middle);
    VERIFY_ERROR(refused({many, std::vector<Vec3>(401, Vec3::Zero())}), ErrorCode::LimitExceeded);
    CancelToken token;
    token.cancel();
    VERIFY_ERROR(pull(motion, {{middle}, {{20, 0, 20}}}, Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(SweepUnreachedTest)
#include "sweep_unreached_test.moc"
