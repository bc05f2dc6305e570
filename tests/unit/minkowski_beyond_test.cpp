#include <fmt/format.h>

#include "core/error.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "minkowski/kernel/morph/morph.h"
#include "support/boundary_distance.h"
#include "support/curved_regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

Region at(const std::vector<Region>& shapes, const std::vector<double>& t, const MorphOptions& options = {}) {
  return morph(shapes, std::vector<std::vector<double>>{t}, options).regions.front();
}

Region weightsTimes(const std::vector<Region>& shapes, const std::vector<double>& weights) {
  return minkowskiSum(shapes, {.weights = weights}).region;
}

Region convexPolygon(Random& random, double reach) {
  const int corners = uniformInt(random, 3, 9);
  const Vec2 centre(uniform(random, -5, 5), uniform(random, -5, 5));
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * pi * (k + uniform(random, 0, 0.9)) / corners;
    points.emplace_back(centre + reach * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygonRegion(points);
}

Region roundedSquare(double side, double radius) {
  const double h = side / 2;
  return {{roundedPath({{-h, -h}, {h, -h}, {h, h}, {-h, h}}, radius)}};
}

double boundariesOff(const Region& a, const Region& b) {
  return distanceBetween(sidesOf(flattened(a, {}, "shape")), sidesOf(flattened(b, {}, "shape")));
}

/// What is told of a morph that does not go on to t.
std::pair<std::string, std::string> refusal(const std::vector<Region>& shapes, const std::vector<double>& t,
                                            const MorphOptions& options = {}) {
  try {
    at(shapes, t, options);
  } catch (const Error& error) {
    return {error.message(), error.hint()};
  }
  return {};
}

}  // namespace

/// Morphs beyond their first and last shape.
class MinkowskiBeyondTest : public QObject {
  Q_OBJECT

 private slots:
  void similarShapesGoOn() {
    const std::vector<Region> squares{rectangleRegion({-1, -1}, {1, 1}), rectangleRegion({8, -2}, {12, 2})};
    for (const auto& [t, side, x] : {std::tuple{1.5, 5.0, 15.0}, {-0.5, 1.0, -5.0}, {3.0, 8.0, 30.0}}) {
      const Region square = at(squares, {t});
      QVERIFY2(boundariesOff(square, rectangleRegion({x - side / 2, -side / 2}, {x + side / 2, side / 2})) < 1e-9,
               fmt::format("t = {}", t).c_str());
    }
    const std::vector<Region> discs{circleRegion(3, {1, 0}), circleRegion(2, {4, 5})};
    QVERIFY(std::abs(area(at(discs, {2})) - pi) < 1e-9);
    QVERIFY(std::abs(area(at(discs, {-1})) - 16 * pi) < 1e-9);
    QVERIFY(hasCurves(at(discs, {2})));
  }

  // The radius of the corners, 2 t - 5 (t - 1), vanishes at 5/3.
  void roundedCornersGoOnUntilTheyAreSharp() {
    const std::vector<Region> shapes{circleRegion(5), roundedSquare(20, 2)};
    for (const double t : {1.1, 1.5, 1.66}) {
      const double r = 2 * t - 5 * (t - 1), flat = 16 * t;
      QVERIFY(std::abs(area(at(shapes, {t})) - (flat * flat + 4 * flat * r + pi * r * r)) < 1e-6);
    }
    const auto [message, hint] = refusal(shapes, {1.7});
    QVERIFY2(message.find("t = 1.7") != std::string::npos, message.c_str());
    QVERIFY2(hint.starts_with("t = 1.66"), hint.c_str());
  }

  void shapesWithoutACommonPartDoNot() {
    const std::vector<Region> shapes{polygonRegion({{5, 0}, {-3, 4}, {-3, -4}}), circleRegion(4)};
    QCOMPARE(refusal(shapes, {1.5}).second, std::string("These shapes go no farther than t = 1."));
    QCOMPARE(refusal(shapes, {-0.5}).second, std::string("These shapes go no farther than t = 0."));
    QVERIFY(!refusal(shapes, {std::nan("")}).first.empty());
  }

  // With B = A + K, t B = (A + t K) + (t - 1) A, and likewise at the other end.
  void whatWasAddedGoesOnBeingAdded() {
    Random random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const Region a = convexPolygon(random, 4), more = convexPolygon(random, uniform(random, 0.5, 8));
      const Region both = weightsTimes({a, more}, {1, 1});
      const double t = uniform(random, 1.05, 3);
      QVERIFY2(boundariesOff(at({a, both}, {t}), weightsTimes({a, more}, {1, t})) < 1e-8, fmt::format("pair {}", k).c_str());
      QVERIFY2(boundariesOff(at({both, a}, {1 - t}), weightsTimes({a, more}, {1, t})) < 1e-8,
               fmt::format("pair {}", k).c_str());
    }
  }

  // P + 2 t Q + t^2 R, whose blossom is P + (t1 + t2) Q + t1 t2 R.
  void higherDegreesAndBlossomsGoOn() {
    Random random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const Region p = convexPolygon(random, 5), q = convexPolygon(random, 3), r = convexPolygon(random, 2);
      const std::vector<Region> shapes{p, weightsTimes({p, q}, {1, 1}), weightsTimes({p, q, r}, {1, 2, 1})};
      const double t1 = uniform(random, 1.1, 2), t2 = uniform(random, 0.2, 2);
      QVERIFY(boundariesOff(at(shapes, {t1, t1}), weightsTimes({p, q, r}, {1, 2 * t1, t1 * t1})) < 1e-8);
      QVERIFY(boundariesOff(at(shapes, {t1, t2}), weightsTimes({p, q, r}, {1, t1 + t2, t1 * t2})) < 1e-8);
      QVERIFY(boundariesOff(at(shapes, {t2, t1}), at(shapes, {t1, t2})) < 1e-8);
    }
  }

  void freeFormShapesGoOnWithinTheTolerance() {
    const Region ellipse = at({ellipseRegion(2, 1), ellipseRegion(4, 2)}, {1.5}, {.tolerance = 1e-3});
    QVERIFY(std::abs(area(ellipse) - 12.5 * pi) < 1e-3 * 25);
  }

  void areasGoOnWithTheShapes() {
    const std::vector<Region> discs{circleRegion(1), circleRegion(2)};
    QVERIFY(std::abs(area(at(discs, {1.2}, {.areaPreserving = true})) - 4.6 * pi) < 1e-9);
    QVERIFY(refusal(discs, {-0.5}, {.areaPreserving = true}).first.find("areas") != std::string::npos);
  }

  void nothingIsToldOfAnOrderBeyondTheEnds() {
    const std::vector<Region> discs{circleRegion(1), circleRegion(2)};
    const auto orderAt = [&](double t) { return morph(discs, std::vector<std::vector<double>>{{t}}).evaluation; };
    QVERIFY(!orderAt(1.5) && !orderAt(0));
    QVERIFY(orderAt(0.5) == EvaluationOrder::Explicit);
  }
};

BLOSSOM_TEST(MinkowskiBeyondTest)
#include "minkowski_beyond_test.moc"
