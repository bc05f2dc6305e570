#include "geometry/planar/sums/convex_hull.h"
#include "geometry/planar/sums/flattening.h"
#include "minkowski/kernel/morph/influence_curves.h"
#include "minkowski/kernel/morph/sector_shape.h"
#include "minkowski/kernel/morph/shape_spline.h"
#include "support/boundary_distance.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

std::vector<Region> poleShapes(Random& random, int count) {
  std::vector<Region> shapes;
  for (int k = 0; k < count; ++k)
    shapes.push_back(polygonRegion(spikyPoints(random, {uniform(random, -3, 3), 4.0 * k}, 5, uniformInt(random, 4, 7))));
  return shapes;
}

std::vector<Region> roundShapes(Random& random, int count) {
  std::vector<Region> shapes;
  for (int k = 0; k < count; ++k) {
    const Vec2 at(uniform(random, -9, 9), uniform(random, -9, 9));
    shapes.push_back(k % 2 == 0 ? circleRegion(uniform(random, 1, 4), at)
                                : rectangleRegion(at, at + Vec2(uniform(random, 1, 5), uniform(random, 1, 5))));
  }
  return shapes;
}

Region splineAt(const std::vector<Region>& shapes, const ShapeKnots& spline, double t) {
  return splineMorph(shapes, spline, std::vector{t}).regions.front();
}

double apartOf(const Region& a, const Region& b) {
  return distanceBetween(sidesOf(flattened(a, {}, "shape")), sidesOf(flattened(b, {}, "shape")));
}

/// N_i of a degree by its recursive definition, with 0 / 0 = 0.
double basisOf(const std::vector<double>& knots, std::size_t i, int degree, double u) {
  if (degree == 0) return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
  const auto d = static_cast<std::size_t>(degree);
  double sum = 0;
  if (knots[i + d] > knots[i]) sum += (u - knots[i]) / (knots[i + d] - knots[i]) * basisOf(knots, i, degree - 1, u);
  if (knots[i + d + 1] > knots[i + 1])
    sum += (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) * basisOf(knots, i + 1, degree - 1, u);
  return sum;
}

double reachTo(const Region& region, double angle) {
  const Vec2 u(std::cos(angle), std::sin(angle));
  double reach = -HUGE_VAL;
  for (const Vec2& p : flatten(region.loops.front(), 1e-6)) reach = std::max(reach, p.dot(u));
  return reach;
}

}  // namespace

/// Morphs whose control shapes act in part of the time, or in some directions.
class MinkowskiSplineTest : public QObject {
  Q_OBJECT

 private slots:
  void areasAreBlendedByTheBasisFunctions() {
    Random random = seededRandom();
    const std::vector<Region> shapes = poleShapes(random, 6);
    const ShapeKnots spline = uniformKnots(shapes.size(), 2);
    for (const double t : {0.1, 0.37, 0.5, 0.81}) {
      double wanted = 0;
      const std::vector<double> shares = influences(spline, t);
      for (std::size_t i = 0; i < shapes.size(); ++i) wanted += shares[i] * area(shapes[i]);
      const auto made = splineMorph(shapes, spline, std::vector{t}, {.areaPreserving = true});
      COMPARE_NEAR(area(made.regions.front()), wanted, 1e-9 * wanted);
    }
  }

  void ofFullDegreeItIsTheBezierMorph() {
    Random random = seededRandom();
    for (int count = 2; count <= 4; ++count) {
      const std::vector<Region> shapes = poleShapes(random, count);
      const ShapeKnots spline = uniformKnots(shapes.size(), count - 1);
      for (const double t : {0.0, 0.3, 0.5, 0.8, 1.0}) {
        const auto bezier = morph(shapes, std::vector<std::vector<double>>{diagonal(shapes.size() - 1, t)},
                                  {.evaluation = EvaluationOrder::BottomUp});
        QVERIFY(apartOf(splineAt(shapes, spline, t), bezier.regions.front()) < 1e-9);
      }
      QVERIFY(!continuityOf(spline));
    }
  }

  void aShapeActsInItsSupportOnly() {
    Random random = seededRandom();
    std::vector<Region> shapes = poleShapes(random, 7);
    const ShapeKnots spline = uniformKnots(7, 2);  // knots 0 0 0 1 2 3 4 5 5 5; shape 5 acts from 3 to 5
    QCOMPARE(continuityOf(spline), std::optional(1));
    const Region before = splineAt(shapes, spline, 2.9 / 5), inside = splineAt(shapes, spline, 3.5 / 5);
    shapes[5] = circleRegion(9, {40, 0});
    QVERIFY(splineAt(shapes, spline, 2.9 / 5) == before);
    QVERIFY(!(splineAt(shapes, spline, 3.5 / 5) == inside));
  }

