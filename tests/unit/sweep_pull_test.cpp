#include <Eigen/Geometry>

#include "support/motion_sizes.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// Open, periodic and anti-periodic motions in turn; those that close have 1 to 9 rows, often as few as 3. A point of the
/// frame has components that are zero now and then.
Motion anyMotion(Random& random, int k) {
  const ClosedU closed = static_cast<ClosedU>(k % 3);
  Motion motion = randomMotion(random, closed, k % 5 == 0, k % 2 == 0 ? uniformInt(random, 1, 3) : 9);
  for (int i = uniformInt(random, 0, 2); i > 0; --i) motion.point[uniformInt(random, 0, 2)] = 0;
  if (motion.point.isZero()) motion.point.z() = 1;
  return motion;
}

Vec3 anywhere(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

enum class Way { Translate, Rotate, Scale, RotateAndScale, AllThree };

/// A target that the shares of this way can reach.
MotionPull reachable(Random& random, const Motion& motion, const MotionPlace& at, Way way) {
  const Vec3 centre = blossom::point(motion.trajectory, at.v), arm = evaluate(motion, at.u, at.v).point - centre;
  const double r = uniform(random, 0.1, 1), t = uniform(random, 0.1, 1);
  const bool whole = (motion.point.array() == 0).any();
  switch (way) {
    case Way::Translate:
      return {{at}, {anywhere(random, 20)}, {t, 0, 0}};
    case Way::Rotate:
      return {{at}, {centre + arm.norm() * anywhere(random, 1).normalized()}, {0, r, 0}};
    case Way::Scale: {
      const Vec4 q = evaluate(motion.orientation, at.u, at.v);
      const Vec3 inFrame = (motion.point.array() == 0).select(0, anywhere(random, 20).array());
      return {{at}, {centre + Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized() * inFrame}, {0, 0, r}};
    }
    case Way::RotateAndScale:
      return {{at}, {anywhere(random, 20)}, {0, 1, r}};
    case Way::AllThree:
      return {{at}, {anywhere(random, 20)}, {t, whole ? 1 : r, 1}};
  }
  return {};
}

bool nearlyNoFrame(const Motion& motion, const MotionPlace& at) {
  return evaluate(motion.orientation, at.u, at.v).norm() < 0.05;
}

MotionPlace anyPlace(Random& random, const Motion& motion) {
  return {randomParameter(random, motion.domainU()), randomParameter(random, motion.domainV())};
}

std::string whatOf(const EditResult& result) {
  return result.obstacles.empty() ? "" : explain(result.obstacles.front()).what;
}

/// Poles that have changed although their basis function is 0 at the place, and repeated rows that differ.
void verifyLocal(const Surface& before, const Surface& after, const MotionPlace& at, std::size_t free) {
  for (std::size_t i = 0; i < free; ++i)
    for (std::size_t j = 0; j < before.countV(); ++j) {
      if (sameBits(before.pole(i, j), after.pole(i, j))) continue;
      // Some copy of row i lies over u, and column j over v.
      const auto over = [](const std::vector<double>& knots, std::size_t k, int degree, double t) {
        return t >= knots[k] && t <= knots[k + static_cast<std::size_t>(degree) + 1];
      };
      bool overU = false;
      for (std::size_t k = i; k < before.countU(); k += free) overU = overU || over(before.knotsU, k, before.degreeU, at.u);
      QVERIFY(overU && over(before.knotsV, j, before.degreeV, at.v));
    }
}

}  // namespace

class SweepPullTest : public QObject {
  Q_OBJECT

 private slots:
  void dragsArrive() {
    auto random = seededRandom();
    double worst = 0, worstSaid = 0;
    int drags = 0, small = 0, few = 0;
    for (int k = 0; drags < 20000; ++k) {
      const Motion motion = anyMotion(random, k);
      for (int i = 0; i < 20; ++i) {
        const MotionPlace at = anyPlace(random, motion);
        if (nearlyNoFrame(motion, at)) continue;
        const MotionPull edit = reachable(random, motion, at, static_cast<Way>(uniformInt(random, 0, 4)));
        const EditResult result = pull(motion, edit);
        QVERIFY2(result.obstacles.empty(), whatOf(result).c_str());
        const double left = (evaluate(result.motion, at.u, at.v).point - edit.to[0]).norm(),
                     size = std::max(sizeOfPoles(motion, at.u, at.v), sizeOfPoles(result.motion, at.u, at.v));
        worst = std::max(worst, left / size);
        worstSaid = std::max(worstSaid, std::abs(left - result.remainder) / size);
        QVERIFY2(left <= 1e-12 * size, qPrintable(QString("%1 of %2").arg(left).arg(size)));
        ++drags;
        if (motion.closedU != ClosedU::No && motion.scaling.countU() <= 3 + static_cast<std::size_t>(motion.scaling.degreeU))
          ++few;
        if (left <= 1e-13 * (20 + edit.to[0].norm())) ++small;
      }
    }
    QVERIFY(worstSaid <= 1e-15);
    QVERIFY(few > 2000);
    std::printf("figure drags %d\nfigure drag_miss_share %.3g\nfigure drags_of_few_rows %d\n", drags, worst, few);
    std::printf("figure drags_within_1e13 %.4g\n", small / static_cast<double>(drags));
  }

