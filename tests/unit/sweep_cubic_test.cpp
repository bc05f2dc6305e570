#include "geometry/bspline/bspline.h"
#include "support/motion_samples.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/cubic_approximation.h"
#include "sweep/kernel/cubic_spline.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

Curve toCurve(const CubicBreaks& breaks, const Rows& poles) {
  Curve curve{3, breaks.knots(), {}};
  for (Eigen::Index i = 0; i < poles.rows(); ++i) curve.poles.emplace_back(poles(i, 0), 0, 0, 1);
  return curve;
}

}  // namespace

class SweepCubicTest : public QObject {
  Q_OBJECT
 private slots:
  /// Knots that agree but for their last digits are the same: no more spans than where they agree in all of them.
  void knotsOfFactorsThatNearlyAgreeAreOne() {
    for (const double share : {0.0, 1e-14, 1e-12, 1e-10, 1e-8, -1e-8, 1e-7, 1e-6, 1e-5, 1e-3}) {
      Motion motion = primitiveMotion({.radius = 10, .height = 40}).motion;
      Surface& s = motion.scaling;
      const std::size_t free = s.countU() - static_cast<std::size_t>(s.degreeU);
      for (std::size_t i = 0; i < s.countU(); ++i)
        for (std::size_t j = 0; j < s.countV(); ++j)
          s.pole(i, j).head<3>() *= 1 + 0.1 * std::sin(static_cast<double>(i % free + 2 * j));
      std::vector<double> period(s.knotsU.begin() + s.degreeU, s.knotsU.end() - s.degreeU);
      for (std::size_t i = 1; i + 1 < period.size(); ++i) period[i] += share;
      s.knotsU = unwrappedKnots(s.degreeU, period);
      for (double& knot : s.knotsV)
        if (knot > 0 && knot < 1) knot += share;
      validate(motion);
      const CubicResult result = approximateCubic(motion, {.tolerance = 0.01});
      // 12 x 8 spans where knots agree, halved twice at most.
      if (std::abs(share) <= 1e-8) QVERIFY2(result.spansU <= 48 && result.spansV <= 32, qPrintable(QString::number(share)));
      double worst = 0;
      for (int i = 0; i <= 150; ++i)
        for (int j = 0; j <= 110; ++j)
          worst = std::max(
              worst, (point(result.surface, i / 150.0, j / 110.0) - evaluate(motion, i / 150.0, j / 110.0).point).norm());
      QVERIFY2(worst <= 0.01, qPrintable(QString("%1: %2").arg(share).arg(worst)));
    }
  }

  /// Two kinks right beside each other are both kept, each with slopes of its own.
  void kinksThatNearlyMeetStay() {
    Motion motion = primitiveMotion({.radius = 10, .height = 40}).motion;
    motion.trajectory = {1, {0, 0, 0.5, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(3, 0, 20, 1), Vec4(0, 0, 40, 1)}};
    motion.scaling.degreeV = 1;
    motion.scaling.knotsV = {0, 0, 0.5 + 1e-9, 1, 1};
    std::vector<Vec4> poles;
    for (std::size_t i = 0; i < motion.scaling.countU(); ++i)
      for (const double scale : {1.0, 2.0, 1.0}) poles.emplace_back(scale, scale, scale, 1);
    motion.scaling.poles = poles;
    validate(motion);
    const CubicResult result = approximateCubic(motion, {.tolerance = 0.001});
    for (const double v : {0.0, 0.2, 0.49, 0.5, 0.51, 0.8, 1.0})
      QVERIFY((point(result.surface, 0.3, v) - evaluate(motion, 0.3, v).point).norm() <= 0.001);
  }

