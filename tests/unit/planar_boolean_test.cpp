#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/planar/booleans/region_boolean.h"
#include "geometry/planar/planar.h"
#include "support/curved_regions.h"
#include "support/lattice_regions.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

constexpr std::array operations{BooleanOperation::Union, BooleanOperation::Difference, BooleanOperation::Intersection};

bool lies(const Region& region, const Vec2& p) {
  int winding = 0;
  for (const Path& loop : region.loops) winding += windingNumber(loop, p);
  return winding > 0;
}

bool shouldLie(BooleanOperation operation, bool inA, bool inB) {
  if (operation == BooleanOperation::Union) return inA || inB;
  return operation == BooleanOperation::Intersection ? inA && inB : inA && !inB;
}

double distanceToBoundary(const Region& region, const Vec2& p) {
  double nearest = 1e300;
  for (const Path& loop : region.loops) {
    const std::vector<Vec2> points = flatten(loop, 1e-4);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], along = points[(i + 1) % points.size()] - a;
      const double share = along.squaredNorm() > 0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
      nearest = std::min(nearest, (a + share * along - p).norm());
    }
  }
  return nearest;
}

/// The areas of all three as far as they are told, which depend on each other.
void checkAreas(const Region& a, const Region& b, int& untold) {
  std::array<std::optional<Region>, 3> results;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    results[i] = combined(std::array{a, b}, operations[i]);
    if (!results[i]) ++untold;
  }
  const double all = area(a) + area(b);
  if (results[0] && results[2]) COMPARE_NEAR((area(*results[0]) + area(*results[2]) - all) / all, 0, 1e-9);
  if (results[1] && results[2]) COMPARE_NEAR((area(*results[1]) + area(*results[2]) - area(a)) / all, 0, 1e-9);
}

/// The areas of all three.
void checkExpected(const Region& a, const Region& b, const std::array<double, 3>& areas) {
  for (std::size_t i = 0; i < operations.size(); ++i) {
    const auto result = combined(std::array{a, b}, operations[i]);
    QVERIFY(result);
    COMPARE_NEAR(area(*result), areas[i], 1e-9 * (area(a) + area(b)));
  }
}

void checkUntold(int untold, int results, int share) {
  qInfo("%d of %d results are left to others", untold, results);
  QVERIFY(untold <= results / share);
}

void checkMembers(Random& random, const Region& a, const Region& b, const Vec2& low, const Vec2& high) {
  for (const BooleanOperation operation : operations) {
    const auto result = combined(std::array{a, b}, operation);
    if (!result) continue;
    for (int i = 0; i < 25; ++i) {
      const Vec2 p(uniform(random, low.x(), high.x()), uniform(random, low.y(), high.y()));
      if (std::min(distanceToBoundary(a, p), distanceToBoundary(b, p)) < 1e-3) continue;
      QCOMPARE(lies(*result, p), shouldLie(operation, lies(a, p), lies(b, p)));
    }
  }
}

}  // namespace

class PlanarBooleanTest : public QObject {
  Q_OBJECT

 private slots:
  /// Lens of two discs: 2 r^2 acos(d / 2r) - d / 2 sqrt(4 r^2 - d^2).
  void discs() {
    for (const double d : {0.01, 0.5, 1.0, 1.9, 1.999}) {
      const Region a = circleRegion(1), b = circleRegion(1, {d, 0});
      const double lens = 2 * std::acos(d / 2) - d / 2 * std::sqrt(4 - d * d);
      const auto both = combined(std::array{a, b}, BooleanOperation::Intersection);
      const auto any = combined(std::array{a, b}, BooleanOperation::Union);
      QVERIFY(both && any);
      COMPARE_NEAR(area(*both), lens, 1e-12);
      COMPARE_NEAR(area(*any), 2 * pi - lens, 1e-11);
      QCOMPARE(both->loops.front().segments.size(), std::size_t{2});
      QCOMPARE(any->loops.front().segments.size(), std::size_t{2});
    }
  }

  void aSlotOfItsParts() {
    const Region bar = rectangleRegion({0, -1}, {5, 1}), left = circleRegion(1), right = circleRegion(1, {5, 0});
    const auto slot = combined(std::array{bar, left, right}, BooleanOperation::Union);
    QVERIFY(slot);
    QCOMPARE(slot->loops.size(), std::size_t{1});
    QCOMPARE(slot->loops.front().segments.size(), std::size_t{4});
    COMPARE_NEAR(area(*slot), 10 + pi, 1e-12);
  }

