#include "geometry/planar/sums/convex_sum.h"
#include "geometry/planar/sums/curved_sum.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/sums/region_sum.h"
#include "geometry/planar/sums/set_operations.h"
#include "minkowski/kernel/morph/morph.h"
#include "support/curved_regions.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/segment_counts.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

std::vector<Vec2> convexCorners(Random& random, double reach) {
  const int n = uniformInt(random, 3, 9);
  std::vector<Vec2> corners;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * pi * (k + uniform(random, 0.1, 0.9)) / n;
    corners.push_back(reach * Vec2(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

int arcCountOf(const Region& region) { return static_cast<int>(segmentCountOf<Arc2>(region)); }

double wayAround(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += length(loop);
  return sum;
}

Region curvedSumOf(const Region& a, const Region& b, std::optional<double> tolerance = {}) {
  return minkowskiSum(std::vector<Region>{a, b}, {.tolerance = tolerance}).region;
}

Region moved(const Region& region, const Vec2& by, double turn) {
  Eigen::Matrix<double, 2, 3> map;
  map << std::cos(turn), -std::sin(turn), by.x(), std::sin(turn), std::cos(turn), by.y();
  Region image;
  for (const Path& loop : region.loops) image.loops.push_back(transformed(loop, map));
  return image;
}

}  // namespace

/// Lines and arcs stay lines and arcs.
class MinkowskiCurvesTest : public QObject {
  Q_OBJECT

 private slots:
  void sumsOfConvexShapesAreCancelled() {
    const CancelToken token;
    const Progress progress(token);
    const Region box = rectangleRegion({0, 0}, {2, 1}), disc = circleRegion(3);
    COMPARE_NEAR(area(convexSum(box, disc, progress)), 2 + 6 * 3 + 9 * std::numbers::pi, 1e-12);
    token.cancel();
    QVERIFY_THROWS_EXCEPTION(Error, (void)convexSum(box, disc, progress));
  }

  /// Files end circles of several arcs a rounding beside their beginning, and close them by a line.
  void aClosingLineWithoutLengthIsNoSide() {
    for (const double gap : {0.0, 1e-15, 5e-15, -5e-15, 1e-13}) {
      Region ring;
      for (const double radius : {20.0, -10.0}) {
        Path& loop = ring.loops.emplace_back();
        loop.closed = true;
        const double third = (radius > 0 ? 2 : -2) * pi / 3;
        for (int k = 0; k < 3; ++k) loop.segments.emplace_back(Arc2{{0, 0}, std::abs(radius), k * third, third});
        const Vec2 begin = startPoint(loop.segments.front());
        loop.segments.emplace_back(Line2{begin + Vec2(0, gap), begin});
      }
      const Region sum = minkowskiSum(std::vector{ring, circleRegion(2)}).region;
      COMPARE_NEAR(area(sum), pi * (22 * 22 - 8 * 8), 1e-9);
      for (const Path& loop : sum.loops) QCOMPARE(loop.segments.size(), std::size_t{1});
    }
  }

  void aSquareAndADisc() {
    Random random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      const double s = std::pow(10, uniform(random, -2, 2)), r = s * std::pow(10, uniform(random, -2, 2));
      const Region square = moved(rectangleRegion({0, 0}, {s, s}), {uniform(random, -s, s), 0}, uniform(random, 0, 7));
      const Region sum = curvedSumOf(square, circleRegion(r, {0, uniform(random, -r, r)}));
      const double exact = s * s + 4 * s * r + pi * r * r;
      COMPARE_NEAR(area(sum), exact, 1e-12 * exact);
      QCOMPARE(arcCountOf(sum), 4);
      QCOMPARE(segmentCount(sum), std::size_t{8});
      QVERIFY(largestGap(sum) <= 1e-13 * (s + r));
    }
  }

  void aTriangleBecomesACircle() {
    const Region triangle = polygonRegion({{-9, -7}, {11, -4}, {2, 13}});
    const double side = wayAround(triangle), r = 6;
    for (int k = 1; k <= 50; ++k) {
      const double t = k / 51.0;
      const Region between =
          morph(std::vector<Region>{triangle, circleRegion(r)}, std::vector<std::vector<double>>{{t}}).regions.front();
      QCOMPARE(arcCountOf(between), 3);
      QCOMPARE(segmentCount(between), std::size_t{6});
      const double exact = (1 - t) * (1 - t) * area(triangle) + (1 - t) * t * side * r + t * t * pi * r * r;
      COMPARE_NEAR(area(between), exact, 1e-12 * exact);
    }
  }

  /// Steiner's formula, and the same for rounded outlines, whose arcs are shorter by what rounding takes.
  void convexOutlinesAndDiscs() {
    Random random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      const std::vector<Vec2> corners = convexCorners(random, 10);
      const Region outline = k % 2 == 0 ? polygonRegion(corners) : Region{{roundedPath(corners, uniform(random, 0.1, 3))}};
      const double r = std::pow(10, uniform(random, -2, 2));
      const Region sum = curvedSumOf(outline, circleRegion(r, {3, -2}));
      const double exact = area(outline) + r * wayAround(outline) + pi * r * r;
      COMPARE_NEAR(area(sum), exact, 1e-11 * exact);
      COMPARE_NEAR(wayAround(sum), wayAround(outline) + 2 * pi * r, 1e-10 * wayAround(sum));
    }
  }

  /// The perimeters of convex sets add up, and A + A = 2 A.
  void roundedConvexOutlines() {
    Random random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      const Region a{{roundedPath(convexCorners(random, 10), uniform(random, 0.1, 4))}};
      const Region b{{roundedPath(convexCorners(random, 5), uniform(random, 0.1, 4))}};
      const Region sum = curvedSumOf(a, b);
      COMPARE_NEAR(wayAround(sum), wayAround(a) + wayAround(b), 1e-10 * wayAround(sum));
      QVERIFY(largestGap(sum) <= 1e-11);
      COMPARE_NEAR(area(curvedSumOf(a, a)), 4 * area(a), 1e-10 * area(a));
    }
  }

  /// The result is that of fine polygons within their tolerance, and but for specks that the coarser polygons miss it does
  /// not depend on how finely arcs are sampled.
  void anyRoundedOutlines() {
    Random random = seededRandom();
    int exact = 0;
    constexpr int pairs = 120;
    for (int k = 0; k < pairs; ++k) {
      const Region a = anyRounded(random, 10), b = anyRounded(random, std::pow(10, uniform(random, -1, 1)));
      const Region sum = curvedSumOf(a, b), finer = curvedSumOf(a, b, 3e-4);
      constexpr double fine = 1e-4;
      Effort unlimited;
      const Polygons polygons = planar::sum(flattened(a, {.tolerance = fine}, "a"), flattened(b, {.tolerance = fine}, "b"),
                                            Progress::none(), unlimited);
      QCOMPARE(sum.loops.size(), toRegion(polygons).loops.size());
      COMPARE_NEAR(area(sum), planar::area(polygons), 2 * fine * wayAround(sum));
      if (std::abs(area(sum) - area(finer)) <= 1e-10 * area(sum) && largestGap(sum) <= 1e-10) ++exact;
      // Few sides are left where only lines bound the sum.
      if (edgeCount(polygons) > 40) QVERIFY(arcCountOf(sum) > 0);
    }
    qInfo("%d of %d pairs to rounding", exact, pairs);
    QVERIFY(exact >= 0.9 * pairs);
  }

  /// A disc put on a convex outline and taken off again leaves it, but for specks within the tolerance that may be missed.
  void discsPutOnAndTakenOff() {
    Random random = seededRandom();
    int exact = 0;
    constexpr int times = 100;
    for (int k = 0; k < times; ++k) {
      const Region outline{{k % 2 == 0 ? polygonPath(convexCorners(random, 10))
                                       : roundedPath(convexCorners(random, 10), uniform(random, 0.1, 3))}};
      const Region disc = circleRegion(uniform(random, 0.1, 20)), grown = curvedSumOf(outline, disc);
      const double back = area(minkowskiDifference(std::vector<Region>{grown, disc}).region),
                   rounding = 1e-10 * area(outline);
      QVERIFY(back <= area(outline) + rounding);
      QVERIFY(back >= area(outline) - (defaultTolerance(grown) + defaultTolerance(disc)) * wayAround(outline));
      if (back >= area(outline) - rounding) ++exact;
    }
    QVERIFY(exact >= 0.9 * times);
  }

  /// A hole with a disc in it, whose room is a smaller disc; a slot; a rectangle.
  void roomOfDiscs() {
    Random random = seededRandom();
    for (int k = 0; k < 100; ++k) {
      const double r = std::pow(10, uniform(random, -3, 1)), wide = r * uniform(random, 1.1, 9),
                   high = r * uniform(random, 1.2, 9);
      const Region disc = circleRegion(r, {uniform(random, -3, 3), 1});
      const auto roomIn = [&](const Region& region) {
        return area(minkowskiDifference(std::vector<Region>{region, disc}).region);
      };
      COMPARE_NEAR(roomIn(circleRegion(wide)), pi * (wide - r) * (wide - r), 1e-10 * wide * wide);
      const double box = 4 * (wide - r) * (high - r);
      COMPARE_NEAR(roomIn(rectangleRegion({-wide, -high}, {wide, high})), box, 1e-10 * wide * high);
      const Region slot{
          {roundedPath({{-wide - high, -high}, {wide + high, -high}, {wide + high, high}, {-wide - high, high}}, high)}};
      COMPARE_NEAR(roomIn(slot), area(slot) - r * wayAround(slot) + pi * r * r, 1e-6 * area(slot));
      // A ring has no room for a disc wider than itself, and a ring of room for a smaller one.
      Region ring = circleRegion(wide + 3 * r);
      ring.loops.push_back(blossom::reversed(circleRegion(wide).loops.front()));
      COMPARE_NEAR(roomIn(ring), pi * ((wide + 2 * r) * (wide + 2 * r) - (wide + r) * (wide + r)), 1e-10 * wide * wide);
    }
  }

  /// The room is that in fine polygons on the safe side, within their tolerance.
  void anyRoom() {
    Random random = seededRandom();
    int rooms = 0;
    for (int k = 0; k < 120; ++k) {
      const Region a = anyRounded(random, 10), b = anyRounded(random, uniform(random, 0.1, 3));
      constexpr double fine = 1e-4;
      Effort unlimited;
      const auto polygonsOf = [&](const Region& region, Approximation side) {
        return flattened(region, {.tolerance = fine, .side = side}, "shape");
      };
      const Polygons safe = planar::difference(polygonsOf(a, Approximation::Inside), polygonsOf(b, Approximation::Outside),
                                               Progress::none(), unlimited);
      if (planar::area(safe) < 0.5) continue;
      ++rooms;
      const Region room = minkowskiDifference(std::vector<Region>{a, b}).region;
      QVERIFY(area(room) >= planar::area(safe) - 0.01 * wayAround(room));
      COMPARE_NEAR(area(room), planar::area(safe), 0.02 * wayAround(room));
      QVERIFY(largestGap(room) <= 0.05);
    }
    QVERIFY(rooms > 20);
  }

  /// Steiner's formula within the tolerance, by few smooth pieces.
  void ellipsesAndDiscs() {
    Random random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const double a = std::pow(10, uniform(random, -1, 2)), b = a * uniform(random, 0.2, 1),
                   r = a * uniform(random, 0.01, 2);
      const Region ellipse = ellipseRegion(a, b), sum = curvedSumOf(ellipse, circleRegion(r));
      const double tolerance = 2 * (defaultTolerance(ellipse) + defaultTolerance(circleRegion(r)));
      const double exact = area(ellipse) + r * wayAround(ellipse) + pi * r * r;
      COMPARE_NEAR(area(sum), exact, tolerance * wayAround(sum));
      QCOMPARE(segmentCount(sum), std::size_t{1});
      QVERIFY(std::get<Spline2>(sum.loops.front().segments.front()).poles.size() <= 200);
    }
  }

  /// Free-form outlines with hollows, with lines, arcs and each other: as fine polygons within the tolerance, and not of
  /// many more pieces than what they come from.
  void anyFreeOutlines() {
    Random random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const Region a = freeRegion(random, 10);
      const Region b = k % 3 == 0   ? freeRegion(random, 3)
                       : k % 3 == 1 ? circleRegion(uniform(random, 0.1, 6))
                                    : anyRounded(random, 3);
      const Region sum = curvedSumOf(a, b);
      constexpr double fine = 1e-4;
      Effort unlimited;
      const Polygons polygons = planar::sum(flattened(a, {.tolerance = fine}, "a"), flattened(b, {.tolerance = fine}, "b"),
                                            Progress::none(), unlimited);
      const double tolerance = 4 * (defaultTolerance(a) + defaultTolerance(b));
      COMPARE_NEAR(area(sum), planar::area(polygons), tolerance * wayAround(sum));
      QVERIFY(segmentCount(sum) <= 60);
      QVERIFY(largestGap(sum) <= tolerance);
    }
  }

  /// Two discs that touch, joined by lines to a point: convex but for the cusp between the discs.
  void aCuspIsNotConvex() {
    const double half = 3;  // from (0, -3) the discs about (+-1, 0) are touched at a distance of 3
    const Vec2 tip(0, -3);
    const auto touch = [&](double side) {  // of the tangent from the tip to the outer side of a disc
      const Vec2 centre(side, 0), to = centre - tip;
      const double angle = std::atan2(to.y(), to.x()) - side * std::asin(1 / to.norm());
      return Vec2(tip + half * Vec2(std::cos(angle), std::sin(angle)));
    };
    const Vec2 first = touch(1), last = touch(-1);
    const double start = std::atan2(first.y(), first.x() - 1), end = std::atan2(last.y(), last.x() + 1);
    Path heart;
    heart.closed = true;
    heart.segments = {Line2{tip, first}, Arc2{{1, 0}, 1, start, pi - start},
                      Arc2{{-1, 0}, 1, 0, end < 0 ? end + 2 * pi : end}, Line2{last, tip}};
    const Region disc = circleRegion(0.1), sum = curvedSumOf({{heart}}, disc);
    constexpr double fine = 1e-5;
    Effort unlimited;
    const Polygons polygons = planar::sum(flattened({{heart}}, {.tolerance = fine}, "heart"),
                                          flattened(disc, {.tolerance = fine}, "disc"), Progress::none(), unlimited);
    COMPARE_NEAR(area(sum), planar::area(polygons), 2 * fine * wayAround(sum));
  }

  /// A segment without a length in a hollow corner.
  void aPointInTheDrawingDoesNoHarm() {
    Region hollow = polygonRegion({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
    const double without = area(curvedSumOf(hollow, circleRegion(0.3)));
    auto& segments = hollow.loops.front().segments;
    segments.insert(segments.begin() + 3, Line2{{2, 1}, {2, 1}});
    COMPARE_NEAR(area(curvedSumOf(hollow, circleRegion(0.3))), without, 1e-12);
  }

  /// A side drawn in two lines, an arc that turns into a hollow one, and ends of arcs a rounding apart at the angle 0.
  void sidesAndArcsGoOnThroughStraightCorners() {
    const Region bent = polygonRegion({{0, 0}, {1.3, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}, {0, 1.7}});
    Region disc = circleRegion(0.5);
    std::get<Arc2>(disc.loops.front().segments.front()).start = 0.1;
    // Steiner's formula, but in the hollow corner two strips overlap in a square instead of being joined by a quarter.
    const double r = 0.5, exact = 12 + 16 * r + 5 * pi * r * r / 4 - r * r;
    COMPARE_NEAR(area(curvedSumOf(bent, disc)), exact, 1e-12);
    const Region coarse = curvedSumOf(bent, disc, 0.01), fine = curvedSumOf(bent, disc, 1e-4);
    COMPARE_NEAR(area(coarse), area(fine), 1e-12);
    QCOMPARE(segmentCount(coarse), std::size_t{11});

    Path fillets;
    fillets.closed = true;
    fillets.segments = {Line2{{0, 0}, {3, 0}},
                        Arc2{{3, 1}, 1, -pi / 2, pi / 2},
                        Line2{{4, 1}, {4, 2}},
                        Line2{{4, 2}, {2, 2}},
                        Line2{{2, 2}, {2, 3}},
                        Line2{{2, 3}, {2, 3}},
                        Arc2{{1, 3}, 1, -1e-17, pi / 2},
                        Line2{{1, 4}, {0, 4}},
                        Line2{{0, 4}, {0, 0}}};
    Region other = circleRegion(0.5);
    std::get<Arc2>(other.loops.front().segments.front()).start = 1;
    const Region grown = curvedSumOf({{fillets}}, other);
    COMPARE_NEAR(area(grown), area(curvedSumOf({{fillets}}, other, 2e-4)), 1e-12);
    QCOMPARE(arcCountOf(grown), 5);
  }

  /// A half-round bite in which the disc just does not fit, and just fits.
  void aHollowThatIsFilled() {
    for (const double less : {1e-2, 1e-6, 1e-7, 1e-9, 1e-11}) {
      const double bite = 1 - less;
      Path block;
      block.closed = true;
      block.segments = {Line2{{-4, 0}, {4, 0}},     Line2{{4, 0}, {4, 4}},      Line2{{4, 4}, {bite, 4}},
                        Arc2{{0, 4}, bite, 0, -pi}, Line2{{-bite, 4}, {-4, 4}}, Line2{{-4, 4}, {-4, 0}}};
      const Region sum = curvedSumOf({{block}}, circleRegion(1));
      QVERIFY2(arcCountOf(sum) == 6, qPrintable(QStringLiteral("%1 arcs at %2").arg(arcCountOf(sum)).arg(less)));
    }
  }

  /// Near the ends of a morph the other shape is smaller than any rounding.
  void theEndsOfAMorphAreCurved() {
    Random random = seededRandom();
    const std::vector<Region> shapes{{{roundedPath(spikyPoints(random, {0, 0}, 10, 8), 0.5)}},
                                     {{roundedPath(spikyPoints(random, {0, 0}, 6, 7), 0.3)}}};
    for (const double t : {1e-15, 1e-13, 1e-163, 1 - 1e-16, 1 - 1e-14}) {
      const Region between = morph(shapes, std::vector<std::vector<double>>{{t}}).regions.front();
      QVERIFY(arcCountOf(between) >= 7);
      COMPARE_NEAR(area(between), area(shapes[t < 0.5 ? 0 : 1]), 1e-9);
    }
  }

  /// The normals at the ends of one shape's arcs cut the other's, not its own.
  void manyFilletsAreNoBurden() {
    Random random = seededRandom();
    const Region many{{roundedPath(spikyPoints(random, {0, 0}, 50, 600), 0.02)}};
    const Region sum = curvedSumOf(many, circleRegion(1));
    QVERIFY(arcCountOf(sum) > 10);
    const Region some{{roundedPath(spikyPoints(random, {0, 0}, 20, 200), 0.02)}};
    QVERIFY(arcCountOf(curvedSumOf(many, some)) > 10);
  }

  /// A disc rounds the outer corners of a rectangle, the inner ones of a frame and the hollow one of an angle.
  void openingAndClosingRoundCorners() {
    const Region disc = circleRegion(2, {5, 7});  // where the disc lies makes no difference
    const double corner = (4 - pi) * 4 / 4;       // what a corner loses
    const Region angle = polygonRegion({{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}});
    const auto opening = [](const Region& a, const Region& b) { return setOpening({a}, {b}).set.area; };
    const auto closing = [](const Region& a, const Region& b) { return setClosing({a}, {b}).set.area; };
    const Region opened = opening(angle, disc), closed = closing(angle, disc);
    COMPARE_NEAR(area(opened), area(angle) - 5 * corner, 1e-10);
    COMPARE_NEAR(area(closed), area(angle) + corner, 1e-10);
    QCOMPARE(arcCountOf(opened), 5);
    QCOMPARE(arcCountOf(closed), 1);
    Region frame = rectangleRegion({0, 0}, {30, 30});
    frame.loops.push_back(blossom::reversed(rectanglePath({10, 10}, {20, 20})));
    COMPARE_NEAR(area(closing(frame, disc)), area(frame) + 4 * corner, 1e-10);
    // Both change nothing when they are done again.
    COMPARE_NEAR(area(opening(opened, disc)), area(opened), 1e-9);
    COMPARE_NEAR(area(closing(closed, disc)), area(closed), 1e-9);
  }

  /// What is left of the first difference may touch itself: two holes that have grown until they meet.
  void differencesOfWhatTouchesItself() {
    Effort unlimited;
    const auto hole = [](double x) { return blossom::reversed(circleRegion(2, {x, 0}).loops.front()); };
    const SoundRegion plate{{{rectanglePath({-20, -10}, {20, 10}), hole(-2), hole(2)}}, 1e-3};
    const SoundRegion disc{circleRegion(0.5), 1e-3};
    const SoundRegion room = difference(plate, disc, Progress::none(), unlimited);
    const double outside = 39 * 19, lens = 2 * (6.25 * std::acos(2 / 2.5) - 2 * 1.5);
    COMPARE_NEAR(area(room.region), outside - 2 * pi * 6.25 + lens, 0.05);
  }
};

BLOSSOM_TEST(MinkowskiCurvesTest)
#include "minkowski_curves_test.moc"
