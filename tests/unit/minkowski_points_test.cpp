#include "minkowski/kernel/morph/ladder.h"
#include "minkowski/kernel/morph/morph.h"
#include "minkowski/kernel/morph/point_shape.h"
#include "minkowski/kernel/morph/shape_spline.h"

#include "geometry/planar/single_point.h"
#include "geometry/planar/sums/region_sum.h"
#include "support/errors.h"
#include "support/modeling.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

namespace {

Region inBetween(const std::vector<Region>& shapes, const std::vector<double>& t, const MorphOptions& options = {}) {
  return morph(shapes, std::vector<std::vector<double>>{t}, options).regions.front();
}

constexpr EvaluationOrder everyOrder[] = {EvaluationOrder::Automatic, EvaluationOrder::Recursive, EvaluationOrder::BottomUp,
                                          EvaluationOrder::Explicit};

/// How far the outlines and their areas differ; infinite for other numbers of corners.
double farthestCorner(const Region& a, const Region& b) {
  double most = std::abs(area(a) - area(b));
  const auto corners = [](const Region& region) {
    std::vector<Vec2> all;
    for (const Path& loop : region.loops)
      for (const Segment& segment : loop.segments) all.push_back(startPoint(segment));
    return all;
  };
  const std::vector<Vec2> first = corners(a), second = corners(b);
  if (first.size() != second.size()) return HUGE_VAL;
  for (const Vec2& p : first) {
    double nearest = HUGE_VAL;
    for (const Vec2& q : second) nearest = std::min(nearest, (p - q).norm());
    most = std::max(most, nearest);
  }
  return most;
}

Shape pointShape(const Vec2& at) { return Shape(pointDrawing(at)); }

}  // namespace

/// Points among the control shapes of morphs: w {p} + A is A, moved by w p.
class MinkowskiPointsTest : public QObject {
  Q_OBJECT

 private slots:
  void aShapeGrowsOutOfAPoint() {
    Random random = seededRandom();
    for (int round = 0; round < 20; ++round) {
      const Vec2 point = randomVector(random, 50);
      const Region shape = randomRegion(random, 10);
      const double t = uniform(random, 0.05, 0.95);
      Region wanted = shape;
      Eigen::Matrix<double, 2, 3> affine;
      affine << t, 0, (1 - t) * point.x(), 0, t, (1 - t) * point.y();
      for (Path& loop : wanted.loops) loop = transformed(loop, affine);
      for (const EvaluationOrder evaluation : everyOrder) {
        QVERIFY(farthestCorner(inBetween({pointRegion(point), shape}, {t}, {.evaluation = evaluation}), wanted) < 1e-7);
        QVERIFY(farthestCorner(inBetween({shape, pointRegion(point)}, {1 - t}, {.evaluation = evaluation}), wanted) < 1e-7);
      }
    }
  }

  void aPointAmongShapesMovesThem() {
    Random random = seededRandom();
    for (int round = 0; round < 10; ++round) {
      const Vec2 point = randomVector(random, 50);
      const std::vector<Region> shapes{randomRegion(random, 10), pointRegion(point), circleRegion(3, {5, 5})};
      const double t = uniform(random, 0.1, 0.9), s = uniform(random, 0.1, 0.9);
      const double first = (1 - t) * (1 - s), last = t * s;
      Region wanted = minkowskiSum(std::vector<Region>{shapes[0], shapes[2]}, {.weights = {first, last}}).region;
      wanted = translated(SoundRegion{wanted}, (1 - first - last) * point).region;
      for (const EvaluationOrder evaluation : everyOrder)
        QVERIFY(farthestCorner(inBetween(shapes, {t, s}, {.evaluation = evaluation}), wanted) < 1e-7);
      const LadderResult rungs = ladder(shapes, std::vector<double>{t, s});
      QVERIFY(farthestCorner(rungs.levels.back().front(), wanted) < 1e-7);
      COMPARE_NEAR(area(rungs.levels[1][1]), t * t * area(shapes[2]), 1e-9);
    }
  }

  /// On the line through its control points, as any Bezier curve of degree 1; of the ends nothing is computed.
  void pointsMorphAsPoints() {
    const std::vector<Region> points{pointRegion({1, 2}), pointRegion({5, -2}), pointRegion({9, 2})};
    for (const EvaluationOrder evaluation : everyOrder) {
      const auto at = pointIn(inBetween(points, {0.5, 0.5}, {.evaluation = evaluation}));
      QVERIFY(at);
      COMPARE_NEAR((*at - Vec2(5, 0)).norm(), 0, 1e-15);
    }
    const std::vector<Region> grows{pointRegion({3, 4}), circleRegion(2)};
    QVERIFY(pointIn(inBetween(grows, {0})) == std::optional(Vec2(3, 4)));
    QVERIFY(inBetween(grows, {1}) == grows.back());
  }

