#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/set_operations.h"
#include "support/curved_regions.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/segment_counts.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;
using std::numbers::pi;

namespace {

Path polyline(const std::vector<Vec2>& points) {
  Path path;
  for (std::size_t i = 1; i < points.size(); ++i) path.segments.emplace_back(Line2{points[i - 1], points[i]});
  return path;
}

PlanarSet curveSet(const Path& path) { return {{}, {path}}; }
PlanarSet segmentSet(const Vec2& from, const Vec2& to) { return curveSet(polyline({from, to})); }
PlanarSet areaSet(const Region& region) { return {region}; }
PlanarSet pointSet(const std::vector<Vec2>& points) { return {{}, {}, points}; }

SetSumResult setSumOf(const PlanarSet& a, const PlanarSet& b) { return setSum(std::vector{a, b}); }
Region areaOfSum(const PlanarSet& a, const PlanarSet& b) { return setSumOf(a, b).set.area; }
Region roomFor(const Region& a, const PlanarSet& b) { return setDifference(std::vector{areaSet(a), b}).set.area; }

std::pair<int, int> lineAndArcCounts(const Region& region) {
  return {static_cast<int>(segmentCountOf<Line2>(region)), static_cast<int>(segmentCountOf<Arc2>(region))};
}

Vec2 randomVector(Random& random, double reach) { return {uniform(random, -reach, reach), uniform(random, -reach, reach)}; }

std::vector<Vec2> randomWalk(Random& random, int corners, double reach) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) points.push_back(randomVector(random, reach));
  return points;
}

/// How wide a set of corners is across a direction.
double widthAcross(const std::vector<Vec2>& corners, const Vec2& along) {
  const Vec2 across = Vec2(-along.y(), along.x()).normalized();
  double low = INFINITY, high = -INFINITY;
  for (const Vec2& p : corners) low = std::min(low, p.dot(across)), high = std::max(high, p.dot(across));
  return high - low;
}

bool crossProperly(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(Vec2(q - p), Vec2(r - p)) > 0; };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

bool liesInRegion(const Region& region, const Vec2& p) {
  int winding = 0;
  for (const Path& loop : region.loops) winding += windingNumber(loop, p);
  return winding > 0;
}

/// Whether the region and x - path have a point in common, decided without any sum.
bool meets(const Region& region, const std::vector<Vec2>& path, const Vec2& x) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 from = x - path[i], to = x - path[i + 1];
    if (liesInRegion(region, from) || liesInRegion(region, to)) return true;
    for (const Path& loop : region.loops)
      for (const Segment& segment : loop.segments)
        if (crossProperly(startPoint(segment), endPoint(segment), from, to)) return true;
  }
  return false;
}

double distanceToBoundary(const Region& region, const Vec2& p) {
  double nearest = INFINITY;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) {
      const Vec2 from = startPoint(segment), along = endPoint(segment) - from;
      const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (from + t * along - p).norm());
    }
  return nearest;
}

/// Area that two discs of one radius have in common.
double lensArea(double radius, double distance) {
  return 2 * radius * radius * std::acos(distance / (2 * radius)) -
         distance / 2 * std::sqrt(4 * radius * radius - distance * distance);
}

}  // namespace

/// Open curves, points and nothing at all as operands.
class MinkowskiOpenTest : public QObject {
  Q_OBJECT

 private slots:
  void aSegmentAndADiscAreAStadium() {
    Random random = seededRandom();
    for (int k = 0; k < 100; ++k) {
      const Vec2 from = randomVector(random, 10), to = randomVector(random, 10);
      const double r = std::pow(10, uniform(random, -2, 2)), length = (to - from).norm();
      const Region sum = areaOfSum(segmentSet(from, to), areaSet(circleRegion(r, randomVector(random, 5))));
      const double exact = 2 * r * length + pi * r * r;
      COMPARE_NEAR(area(sum), exact, 1e-10 * (exact + length));  // the grid is one of both shapes
      QCOMPARE(lineAndArcCounts(sum), std::pair(2, 2));
    }
  }

