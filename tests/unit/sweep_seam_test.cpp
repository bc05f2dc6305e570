#include <Eigen/Geometry>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "support/motion_rings.h"
#include "support/motion_sizes.h"
#include "support/motions.h"
#include "support/support.h"
#include "support/symmetric_motions.h"
#include "sweep/kernel/begin/motion_from_curve.h"
#include "sweep/kernel/begin/motion_knots.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/begin/turning_spline.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/seam_v.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/quaternion.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// By what looks the same after the rotation of the ring by `turn`.
EditResult edit(const Motion& motion, const MotionPlace& at, EditWay way, const Eigen::Matrix3d& turn, int fold = 1) {
  return editRing(motion, {at, way, fold, 0, turn});
}

/// Point and derivatives in v of the exact surface, up to the second.
std::array<Vec3, 3> alongV(const Surface& surface, double u, double v) {
  const std::vector<Vec4> d = derivatives(isoU(surface, u), v, 2);
  const Vec3 p = d[0].head<3>() / d[0].w(), first = (d[1].head<3>() - d[1].w() * p) / d[0].w();
  return {p, first, (d[2].head<3>() - 2 * d[1].w() * first - d[2].w() * p) / d[0].w()};
}

}  // namespace

/// Motions that close in v stay closed while they are edited.
class SweepSeamTest : public QObject {
  Q_OBJECT
 private slots:
  void onlyRingsAreClosed() {
    for (const PrimitiveKind kind :
         {PrimitiveKind::Cylinder, PrimitiveKind::Cone, PrimitiveKind::Sphere, PrimitiveKind::Tube, PrimitiveKind::Helicoid,
          PrimitiveKind::Plane, PrimitiveKind::Sheet})
      QVERIFY(!joinedInV(primitiveMotion({.kind = kind, .turns = 3}).motion));
    const auto ring = joinedInV(primitiveMotion({.kind = PrimitiveKind::Torus}).motion);
    QVERIFY(ring);
    QCOMPARE(ring->trajectory.ratio, 1.0);
    QCOMPARE(ring->orientation.ratio, -1.0);
    QCOMPARE(ring->scaling.ratio, 1.0);
    for (const JoinedEnds& ends : {ring->trajectory, ring->orientation, ring->scaling}) QCOMPARE(ends.continuity, 2);
    QVERIFY(joinedInV(readMotionOf("torus.json")) && !joinedInV(readMotionOf("twisted-tube.json")));
    // Nothing changes along v: that is no ring.
    Motion still = primitiveMotion({}).motion;
    for (Vec4& pole : still.trajectory.poles) pole = Vec4(0, 0, 0, 1);
    QVERIFY(!joinedInV(still));
  }

  void tubesAlongClosedCurvesAreClosed() {
    const Motion tube = motionFromCurve(closedOval(), {.radius = 4}).motion;
    const auto joined = joinedInV(tube);
    QVERIFY(joined);
    QCOMPARE(joined->trajectory.continuity, 2);
    QVERIFY(joined->orientation.continuity >= 1);
    const EditResult pulled = edit(tube, {0.3, 0}, EditWay::Together, Eigen::Matrix3d::Identity());
    QVERIFY(pulled.obstacles.empty());
    QVERIFY(openness(pulled.motion) < 1e-13);
  }

