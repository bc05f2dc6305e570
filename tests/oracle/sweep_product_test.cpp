#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QElapsedTimer>
#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <thread>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/begin/turning_spline.h"
#include "sweep/kernel/grid/motion_grid.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/validity.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// Q(r) as printed in Yoon & Lee 2009, with the factor 2 of r21.
Eigen::Matrix3d rotationTimesSquare(const Vec4& r) {
  const double w = r[0], x = r[1], y = r[2], z = r[3];
  Eigen::Matrix3d q;
  q << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return q;
}

/// M(u,v) p in homogeneous coordinates, from the factors' values alone.
Vec4 printedFormula(const Motion& m, double u, double v) {
  const Vec4 t = evaluate(m.trajectory, v), r = evaluate(m.orientation, u, v), s = evaluate(m.scaling, u, v);
  const Vec3 y = rotationTimesSquare(r) * s.head<3>().cwiseProduct(m.point);
  const double d = r.squaredNorm();
  Vec4 x;
  x << t[3] * y + t.head<3>() * d * s[3], t[3] * d * s[3];
  return x;
}

}  // namespace

class SweepProductTest : public QObject {
  Q_OBJECT
 private slots:
  void matrixIsARotationTimesSquaredLength() {
    auto random = seededRandom();
    for (int k = 0; k < 1000; ++k) {
      const Vec4 r(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2));
      const Eigen::Matrix3d q = rotationTimesSquare(r);
      const double d = r.squaredNorm();
      QVERIFY((q.transpose() * q - d * d * Eigen::Matrix3d::Identity()).norm() <= 1e-13 * d * d);
      COMPARE_NEAR(q.determinant(), d * d * d, 1e-13 * d * d * d);
    }
  }

  void productEqualsDirectEvaluation_data() {
    QTest::addColumn<int>("closed");
    QTest::newRow("clamped") << 0;
    QTest::newRow("periodic") << 1;
    QTest::newRow("anti-periodic") << 2;
  }
  void productEqualsDirectEvaluation() {
    QFETCH(int, closed);
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 60; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(closed), k % 3 == 0);
      validate(motion);
      const auto product = sweep::productSurface(motion);
      validate(product.surface);
      QCOMPARE(product.surface.degreeU, 2 * motion.orientation.degreeU + motion.scaling.degreeU);
      QCOMPARE(product.surface.degreeV, motion.trajectory.degree + 2 * motion.orientation.degreeV + motion.scaling.degreeV);
      QVERIFY(product.smallestWeight > 0);
      for (int i = 0; i < 60; ++i) {
        const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
        const Vec4 wanted = printedFormula(motion, u, v);
        worst = std::max(worst, (point(product.surface, u, v) - wanted.head<3>() / wanted[3]).norm() / 10);
      }
    }
    qInfo("figure product_error %.3g", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void cubicFactorsGiveNineByTwelveAndKeepC2() {
    auto random = seededRandom();
    Motion motion = randomMotion(random, ClosedU::AntiPeriodic, true);
    std::vector<double> period;
    for (int i = 0; i <= 9; ++i) period.push_back(i / 9.0);
    motion.orientation.knotsU = motion.scaling.knotsU = unwrappedKnots(3, period);
    const Surface surface = sweep::productSurface(motion).surface;
    QCOMPARE(surface.degreeU, 9);
    QCOMPARE(surface.degreeV, 12);
    for (int i = 1; i < 9; ++i)
      QCOMPARE(std::count(surface.knotsU.begin(), surface.knotsU.end(), period[static_cast<std::size_t>(i)]), 7);
  }

  void seamClosesHomogeneously() {
    auto random = seededRandom();
    for (const ClosedU closed : {ClosedU::Periodic, ClosedU::AntiPeriodic}) {
      const Surface surface = sweep::productSurface(randomMotion(random, closed)).surface;
      for (std::size_t j = 0; j < surface.countV(); ++j)
        QVERIFY(surface.pole(0, j) == surface.pole(surface.countU() - 1, j));
    }
  }

  void derivativesAndGridAgreeWithTheProduct() {
    auto random = seededRandom();
    for (const ClosedU closed : {ClosedU::No, ClosedU::Periodic, ClosedU::AntiPeriodic}) {
      const Motion motion = randomMotion(random, closed);
      const Surface surface = sweep::productSurface(motion).surface;
      std::vector<double> us, vs;
      for (int i = 0; i < 37; ++i) us.push_back(randomIn(random, motion.domainU()));
      for (int i = 0; i < 131; ++i) vs.push_back(randomIn(random, motion.domainV()));
      sweep::MotionGrid grid;
      sweep::evaluateGrid(motion, us, vs, grid, sweep::GridDerivatives::Yes);
      for (std::size_t k = 0; k < us.size(); ++k)
        for (std::size_t l = 0; l < vs.size(); ++l) {
          const SurfaceFrame wanted = frame(surface, us[k], vs[l]);
          const auto single = sweep::evaluate(motion, us[k], vs[l]);
          const double size = 1 + wanted.du.norm() + wanted.dv.norm();
          QVERIFY((grid.pointAt(k, l) - wanted.point).norm() < 1e-11);
          QVERIFY((single.point - wanted.point).norm() < 1e-11);
          QVERIFY((grid.duAt(k, l) - wanted.du).norm() < 1e-9 * size);
          QVERIFY((grid.dvAt(k, l) - wanted.dv).norm() < 1e-9 * size);
          QVERIFY((single.du - wanted.du).norm() < 1e-9 * size);
          QVERIFY((single.dv - wanted.dv).norm() < 1e-9 * size);
          QVERIFY((grid.normalAt(k, l) - grid.duAt(k, l).cross(grid.dvAt(k, l)).normalized()).norm() < 1e-9);
        }
    }
  }

  void negativeCoefficientsAreMendedByKnots() {
    // A quarter turn and more in one cubic span makes coefficients of |r|^2 negative while |r| stays away from zero.
    Motion motion;
    motion.trajectory = {1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {0, 0, 1, 1}}};
    motion.orientation = {3, 1, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 1, 1}, {}};
    for (const Vec4& pole : {Vec4(1, 0, 0, 0), Vec4(-1.2, 0, 0, 1.6), Vec4(1.2, 0, 0, 1.6), Vec4(-1, 0, 0, 0)})
      motion.orientation.poles.insert(motion.orientation.poles.end(), 2, pole);
    motion.scaling = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4(1, 1, 1, 1))};
    motion.point = Vec3::UnitX();
    const auto product = sweep::productSurface(motion);
    QVERIFY(product.refinements > 0);
    QVERIFY(product.smallestWeight > 0);
    for (int i = 0; i <= 100; ++i) {
      const Vec4 wanted = printedFormula(motion, i / 100.0, 0.3);
      QVERIFY((point(product.surface, i / 100.0, 0.3) - wanted.head<3>() / wanted[3]).norm() < 1e-12);
    }
  }

  void vanishingQuaternionIsRejectedWithItsPlace() {
    Motion motion;
    motion.trajectory = {1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {0, 0, 1, 1}}};
    motion.orientation = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{1, 0, 0, 0}, {1, 0, 0, 0}, {-3, 0, 0, 0}, {-3, 0, 0, 0}}};
    motion.scaling = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4(1, 1, 1, 1))};
    VERIFY_ERROR(sweep::productSurface(motion), ErrorCode::Degenerate);
    try {
      sweep::productSurface(motion);
    } catch (const Error& error) {
      QVERIFY2(error.message().find("u = 0.25") != std::string::npos, error.what());
    }
  }

  /// A motion file may hold more spans than the product of its factors has room for.
  void whatWouldFillTheMemoryIsRefused() {
    const std::vector<double> knots = sweep::clampedKnots(3, sweep::evenBreaks(400));
    const std::size_t poles = (knots.size() - 4) * (knots.size() - 4);
    const Surface plain{3, 3, knots, knots, std::vector<Vec4>(poles, Vec4(1, 0, 0, 0))};
    Motion motion{sweep::straightLine(8, {0, 0, 0}, {0, 0, 40}), plain, plain, ClosedU::No, Vec3(5, 0, 0)};
    for (Vec4& pole : motion.scaling.poles) pole = Vec4(1, 1, 1, 1);
    validate(motion);
    VERIFY_ERROR(sweep::productSurface(motion), ErrorCode::LimitExceeded);
    VERIFY_ERROR(sweep::smallestProductWeight(motion), ErrorCode::LimitExceeded);
  }

  void cancelStopsTheWork() {
    auto random = seededRandom();
    const Motion motion = randomMotion(random, ClosedU::No);
    CancelToken token;
    token.cancel();
    VERIFY_ERROR(sweep::productSurface(motion, {}, Progress(token)), ErrorCode::Cancelled);
    VERIFY_ERROR(sweep::smallestProductWeight(motion, Progress(token)), ErrorCode::Cancelled);
  }

  /// Of a plain motion with many poles: it tells how far it is, and ends wherever it is asked to.
  void longProductsTellHowFarTheyAre() {
    const Motion motion = sweep::primitiveMotion({.rows = 64, .columns = 64}).motion;
    std::vector<double> told;
    sweep::productSurface(motion, {}, Progress({}, [&](double done, const std::string&) { told.push_back(done); }));
    QVERIFY(told.size() >= 5 && std::is_sorted(told.begin(), told.end()));
    for (std::size_t k = 0; k + 1 < told.size(); ++k) {
      const CancelToken token;
      std::size_t reports = 0;
      const Progress asked(token, [&](double, const std::string&) {
        if (reports++ == k) token.cancel();
      });
      VERIFY_ERROR(sweep::productSurface(motion, {}, asked), ErrorCode::Cancelled);
      QCOMPARE(reports, k + 1);
    }
  }

  /// From another thread at moments spread over all of it: memory stays whole wherever the work is left. Ended the program
  /// while the rows of the matrix were a braced list.
  void anyMomentIsGoodToCancel() {
    const Motion motion = sweep::primitiveMotion({.rows = 8, .columns = 32}).motion;
    qint64 whole = std::numeric_limits<qint64>::max();
    for (int k = 0; k < 5; ++k) {  // the first one is slower
      QElapsedTimer timer;
      timer.start();
      (void)sweep::productSurface(motion, {});
      whole = std::min(whole, timer.nsecsElapsed());
    }
    constexpr int moments = 400;
    int cancelled = 0;
    for (int k = 0; k < moments; ++k) {
      const CancelToken token;
      std::atomic<bool> begun = false;
      std::thread canceller([&] {
        while (!begun) std::this_thread::yield();
        QElapsedTimer since;
        since.start();
        while (since.nsecsElapsed() < whole * k / moments) std::this_thread::yield();
        token.cancel();
      });
      begun = true;
      if (k == 0) canceller.join();  // on a busy machine it may be late for all others
      std::optional<ErrorCode> code;
      try {
        (void)sweep::productSurface(motion, {}, Progress(token));
      } catch (const Error& error) {
        code = error.code();
      }
      if (canceller.joinable()) canceller.join();
      QVERIFY(!code || code == ErrorCode::Cancelled);
      cancelled += code ? 1 : 0;
    }
    QVERIFY(cancelled > 0);
  }
};

BLOSSOM_TEST(SweepProductTest)
#include "sweep_product_test.moc"
