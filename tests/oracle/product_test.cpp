#include "geometry/bspline/product.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/bspline/patch_polynomial.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr double kAsked = 1e-12;  ///< on size 10

int multiplicityOf(const std::vector<double>& knots, double at) {
  return static_cast<int>(std::count(knots.begin(), knots.end(), at));
}

KnotChoice sharing(std::vector<double> pool, int highest = 0) {
  return {.spans = 6, .highest = highest, .pool = std::move(pool)};
}

/// The factors of a motion, values of size 10 in the product.
struct Factors {
  Surface r, s;
  Curve t;
};

Vec4 direct(const Factors& f, const Vec3& p, double u, double v) {
  const Vec4 q = evaluate(f.r, u, v), s = evaluate(f.s, u, v), t = evaluate(f.t, v);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const Vec3 y0 = s.head<3>().cwiseProduct(p), axis(x, y, z);
  // rotation of y0 by the quaternion, times |q|^2, without a matrix
  const Vec3 turned = (w * w - axis.squaredNorm()) * y0 + 2 * axis.dot(y0) * axis + 2 * w * axis.cross(y0);
  const double scale = q.squaredNorm() * s[3];
  Vec4 result;
  result << t[3] * turned + scale * t.head<3>(), t[3] * scale;
  return result;
}

PatchGrid gridOf(const Factors& f) {
  return {productKnots(std::vector<ProductFactor>{{f.r.degreeU, 2, f.r.knotsU}, {f.s.degreeU, 1, f.s.knotsU}}),
          productKnots(std::vector<ProductFactor>{
              {f.r.degreeV, 2, f.r.knotsV}, {f.s.degreeV, 1, f.s.knotsV}, {f.t.degree, 1, f.t.knots}})};
}

Surface swept(const Factors& f, const Vec3& p) {
  const PatchGrid grid = gridOf(f);
  const auto [w, x, y, z] = patchPolynomials(f.r, grid);
  const auto s = patchPolynomials(f.s, grid);
  const auto t = patchPolynomialsInV(f.t, grid);
  const auto squares = [&](double ww, double xx, double yy, double zz) {
    PatchPolynomial sum = product(w, w, ww);
    return std::move(sum.addProduct(x, x, xx).addProduct(y, y, yy).addProduct(z, z, zz));
  };
  const auto twice = [](const auto& a, const auto& b, double sign, const auto& c, const auto& d) {
    PatchPolynomial sum = product(a, b, 2);
    return std::move(sum.addProduct(c, d, 2 * sign));
  };
  const PatchPolynomial q[3][3] = {{squares(1, 1, -1, -1), twice(x, y, -1, w, z), twice(x, z, 1, w, y)},
                                   {twice(x, y, 1, w, z), squares(1, -1, 1, -1), twice(y, z, -1, w, x)},
                                   {twice(x, z, -1, w, y), twice(y, z, 1, w, x), squares(1, -1, -1, 1)}};
  const PatchPolynomial scale = product(squares(1, 1, 1, 1), s[3]);
  const auto component = [&](std::size_t i) {
    PatchPolynomial turned = product(q[i][0], s[0], p.x());
    turned.addProduct(q[i][1], s[1], p.y()).addProduct(q[i][2], s[2], p.z());
    PatchPolynomial result = product(turned, t[3]);
    return std::move(result.addProduct(scale, t[i]));
  };
  return assemble({component(0), component(1), component(2), product(scale, t[3])}, grid);
}

/// All four components equal to component c.
Surface spread(const Surface& surface, Eigen::Index c) {
  Surface result = surface;
  for (Vec4& pole : result.poles) pole = Vec4::Constant(pole[c]);
  return result;
}

}  // namespace

class ProductTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  void multiplicitiesFollowTheRule() {
    const std::vector<double> r = {0, 0, 0, 0, 0.25, 0.5, 1, 1, 1, 1}, s = {0, 0, 0, 0, 0.5, 0.5, 0.75, 1, 1, 1, 1},
                              t = {-1, 0, 0.1, 1, 2};
    const ProductKnots u = productKnots(std::vector<ProductFactor>{{3, 2, r}, {3, 1, s}});
    QCOMPARE(u.degree, 9);
    QCOMPARE(multiplicityOf(u.knots, 0), 10);
    QCOMPARE(multiplicityOf(u.knots, 0.25), 7);
    QCOMPARE(multiplicityOf(u.knots, 0.5), 8);
    QCOMPARE(multiplicityOf(u.knots, 0.75), 7);
    QCOMPARE(multiplicityOf(u.knots, 1), 10);
    const ProductKnots v = productKnots(std::vector<ProductFactor>{{3, 1, r}, {3, 2, r}, {3, 1, s}, {1, 1, t}});
    QCOMPARE(v.degree, 13);
    QCOMPARE(multiplicityOf(v.knots, 0.25), 11);
    QCOMPARE(multiplicityOf(v.knots, 0.1), 13);
    QCOMPARE(v.knots.size(), std::size_t(14 + 13 + 11 + 12 + 11 + 14));
  }

  void almostEqualKnotsAreOne() {
    const double third = 1.0 / 3, close = third + 4e-16;
    QVERIFY(close != third);
    const Curve a{2, {0, 0, 0, third, 1, 1, 1}, {{1, 2, 3, 4}, {2, 1, 0, 3}, {5, 5, 5, 5}, {1, 0, 1, 0}}};
    Curve b = a;
    b.knots[3] = close;
    b.knots.back() = b.knots[5] = b.knots[4] = 1 + 2e-16;
    const Curve c = product(a, b);
    validate(c);
    QCOMPARE(c.poles.size(), std::size_t(8));  // 1/3 three times, not six
    for (int i = 0; i <= 100; ++i) {
      const double t = i / 100.0;
      COMPARE_NEAR((evaluate(c, t) - evaluate(a, t).cwiseProduct(evaluate(b, t))).norm(), 0, 1e-13);
    }
  }

  void powersMultiply() {  // x^p x^q = x^(p+q): only the last Bezier pole is not zero
    const auto power = [](int degree) {
      const auto order = static_cast<std::size_t>(degree) + 1;
      Curve result{degree, std::vector<double>(order, 0.0), std::vector<Vec4>(order, Vec4::Zero())};
      result.knots.resize(2 * order, 1.0);
      result.poles.back().setOnes();
      return result;
    };
    for (int p = 1; p <= 12; ++p)
      for (int q = 1; q <= 13; ++q) QVERIFY(product(power(p), power(q)) == power(p + q));
  }

  void circleSquaredIsItsWeightSquared() {  // x^2 + y^2 = w^2 pole by pole
    const double h = std::numbers::sqrt2 / 2;
    const Curve circle{
        2, {0, 0, 0, 1, 1, 2, 2, 2}, {{1, 0, 0, 1}, {h, h, 0, h}, {0, 1, 0, 1}, {-h, h, 0, h}, {-1, 0, 0, 1}}};
    for (const Vec4& pole : product(circle, circle).poles) COMPARE_NEAR(pole.x() + pole.y() - pole.w(), 0, 1e-15);
  }

  void curvesOfAnyDegree() {
    double worst = 0;
    for (int repeat = 0; repeat < 400; ++repeat) {
      const int p = uniformInt(random_, 1, 24), q = uniformInt(random_, 1, 25 - p);
      const std::vector<double> pool = {0.125, 0.3, uniform(random_, 0.1, 0.9)};
      const Curve a = randomCurve(random_, p, sharing(pool, p + uniformInt(random_, 0, 1)), 3),
                  b = randomCurve(random_, q, sharing(pool), 3);
      const Curve c = product(a, b);
      validate(c);
      for (int i = 0; i < 10; ++i) {
        const double t = randomParameter(random_, {0, 1});
        worst = std::max(worst, (evaluate(c, t) - evaluate(a, t).cwiseProduct(evaluate(b, t))).cwiseAbs().maxCoeff() /
                                    (magnitude(a.poles) * magnitude(b.poles)));
      }
    }
    qInfo("largest error relative to the poles: %.2g", worst);
    COMPARE_NEAR(worst, 0, 1e-13);
  }

  void productsOfConstantsHaveConstantPoles() {
    for (int repeat = 0; repeat < 50; ++repeat) {
      Curve a = randomCurve(random_, uniformInt(random_, 1, 8)), b = randomCurve(random_, uniformInt(random_, 1, 8));
      for (Vec4& pole : a.poles) pole = Vec4(1, 2, 3, 4);
      for (Vec4& pole : b.poles) pole = Vec4(5, 0.5, 0.25, 2);
      for (const Vec4& pole : product(a, b).poles) COMPARE_NEAR((pole - Vec4(5, 1, 0.75, 8)).norm(), 0, 1e-13);
    }
  }

  void timesOneIsDegreeElevation() {
    for (int repeat = 0; repeat < 100; ++repeat) {
      const int p = uniformInt(random_, 1, 15), q = uniformInt(random_, 1, 10);
      const Curve curve = randomCurve(random_, p);
      Curve one{q, std::vector<double>(static_cast<std::size_t>(q) + 1, 0.0),
                std::vector<Vec4>(static_cast<std::size_t>(q) + 1, Vec4::Ones())};
      one.knots.resize(2 * one.knots.size(), 1.0);
      const Curve raised = elevateDegree(curve, q), multiplied = product(curve, one);
      QVERIFY(raised.knots == multiplied.knots);
      for (std::size_t i = 0; i < raised.poles.size(); ++i)
        COMPARE_NEAR((raised.poles[i] - multiplied.poles[i]).norm(), 0, 1e-13 * magnitude(curve.poles));
    }
  }

  void surfaces() {
    double worst = 0;
    for (int repeat = 0; repeat < 60; ++repeat) {
      const std::vector<double> pool = {0.25, 0.6};
      const Surface a =
          randomSurface(random_, uniformInt(random_, 1, 4), uniformInt(random_, 1, 4), sharing(pool), sharing(pool), 3);
      const Surface b =
          randomSurface(random_, uniformInt(random_, 1, 4), uniformInt(random_, 1, 4), sharing(pool), sharing(pool), 3);
      const Surface c = product(a, b);
      validate(c);
      for (int i = 0; i < 20; ++i) {
        const double u = randomParameter(random_, {0, 1}), v = randomParameter(random_, {0, 1});
        worst =
            std::max(worst, (evaluate(c, u, v) - evaluate(a, u, v).cwiseProduct(evaluate(b, u, v))).cwiseAbs().maxCoeff() /
                                (magnitude(a.poles) * magnitude(b.poles)));
      }
    }
    qInfo("largest error relative to the poles: %.2g", worst);
    COMPARE_NEAR(worst, 0, 1e-13);
  }

  void sweptSurfacesMatchTheirFactors_data() {
    QTest::addColumn<int>("r");
    QTest::addColumn<int>("s");
    QTest::addColumn<int>("t");
    QTest::newRow("cubic") << 3 << 3 << 3;
    QTest::newRow("linear") << 1 << 1 << 1;
    QTest::newRow("quadratic turned, cubic scaled") << 2 << 3 << 4;
    QTest::newRow("quintic") << 5 << 4 << 5;
  }
  void sweptSurfacesMatchTheirFactors() {
    QFETCH(int, r);
    QFETCH(int, s);
    QFETCH(int, t);
    double worst = 0;
    for (int repeat = 0; repeat < 30; ++repeat) {
      const std::vector<double> pool = {0.2, 0.25, uniform(random_, 0.1, 0.9)};
      Factors f{randomSurface(random_, r, r, sharing(pool), sharing(pool), 1),
                randomSurface(random_, s, s, sharing(pool), sharing(pool), 1), randomCurve(random_, t, sharing(pool), 2)};
      const Vec3 p(uniform(random_, -1, 1), uniform(random_, -1, 1), uniform(random_, -1, 1));
      Surface x = swept(f, p);
      validate(x);
      QCOMPARE(x.degreeU, 2 * r + s);
      QCOMPARE(x.degreeV, 2 * r + s + t);
      // `kAsked` is for size 10
      const double scale = 10 / magnitude(x.poles);
      for (int i = 0; i < 40; ++i) {
        const double u = randomParameter(random_, {0, 1}), v = randomParameter(random_, {0, 1});
        worst = std::max(worst, scale * (evaluate(x, u, v) - direct(f, p, u, v)).cwiseAbs().maxCoeff());
      }
    }
    qInfo("largest error on size 10: %.2g", worst);
    COMPARE_NEAR(worst, 0, kAsked);
  }

  void patchProductsMatchSymmetrisedBlossoms() {  // two ways to the same poles
    double worst = 0;
    for (int repeat = 0; repeat < 30; ++repeat) {
      const Surface a = randomSurface(random_, 3, 2, {.spans = 5}, {.spans = 5}, 3),
                    b = randomSurface(random_, 2, 3, {.spans = 5}, {.spans = 5}, 3);
      const Surface expected = product(a, b);
      const PatchGrid grid({expected.degreeU, expected.knotsU}, {expected.degreeV, expected.knotsV});
      const auto x = patchPolynomials(a, grid), y = patchPolynomials(b, grid);
      const Surface actual =
          assemble({product(x[0], y[0]), product(x[1], y[1]), product(x[2], y[2]), product(x[3], y[3])}, grid);
      for (std::size_t i = 0; i < expected.poles.size(); ++i)
        worst = std::max(worst, (actual.poles[i] - expected.poles[i]).norm() / (magnitude(a.poles) * magnitude(b.poles)));
    }
    qInfo("largest difference relative to the poles: %.2g", worst);
    COMPARE_NEAR(worst, 0, 1e-12);
  }

  void threeFactorsInAnyOrder() {
    const Surface a = randomSurface(random_, 2, 2, {}, {}, 2), b = randomSurface(random_, 3, 1, {}, {}, 2),
                  c = randomSurface(random_, 1, 2, {}, {}, 2);
    const Surface first = product(product(a, b), c), second = product(a, product(c, b));
    QVERIFY(first.knotsU == second.knotsU && first.knotsV == second.knotsV);
    for (std::size_t i = 0; i < first.poles.size(); ++i)
      COMPARE_NEAR((first.poles[i] - second.poles[i]).norm(), 0, 1e-13 * magnitude(first.poles));
    const Surface squared = product(spread(a, 0), a);
    COMPARE_NEAR(evaluate(squared, 0.3, 0.4).x(), std::pow(evaluate(a, 0.3, 0.4).x(), 2), 1e-12);
  }

  void patchesBeyondWholeBlocks() {  // numbers of patches around the lane count
    for (int spans = 1; spans <= 9; ++spans) {
      std::vector<double> knots = {0, 0};
      for (int i = 1; i < spans; ++i) knots.push_back(static_cast<double>(i) / spans);
      knots.insert(knots.end(), {1, 1});
      Surface s{1, 1, {0, 0, 1, 1}, knots, {}};
      while (s.poles.size() < 2 * s.countV()) s.poles.push_back(randomPole(random_, 1));
      const ProductKnots u = productKnots(std::vector<ProductFactor>{{1, 1, s.knotsU}}),
                         v = productKnots(std::vector<ProductFactor>{{1, 1, knots}});
      const PatchGrid grid(u, v);
      const Surface same = assemble(patchPolynomials(s, grid), grid);
      for (std::size_t i = 0; i < s.poles.size(); ++i) COMPARE_NEAR((same.poles[i] - s.poles[i]).norm(), 0, 1e-14);
    }
  }

  void everyStepEndsWhenAsked() {
    const Factors f{randomSurface(random_, 2, 2, {.spans = 5}, {.spans = 5}, 1),
                    randomSurface(random_, 1, 1, {.spans = 5}, {.spans = 5}, 1), randomCurve(random_, 2, {.spans = 5}, 2)};
    const CancelToken token;
    token.cancel();
    const Progress cancelled(token);
    const PatchGrid grid({f.r.degreeU, f.r.knotsU}, {f.r.degreeV, f.r.knotsV});
    const auto r = patchPolynomials(f.r, grid);
    VERIFY_ERROR(patchPolynomials(f.r, grid, cancelled), ErrorCode::Cancelled);
    VERIFY_ERROR(patchPolynomialsInV(f.t, gridOf(f), cancelled), ErrorCode::Cancelled);
    VERIFY_ERROR(product(r[0], r[1], 1, cancelled), ErrorCode::Cancelled);
    VERIFY_ERROR(assemble(r, grid, cancelled), ErrorCode::Cancelled);
  }

  void mistakesAreRejected() {
    const Curve a{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, 1}}}, b{1, {0, 0, 2, 2}, a.poles};
    VERIFY_ERROR(product(a, b), ErrorCode::InvalidInput);
    VERIFY_ERROR(productKnots(std::vector<ProductFactor>{}), ErrorCode::InvalidInput);
    VERIFY_ERROR(productKnots(std::vector<ProductFactor>{{1, 61, a.knots}}), ErrorCode::LimitExceeded);
    const PatchPolynomial one(4, 1, 1), other(4, 2, 1);
    VERIFY_ERROR(PatchPolynomial(one).add(other), ErrorCode::Internal);
    VERIFY_ERROR(PatchPolynomial(one).addProduct(one, one), ErrorCode::Internal);
  }

 private:
  Random random_;
};

BLOSSOM_TEST(ProductTest)
#include "product_test.moc"
