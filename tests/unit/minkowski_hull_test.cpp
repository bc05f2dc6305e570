#include "geometry/planar/sums/convex_hull.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "minkowski/kernel/hull_distance.h"
#include "minkowski/kernel/region_repeat.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

Region together(const std::vector<Region>& regions) {
  Region all;
  for (const Region& region : regions) all.loops.insert(all.loops.end(), region.loops.begin(), region.loops.end());
  return all;
}

Region starOf(int points, double outer, double inner, const Vec2& centre = Vec2::Zero(), double turn = 0) {
  std::vector<Vec2> corners;
  for (int k = 0; k < 2 * points; ++k) {
    const double angle = turn + pi * k / points;
    corners.push_back(centre + (k % 2 == 0 ? outer : inner) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygonRegion(corners);
}

template <class Kind>
int countOf(const Region& region) {
  int count = 0;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) count += std::holds_alternative<Kind>(segment) ? 1 : 0;
  return count;
}

/// The largest p.u of a region of lines and arcs.
double reachOf(const Region& region, double angle) {
  const Vec2 u(std::cos(angle), std::sin(angle));
  double reach = -HUGE_VAL;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) {
      reach = std::max({reach, startPoint(segment).dot(u), endPoint(segment).dot(u)});
      const auto* arc = std::get_if<Arc2>(&segment);
      if (!arc || arc->sweep < 0) continue;
      const double along = std::fmod(std::fmod(angle - arc->start, 2 * pi) + 2 * pi, 2 * pi);
      if (along <= arc->sweep) reach = std::max(reach, arc->center.dot(u) + arc->radius);
    }
  return reach;
}

/// A slot or a disc or a star, with arcs of all sweeps.
Region roundedPart(Random& random, const Vec2& at) {
  const double r = uniform(random, 0.5, 3);
  if (uniformInt(random, 0, 2) == 0) return circleRegion(r, at);
  if (uniformInt(random, 0, 1) == 0) return starOf(uniformInt(random, 3, 7), r + 1, r / 2, at, uniform(random, 0, 6));
  const double start = uniform(random, -7, 7), sweep = uniform(random, 0.2, 6);  // a disc cut along a chord
  const Arc2 arc{at, r, start, sweep};
  Path path;
  path.closed = true;
  path.segments = {arc, Line2{endPoint(arc), startPoint(arc)}};
  return {{path}};
}

Region repeatedRegion(const Region& region, std::size_t count, bool normalised, std::optional<double> tolerance = {}) {
  return regionRepeat(region, {.count = count, .normalised = normalised, .tolerance = tolerance}).region;
}

}  // namespace

/// Convex hulls, and repeated sums on their way to them.
class MinkowskiHullTest : public QObject {
  Q_OBJECT

 private slots:
  void twoDiscsMakeAStadium() {
    const Region hull = regionHull(together({circleRegion(2), circleRegion(2, {10, 0})}), {});
    QCOMPARE(countOf<Line2>(hull), 2);
    QCOMPARE(countOf<Arc2>(hull), 2);
    COMPARE_NEAR(area(hull), 40 + 4 * pi, 1e-12 * 50);
    // Of different radii: two sectors and two right-angled trapezoids along the lines that touch both.
    const double a = 5, b = 2, d = 10, along = std::sqrt(d * d - (a - b) * (a - b)), half = std::acos((a - b) / d);
    const Region belt = regionHull(together({circleRegion(a), circleRegion(b, {6, 8})}), {});
    QCOMPARE(countOf<Line2>(belt), 2);
    QCOMPARE(countOf<Arc2>(belt), 2);
    COMPARE_NEAR(area(belt), (a + b) * along + a * a * (pi - half) + b * b * half, 1e-12 * 150);
  }