  void splinesAreasAndHigherDegreesTakePoints() {
    const std::vector<Region> shapes{circleRegion(4), pointRegion({10, 0}), circleRegion(2, {20, 0}), pointRegion({30, 5})};
    const ShapeKnots knots = uniformKnots(4, 2);
    const double t = 0.4;
    const std::vector<double> shares = influences(knots, t);
    const Region made = splineMorph(shapes, knots, std::vector<double>{t}).regions.front();
    const double radius = shares[0] * 4 + shares[2] * 2;
    COMPARE_NEAR(area(made), std::numbers::pi * radius * radius, 1e-9);
    const std::vector<Region> grows{pointRegion({7, 7}), circleRegion(5)};
    COMPARE_NEAR(area(inBetween(grows, {0.3}, {.areaPreserving = true})), 0.3 * area(grows.back()), 1e-9);
    COMPARE_NEAR(area(inBetween(grows, {0.3}, {.degreeElevate = true})), 0.09 * area(grows.back()), 1e-9);
  }

  /// However little has grown yet: the hull stands for a shape only where that is near enough for its size.
  void whatHasHardlyGrownHasItsForm() {
    Random random = seededRandom();
    for (const double t : {1e-2, 1e-4, 1e-5, 1e-8}) {
      const Region spiky = polygonRegion(spikyPoints(random, {0, 0}, 20, 9));
      for (const std::vector<Region>& shapes : {std::vector<Region>{pointRegion({0, 0}), spiky, circleRegion(3)},
                                                std::vector<Region>{pointRegion({0, 0}), spiky, pointRegion({0, 0})}}) {
        const Region wanted = minkowskiSum(std::vector<Region>{spiky, spiky}).region;
        const double share = t * (1 - t), twice = area(wanted) * share * share;
        const double disc = 3 * t * t * share;  // of the circle, times the perimeter, which is below 1000 mm
        for (const EvaluationOrder evaluation : everyOrder)
          COMPARE_NEAR(area(inBetween(shapes, {t, t}, {.evaluation = evaluation})), twice, 1e-9 * twice + 1000 * disc);
      }
    }
  }

  void whatIsSmallerThanTheDigitsIsAPoint() {
    for (const double t : {1e-200, 1e-16}) QVERIFY(pointIn(inBetween({pointRegion({3, 4}), circleRegion(2)}, {t})));
    QVERIFY(!pointIn(inBetween({pointRegion({3, 4}), circleRegion(2)}, {1e-9})));
  }

  void pointsFarAwayAreRefused() {
    for (const double x : {1.1e9, 1e17, 1e300})
      QCOMPARE(errorOf([&] { inBetween({pointRegion({x, 2}), circleRegion(2)}, {0.5}); }).code(), ErrorCode::LimitExceeded);
    QCOMPARE(errorOf([&] { inBetween({pointRegion({NAN, 2}), circleRegion(2)}, {0.5}); }).code(), ErrorCode::InvalidInput);
  }

  void beyondAShapeThatGrowsThereIsMoreOfIt() {
    const std::vector<Region> grows{pointRegion({2, 0}), circleRegion(5)};
    const Region beyond = inBetween(grows, {1.5});
    COMPARE_NEAR(area(beyond), std::numbers::pi * 7.5 * 7.5, 1e-9);
    QCOMPARE(errorOf([&] { inBetween(grows, {-0.5}); }).code(), ErrorCode::InvalidParameter);
  }

  /// As a feature: a point of a drawing; other drawings make a region or are refused, as they were.
  void theFeatureTakesASinglePoint() {
    const Shape disc(circleRegion(5));
    const Evaluated half = made("morph", {{"t", 0.5}, {"offsets", Value::parse("[[4, 0, 0]]")}}, {pointShape({0, 2}), disc});
    const auto* region = half.shape.get<Region>();
    QVERIFY(region);
    COMPARE_NEAR(area(*region), std::numbers::pi * 6.25, 1e-9);
    const auto* arc = std::get_if<Arc2>(&region->loops.front().segments.front());
    QVERIFY(arc);
    COMPARE_NEAR((arc->center - Vec2(2, 1)).norm(), 0, 1e-12);
    const Evaluated film = made("morph", {{"frames", 5}}, {pointShape({0, 2}), disc});
    const auto* sequence = film.shape.get<Sequence>();
    QVERIFY(sequence && sequence->frames.front().get<Curves>() && sequence->frames[1].get<Region>());
    QVERIFY(singlePoint(sequence->frames.front().get<Curves>()->paths) == std::optional(Vec2(0, 2)));
    const Curves open{{Path{{Line2{{0, 0}, {5, 0}}}, false, {}, {}}}, {}};
    const Error refused = errorOf([&] { made("morph", Value::object(), {Shape(open), disc}); });
    QCOMPARE(refused.code(), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(MinkowskiPointsTest)
#include "minkowski_points_test.moc"
