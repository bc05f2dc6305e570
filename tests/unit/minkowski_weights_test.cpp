#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "support/boundary_distance.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;
using std::numbers::pi;

namespace {

Region weightedSum(const std::vector<Region>& shapes, const std::vector<double>& weights) {
  return minkowskiSum(shapes, {.weights = weights}).region;
}

Polygons timesAs(const Region& region, double factor) { return scaled(flattened(region, {}, "shape"), factor); }

double between(const Polygons& a, const Polygons& b) { return distanceBetween(sidesOf(a), sidesOf(b)); }

Region convexOne(Random& random) {
  std::vector<double> angles;
  const int corners = uniformInt(random, 3, 9);
  for (int k = 0; k < corners; ++k) angles.push_back(2 * pi * (k + uniform(random, 0, 0.9)) / corners);
  const Vec2 at(uniform(random, -5, 5), uniform(random, -5, 5));
  std::vector<Vec2> points;
  for (const double angle : angles) points.emplace_back(at + 3 * Vec2(std::cos(angle), std::sin(angle)));
  return polygonRegion(points);
}

}  // namespace

/// Sums of shapes times numbers.
class MinkowskiWeightsTest : public QObject {
  Q_OBJECT

 private slots:
  void aShapeAndItsReflectionAreSymmetric() {
    Random random = seededRandom();
    for (int round = 0; round < 40; ++round) {
      const Region shape = randomRegion(random, 10);
      const Region sum = weightedSum({shape, shape}, {1, -1});
      QVERIFY(between(timesAs(sum, 1), timesAs(sum, -1)) < 1e-9);
    }
  }

  void weightsOfAConvexShapeAddUp() {
    Random random = seededRandom();
    for (int round = 0; round < 40; ++round) {
      const Region shape = convexOne(random);
      const double v = uniform(random, 0.1, 3), w = uniform(random, 0.1, 3);
      QVERIFY(between(timesAs(weightedSum({shape, shape}, {v, w}), 1), timesAs(shape, v + w)) < 1e-9);
      QVERIFY(between(timesAs(weightedSum({shape, shape}, {-v, -w}), 1), timesAs(shape, -v - w)) < 1e-9);
    }
  }

  /// w A is {w a}: what scaling first gives.
  void weightsScaleAboutTheOrigin() {
    Random random = seededRandom();
    for (int round = 0; round < 40; ++round) {
      const Region a = randomRegion(random, 6), b = randomRegion(random, 4);
      const double v = uniform(random, -2, 2), w = uniform(random, 0.2, 2);
      const Region first = planar::toRegion(timesAs(a, v)), second = planar::toRegion(timesAs(b, w));
      QVERIFY(between(timesAs(weightedSum({a, b}, {v, w}), 1), timesAs(weightedSum({first, second}, {}), 1)) < 1e-9);
    }
    const Region discs = weightedSum({circleRegion(2, {1, 0}), circleRegion(3, {0, 1})}, {2, -1});
    QCOMPARE(discs.loops.front().segments.size(), std::size_t{1});
    const auto& arc = std::get<Arc2>(discs.loops.front().segments.front());
    COMPARE_NEAR((arc.center - Vec2(2, -1)).norm() + std::abs(arc.radius - 7), 0, 1e-12);
  }

  /// 0 A is the origin alone, which changes nothing; missing weights are 1.
  void aWeightOfZeroLeavesOut() {
    Random random = seededRandom();
    const Region a = randomRegion(random, 6), b = circleRegion(4);
    QVERIFY(weightedSum({b, a}, {1, 0}) == b);
    QVERIFY(between(timesAs(weightedSum({a, b, a}, {0.5, 0, 0}), 1), timesAs(a, 0.5)) < 1e-12);
    QCOMPARE(minkowskiSum(std::vector{a, b, a}, {.weights = {1, 0}}).sums, std::size_t{1});
    QVERIFY(weightedSum({b, b}, {1}) == weightedSum({b, b}, {}));
  }

  void unsuitableWeightsAreRefused() {
    const Region disc = circleRegion(4);
    VERIFY_ERROR(weightedSum({disc, disc}, {0, 0}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(weightedSum({disc, disc}, {1, 1, 1}), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(MinkowskiWeightsTest)
#include "minkowski_weights_test.moc"