  void circlesInSeveralArcsLoseNone() {
    for (const int arcs : {2, 3, 4, 8})
      for (const double start : {0.0, 0.4}) {
        const Vec2 at(50, -30);
        const Region ring{{circleInArcs(10, arcs, at, start), reversed(circleInArcs(5, arcs, at, start))}};
        const Region hull = regionHull(ring, std::nullopt);
        QVERIFY2(std::abs(area(hull) - 100 * pi) < 1e-9, fmt::format("{} arcs from {}", arcs, start).c_str());
        // A slice with the rest of the circle cut out, down to its centre.
        Path slice = circleInArcs(10, arcs, at, start);
        slice.segments.pop_back();
        slice.segments.emplace_back(Line2{endPoint(slice.segments.back()), at});
        slice.segments.emplace_back(Line2{at, startPoint(slice.segments.front())});
        const double turn = 2 * pi * (arcs - 1) / arcs, rest = 2 * pi - turn;
        const double expected = turn < pi + 1e-9 ? 50 * turn : 50 * (turn + std::sin(rest));
        QVERIFY2(std::abs(area(regionHull({{slice}}, std::nullopt)) - expected) < 1e-9,
                 fmt::format("{} arcs", arcs).c_str());
        QVERIFY(std::abs(area(regionRepeat(ring, {.count = 3}).region) - 900 * pi) < 1e-7);
      }
  }
  void convexShapesAreTheirHulls() {
    for (const Region& region : {circleRegion(3, {1, 2}), rectangleRegion({0, 0}, {3, 2}), ellipseRegion(10, 4)})
      QVERIFY(regionHull(region, {}) == region);
    const Region star = regionHull(starOf(5, 10, 4), {});
    QCOMPARE(countOf<Line2>(star), 5);
    COMPARE_NEAR(area(star), 2.5 * 100 * std::sin(2 * pi / 5), 1e-10);
  }

  /// In every direction the hull reaches as far as the shape, and it is convex and stays what it is.
  void theHullReachesAsFarAsTheShape() {
    Random random = seededRandom();
    for (int round = 0; round < 300; ++round) {
      Region shape;
      const int parts = uniformInt(random, 1, 6);
      for (int k = 0; k < parts; ++k)
        shape = together({shape, roundedPart(random, {uniform(random, -20, 20), uniform(random, -20, 20)})});
      const Region hull = convexHull(shape, 1e-3);
      QVERIFY(isConvex(SoundRegion{hull, 1e-3}));
      for (int k = 0; k < 60; ++k) {
        const double angle = uniform(random, -pi, pi);
        COMPARE_NEAR(reachOf(hull, angle), reachOf(shape, angle), 1e-11 * 50);
      }
      COMPARE_NEAR(area(convexHull(hull, 1e-3)), area(hull), 1e-9 * area(hull));
    }
  }

  void freeFormPartsStaySmooth() {
    const Region shape = together({ellipseRegion(10, 4), circleRegion(1, {20, 3})});
    const double tolerance = 1e-3;
    const Region hull = convexHull(shape, tolerance);
    QCOMPARE(countOf<Spline2>(hull), 1);
    QCOMPARE(countOf<Arc2>(hull), 1);
    QCOMPARE(countOf<Line2>(hull), 2);
    Region polygons;
    for (const Path& loop : shape.loops) polygons.loops.push_back(polygonPath(flatten(loop, 1e-7)));
    COMPARE_NEAR(area(hull), area(convexHull(polygons, 1e-7)), 70 * tolerance);
  }

  void theDistanceToTheHullIsMeasured() {
    // A slot 2 wide and 6 deep: half-way between its walls.
    const Region slotted = polygonRegion({{0, 0}, {10, 0}, {10, 8}, {6, 8}, {6, 2}, {4, 2}, {4, 8}, {0, 8}});
    COMPARE_NEAR(distanceToHull(slotted, convexHull(slotted, 1e-3), 1e-4).distance, 1, 1e-6);
    // Of two discs, half-way along a line that touches both.
    const Region discs = together({circleRegion(2), circleRegion(2, {10, 0})});
    const HullDistance between = distanceToHull(discs, convexHull(discs, 1e-3), 1e-4);
    COMPARE_NEAR(between.distance, std::hypot(5, 2) - 2, 1e-9);
    COMPARE_NEAR(std::abs(between.at.y()), 2, 1e-3);
    QVERIFY(between.atMost >= between.distance && between.atMost <= 1.002 * between.distance + 1e-4);
    // A hole: its centre.
    Region plate = rectangleRegion({0, 0}, {10, 10});
    plate.loops.push_back(reversed(circleRegion(3, {5, 5}).loops.front()));
    const HullDistance hole = distanceToHull(plate, convexHull(plate, 1e-3), 1e-4);
    COMPARE_NEAR(hole.distance, 3, 1e-6);
    COMPARE_NEAR((hole.at - Vec2(5, 5)).norm(), 0, 1e-5);
    COMPARE_NEAR(circumradius(plate, 1e-6), 5 * std::sqrt(2), 1e-5);
    COMPARE_NEAR(circumradius(starOf(7, 10, 3, {100, 200}), 1e-6), 10, 1e-9);
  }