  void wallsInCommon() {
    const Region a = rectangleRegion({0, 0}, {4, 3}), b = rectangleRegion({4, 0}, {6, 3}),
                 c = rectangleRegion({4, 1}, {6, 2});
    const auto bar = combined(std::array{a, b}, BooleanOperation::Union);
    QVERIFY(bar);
    QCOMPARE(bar->loops.front().segments.size(), std::size_t{4});
    COMPARE_NEAR(area(*bar), 18, 1e-12);
    const auto nose = combined(std::array{a, c}, BooleanOperation::Union);
    QVERIFY(nose);
    QCOMPARE(nose->loops.front().segments.size(), std::size_t{8});
    const auto none = combined(std::array{a, b}, BooleanOperation::Intersection);
    QVERIFY(none && none->loops.empty());
    const auto same = combined(std::array{a, b}, BooleanOperation::Difference);
    QVERIFY(same);
    COMPARE_NEAR(area(*same), 12, 1e-12);
    const auto nothing = combined(std::array{a, a}, BooleanOperation::Difference);
    QVERIFY(nothing && nothing->loops.empty());
  }

  /// A crossing far flatter than the first chords is kept.
  void shallowLenses() {
    for (const double depth : {1e-2, 1e-4, 1e-6}) {
      const Region plate = rectangleRegion({-10, -10}, {10, 0}), disc = circleRegion(5, {0, 5 - depth});
      const auto cut = combined(std::array{plate, disc}, BooleanOperation::Difference);
      QVERIFY(cut);
      const double half = std::acos(1 - depth / 5), segment = 25 * (half - std::sin(half) * std::cos(half));
      COMPARE_NEAR(200 - area(*cut), segment, 1e-10);
      QCOMPARE(cut->loops.front().segments.size(), std::size_t{6});
    }
  }

  /// Between an arc and the chord of its first polygon, where the polygons tell the wrong side.
  void betweenArcAndChord() {
    const double turn = pi / 32;
    const Region disc = circleRegion(100), speck = circleRegion(0.1, {99.7 * std::cos(turn), 99.7 * std::sin(turn)});
    const Region bar = moved(rectangleRegion({90, -0.1}, {99.9, 0.1}), 1, turn, {0, 0});
    const Region plate{{rectanglePath({-200, -200}, {200, 200}), reversed(disc.loops.front())}};
    for (const Region& small : {speck, bar}) {
      checkExpected(disc, small, {area(disc), area(disc) - area(small), area(small)});
      checkExpected(plate, small, {area(plate) + area(small), area(plate), 0});
    }
  }

  /// Ends of segments that are a little apart are refused or joined, and nothing is thrown.
  void gapsInTheInput() {
    for (const double gap : {0.0, 1e-10, 2e-9, 1e-7, 1e-5}) {
      Path path;
      path.closed = true;
      path.segments = {Arc2{{0, 0}, 10, -1, 2}, Arc2{{10 * std::cos(1) + gap, 0}, 10 * std::sin(1), pi / 2, pi}};
      const auto both = combined(std::array{Region{{path}}, circleRegion(1, {8, 0})}, BooleanOperation::Intersection);
      if (both) COMPARE_NEAR(area(*both), pi, 1e-9);
      QVERIFY(both || gap > 1e-9);
    }
  }

  /// A corner hardly above the middle of a side, which is inside on both halves.
  void aCornerBesideTheMiddleOfASide() {
    const Vec2 centre(10 * std::sin(0.1), -10 * std::cos(0.1)), mirrored(-centre.x(), centre.y());
    const Arc2 right{centre, 10, pi / 2 + 0.1 - 2, 2}, left{mirrored, 10, pi / 2 - 0.1, 2};
    Path path;
    path.closed = true;
    path.segments = {right, left, Line2{endPoint(Segment(left)), startPoint(Segment(right))}};
    const Region a{{path}};
    for (const double below : {5e-9, 2e-9, 9e-9, 1e-7, 1e-6}) {
      const Region b = rectangleRegion({-1.2, -1}, {1.2, -below});
      const auto any = combined(std::array{a, b}, BooleanOperation::Union);
      if (any) COMPARE_NEAR(area(*any), area(a), 1e-7);
      const auto both = combined(std::array{a, b}, BooleanOperation::Intersection);
      if (both) COMPARE_NEAR(area(*both), area(b), 1e-7);
      QVERIFY(any || both || below < 1e-7);
    }
  }