  /// Of a convex shape: its area and the length times its width across the segment.
  void aConvexShapeAlongASegment() {
    Random random = seededRandom();
    for (int k = 0; k < 100; ++k) {
      std::vector<Vec2> corners;
      const int n = uniformInt(random, 3, 9);
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * (i + uniform(random, 0, 0.9)) / n;
        corners.emplace_back(3 * std::cos(angle), 3 * std::sin(angle));
      }
      const Vec2 from = randomVector(random, 20), along = randomVector(random, 10);
      const Region sum = areaOfSum(areaSet(polygonRegion(corners)), segmentSet(from, from + along));
      const double exact = area(polygonRegion(corners)) + along.norm() * widthAcross(corners, along);
      COMPARE_NEAR(area(sum), exact, 1e-11 * exact);
    }
  }

  /// x is in A + P exactly when A meets x - P; lattice paths run along edges and fold back on themselves.
  void regionsAlongPolylines() {
    Random random = seededRandom();
    int inside = 0, holes = 0;
    for (int k = 0; k < 60; ++k) {
      const bool lattice = k % 3 == 0;
      const Region region = lattice ? cellRegion(randomCells(random, 5, 5, 0.5)) : randomRegion(random, 4);
      std::vector<Vec2> path = randomWalk(random, uniformInt(random, 2, 7), 5);
      if (lattice)
        for (Vec2& p : path) p = p.array().round();
      if (lattice) path.push_back(path.front());
      if (k % 5 == 0) path.insert(path.end(), {path.back() + Vec2(2, 1), path.back() + Vec2(-2, -1)});
      std::vector<Vec2> apart;
      for (const Vec2& p : path)
        if (apart.empty() || apart.back() != p) apart.push_back(p);
      if (apart.size() < 2) continue;
      const Region sum = areaOfSum(areaSet(region), curveSet(polyline(apart)));
      holes += static_cast<int>(components(sum).size() < sum.loops.size());
      for (int i = 0; i < 150; ++i) {
        const Vec2 x = randomVector(random, 14);
        if (distanceToBoundary(sum, x) < 1e-9) continue;
        const bool is = liesInRegion(sum, x);
        inside += is ? 1 : 0;
        QCOMPARE(is, meets(region, apart, x));
      }
    }
    QVERIFY(inside > 500 && holes > 0);
  }

  void twoSegmentsAreAParallelogram() {
    Random random = seededRandom();
    for (int k = 0; k < 50; ++k) {
      const Vec2 a = randomVector(random, 10), b = randomVector(random, 10);
      const Region sum = areaOfSum(segmentSet({1, 2}, Vec2(1, 2) + a), segmentSet({-4, 0}, Vec2(-4, 0) + b));
      COMPARE_NEAR(area(sum), std::abs(cross(a, b)), 1e-11 * a.norm() * b.norm());
      QCOMPARE(lineAndArcCounts(sum), std::pair(4, 0));
    }
  }

  void parallelSegmentsSweepNoArea() {
    try {
      (void)setSumOf(segmentSet({1, 2}, {4, 6}), segmentSet({0, 0}, {6, 8}));
      QFAIL("a line is no area");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::Degenerate);
      QVERIFY2(error.message().find("(1, 2)") != std::string::npos, error.message().c_str());
      QVERIFY(!error.hint().empty());
    }
  }

  /// Two crossing paths: the sum covers what any of their pieces do.
  void twoPolylines() {
    // An L along an L: squares of 2, 3 x 2, 2 x 3 and, across, 3 x 3, of which parts lie over one another.
    const Region sum = areaOfSum(curveSet(polyline({{0, 0}, {2, 0}, {2, 2}})), curveSet(polyline({{0, 0}, {0, 3}, {3, 3}})));
    // The horizontal piece along the upright one is [0,2]x[0,3], the upright piece along the horizontal one [2,5]x[3,5];
    // the other two pairs are lines.
    COMPARE_NEAR(area(sum), 6 + 6, 1e-9);
  }

  void aBentTubeOfArcs() {
    for (const double sweep : {0.5 * pi, -0.5 * pi, 1.2 * pi, -pi}) {
      Path bow;
      bow.segments.emplace_back(Arc2{{3, 1}, 10, 0.3, sweep});
      const Region sum = areaOfSum(curveSet(bow), areaSet(circleRegion(2)));
      COMPARE_NEAR(area(sum), 2 * 2 * 10 * std::abs(sweep) + 4 * pi, 1e-9);
      QCOMPARE(lineAndArcCounts(sum), std::pair(0, 4));
    }
  }

  /// A hook of a line and an arc that touches it.
  void aHookOfALineAndAnArc() {
    Path hook = polyline({{-10, 0}, {0, 0}});
    hook.segments.emplace_back(Arc2{{0, 5}, 5, -pi / 2, pi / 2});
    const Region sum = areaOfSum(areaSet(circleRegion(1)), curveSet(hook));
    COMPARE_NEAR(area(sum), 2 * (10 + 2.5 * pi) + pi, 1e-10);
    QCOMPARE(lineAndArcCounts(sum), std::pair(2, 4));
  }

  void aFreeFormTube() {
    Path wave;
    wave.segments.emplace_back(Spline2{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 1}, {10, 8, 1}, {20, -8, 1}, {30, 0, 1}}});
    const double r = 1.5, exact = 2 * r * length(wave) + pi * r * r;
    const SetSumResult sum = setSumOf(curveSet(wave), areaSet(circleRegion(r)));
    COMPARE_NEAR(area(sum.set.area), exact, 0.01 * length(wave));
    QVERIFY(segmentCount(sum.set.area) < 12);
  }

  /// A curve that turns either way: few curves come out, at the tolerance that is chosen by itself, too.
  void tubesOfCurvesWithInflections() {
    for (const std::vector<Vec3>& poles : {std::vector<Vec3>{{0, 0, 1}, {10, 20, 1}, {20, -20, 1}, {30, 0, 1}},
                                           {{0, 0, 1}, {7, 31, 1}, {25, -17, 1}, {40, 11, 1}}}) {
      Path path;
      path.segments.emplace_back(Spline2{3, {0, 0, 0, 0, 1, 1, 1, 1}, poles});
      const double length = blossom::length(path);
      for (const double radius : {0.1, 1.0}) {
        const Region tube = areaOfSum(curveSet(path), areaSet(circleRegion(radius)));
        QVERIFY2(segmentCount(tube) <= 10, qPrintable(QString::number(segmentCount(tube))));
        COMPARE_NEAR(area(tube), 2 * radius * length + pi * radius * radius,
                     1e-3 * radius * length);  // Steiner: no side folds
      }
    }
  }
  void roomForCurves() {
    COMPARE_NEAR(area(roomFor(rectangleRegion({0, 0}, {10, 6}), segmentSet({1, 1}, {4, 2}))), 7 * 5, 1e-9);
    const Region lens = roomFor(circleRegion(5), segmentSet({-2, 0}, {2, 0}));
    COMPARE_NEAR(area(lens), lensArea(5, 4), 1e-9);
    QCOMPARE(lineAndArcCounts(lens), std::pair(0, 2));
    // A hole that the segment crosses blocks what A blocks: the hole and itself moved, and all between.
    Region plate = rectangleRegion({-20, -20}, {20, 20});
    plate.loops.push_back(reversed(rectanglePath({-1, -1}, {1, 1})));
    COMPARE_NEAR(area(roomFor(plate, segmentSet({0, 0}, {6, 0}))), 34 * 40 - 8 * 2, 1e-9);
    const SetSumResult none = setDifference(std::vector{areaSet(circleRegion(1)), segmentSet({0, 0}, {3, 0})});
    QVERIFY(none.set.empty() && none.warnings.size() == 1);
    VERIFY_ERROR(setDifference(std::vector{segmentSet({0, 0}, {3, 0}), areaSet(circleRegion(1))}), ErrorCode::InvalidInput);
  }

  /// However coarse, a difference is never too large.
  void roomInFreeFormOutlines() {
    Random random = seededRandom();
    for (int k = 0; k < 12; ++k) {
      const Region outline = k == 0 ? ellipseRegion(9, 4) : freeRegion(random, 10);
      Path arc;
      arc.segments.emplace_back(Arc2{{0, 0}, 1, uniform(random, 0, 6), uniform(random, 1, 4)});
      Path spline;
      spline.segments.emplace_back(ellipticArc({0, 0}, {1.5, 0}, 0.5, 0, 2.5));
      for (const PlanarSet& tool : {curveSet(arc), curveSet(spline), segmentSet({0, 0}, randomVector(random, 1.5))}) {
        const auto roomWithin = [&](double tolerance) {
          return area(setDifference(std::vector{areaSet(outline), tool}, {.tolerance = tolerance}).set.area);
        };
        const double fine = roomWithin(1e-4);
        for (const double coarse : {0.02, 0.005, 0.001}) {
          const double room = roomWithin(coarse);
          QVERIFY(room <= fine * (1 + 1e-12));
          QVERIFY(room >= 0.95 * fine - 1);
        }
      }
    }
  }

  void roomForAPointIsTheShapeMoved() {
    const Region outline = ellipseRegion(9, 4), room = roomFor(outline, pointSet({{2, 1}}));
    COMPARE_NEAR(area(room), area(outline), 1e-12);
    COMPARE_NEAR((startPoint(room.loops.front()) - startPoint(outline.loops.front()) - Vec2(-2, -1)).norm(), 0, 1e-12);
  }

  /// p + P inside A, decided without any difference.
  void roomForPolylines() {
    Random random = seededRandom();
    for (int k = 0; k < 40; ++k) {
      const Region region = randomRegion(random, 10);
      const std::vector<Vec2> path = randomWalk(random, uniformInt(random, 2, 5), 1.5);
      const Region room = roomFor(region, curveSet(polyline(path)));
      Region complement{{rectanglePath({-200, -200}, {200, 200})}};
      for (const Path& loop : region.loops) complement.loops.push_back(reversed(loop));
      std::vector<Vec2> turned;
      for (const Vec2& p : path) turned.push_back(-p);
      for (int i = 0; i < 150; ++i) {
        const Vec2 x(uniform(random, -12, 60), uniform(random, -14, 14));
        if (!room.loops.empty() && distanceToBoundary(room, x) < 1e-9) continue;
        QCOMPARE(liesInRegion(room, x), !meets(complement, turned, x));
      }
    }
  }

  void aPointMoves() {
    Random random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const Region region = k % 2 == 0 ? randomRegion(random, 5) : anyRounded(random, 5);
      const Vec2 by = randomVector(random, 9);
      COMPARE_NEAR(area(areaOfSum(areaSet(region), pointSet({by}))), area(region), 1e-12 * area(region));
      QVERIFY(areaOfSum(areaSet(region), pointSet({{0, 0}})) == soundRegion(region, {}, "A").region);
      QVERIFY(roomFor(region, pointSet({{0, 0}})).loops.size() == region.loops.size());
      COMPARE_NEAR(area(roomFor(region, pointSet({by}))), area(region), 1e-9 * area(region));
    }
    const SetSumResult curve = setSumOf(segmentSet({0, 0}, {1, 2}), pointSet({{5, 5}}));
    QVERIFY(curve.set.area.loops.empty() && curve.set.points.empty());
    QCOMPARE(startPoint(curve.set.curves.front()), Vec2(5, 5));
    QCOMPARE(setSumOf(pointSet({{1, 2}, {3, 4}}), pointSet({{10, 0}, {12, 2}})).set.points.size(), std::size_t{3});
  }

  /// Copies that lie over one another are one area; room for two points is what two copies have in common.
  void severalPoints() {
    const Region discs = areaOfSum(areaSet(circleRegion(5)), pointSet({{0, 0}, {6, 0}, {100, 0}}));
    COMPARE_NEAR(area(discs), 3 * 25 * pi - lensArea(5, 6), 1e-9);
    QCOMPARE(discs.loops.size(), std::size_t{2});
    COMPARE_NEAR(area(roomFor(circleRegion(5), pointSet({{0, 0}, {6, 0}}))), lensArea(5, 6), 1e-9);
  }

  /// What two of three sets sweep without width takes part in the third.
  void sumsOfSeveralSetsDoNotDependOnTheirOrder() {
    Random random = seededRandom();
    for (int round = 0; round < 60; ++round) {
      std::vector<PlanarSet> sets{{circleRegion(uniform(random, 0.5, 2)), {}, {{20, 3}}}};  // no area alone
      for (int k = uniformInt(random, 2, 3); k > 0; --k) {
        std::vector<Vec2> corners{{0, 0}};
        for (int side = uniformInt(random, 1, 3); side > 0; --side) {  // along the axes, so that many are parallel
          const double length = uniformInt(random, 0, 1) == 0 ? uniformInt(random, 2, 6) : -uniformInt(random, 2, 6);
          corners.push_back(corners.back() + (uniformInt(random, 0, 1) == 0 ? Vec2(length, 0) : Vec2(0, length)));
        }
        sets.push_back(curveSet(polyline(corners)));
        if (uniformInt(random, 0, 2) == 0) sets.back().points.emplace_back(uniform(random, 8, 12), uniform(random, 8, 12));
        if (uniformInt(random, 0, 2) == 0) sets.back().area = rectangleRegion({-9, -9}, {-7, -6});
      }
      const Region discFirst = setSum(sets).set.area;
      std::reverse(sets.begin(), sets.end());
      const Region discLast = setSum(sets).set.area;
      COMPARE_NEAR(area(discLast), area(discFirst), 1e-7 * area(discFirst));
    }
  }

  void linesOfOneDirectionAndADiscAreAStadium() {
    const PlanarSet left = segmentSet({3, 0}, {0, 0}), right = segmentSet({1, 1}, {5, 1});
    for (const PlanarSet& disc : {areaSet(circleRegion(1)), PlanarSet{circleRegion(1), {}, {{30, 0}}}})
      for (const auto& sets :
           {std::vector{left, right, disc}, std::vector{left, disc, right}, std::vector{disc, left, right}})
        COMPARE_NEAR(area(setSum(sets).set.area), 2.0 * 7 + pi, 1e-9);
    QVERIFY_THROWS_EXCEPTION(Error, (void)setSum(std::vector{left, right, left}));
  }

  void manyPointsAreCounted() {
    Random random = seededRandom();
    const std::vector sets{pointSet(randomWalk(random, 100, 9)), pointSet(randomWalk(random, 100, 9)),
                           pointSet(randomWalk(random, 100, 9))};
    QVERIFY_THROWS_EXCEPTION(TooMuchWork, (void)setSum(sets, {.maximumWork = 100'000}));
    CancelToken token;
    token.cancel();
    QVERIFY_THROWS_EXCEPTION(Error, (void)setSum(sets, {}, Progress(token)));
  }

  void theEmptySetAbsorbs() {
    for (const PlanarSet& set : {areaSet(circleRegion(2)), segmentSet({0, 0}, {1, 0}), pointSet({{0, 0}})})
      for (const bool first : {false, true}) {
        const SetSumResult sum = first ? setSumOf({}, set) : setSumOf(set, {});
        QVERIFY(sum.set.empty() && sum.warnings.size() == 1);
      }
    QVERIFY(setDifference(std::vector{PlanarSet(), areaSet(circleRegion(1))}).set.empty());
    VERIFY_ERROR(setDifference(std::vector{areaSet(circleRegion(1)), PlanarSet()}), ErrorCode::InvalidInput);
  }

  void whatNearlyClosesIsTold() {
    const PlanarSet gap = curveSet(polyline({{0, 0}, {10, 0}, {10, 10}, {0, 0.1}}));
    const SetSumResult sum = setSumOf(areaSet(circleRegion(1)), gap);
    QVERIFY(sum.warnings.size() == 1 && sum.warnings.front().starts_with("Shape 2 is open at (0, 0.1)"));
    QVERIFY(setSumOf(areaSet(circleRegion(1)), segmentSet({0, 0}, {1, 0})).warnings.empty());
    QCOMPARE(setClosing(areaSet(circleRegion(1)), gap).warnings, sum.warnings);
    QCOMPARE(setOpening(areaSet(circleRegion(30)), gap).warnings, sum.warnings);
  }

  void weightsOfCurves() {
    const RegionSumOptions options{.weights = {2, -1}};
    const SetSumResult sum = setSum(std::vector{segmentSet({0, 0}, {3, 0}), segmentSet({1, 1}, {1, 5})}, options);
    COMPARE_NEAR(area(sum.set.area), 6 * 4, 1e-9);
    QVERIFY(liesInRegion(sum.set.area, {2, -3}) && !liesInRegion(sum.set.area, {2, 3}));
  }

  void badCurvesAreRefusedWithTheirPlace() {
    const PlanarSet disc = areaSet(circleRegion(1));
    PlanarSet torn = segmentSet({0, 0}, {1, 0});
    torn.curves.front().segments.emplace_back(Line2{{2, 0}, {3, 0}});
    VERIFY_ERROR(setSumOf(disc, torn), ErrorCode::InvalidInput);
    VERIFY_ERROR(setSumOf(disc, segmentSet({0, 0}, {NAN, 0})), ErrorCode::InvalidInput);
    VERIFY_ERROR(setSumOf(disc, segmentSet({0, 0}, {1e12, 0})), ErrorCode::LimitExceeded);
    VERIFY_ERROR(setSumOf(disc, pointSet({{NAN, 0}})), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(MinkowskiOpenTest)
#include "minkowski_open_test.moc"