  void theSplineIsContinuousAndEndsAtTheShapes() {
    Random random = seededRandom();
    const std::vector<Region> shapes = poleShapes(random, 6);
    const ShapeKnots spline = uniformKnots(6, 3);
    for (const double knot : {1.0 / 3, 2.0 / 3})
      QVERIFY(apartOf(splineAt(shapes, spline, knot - 1e-12), splineAt(shapes, spline, knot)) < 1e-8);
    QVERIFY(splineAt(shapes, spline, 0) == shapes.front());
    QVERIFY(splineAt(shapes, spline, 1) == shapes.back());
    // A knot as often as the degree: the morph passes that shape.
    const ShapeKnots corner{2, {0, 0, 0, 1, 1, 2, 3, 3, 3}};
    QCOMPARE(continuityOf(corner), std::optional(0));
    QVERIFY(splineAt(shapes, corner, 1.0 / 3) == shapes[2]);
  }

  /// A map of the plane may come before or after.
  void affineMapsPassThrough() {
    Random random = seededRandom();
    Eigen::Matrix<double, 2, 3> map;
    map << 1.2, 0.4, 7, -0.3, 0.9, -2;
    const auto mapped = [&](Region region) {
      for (Path& loop : region.loops) loop = transformed(loop, map);
      return region;
    };
    for (int round = 0; round < 10; ++round) {
      const std::vector<Region> shapes = poleShapes(random, 5);
      std::vector<Region> images;
      for (const Region& shape : shapes) images.push_back(mapped(shape));
      const ShapeKnots spline = uniformKnots(5, 2);
      const double t = uniform(random, 0, 1);
      QVERIFY(apartOf(mapped(splineAt(shapes, spline, t)), splineAt(images, spline, t)) < 1e-8);
    }
  }

  /// Support functions of convex shapes are blended by the basis functions.
  void convexShapesAreBlendedByTheirInfluences() {
    Random random = seededRandom();
    for (int round = 0; round < 20; ++round) {
      const std::vector<Region> shapes = roundShapes(random, 6);
      const ShapeKnots spline = uniformKnots(6, uniformInt(random, 1, 4));
      const double t = uniform(random, 0, 1), angle = uniform(random, -pi, pi);
      const std::vector<double> shares = influences(spline, t);
      double wanted = 0;
      for (std::size_t i = 0; i < shapes.size(); ++i) wanted += shares[i] * reachTo(shapes[i], angle);
      const MorphResult result = splineMorph(shapes, spline, std::vector{t});
      COMPARE_NEAR(reachTo(result.regions.front(), angle), wanted, 1e-4);
      QCOMPARE(result.sums, static_cast<std::size_t>(spline.degree));
    }
  }

  void influencesAreTheBasisFunctions() {
    Random random = seededRandom();
    const std::vector<ShapeKnots> all{uniformKnots(6, 3), uniformKnots(7, 2), {2, {0, 0, 0, 1, 1, 4, 5, 5, 5}}};
    for (const ShapeKnots& spline : all)
      for (int round = 0; round < 30; ++round) {
        const double t = uniform(random, 0, 1);
        const std::vector<double> shares = influences(spline, t);
        double sum = 0;
        for (std::size_t i = 0; i < shares.size(); ++i) {
          COMPARE_NEAR(shares[i], basisOf(spline.knots, i, spline.degree, t * spline.knots.back()), 1e-12);
          sum += shares[i];
        }
        COMPARE_NEAR(sum, 1, 1e-12);
      }
    const std::vector<double> bernstein = sharesOf(diagonal(3, 0.25)), same = influences(uniformKnots(4, 3), 0.25);
    for (std::size_t i = 0; i < 4; ++i) COMPARE_NEAR(bernstein[i], same[i], 1e-15);
    COMPARE_NEAR(sharesOf(std::vector{0.2, 0.7})[1], 0.2 * 0.3 + 0.8 * 0.7, 1e-15);
  }

