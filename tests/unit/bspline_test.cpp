#include "geometry/bspline/bspline.h"

#include <limits>
#include <numbers>

#include "geometry/bspline/product.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr double kDigits = 1e-13;  ///< relative to the poles

/// The unit circle as four rational quadratic arcs.
Curve unitCircle() {
  const double h = std::numbers::sqrt2 / 2;
  return {2,
          {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
          {{1, 0, 0, 1},
           {h, h, 0, h},
           {0, 1, 0, 1},
           {-h, h, 0, h},
           {-1, 0, 0, 1},
           {-h, -h, 0, h},
           {0, -1, 0, 1},
           {h, -h, 0, h},
           {1, 0, 0, 1}}};
}

/// The unit sphere: the right half of that circle turned about z.
Surface unitSphere() {
  const Curve around = unitCircle();
  const double h = std::numbers::sqrt2 / 2;
  const std::vector<Vec3> half = {{0, -1, 1}, {h, -h, h}, {1, 0, 1}, {h, h, h}, {0, 1, 1}};  // radius, height, weight
  Surface surface{2, 2, around.knots, {0, 0, 0, 1, 1, 2, 2, 2}, {}};
  for (const Vec4& pole : around.poles)
    for (const Vec3& m : half)
      surface.poles.emplace_back(pole.x() * m.x(), pole.y() * m.x(), pole.w() * m.y(), pole.w() * m.z());
  return surface;
}

double difference(const Curve& a, const Curve& b, double t) {
  return (evaluate(a, t) - evaluate(b, t)).cwiseAbs().maxCoeff();
}
double difference(const Surface& a, const Surface& b, double u, double v) {
  return (evaluate(a, u, v) - evaluate(b, u, v)).cwiseAbs().maxCoeff();
}

/// Knots inside the domain that may be inserted once more, and some new ones.
std::vector<double> insertable(Random& random, const Curve& curve) {
  const auto [from, to] = curve.domain();
  std::vector<double> knots;
  for (int i = uniformInt(random, 0, 4); i > 0; --i) knots.push_back(uniform(random, from, to));
  for (const double knot : curve.knots)
    if (knot > from && knot < to && uniformInt(random, 0, 3) == 0 &&
        std::count(curve.knots.begin(), curve.knots.end(), knot) + std::count(knots.begin(), knots.end(), knot) <=
            curve.degree)
      knots.push_back(knot);
  std::sort(knots.begin(), knots.end());
  return knots;
}

Vec4 deCasteljau(std::vector<Vec4> poles, double s) {
  for (std::size_t n = poles.size(); n > 1; --n)
    for (std::size_t i = 0; i + 1 < n; ++i) poles[i] = (1 - s) * poles[i] + s * poles[i + 1];
  return poles.front();
}

}  // namespace

class BsplineTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  void spansHoldTheirParameter() {
    const std::vector<double> knots = {0, 0, 0, 1, 1, 2, 5, 5, 5};
    QCOMPARE(findSpan(2, knots, 0), 2u);
    QCOMPARE(findSpan(2, knots, 1), 4u);
    QCOMPARE(findSpan(2, knots, 1.5), 4u);
    QCOMPARE(findSpan(2, knots, 5), 5u);
    QCOMPARE(findSpan(2, knots, -1), 2u);
    QCOMPARE(findSpan(2, knots, 9), 5u);
    const std::vector<double> multipleEnd = {-1, 0, 0, 2, 3, 3, 4};  // unclamped, domain 0..3
    QCOMPARE(findSpan(2, multipleEnd, 0), 2u);
    QCOMPARE(findSpan(2, multipleEnd, 3), 3u);
  }

  void basisIsAPartitionOfUnity() {
    for (int repeat = 0; repeat < 500; ++repeat) {
      const int degree = uniformInt(random_, 1, 25), order = uniformInt(random_, 0, 3);
      const std::vector<double> knots = randomKnots(random_, degree);
      const double t = randomParameter(random_, {0, 1});
      const std::size_t width = static_cast<std::size_t>(degree) + 1;
      std::vector<double> basis(static_cast<std::size_t>(order + 1) * width);
      basisDerivatives(degree, knots, findSpan(degree, knots, t), t, order, basis);
      for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
        double sum = 0, size = 0;
        for (std::size_t j = 0; j < width; ++j) {
          sum += basis[k * width + j];
          size += std::abs(basis[k * width + j]);
          if (k == 0) QVERIFY(basis[j] >= 0);
        }
        COMPARE_NEAR(sum, k == 0 ? 1.0 : 0.0, 1e-13 * std::max(1.0, size));
      }
    }
  }

  void derivativesOfAPowerAreExact() {
    for (int degree = 1; degree <= 25; ++degree) {  // x^degree on 0..1: only the last Bezier pole is not zero
      Curve power{degree, std::vector<double>(static_cast<std::size_t>(degree) + 1, 0.0),
                  std::vector<Vec4>(static_cast<std::size_t>(degree) + 1, Vec4::Zero())};
      power.knots.resize(2 * power.knots.size(), 1.0);
      power.poles.back() = Vec4(1, 2, 3, 4);
      const double x = uniform(random_, 0, 1);
      const auto values = derivatives(power, x, degree + 2);
      double factor = 1;
      for (int k = 0; k <= degree + 2; ++k) {
        const double expected = k > degree ? 0 : factor * std::pow(x, degree - k);
        COMPARE_NEAR(values[static_cast<std::size_t>(k)].x(), expected, 1e-12 * factor);
        COMPARE_NEAR(values[static_cast<std::size_t>(k)].w(), 4 * expected, 1e-12 * factor);
        if (k < degree) factor *= degree - k;
      }
    }
  }

  void clampedCurvesEndAtTheirPoles() {
    for (int degree = 1; degree <= 25; ++degree) {
      const Curve curve = randomCurve(random_, degree, {.clamped = true});
      QCOMPARE(evaluate(curve, 0), curve.poles.front());
      QCOMPARE(evaluate(curve, 1), curve.poles.back());
    }
  }

  void circleHasRadiusOne() {
    const Curve c = unitCircle(), raised = elevateDegree(c, 3);
    for (int i = 0; i <= 1000; ++i) {
      const double t = 4.0 * i / 1000;
      COMPARE_NEAR(point(c, t).norm(), 1, 1e-15);
      COMPARE_NEAR(point(raised, t).norm(), 1, 2e-15);
    }
  }

  void sphereFramesAreTangent() {
    const Surface ball = unitSphere();
    validate(ball);
    for (int i = 0; i < 1000; ++i) {
      const SurfaceFrame f = frame(ball, uniform(random_, 0, 4), uniform(random_, 0, 2));
      COMPARE_NEAR(f.point.norm(), 1, 2e-15);
      COMPARE_NEAR(f.du.dot(f.point), 0, 2e-15);
      COMPARE_NEAR(f.dv.dot(f.point), 0, 4e-15);
      COMPARE_NEAR(f.du.dot(f.dv), 0, 4e-15);  // meridians and parallels
    }
  }

  void knotInsertionKeepsPointsAndDerivatives() {
    for (int repeat = 0; repeat < 300; ++repeat) {
      const Curve curve = randomCurve(random_, uniformInt(random_, 1, 25));
      const Curve refined = insertKnots(curve, insertable(random_, curve));
      validate(refined);
      const double t = uniform(random_, 0, 1);
      const auto before = derivatives(curve, t, 2), after = derivatives(refined, t, 2);
      COMPARE_NEAR(difference(curve, refined, randomParameter(random_, {0, 1})), 0, kDigits * magnitude(curve.poles));
      // A derivative subtracts poles and divides by knot differences as small as the narrowest span; its error follows the
      // largest.
      const std::size_t width = static_cast<std::size_t>(curve.degree) + 1;
      std::vector<double> basis(3 * width);
      basisDerivatives(refined.degree, refined.knots, findSpan(refined.degree, refined.knots, t), t, 2, basis);
      for (std::size_t k = 1; k <= 2; ++k) {
        double size = 0;
        for (std::size_t j = 0; j < width; ++j) size += std::abs(basis[k * width + j]);
        COMPARE_NEAR((before[k] - after[k]).cwiseAbs().maxCoeff(), 0, kDigits * size * magnitude(curve.poles));
      }
    }
  }

  void clampingKeepsPoints() {
    for (int repeat = 0; repeat < 300; ++repeat) {
      const Curve curve = randomCurve(random_, uniformInt(random_, 1, 25));
      const Curve result = clamped(curve);
      validate(result);
      QCOMPARE(result.knots[static_cast<std::size_t>(curve.degree)], result.knots.front());
      for (int i = 0; i < 5; ++i)
        COMPARE_NEAR(difference(curve, result, randomParameter(random_, {0, 1})), 0, kDigits * magnitude(curve.poles));
    }
  }

  void elevationKeepsPointsAndContinuity() {
    for (int repeat = 0; repeat < 200; ++repeat) {
      const int degree = uniformInt(random_, 1, 15), times = uniformInt(random_, 0, 10);
      const Curve curve = randomCurve(random_, degree), result = elevateDegree(curve, times);
      validate(result);
      QCOMPARE(result.degree, degree + times);
      for (const double knot : result.knots)
        if (knot > 0 && knot < 1)
          QCOMPARE(std::count(result.knots.begin(), result.knots.end(), knot),
                   std::count(curve.knots.begin(), curve.knots.end(), knot) + times);
      for (int i = 0; i < 5; ++i)
        COMPARE_NEAR(difference(curve, result, randomParameter(random_, {0, 1})), 0, kDigits * magnitude(curve.poles));
    }
  }

  void surfacesKeepTheirPoints() {
    for (int repeat = 0; repeat < 100; ++repeat) {
      const Surface s = randomSurface(random_, uniformInt(random_, 1, 7), uniformInt(random_, 1, 7));
      validate(s);
      const double u = randomParameter(random_, {0, 1}), v = randomParameter(random_, {0, 1});
      const double tolerance = kDigits * magnitude(s.poles);
      std::vector<double> knots = {uniform(random_, 0, 0.5), uniform(random_, 0.5, 1)};
      for (const Surface& same :
           {insertKnotsU(s, knots), insertKnotsV(s, knots), clamped(s), elevateDegree(s, 1, 2), elevateDegree(s, 3, 0)}) {
        validate(same);
        COMPARE_NEAR(difference(s, same, u, v), 0, tolerance);
      }
      COMPARE_NEAR((evaluate(reversedU(s), 1 - u, v) - evaluate(s, u, v)).norm(), 0,
                   10 * 25 * tolerance);  // 1 - u is rounded
      COMPARE_NEAR((evaluate(transposed(s), v, u) - evaluate(s, u, v)).norm(), 0, tolerance);
      QVERIFY(transposed(transposed(s)) == s);
      COMPARE_NEAR((evaluate(isoU(s, u), v) - evaluate(s, u, v)).norm(), 0, tolerance);
      COMPARE_NEAR((evaluate(isoV(s, v), u) - evaluate(s, u, v)).norm(), 0, tolerance);
    }
  }

  void surfaceDerivativesAreThoseOfTheIsoCurves() {
    for (int repeat = 0; repeat < 100; ++repeat) {
      const Surface s = randomSurface(random_, uniformInt(random_, 1, 7), uniformInt(random_, 1, 7));
      const double u = uniform(random_, 0, 1), v = uniform(random_, 0, 1);
      const auto d = derivatives(s, u, v, 3);
      const auto inU = derivatives(isoV(s, v), u, 3), inV = derivatives(isoU(s, u), v, 3);
      for (std::size_t k = 0; k <= 3; ++k) {
        COMPARE_NEAR((d[k * 4] - inU[k]).norm(), 0, 1e-9 * std::max(1.0, inU[k].norm()));
        COMPARE_NEAR((d[k] - inV[k]).norm(), 0, 1e-9 * std::max(1.0, inV[k].norm()));
      }
      const SurfaceFrame f = frame(s, u, v);
      const Vec3 du = (d[4].head<3>() * d[0].w() - d[0].head<3>() * d[4].w()) / (d[0].w() * d[0].w());
      COMPARE_NEAR((f.du - du).norm(), 0, 1e-10 * std::max(1.0, du.norm()));
      COMPARE_NEAR((f.point - point(s, u, v)).norm(), 0, 1e-12);
    }
  }

  void mixedDerivativesOfAPowerProductAreExact() {  // u^2 v^3
    Surface s{2, 3, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, std::vector<Vec4>(12, Vec4::Zero())};
    s.poles.back() = Vec4(1, 0, 0, 1);
    const double u = 0.3, v = 0.7;
    const auto d = derivatives(s, u, v, 3);
    COMPARE_NEAR(d[1 * 4 + 1].x(), 2 * u * 3 * v * v, 1e-14);
    COMPARE_NEAR(d[2 * 4 + 1].x(), 2 * 3 * v * v, 1e-14);
    COMPARE_NEAR(d[1 * 4 + 2].x(), 2 * u * 6 * v, 1e-14);
    COMPARE_NEAR(d[3].x(), u * u * 6, 1e-14);
    COMPARE_NEAR(d[3 * 4].x(), 0, 0);
  }

  void bezierPiecesAreTheCurve() {
    for (int repeat = 0; repeat < 200; ++repeat) {
      const Curve curve = randomCurve(random_, uniformInt(random_, 1, 25));
      const BezierCurve pieces = toBezier(curve);
      const auto order = static_cast<std::size_t>(curve.degree) + 1;
      QCOMPARE(pieces.poles.size(), (pieces.breaks.size() - 1) * order);
      QCOMPARE(pieces.breaks.front(), 0.0);
      QCOMPARE(pieces.breaks.back(), 1.0);
      for (std::size_t i = 0; i + 1 < pieces.breaks.size(); ++i) {
        const double s = uniform(random_, 0, 1), a = pieces.breaks[i], b = pieces.breaks[i + 1];
        const std::vector<Vec4> poles(pieces.poles.begin() + static_cast<std::ptrdiff_t>(i * order),
                                      pieces.poles.begin() + static_cast<std::ptrdiff_t>((i + 1) * order));
        // a + s (b - a) is rounded; the slope turns that into an error
        COMPARE_NEAR((deCasteljau(poles, s) - evaluate(curve, a + s * (b - a))).norm(), 0,
                     1e-13 * magnitude(curve.poles) * (1 + 1e-2 * curve.degree / (b - a)));
      }
    }
  }

  void bezierPiecesJoinAgain() {
    for (int repeat = 0; repeat < 200; ++repeat) {
      const Curve curve = randomCurve(random_, uniformInt(random_, 1, 3), {.spans = 4});
      const Curve same = fromBezier(toBezier(curve), clamped(curve).knots);
      for (std::size_t i = 0; i < same.poles.size();
           ++i)  // unequal spans make extrapolation worse, by the square of their ratio
        COMPARE_NEAR((same.poles[i] - clamped(curve).poles[i]).norm(), 0, 1e-9 * magnitude(curve.poles));
      const Curve unclamped = fromBezier(toBezier(curve), curve.knots);
      COMPARE_NEAR(difference(unclamped, curve, uniform(random_, 0, 1)), 0, 1e-10 * magnitude(curve.poles));
      const Surface s = clamped(randomSurface(random_, 2, 3, {.spans = 4}, {.spans = 4}));
      COMPARE_NEAR(
          difference(fromBezier(toBezier(s), s.knotsU, s.knotsV), s, uniform(random_, 0, 1), uniform(random_, 0, 1)), 0,
          1e-10 * magnitude(s.poles));
    }
  }

  void bezierPatchesLieWhereTheHeaderSays() {
    const Surface s = randomSurface(random_, 2, 3, {.spans = 5}, {.spans = 5});
    const BezierSurface pieces = toBezier(s);
    const std::size_t spansV = pieces.breaksV.size() - 1, size = 3 * 4;
    for (std::size_t a = 0; a + 1 < pieces.breaksU.size(); ++a)
      for (std::size_t b = 0; b < spansV; ++b)
        COMPARE_NEAR((pieces.poles[(a * spansV + b) * size] - evaluate(s, pieces.breaksU[a], pieces.breaksV[b])).norm(), 0,
                     kDigits * magnitude(s.poles));
  }

  void parametersBeyondTheDomainContinueThePiece() {
    const Curve line{1, {0, 0, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}}};
    COMPARE_NEAR((point(line, -1) - Vec3(-1, 0, 0)).norm(), 0, 1e-15);
    COMPARE_NEAR((point(line, 3) - Vec3(1, 2, 0)).norm(), 0, 1e-15);
  }

  void smallestWeightIsThatOfThePoles() {
    Surface s = randomSurface(random_, 2, 2);
    s.poles[s.poles.size() / 2].w() = -3;
    QCOMPARE(smallestWeight(s), -3.0);
    QCOMPARE(smallestWeight(unitCircle()), std::numbers::sqrt2 / 2);
  }

  void vanishingWeightsHaveNoPoint() {
    const Curve c{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, -1}}};
    VERIFY_ERROR(point(c, 0.5), ErrorCode::Degenerate);
  }

  void malformedCurvesAreRejected_data() {
    QTest::addColumn<int>("degree");
    QTest::addColumn<QList<double>>("knots");
    QTest::addColumn<int>("poles");
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    QTest::newRow("degree zero") << 0 << QList<double>{0, 1, 2} << 2;
    QTest::newRow("degree negative") << -3 << QList<double>{0, 1, 2} << 5;
    QTest::newRow("no knots") << 3 << QList<double>{} << 4;
    QTest::newRow("no poles") << 1 << QList<double>{0, 0, 1, 1} << 0;
    QTest::newRow("too few knots") << 2 << QList<double>{0, 0, 1, 1, 1} << 2;
    QTest::newRow("pole missing") << 1 << QList<double>{0, 0, 1, 2, 2} << 2;
    QTest::newRow("decreasing") << 1 << QList<double>{0, 0, 2, 1, 3, 3} << 4;
    QTest::newRow("NaN knot") << 1 << QList<double>{0, 0, nan, 1, 1} << 3;
    QTest::newRow("infinite knot") << 1 << QList<double>{0, 0, 1, inf} << 2;
    QTest::newRow("multiplicity") << 1 << QList<double>{0, 0, 1, 1, 1, 2, 2} << 5;
    QTest::newRow("end multiplicity") << 1 << QList<double>{0, 0, 0, 1, 1} << 3;
    QTest::newRow("empty domain") << 1 << QList<double>{0, 1, 1, 2} << 2;
  }
  void malformedCurvesAreRejected() {
    QFETCH(int, degree);
    QFETCH(QList<double>, knots);
    QFETCH(int, poles);
    const Curve curve{
        degree, {knots.begin(), knots.end()}, std::vector<Vec4>(static_cast<std::size_t>(poles), Vec4(0, 0, 0, 1))};
    VERIFY_ERROR(validate(curve), ErrorCode::InvalidInput);
    const Surface surface{
        1, degree, {0, 0, 1, 1}, curve.knots, std::vector<Vec4>(static_cast<std::size_t>(2 * poles), Vec4(0, 0, 0, 1))};
    VERIFY_ERROR(validate(surface), ErrorCode::InvalidInput);
  }

  void otherMistakesAreRejected() {
    Curve curve = unitCircle();
    curve.poles[3].y() = std::numeric_limits<double>::quiet_NaN();
    VERIFY_ERROR(validate(curve), ErrorCode::InvalidInput);
    VERIFY_ERROR(validate(Curve{61, std::vector<double>(124), std::vector<Vec4>(62)}), ErrorCode::LimitExceeded);
    const auto insert = [](std::vector<double> knots) { return insertKnots(unitCircle(), knots); };
    VERIFY_ERROR(insert({0.5, 0.25}), ErrorCode::InvalidInput);
    VERIFY_ERROR(insert({-0.5}), ErrorCode::InvalidInput);
    VERIFY_ERROR(insert({4.5}), ErrorCode::InvalidInput);
    VERIFY_ERROR(insert({1, 1}), ErrorCode::InvalidInput);
    VERIFY_ERROR(insert({std::numeric_limits<double>::quiet_NaN()}), ErrorCode::InvalidInput);
    VERIFY_ERROR(elevateDegree(unitCircle(), -1), ErrorCode::InvalidInput);
    VERIFY_ERROR(elevateDegree(unitCircle(), 100), ErrorCode::LimitExceeded);
    const BezierCurve pieces = toBezier(unitCircle());
    VERIFY_ERROR(fromBezier(pieces, std::vector<double>{0, 0, 0, 0.5, 4, 4, 4}), ErrorCode::InvalidInput);
    VERIFY_ERROR(fromBezier(pieces, std::vector<double>{0, 4}), ErrorCode::InvalidInput);
  }

 private:
  Random random_;
};

BLOSSOM_TEST(BsplineTest)
#include "bspline_test.moc"