  void copiesAreAddedByDoubling() {
    const Region star = starOf(5, 10, 4);
    const std::vector<Region> seven(7, star);
    const Region sum = minkowskiSum(seven).region;
    const RegionRepeatResult result = regionRepeat(star, {.count = 7});
    COMPARE_NEAR(area(result.region), area(sum), 1e-9 * area(sum));
    QCOMPARE(result.sums, std::size_t{4});
    COMPARE_NEAR(area(repeatedRegion(star, 7, true)), area(sum) / 49, 1e-9 * area(sum));
    QVERIFY(repeatedRegion(star, 1, true) == star);
    const Region disc = circleRegion(2, {1, 1});
    const RegionRepeatResult discs = regionRepeat(disc, {.count = 1'000'000});
    QVERIFY(discs.region == circleRegion(2e6, {1e6, 1e6}) && discs.sums == 0 && discs.hullDistance == 0);
  }

  /// Equation 1.3: (1/k) [k]A tends to the hull; the distance of the hull to [k]A does not grow with k. (Where the hull
  /// stands for [k]A, only a bound of it is told.)
  void copiesComeNearerToTheHull() {
    Random random = seededRandom();
    for (int round = 0; round < 20; ++round) {
      const Region shape = polygonRegion(spikyPoints(random, {uniform(random, -9, 9), 0}, 10, uniformInt(random, 5, 12)));
      const double hullArea = area(regionHull(shape, {}));
      double before = HUGE_VAL;
      for (const std::size_t k : {1, 2, 3, 4, 6, 8}) {
        const RegionRepeatResult result = regionRepeat(shape, {.count = k, .normalised = true});
        QVERIFY(result.hullDistance <= result.hullBound);
        QVERIFY(area(result.region) <= hullArea * (1 + 1e-9));
        if (result.isHull) continue;
        const double total = static_cast<double>(k) * result.hullDistance;
        if (k >= 3) QVERIFY2(total <= before + 1e-4, qPrintable(QString("%1 %2").arg(total).arg(before)));
        if (k >= 2) before = total;
      }
    }
  }

  void endlessCopiesAreRefusedBeforehand() {
    const Region star = polygonRegion({{20, 0}, {4, 3}, {0, 20}, {-3, 4}, {-20, 0}, {-4, -4}, {0, -20}, {5, -3}});
    VERIFY_ERROR(regionRepeat(star, {.count = 1'000'000'000}), ErrorCode::LimitExceeded);
    QVERIFY(regionRepeat(star, {.count = 1'000'000'000, .normalised = true}).isHull);
  }
  void manyCopiesAreTheHull() {
    const Region star = starOf(5, 10, 4);
    const RegionRepeatResult many = regionRepeat(star, {.count = 1'000'000, .normalised = true});
    QVERIFY(many.isHull && many.warnings.size() == 1 && many.hullDistance < 1e-4);
    QVERIFY(many.region == regionHull(star, {}));
    // Just before the hull is near enough, what was computed is no farther from it than was certified.
    const RegionRepeatResult few = regionRepeat(star, {.count = 40, .normalised = true, .tolerance = 0.05});
    const RegionRepeatResult more = regionRepeat(star, {.count = 100, .normalised = true, .tolerance = 0.05});
    QVERIFY(!few.isHull && few.hullDistance > 0.05 && more.isHull && more.hullDistance <= 0.05);
    QVERIFY(repeatedRegion(star, 100, true, 1e-3) != more.region);
    VERIFY_ERROR(regionRepeat(star, {.count = 0}), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(MinkowskiHullTest)
#include "minkowski_hull_test.moc"