  /// What is drawn of them, with a sample at every knot, and the knots that parameters of a morph mean.
  void influenceCurvesAreTheBasisFunctions() {
    const std::vector<ShapeKnots> all{knotsFor(4, 0, {}), knotsFor(6, 2, {}), knotsFor(6, 0, {0, 0, 0, 1, 1, 2, 3, 3, 3})};
    QCOMPARE(all.front().degree, 3);
    QCOMPARE(all.back().degree, 2);
    for (const ShapeKnots& spline : all) {
      const InfluenceCurves curves = influenceCurves(spline, 30);
      QVERIFY(curves.times.front() == 0 && curves.times.back() == 1);
      QVERIFY(std::is_sorted(curves.times.begin(), curves.times.end()));
      for (const double knot : spline.knots) {
        const auto near = std::lower_bound(curves.times.begin(), curves.times.end(), knot / spline.knots.back() - 1e-15);
        QVERIFY(near != curves.times.end() && *near <= knot / spline.knots.back() + 1e-15);
      }
      for (std::size_t k = 0; k + 1 < curves.times.size(); ++k)
        for (std::size_t i = 0; i < curves.shares.size(); ++i)
          COMPARE_NEAR(curves.shares[i][k], basisOf(spline.knots, i, spline.degree, curves.times[k] * spline.knots.back()),
                       1e-12);
      QCOMPARE(curves.shares.back().back(), 1.0);
    }
  }

  void unsuitableKnotsAreRefused() {
    Random random = seededRandom();
    const std::vector<Region> shapes = roundShapes(random, 4);
    const auto at = [&](const ShapeKnots& spline) { return splineAt(shapes, spline, 0.5); };
    VERIFY_ERROR(at({4, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(at({2, {0, 0, 0, 1, 1, 1}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(at({2, {0, 0, 0, 2, 1, 1, 1}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(at({2, {0, 0, 1, 2, 3, 3, 3}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(at({1, {0, 0, 1, 1, 2, 2}}), ErrorCode::InvalidParameter);
  }

  /// In the directions of the sector it reaches as far as the shape; its boundary is a part of the shape's and a chord.
  void aSectorTakesWhatFacesIt() {
    const SoundRegion disc{circleRegion(4, {1, 2}), 1e-3};
    const SoundRegion half = facing(disc, {0, pi}, "shape");
    COMPARE_NEAR(area(half.region), 8 * pi, 1e-12);
    COMPARE_NEAR(area(facing(disc, {-pi / 2, pi / 2}, "shape").region), 8 * pi, 1e-12);
    QVERIFY(facing(disc, {1, 1}, "shape").region == disc.region);
    const SoundRegion square{rectangleRegion({0, 0}, {4, 4}), 1e-3};
    COMPARE_NEAR(area(facing(square, {-0.1, pi / 2 + 0.1}, "shape").region), 8, 1e-12);
    VERIFY_ERROR(facing(square, {0.1, 1}, "shape"), ErrorCode::InvalidParameter);
    VERIFY_ERROR(facing(square, {-0.1, 1}, "shape"), ErrorCode::InvalidParameter);
    // Sides that face the ends of a sector belong to it, whatever their last bits are.
    for (int degrees = 0; degrees < 90; ++degrees) {
      const double turn = degrees * pi / 180;
      const auto regular = [&](int sides) {
        std::vector<Vec2> corners;
        for (int k = 0; k < sides; ++k) {
          const double angle = turn + 2 * pi * (k - 0.5) / sides;
          corners.push_back(10 * Vec2(std::cos(angle), std::sin(angle)));
        }
        return SoundRegion{polygonRegion(corners), 1e-3};
      };
      COMPARE_NEAR(area(facing(regular(4), {turn, turn + pi / 2}, "shape").region), 100, 1e-9);
      COMPARE_NEAR(area(facing(regular(6), {turn, turn + 2 * pi / 3}, "shape").region), 75 * std::sqrt(3), 1e-9);
    }
    const SoundRegion thirds{{{circleInArcs(4, 3)}}, 1e-3};
    QCOMPARE(facing(thirds, {-1, 1}, "shape").region.loops.front().segments.size(), std::size_t{2});
    Random random = seededRandom();
    for (int round = 0; round < 60; ++round) {
      Region drops = circleRegion(uniform(random, 1, 3), {0, 0});
      drops.loops.push_back(circleRegion(uniform(random, 0.5, 2), {8, uniform(random, -4, 4)}).loops.front());
      const SoundRegion shape{drops, 1e-3}, hull = convexHull(shape);
      const double from = uniform(random, -7, 7), width = uniform(random, 0.5, 6);
      const SoundRegion part = facing(shape, {from, from + width}, "shape");
      QVERIFY(isConvex(part));
      QVERIFY(area(part.region) <= area(hull.region) * (1 + 1e-12));
      for (int k = 0; k < 20; ++k) {
        const double angle = from + width * uniform(random, 0.001, 0.999);
        COMPARE_NEAR(reachTo(part.region, angle), reachTo(hull.region, angle), 1e-5);
      }
    }
  }
};

BLOSSOM_TEST(MinkowskiSplineTest)
#include "minkowski_spline_test.moc"