  void onlyWhatLiesOverThePlaceChanges() {
    auto random = seededRandom();
    for (int k = 0; k < 600; ++k) {
      const Motion motion = anyMotion(random, k);
      const MotionPlace at = anyPlace(random, motion);
      if (nearlyNoFrame(motion, at)) continue;
      const Way way = static_cast<Way>(uniformInt(random, 0, 4));
      const EditResult result = pull(motion, reachable(random, motion, at, way));
      const Motion& after = result.motion;
      validate(after);
      QVERIFY(repeatsItsRows(after));
      QVERIFY(result.movedPoles > 0);
      const bool translates = way == Way::Translate || way == Way::AllThree,
                 rotates = way == Way::Rotate || way == Way::RotateAndScale || way == Way::AllThree,
                 scales = way != Way::Translate && way != Way::Rotate;
      QVERIFY(translates || sameBits(after.trajectory.poles, motion.trajectory.poles));
      QVERIFY(rotates || sameBits(after.orientation.poles, motion.orientation.poles));
      QVERIFY(scales || sameBits(after.scaling.poles, motion.scaling.poles));
      const auto free = [&](const Surface& s) {
        return s.countU() - (motion.closedU == ClosedU::No ? 0 : static_cast<std::size_t>(s.degreeU));
      };
      verifyLocal(motion.orientation, after.orientation, at, free(motion.orientation));
      verifyLocal(motion.scaling, after.scaling, at, free(motion.scaling));
      for (std::size_t j = 0; j < motion.trajectory.poles.size(); ++j) {
        const auto& knots = motion.trajectory.knots;
        const Vec4 &before = motion.trajectory.poles[j], &now = after.trajectory.poles[j];
        QCOMPARE(now[3], before[3]);
        if (!sameBits(now, before))
          QVERIFY(at.v >= knots[j] && at.v <= knots[j + static_cast<std::size_t>(motion.trajectory.degree) + 1]);
      }
      for (std::size_t j = 0; j < motion.scaling.poles.size(); ++j)
        QCOMPARE(after.scaling.poles[j][3], motion.scaling.poles[j][3]);
    }
  }

  void thereAndBackIsTheStart() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 3000; ++k) {
      Motion motion = anyMotion(random, k);
      // The start is known to rounding in mm, and so must be its direction from the trajectory.
      for (double& each : motion.point)
        if (each != 0) each += each > 0 ? 0.5 : -0.5;
      const MotionPlace at = anyPlace(random, motion);
      if (nearlyNoFrame(motion, at)) continue;
      const MotionPull there = reachable(random, motion, at, static_cast<Way>(uniformInt(random, 0, 4)));
      MotionPull back = there;
      back.to = {evaluate(motion, at.u, at.v).point};
      const Motion dragged = pull(motion, there).motion, again = pull(dragged, back).motion;
      const auto compare = [&](const std::vector<Vec4>& a, const std::vector<Vec4>& b, const std::vector<Vec4>& between) {
        const double size = std::max(magnitude(a), magnitude(between));
        for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i] - b[i]).norm() / size);
      };
      compare(motion.trajectory.poles, again.trajectory.poles, dragged.trajectory.poles);
      compare(motion.orientation.poles, again.orientation.poles, dragged.orientation.poles);
      compare(motion.scaling.poles, again.scaling.poles, dragged.scaling.poles);
    }
    std::printf("figure there_and_back_share %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void sharesAreOfWhatIsLeft() {
    auto random = seededRandom();
    for (int k = 0; k < 300; ++k) {
      Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      const MotionPlace at{randomIn(random, motion.domainU()), randomIn(random, motion.domainV())};
      const Vec3 to = anywhere(random, 20), start = evaluate(motion, at.u, at.v).point;
      const double t = uniform(random, 0.1, 0.9), r = uniform(random, 0.1, 0.9);
      const Motion after = pull(motion, {{at}, {to}, {t, r, 0.3}}).motion;
      // The trajectory went by its share, the frame by its share of the angle that was left then, scaling the rest.
      const Vec3 centre = blossom::point(motion.trajectory, at.v) + t * (to - start);
      QVERIFY((blossom::point(after.trajectory, at.v) - centre).norm() < 1e-12 * 60);
      const Vec3 a = start + t * (to - start) - centre, b = to - centre;
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      const auto frame = [&](const Motion& m) {
        const Vec4 q = evaluate(m.orientation, at.u, at.v);
        return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
      };
      const Eigen::AngleAxisd wanted(r * angle, a.cross(b).normalized());
      QVERIFY((frame(after) * frame(motion).inverse()).angularDistance(Eigen::Quaterniond(wanted)) < 1e-7);
      QVERIFY((frame(after).toRotationMatrix() - wanted * frame(motion).toRotationMatrix()).norm() < 1e-12);
      QVERIFY((evaluate(after, at.u, at.v).point - to).norm() < 1e-11);
    }
  }

  void uPassesTheSeam() {
    auto random = seededRandom();
    const Motion motion = randomMotion(random, ClosedU::AntiPeriodic);
    const MotionPull inside{{{0.3, 0.4}}, {{5, 6, 7}}}, before{{{-0.7, 0.4}}, {{5, 6, 7}}};
    QVERIFY((evaluate(pull(motion, before).motion, 0.3, 0.4).point - Vec3(5, 6, 7)).norm() < 1e-12);
    QVERIFY((evaluate(pull(motion, inside).motion, 0.3, 0.4).point - Vec3(5, 6, 7)).norm() < 1e-12);
  }
};

BLOSSOM_TEST(SweepPullTest)
#include "sweep_pull_test.moc"