  void cubicPolynomialsAreReproduced() {
    auto random = seededRandom();
    for (int k = 0; k < 50; ++k) {
      CubicBreaks breaks{{0}, {1}, false};
      for (int i = uniformInt(random, 1, 9); i > 0; --i)
        breaks.at.push_back(breaks.at.back() + uniform(random, 0.1, 1)),
            breaks.multiplicity.push_back(uniformInt(random, 1, 3));
      const double a = uniform(random, -1, 1), b = uniform(random, -1, 1), c = uniform(random, -1, 1),
                   d = uniform(random, -1, 1);
      const auto f = [&](double t) { return ((a * t + b) * t + c) * t + d; };
      const auto df = [&](double t) { return (3 * a * t + 2 * b) * t + c; };
      Rows values(static_cast<Eigen::Index>(breaks.at.size()), 1),
          slopes(2 * static_cast<Eigen::Index>(breaks.segments().size()), 1);
      for (std::size_t i = 0; i < breaks.at.size(); ++i) values(static_cast<Eigen::Index>(i), 0) = f(breaks.at[i]);
      Eigen::Index row = 0;
      for (const auto& [from, to] : breaks.segments())
        slopes(row++, 0) = df(breaks.at[from]), slopes(row++, 0) = df(breaks.at[to]);
      const Curve curve = toCurve(breaks, interpolateCubic(breaks, values, slopes));
      validate(curve);
      for (int i = 0; i <= 40; ++i) {
        const double t = breaks.at.back() * i / 40;
        COMPARE_NEAR(point(curve, t).x(), f(t), 1e-11 * (1 + std::abs(f(t))));
      }
    }
  }

  void periodicSplineInterpolatesAndIsC2AtTheSeam() {
    auto random = seededRandom();
    for (int n = 1; n < 12; ++n) {
      CubicBreaks breaks{{0}, {1}, true};
      for (int i = 0; i < n; ++i)
        breaks.at.push_back(breaks.at.back() + uniform(random, 0.5, 1.5)), breaks.multiplicity.push_back(1);
      Rows values(n + 1, 1);
      for (int i = 0; i < n; ++i) values(i, 0) = uniform(random, -1, 1);
      values(n, 0) = values(0, 0);
      const Curve curve = toCurve(breaks, interpolateCubic(breaks, values, Rows(0, 1)));
      validate(curve);
      for (int i = 0; i <= n; ++i)
        COMPARE_NEAR(point(curve, breaks.at[static_cast<std::size_t>(i)]).x(), values(i, 0), 1e-12);
      const auto start = derivatives(curve, 0, 2), end = derivatives(curve, breaks.at.back(), 2);
      for (std::size_t k = 0; k < 3; ++k) QVERIFY((start[k] - end[k]).norm() < 1e-11);
    }
  }