  /// Against curves made by knot insertion from their periodic form.
  void ringsAreFoundAndChangedAsPeriodicSplines() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 400; ++k) {
      const int degree = uniformInt(random, 1, 6), continuity = uniformInt(random, 0, degree - 1);
      const bool rational = k % 2 == 0;
      const double ratio = std::array{1.0, -1.0, 1.5}[static_cast<std::size_t>(rational ? 2 * (k % 4 / 2) : k % 3)];
      RingLine ring = randomRing(random, continuity, degree, ratio);
      const Curve curve = ring.clampedCurve();
      const std::size_t columns = curve.poles.size(), free = columns - 1 - static_cast<std::size_t>(continuity);
      QCOMPARE(free, ring.rows.size());
      const JoinedEnds ends{ratio, continuity};
      const SeamV seam = rational ? SeamV(curve, ends) : SeamV(spaceOf(curve), ends);
      // Free pole f is row f + degree - 1 of the periodic spline, which stands for row f + degree - 1 - free times ratio.
      const std::size_t f = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(free) - 1));
      const Vec3 by(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      std::size_t row = f + static_cast<std::size_t>(degree) - 1;
      double factor = 1;
      for (; row >= free; row -= free) factor *= ratio;
      Vec4& changed = ring.rows[row];
      changed.head<3>() += (rational ? changed[3] : 1 / factor) * by;
      const Curve wanted = ring.clampedCurve();
      PoleChange change{{f}, by.transpose(), 0};
      change = seam.onAllPoles(change);
      std::vector<Vec3> got(columns, Vec3::Zero());
      for (std::size_t i = 0; i < change.pole.size(); ++i)
        got[change.pole[i]] = change.by.row(static_cast<Eigen::Index>(i)).transpose();
      for (std::size_t j = 0; j < columns; ++j) {
        const Vec3 moved = (wanted.poles[j] - curve.poles[j]).head<3>() / (rational ? curve.poles[j][3] : 1.0);
        worst = std::max(worst, (moved - got[j]).norm());
      }
    }
    std::printf("figure seam_change %.3g\n", worst);
    QVERIFY2(worst < 1e-10, qPrintable(QString::number(worst)));
  }

  void theRingStaysClosed() {
    auto random = seededRandom();
    double worst = 0, gap = 0, missed = 0;
    for (int k = 0; k < 60; ++k) {
      const Motion ring = primitiveMotion(ringOptions(random)).motion;
      const double v =
          std::array{0.0, 1.0, uniform(random, 0, 0.2), uniform(random, 0.8, 1)}[static_cast<std::size_t>(k % 4)];
      const MotionPlace at{uniform(random, 0, 1), v};
      for (const EditWay way : allEditWays)
        for (const int fold : {1, 4}) {
          if (way == EditWay::Translate && fold > 1) continue;
          const EditResult result = edit(ring, at, way, Eigen::Matrix3d::Identity(), fold);
          QVERIFY(result.obstacles.empty());
          missed = std::max(missed, result.remainder / (way == EditWay::Twist ? 180 : 60));
          QVERIFY(repeatsItsRows(result.motion));
          worst = std::max(worst, openness(result.motion));
          for (int i = 0; i < 20; ++i) {
            const double u = uniform(random, 0, 1);
            gap = std::max(gap, (evaluate(result.motion, u, 0).point - evaluate(result.motion, u, 1).point).norm() / 60);
          }
        }
    }
    std::printf("figure seam_derivatives %.3g\nfigure seam_gap %.3g\nfigure seam_missed %.3g\n", worst, gap, missed);
    QVERIFY2(worst < 1e-13, qPrintable(QString::number(worst)));
    QVERIFY2(gap < 1e-14, qPrintable(QString::number(gap)));
    QVERIFY2(missed < 1e-13, qPrintable(QString::number(missed)));
  }

  void theSurfaceIsAsSmoothAcrossTheSeamAsElsewhere() {
    auto random = seededRandom();
    const Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 8}).motion;
    for (const EditWay way : allEditWays) {
      const Surface surface = productSurface(edit(ring, {0.2, 1}, way, Eigen::Matrix3d::Identity()).motion).surface;
      const auto [first, last] = surface.domainV();
      for (int i = 0; i < 20; ++i) {
        const double u = uniform(random, 0, 1);
        const std::array<Vec3, 3> start = alongV(surface, u, first), end = alongV(surface, u, last);
        for (std::size_t k = 0; k < 3; ++k)
          QVERIFY2((end[k] - start[k]).norm() < 1e-10 * (1 + start[k].norm()), qPrintable(QString::number(k)));
      }
    }
  }

  /// The same edit half a ring farther gives the same ring, turned.
  void aRingHasNoBeginning() {
    auto random = seededRandom();
    const Eigen::Matrix3d half = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()).toRotationMatrix();
    double worst = 0;
    for (int k = 0; k < 20; ++k) {
      const Motion ring = primitiveMotion(ringOptions(random)).motion;
      const double u = uniform(random, 0, 1), v = uniform(random, 0, 0.1);
      for (const EditWay way : allEditWays) {
        const Motion here = edit(ring, {u, v}, way, Eigen::Matrix3d::Identity()).motion,
                     there = edit(ring, {u, v + 0.5}, way, half).motion;
        for (int i = 0; i < 40; ++i) {
          const double s = uniform(random, 0, 1), t = uniform(random, 0, 1);
          const Vec3 turned = half * evaluate(here, s, t).point,
                     same = evaluate(there, s, t < 0.5 ? t + 0.5 : t - 0.5).point;
          worst = std::max(worst, (turned - same).norm() / 60);
        }
      }
    }
    std::printf("figure seam_turned %.3g\n", worst);
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
  }

  void awayFromTheSeamNothingIsOther() {
    const Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus, .columns = 12}).motion;
    Motion open = ring;
    open.scaling.pole(5, 0)[0] += 1e-3;
    QVERIFY(!joinedInV(open));
    for (const EditWay way : allEditWays) {
      const Motion a = edit(ring, {0.6, 0.5}, way, Eigen::Matrix3d::Identity()).motion,
                   b = edit(open, {0.6, 0.5}, way, Eigen::Matrix3d::Identity()).motion;
      QVERIFY(sameBits(a.trajectory.poles, b.trajectory.poles));
      QVERIFY(sameBits(a.orientation.poles, b.orientation.poles));
      for (std::size_t i = 0; i < a.scaling.countU(); ++i)
        for (std::size_t j = 1; j < a.scaling.countV(); ++j) QVERIFY(sameBits(a.scaling.pole(i, j), b.scaling.pole(i, j)));
    }
  }

  void refinedRingsStayClosed() {
    const Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus}).motion;
    const Motion fine = withKnots(ring, {.u = {0.1}, .v = {0.002, 0.03, 0.03, 0.97, 0.999}});
    const auto joined = joinedInV(fine);
    QVERIFY(joined);
    for (const JoinedEnds& ends : {joined->trajectory, joined->orientation, joined->scaling}) QCOMPARE(ends.continuity, 2);
    for (const EditWay way : allEditWays) {
      const EditResult result = edit(fine, {0.4, 1}, way, Eigen::Matrix3d::Identity());
      QVERIFY(result.obstacles.empty());
      QVERIFY((evaluate(result.motion, 0.4, 0).point - evaluate(result.motion, 0.4, 1).point).norm() < 1e-12);
      QVERIFY(openness(result.motion) < 1e-12);
    }
  }

  void editAfterEditStaysClosed() {
    auto random = seededRandom();
    Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 6}).motion;
    for (int k = 0; k < 200; ++k) {
      const MotionPlace at{uniform(random, 0, 1), k % 2 == 0 ? 0 : uniform(random, 0, 1)};
      const Vec3 to = evaluate(ring, at.u, at.v).point +
                      Vec3(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2));
      const EditResult result = pull(ring, {{at}, {to}, {k % 3 == 0 ? 0.5 : 0.0, 1, 1}});
      QVERIFY(result.obstacles.empty());
      ring = result.motion;
      QVERIFY(joinedInV(ring) && joinedInV(ring)->scaling.continuity == 2);
    }
    QVERIFY(openness(ring) < 1e-12);
  }

  void whatTheSeamSharesCannotGoTwoWays() {
    const Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus}).motion;
    const Vec3 at = evaluate(ring, 0.3, 0).point, aside = at + Vec3(0, 0, 2);
    const EditResult torn = pull(ring, {{{0.3, 0}, {0.3, 1}}, {aside, at}});
    QVERIFY(!torn.obstacles.empty());
    QVERIFY(openness(torn.motion) < 1e-13);
    const EditResult pinned = pull(ring, {{{0.3, 0}}, {aside}, {0, 1, 1}, Vec3::Zero(), {{0.3, 1}}});
    QVERIFY(!pinned.obstacles.empty() && pinned.obstacles.front().why == Unreached::Pinned);
    QVERIFY((evaluate(pinned.motion, 0.3, 0).point - at).norm() < 1e-12);
  }

  /// With a single span a smooth ring has one free pole: everything goes along.
  void oneSpanIsOneFreePole() {
    Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 6}).motion;
    const std::size_t rows = ring.scaling.countU() - 3;
    std::vector<Vec4> poles(rows * 4, Vec4(6, 0, 0, 1));
    ring.scaling = unwrapped(3, 3, evenBreaks(rows), {0, 0, 0, 0, 1, 1, 1, 1}, std::move(poles), 1);
    const EditResult result = edit(ring, {0.3, 0.7}, EditWay::Scale, Eigen::Matrix3d::Identity());
    QVERIFY(result.obstacles.empty());
    for (int i = 0; i <= 10; ++i) {
      const Vec3 arm = evaluate(result.motion, 0.3, i / 10.0).point - blossom::point(ring.trajectory, i / 10.0);
      COMPARE_NEAR(arm.norm(), 1.6 * 6, 1e-12);
    }
  }
};

BLOSSOM_TEST(SweepSeamTest)
#include "sweep_seam_test.moc"