  /// Circles that are one though their numbers are not.
  void circlesInCommon() {
    for (const double off : {0.0, 1e-13, 1e-11, 1e-10}) {
      const Region disc = circleRegion(1, {off, 0}), ring = ringRegion({0, 0}, 2, 1);
      checkExpected(ring, disc, {4 * pi, 3 * pi, 0});
    }
  }

  /// Of two lines that are one the longer one tells the direction.
  void aShortSideBendsNothing() {
    const Region a = polygonRegion({{0, 0}, {1e-6, 3e-10}, {10, 0}, {10, 10}, {0, 10}}), b = circleRegion(1, {0, 8});
    checkExpected(a, b, {100 + pi / 2, 100 - pi / 2, pi / 2});
  }

  /// Up to a thousand times the size; where flatter ones meet is for rounding to say.
  void largeArcs() {
    for (const double radius : {1e3, 8e3, 1e5, 1e6}) {
      const double half = std::asin(5 / radius), height = radius * std::cos(half);
      Path lid;
      lid.closed = true;
      lid.segments = {Line2{{-5, -1}, {5, -1}}, Line2{{5, -1}, {5, 0}}, Arc2{{0, -height}, radius, pi / 2 - half, 2 * half},
                      Line2{{-5, 0}, {-5, -1}}};
      const Region a{{lid}}, b = circleRegion(0.25, {0, -0.5});
      if (radius < 1e4)
        checkExpected(a, b, {area(a), area(a) - area(b), area(b)});
      else
        QVERIFY(!combined(std::array{a, b}, BooleanOperation::Union));
    }
  }

  void whatIsNotToldIsLeft() {
    QVERIFY(!combined(std::array{ellipseRegion(3, 2), circleRegion(1)}, BooleanOperation::Union));
    const Region bowTie = polygonRegion({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    QVERIFY(!combined(std::array{bowTie, circleRegion(1)}, BooleanOperation::Union));
  }

  void manyParts() {
    std::vector<Region> discs;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) discs.push_back(circleRegion(0.6, {i, j}));
    const auto all = combined(discs, BooleanOperation::Union);
    QVERIFY(all);
    const double lens = 2 * 0.36 * std::acos(0.5 / 0.6) - 0.5 * std::sqrt(4 * 0.36 - 1);
    COMPARE_NEAR(area(*all), 144 * 0.36 * pi - 2 * 12 * 11 * lens, 1e-9);
    QCOMPARE(all->loops.size(), std::size_t{1 + 11 * 11});
  }

  void onALattice() {
    Random random = seededRandom();
    int untold = 0;
    constexpr int pairs = 400;
    for (int i = 0; i < pairs; ++i) {
      const Region a = latticeRegion(random), b = latticeRegion(random);
      checkAreas(a, b, untold);
      checkMembers(random, a, b, {-4, -4}, {12, 12});
    }
    checkUntold(untold, 3 * pairs, 60);
  }

  /// The same turned, tiny and far away, both by one map.
  void turnedAndFarAway() {
    Random random = seededRandom();
    int untold = 0;
    constexpr int pairs = 200;
    for (int i = 0; i < pairs; ++i) {
      const double scale = std::pow(10, uniform(random, -3, 3)), angle = uniform(random, 0, 2 * pi);
      const Vec2 by = uniformInt(random, 0, 1) * scale * Vec2(uniform(random, -1e4, 1e4), uniform(random, -1e4, 1e4));
      checkAreas(moved(latticeRegion(random), scale, angle, by), moved(latticeRegion(random), scale, angle, by), untold);
    }
    checkUntold(untold, 3 * pairs, 30);
  }

  void roundedOutlines() {
    Random random = seededRandom();
    int untold = 0;
    constexpr int pairs = 200;
    for (int i = 0; i < pairs; ++i) {
      const Region a = anyRounded(random, 5);
      const Region b =
          moved(anyRounded(random, 5), 1, uniform(random, 0, 2 * pi), {uniform(random, -4, 4), uniform(random, -4, 4)});
      checkAreas(a, b, untold);
      checkMembers(random, a, b, {-12, -12}, {16, 16});
    }
    checkUntold(untold, 3 * pairs, 150);
  }
};

BLOSSOM_TEST(PlanarBooleanTest)
#include "planar_boolean_test.moc"