  /// A ring, pulled so that nothing is symmetric about its seam: the second derivatives on both sides of it are one.
  void ringsStayC2AtTheSeamInV() {
    const Motion given =
        primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 6, .rows = 8, .columns = 12}).motion;
    for (const double v : {0.0, 0.03, 0.9}) {
      const MotionPull edit{{{0.3, v}}, {evaluate(given, 0.3, v).point + Vec3(1, 2, 3)}, {0.5, 0, 1}};
      const Motion motion = pull(given, edit).motion;
      const Surface s = approximateCubic(motion, {.tolerance = 1e-2}).surface;
      validate(s);
      for (std::size_t i = 0; i < s.countU(); ++i) QVERIFY(s.pole(i, 0) == s.pole(i, s.countV() - 1));
      for (int i = 0; i <= 24; ++i) {
        const auto along = [&](double at) {
          Curve curve{3, s.knotsV, {}};
          for (std::size_t j = 0; j < s.countV(); ++j) {
            Curve across{3, s.knotsU, {}};
            for (std::size_t k = 0; k < s.countU(); ++k) across.poles.push_back(s.pole(k, j));
            const Vec3 p = point(across, i / 24.0);
            curve.poles.emplace_back(p.x(), p.y(), p.z(), 1);
          }
          return derivatives(curve, at, 2);
        };
        const auto start = along(0), end = along(1);
        for (std::size_t k = 0; k < 3; ++k)
          QVERIFY2(
              (start[k] - end[k]).norm() <= 1e-9 * (1 + start[k].norm()),
              qPrintable(QString("derivative %1 at u = %2: %3 apart").arg(k).arg(i / 24.0).arg((start[k] - end[k]).norm())));
      }
    }
  }

  /// Spans are halved up to a number; those of the motion all stay.
  void aMotionWithMoreSpansKeepsThem() {
    const Motion motion = primitiveMotion({.radius = 10, .rows = 12, .columns = 40}).motion;
    const CubicResult result = approximateCubic(motion, {.tolerance = 1, .maximumSpans = 16});
    QCOMPARE(result.spansU, std::size_t{12});
    QCOMPARE(result.spansV, std::size_t{40});
  }

  void keepsItsTolerance_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("tolerance");
    for (const char* name : {"propeller.json", "torus.json", "helicoid.json"})
      for (const double tolerance : {1e-1, 1e-3})
        QTest::newRow(qPrintable(QString("%1 %2").arg(name).arg(tolerance))) << name << tolerance;
  }
  void keepsItsTolerance() {
    QFETCH(QString, name);
    QFETCH(double, tolerance);
    const Motion motion = readMotionOf(qPrintable(name));
    const CubicResult cubic = approximateCubic(motion, {.tolerance = tolerance});
    validate(cubic.surface);
    QVERIFY(cubic.deviation <= tolerance);
    QCOMPARE(cubic.surface.degreeU, 3);
    auto random = seededRandom();
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
      worst = std::max(worst, (point(cubic.surface, u, v) - evaluate(motion, u, v).point).norm());
    }
    QVERIFY2(worst <= 1.02 * cubic.deviation, qPrintable(QString("%1 against %2").arg(worst).arg(cubic.deviation)));
  }

  void halvingTheSpansGainsAFactorSixteen() {
    // Fourth order: the error of C2 cubic interpolation.
    const Motion motion = readMotionOf("torus.json");
    const double coarse = approximateCubic(motion, {.tolerance = 1e-2}).deviation,
                 fine = approximateCubic(motion, {.tolerance = coarse * 0.9}).deviation;
    QVERIFY2(coarse / fine > 12 && coarse / fine < 20, qPrintable(QString::number(coarse / fine)));
  }

  void closedMotionsCloseExactly() {
    const CubicResult cubic = approximateCubic(readMotionOf("propeller.json"), {.tolerance = 1e-2});
    const Surface& s = cubic.surface;
    for (std::size_t j = 0; j < s.countV(); ++j) QVERIFY(s.pole(0, j) == s.pole(s.countU() - 1, j));
    for (std::size_t i = 4; i + 4 < s.knotsU.size(); ++i) QVERIFY(s.knotsU[i] < s.knotsU[i + 1]);
  }

  void kinksOfTheMotionStay() {
    auto random = seededRandom();
    for (int k = 0; k < 10; ++k) {
      // Degrees from 1: the motion has edges, which the cubic surface must follow with multiple knots.
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      const CubicResult cubic = approximateCubic(motion, {.tolerance = 0.5});
      validate(cubic.surface);
      for (int i = 0; i < 300; ++i) {
        const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
        QVERIFY((point(cubic.surface, u, v) - evaluate(motion, u, v).point).norm() <= 0.55);
      }
    }
  }

  /// The product is never formed, so its degree, 5 + 2 * 22 + 12, does not matter.
  void anyDegreeIsFollowed() {
    const auto line = [](int degree) {
      std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
      knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
      return knots;
    };
    Motion motion = primitiveMotion({.radius = 10, .height = 40}).motion;
    motion.trajectory = {5, line(5), {}};
    for (int j = 0; j <= 5; ++j) motion.trajectory.poles.emplace_back(0, 0, 8.0 * j, 1);
    for (const auto& [factor, degree] : {std::pair(&motion.orientation, 22), std::pair(&motion.scaling, 12)}) {
      const Surface plain = *factor;
      factor->degreeV = degree, factor->knotsV = line(degree), factor->poles.clear();
      for (std::size_t i = 0; i < plain.countU(); ++i)
        factor->poles.insert(factor->poles.end(), static_cast<std::size_t>(degree) + 1, plain.pole(i, 0));
    }
    const CubicResult cubic = approximateCubic(motion, {.tolerance = 1e-3});
    QVERIFY(cubic.deviation <= 1e-3);
    auto random = seededRandom();
    for (int i = 0; i < 300; ++i) {
      const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
      QVERIFY((point(cubic.surface, u, v) - evaluate(motion, u, v).point).norm() <= 1.1e-3);
    }
  }

  void impossibleToleranceIsRefused() {
    VERIFY_ERROR(approximateCubic(readMotionOf("propeller.json"), {.tolerance = 1e-9, .maximumSpans = 200}),
                 ErrorCode::LimitExceeded);
    CancelToken token;
    token.cancel();
    VERIFY_ERROR(approximateCubic(readMotionOf("propeller.json"), {}, Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(SweepCubicTest)
#include "sweep_cubic_test.moc"
