#include <fmt/format.h>

#include "core/error.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "minkowski/kernel/morph/blossom_path.h"
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

  /// Where the sharp tips move much farther than the sides.
  void thinFreeFormShapesGoOn() {
    for (const double height : {0.3, 1.0, 3.0}) {
      const auto arch = [&](double h) {
        return Spline2{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 1}, {20, h, 1}, {40, h, 1}, {60, 0, 1}}};
      };
      Path lens;
      lens.closed = true;
      const Path upper{{arch(height)}, false, {}, {}}, lower{{arch(-height)}, false, {}, {}};
      lens.segments = {lower.segments.front(), blossom::reversed(upper).segments.front()};
      const Region region{{lens}};
      const Region on = at({region, region}, {2});
      QVERIFY2(std::abs(area(on) - area(region)) < 0.03 * area(region), fmt::format("{} mm", height).c_str());
    }
  }

  /// What is added there and taken away again is so large that rounding hides whether there is a shape.
  void whatCannotBeToldIsRefused() {
    const auto octagon = [](double cut) {
      const double r = 5, c = r - cut;
      return polygonRegion({{-c, -r}, {c, -r}, {r, -c}, {r, c}, {c, r}, {-c, r}, {-r, c}, {-r, -c}});
    };
    std::vector<Region> shapes(8, octagon(2));
    shapes.push_back(octagon(2.00000004));
    QVERIFY(!refusal(shapes, diagonal(8, 10)).first.empty());
  }

  /// Squares whose sides grow evenly: the side is 2 + the sum of the numbers.
  void manyDifferentNumbersTakeNoLonger() {
    std::vector<Region> squares;
    std::vector<double> t;
    double side = 2;
    for (int i = 0; i < 26; ++i) {
      const double half = (2.0 + i) / 2;
      squares.push_back(rectangleRegion({-half, -half}, {half, half}));
      if (i > 0) side += t.emplace_back(1 + 1e-3 * i);
    }
    COMPARE_NEAR(area(at(squares, t)), side * side, 1e-6);
    std::vector<Region> hollow(26, polygonRegion({{0, 0}, {4, 0}, {1, 1}, {0, 4}}));
    QVERIFY(refusal(hollow, t).first.find("too many terms") != std::string::npos);
  }

  void theEndsAndFarPlacesAreMetToRounding() {
    const std::vector<Region> discs{circleRegion(10), circleRegion(12)};
    COMPARE_NEAR(area(at(discs, {1 + 1e-12})), 144 * pi, 1e-6);
    COMPARE_NEAR(area(at(discs, {-1e-12})), 100 * pi, 1e-6);
    const Vec2 far(1e8, 1e8);
    const std::vector<Region> squares{rectangleRegion(far, far + Vec2(1, 1)), rectangleRegion(far, far + Vec2(3, 2))};
    COMPARE_NEAR(area(at(squares, {1.5})), 4 * 2.5, 1e-5);
  }

  void aPathEndsWhereTheMorphDoes() {
    const std::vector<std::vector<double>> path{{0, 0}, {0.5, 0}, {1, 1}};
    VERIFY_ERROR(pointOfPath(path, -0.5), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pointOfPath(path, 1.5), ErrorCode::InvalidParameter);
    QVERIFY(pointOfPath(path, 1) == path.back());
  }

  /// What the refusal says works does.
  void theAdviceWorksWhereAreasArePreserved() {
    const std::vector<Region> squares{rectangleRegion({0, 0}, {10, 10}), rectangleRegion({0, 0}, {1, 1})};
    const std::string hint = refusal(squares, {2}, {.areaPreserving = true}).second;
    QVERIFY2(hint.starts_with("t = 1.0"), hint.c_str());
    const double t = std::stod(hint.substr(4));
    COMPARE_NEAR(area(at(squares, {t}, {.areaPreserving = true})), 100 - 99 * t, 1e-9);
  }

  void areasGoOnWithTheShapes() {
    const std::vector<Region> discs{circleRegion(1), circleRegion(2)};
    QVERIFY(std::abs(area(at(discs, {1.2}, {.areaPreserving = true})) - 4.6 * pi) < 1e-9);
    QVERIFY(refusal(discs, {-0.5}, {.areaPreserving = true}).first.find("areas") != std::string::npos);
  }

  void linesAreToldOnlyWhereCurvesWereExpected() {
    const Region blob = ellipseRegion(3, 2), plate = rectangleRegion({0, 0}, {40, 40});
    QVERIFY(minkowskiDifference(std::vector{plate, blob}).warnings.empty());
    QVERIFY(minkowskiSum(std::vector{plate, plate, blob}, {.weights = {1, 1, 0}}).warnings.empty());
    for (const auto& [around, inside] : {std::pair{ellipseRegion(30, 20), circleRegion(1)}, {circleRegion(30), blob}}) {
      const auto room = minkowskiDifference(std::vector{around, inside});
      QVERIFY(room.warnings.size() == 1);
      QVERIFY(room.warnings.front().starts_with("Free-form curves came out as straight lines"));
    }
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
