// Parts that lie against each other along curves, and what nearly fits into each other.
#include <fmt/format.h>

#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "geometry/planar/sums/set_operations.h"
#include "support/regions.h"
#include "support/segment_counts.h"
#include "support/support.h"

using namespace blossom;
using planar::soundRegion;
using namespace blossom::test;
using std::numbers::pi;

namespace {

/// Equal arcs one after the other, from one point to another one.
std::vector<Segment> arcsBetween(const Vec2& from, const Vec2& to, double sweep, int count) {
  const Arc2 whole = arcBetween(from, to, sweep);
  std::vector<Segment> arcs;
  for (int k = 0; k < count; ++k)
    arcs.emplace_back(Arc2{whole.center, whole.radius, whole.start + k * sweep / count, sweep / count});
  return arcs;
}

std::vector<Segment> splineBetween(const Vec2& from, const Vec2& to) {
  const Vec2 b = from + Vec2(4, 6), c = to - Vec2(5, 7);
  const auto pole = [](const Vec2& p) { return Vec3(p.x(), p.y(), 1); };
  return {Spline2{3, {0, 0, 0, 0, 1, 1, 1, 1}, {pole(from), pole(b), pole(c), pole(to)}}};
}

Spline2 splineThrough(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return {3, {0, 0, 0, 0, 1, 1, 1, 1}, {a.homogeneous(), b.homogeneous(), c.homogeneous(), d.homogeneous()}};
}

void addLines(Path& path, const std::vector<Vec2>& points) {
  for (std::size_t k = 1; k < points.size(); ++k) path.segments.emplace_back(Line2{points[k - 1], points[k]});
}

/// A square of 20 in two parts, on either side of curves from its lower to its upper edge.
Region dividedSquare(const Vec2& low, const Vec2& high, const std::vector<Segment>& up, const std::vector<Segment>& same) {
  Path left, right;
  left.closed = right.closed = true;
  addLines(left, {{0, 20}, {0, 0}, low});
  left.segments.insert(left.segments.end(), up.begin(), up.end());
  addLines(left, {high, {0, 20}});
  addLines(right, {low, {20, 0}, {20, 20}, high});
  for (auto each = same.rbegin(); each != same.rend(); ++each) right.segments.push_back(reversed(*each));
  return {{left, right}};
}

Region placed(const Region& region, double angle, const Vec2& by) {
  Eigen::Matrix<double, 2, 3> map;
  map << std::cos(angle), -std::sin(angle), by.x(), std::sin(angle), std::cos(angle), by.y();
  Region image = region;
  for (Path& loop : image.loops) loop = transformed(loop, map);
  return image;
}

Region opened(const Region& a, const Region& b) { return setOpening({a}, {b}).set.area; }

/// What a disc of 1 does to a square of 20.
void verifyIsSquare(const Region& parts, double within) {
  const Region disc = circleRegion(1);
  COMPARE_NEAR(area(minkowskiDifference(std::vector{parts, disc}).region), 324, within);
  COMPARE_NEAR(area(minkowskiSum(std::vector{parts, disc}).region), 480 + pi, within);
  const Region open = opened(parts, disc);
  COMPARE_NEAR(area(open), 396 + pi, within);
  QCOMPARE(open.loops.size(), std::size_t{1});
}

/// A ring whose hole, in arcs, is half filled by a part of its own.
Region halfFilledRing(int arcsOfHole) {
  Region region{{circleInArcs(20, 1), reversed(circleInArcs(15, arcsOfHole, Vec2::Zero(), 0.3)), {}}};
  region.loops.back().closed = true;
  region.loops.back().segments = {Arc2{Vec2::Zero(), 15, 0, pi}, Line2{{-15, 0}, {15, 0}}};
  return region;
}

}  // namespace

/// Both sides of a curve that two parts share are inside of the region.
class MinkowskiSharedTest : public QObject {
  Q_OBJECT

 private slots:
  void partsOnBothSidesOfArcs() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> place(4, 16), turn(-2, 2), any(-3, 3), far(-500, 500);
    for (int run = 0; run < 40; ++run) {
      const Vec2 low(place(random), 0), high(place(random), 20);
      double sweep = turn(random);
      if (std::abs(sweep) < 0.2) sweep = 0.2;
      const double height = (high - low).norm() / 2 * std::tan(std::abs(sweep) / 4);  // of the arc over its chord
      if (height > 3.5) continue;
      const Region parts =
          dividedSquare(low, high, arcsBetween(low, high, sweep, 1 + run % 3), arcsBetween(low, high, sweep, 1 + run % 2));
      verifyIsSquare(placed(parts, any(random), {far(random), far(random)}), 1e-8);
    }
  }

  /// Quarters of a ring share lines only, far from the origin with the last digits of their ends apart.
  void sectorsOfARing() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> far(-1e5, 1e5), any(-3, 3);
    const Region disc = circleRegion(0.25);
    for (int run = 0; run < 20; ++run) {
      const Vec2 centre(far(random), far(random));
      const double start = any(random);
      const auto at = [&](double radius, int quarter) {
        const double angle = start + quarter * pi / 2;
        return Vec2(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
      };
      Region sectors;
      for (int q = 0; q < 4; ++q) {
        Path& sector = sectors.loops.emplace_back();
        sector.closed = true;
        sector.segments = {Line2{at(2, q), at(3, q)}, Arc2{centre, 3, start + q * pi / 2, pi / 2},
                           Line2{at(3, q + 1), at(2, q + 1)}, Arc2{centre, 2, start + (q + 1) * pi / 2, -pi / 2}};
      }
      COMPARE_NEAR(area(minkowskiSum(std::vector{sectors, disc}).region), pi * (3.25 * 3.25 - 1.75 * 1.75), 1e-8);
      COMPARE_NEAR(area(minkowskiDifference(std::vector{sectors, disc}).region), pi * (2.75 * 2.75 - 2.25 * 2.25), 1e-8);
    }
  }

  void partsOnBothSidesOfASpline() {
    const Vec2 low(8, 0), high(12, 20);
    const Region parts = dividedSquare(low, high, splineBetween(low, high), splineBetween(low, high));
    verifyIsSquare(parts, 1e-9);
    verifyIsSquare(placed(parts, 0.4, {70, -30}), 1e-9);
    QVERIFY(minkowskiDifference(std::vector{parts, circleRegion(1)}).warnings.empty());
  }

  /// Files round corners and bulges, the shared ones not alike.
  void partsFromFilesOfSixDecimals() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> place(6, 14), turn(0.5, 1.5), error(-5e-7, 5e-7);
    for (int run = 0; run < 40; ++run) {
      const Vec2 low(place(random), 0), high(place(random), 20);
      const double sweep = (run % 2 == 0 ? 1 : -1) * turn(random);
      const auto rounded = [&](const Vec2& p) { return Vec2(p + Vec2(error(random), error(random))); };
      const Vec2 otherLow = rounded(low), otherHigh = rounded(high);
      Region parts = dividedSquare(low, high, arcsBetween(low, high, sweep, 1), {});
      Path& right = parts.loops[1];
      right.segments.clear();
      addLines(right, {otherLow, {20, 0}, {20, 20}, otherHigh});
      right.segments.push_back(reversed(arcsBetween(otherLow, otherHigh, sweep + 4 * error(random), 1).front()));
      const Region disc = circleRegion(1);
      const Region room = minkowskiDifference(std::vector{parts, disc}).region;
      QCOMPARE(room.loops.size(), std::size_t{1});
      COMPARE_NEAR(area(room), 324, 1e-4);
      COMPARE_NEAR(area(minkowskiSum(std::vector{parts, disc}).region), 480 + pi, 1e-4);
    }
  }

  /// The right part is of two, which share the spline's lower and upper half, higher in degree and otherwise parametrised.
  void partsOfASpline() {
    const Vec2 low(8, 0), high(12, 20);
    const Curve whole = toCurve(std::get<Spline2>(splineBetween(low, high).front()));
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 20; ++run) {
      const double t = std::uniform_real_distribution<double>(0.1, 0.9)(random);
      const BezierCurve halves = toBezier(insertKnots(whole, std::vector<double>{t}));
      const auto half = [&](std::size_t first) {
        Curve made{3, {0, 0, 0, 0, 5, 5, 5, 5}, {}};
        made.poles.assign(halves.poles.begin() + static_cast<std::ptrdiff_t>(first),
                          halves.poles.begin() + static_cast<std::ptrdiff_t>(first) + 4);
        return toSpline(elevateDegree(made, run % 3));
      };
      const Spline2 lower = half(0), upper = half(4);
      const Vec2 middle = endPoint(lower);
      Path left, under, over;
      left.closed = under.closed = over.closed = true;
      addLines(left, {{0, 20}, {0, 0}, low});
      left.segments.push_back(splineBetween(low, high).front());
      addLines(left, {high, {0, 20}});
      addLines(under, {low, {20, 0}, {20, 10}, middle});
      under.segments.push_back(reversed(lower));
      addLines(over, {middle, {20, 10}, {20, 20}, high});
      over.segments.push_back(reversed(upper));
      verifyIsSquare(placed({{left, under, over}}, run, {10.0 * run, 5}), 1e-8);
    }
  }

  /// One loop goes in along a curve and back.
  void slitsBoundNothing() {
    const Vec2 low(10, 0), tip(11, 12);
    for (const std::vector<Segment>& in : {arcsBetween(low, tip, 0.7, 1), splineBetween(low, tip)}) {
      Path outline;
      outline.closed = true;
      addLines(outline, {{0, 20}, {0, 0}, low});
      outline.segments.push_back(in.front());
      outline.segments.push_back(reversed(in.front()));
      addLines(outline, {low, {20, 0}, {20, 20}, {0, 20}});
      verifyIsSquare({{outline}}, 1e-9);
    }
  }

  /// A slot and the walls beside it, narrow beside the circle of a side that is nearly straight.
  void shallowArcsLeaveNarrowWalls() {
    for (const double bow : {0.0, 1e-2, 1e-4, 1e-6, 1e-8}) {
      Path outline;
      outline.closed = true;
      if (bow > 0)
        outline.segments = arcsBetween({0, 0}, {60, 0}, 8 * bow / 60, 1);
      else
        addLines(outline, {{0, 0}, {60, 0}});
      addLines(outline, {{60, 0}, {60, 0.1}, {5, 0.1}, {5, 0.2}, {60, 0.2}, {60, 0.3}, {0, 0.3}, {0, 0}});
      COMPARE_NEAR(area(soundRegion({{outline}}, {}, "a").region), 12.5 + 40 * bow, 1e-6);
      const double moved = area(minkowskiSum(std::vector{Region{{outline}}, rectangleRegion({0, 0}, {0.01, 0.01})}).region);
      COMPARE_NEAR(moved, 60.01 * 0.31 - 55 * 0.09 + 40.01 * bow, 1e-5);
    }
  }

  /// A part of free-form sides that fills a hole, but for a small hole of its own, which lies on the chord of a side.
  void aHoleOnTheChordOfAFreeSide() {
    const auto lens = [](double bow) {
      Path path;
      path.closed = true;
      path.segments = {splineThrough({-3, 0}, {-1, -bow}, {1, -bow}, {3, 0}),
                       splineThrough({3, 0}, {1, bow}, {-1, bow}, {-3, 0})};
      return path;
    };
    const Path island = lens(3);
    const Region parts{
        {rectanglePath({-5, -5}, {5, 5}), reversed(island), island, reversed(rectanglePath({-0.1, -0.1}, {0.1, 0.1}))}};
    COMPARE_NEAR(area(soundRegion(parts, {}, "a").region), 100 - 0.04, 1e-9);
  }

  /// A side that is nearly straight, on a circle of up to a hundred million kilometres.
  void circlesFarLargerThanTheShape() {
    for (double bow = 1e-3; bow > 1e-10; bow /= 10) {
      const double rounding = 1e-13 / bow;  // of places on such a circle
      const auto summed = [](const Segment& side) {
        Path notched;
        notched.closed = true;
        notched.segments = {side};
        addLines(notched, {{0, 0}, {4, 3}, {8, 0}, {8, 10}, {0, 10}});
        return area(minkowskiSum(std::vector{Region{{notched}}, circleRegion(1.7)}).region);
      };
      const double straight = summed(Line2{{0, 10}, {0, 0}});
      COMPARE_NEAR(summed(arcBetween({0, 10}, {0, 0}, 8 * bow / 10)), straight, 10 * bow + rounding + 1e-6);
      Path thin;
      thin.closed = true;
      thin.segments = {arcBetween({0, 0}, {1, 0}, 8e-3 * bow)};
      addLines(thin, {{1, 0}, {1, 1e-3}, {0, 1e-3}, {0, 0}});
      const SoundRegion sound = soundRegion({{thin}}, {}, "a");
      QCOMPARE(sound.region.loops.front().segments.size(), std::size_t{4});
      COMPARE_NEAR(area(sound.region), 1e-3 + 2e-3 / 3 * bow, rounding + 1e-9);
      const Path open{{arcBetween({0, 0}, {1, 0}, 8 * bow)}, false, {}, {}};
      QCOMPARE(planar::soundSet({{}, {open}, {}}, {}, "a").curves.size(), std::size_t{1});
    }
  }

  /// Convex outlines with sides that hardly bend, and discs one after the other: each sum can be summed again.
  void sumsOfConvexShallowSides() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 200; ++round) {
      const int corners = uniformInt(random, 3, 8);
      const double size = std::pow(10, uniform(random, -1, 2)), turn = uniform(random, 0, 6);
      Path outline;
      outline.closed = true;
      for (int k = 0; k < corners; ++k) {
        const auto corner = [&](int i) {
          const double angle = turn + 2 * pi * i / corners;
          return Vec2(size * std::cos(angle), size * std::sin(angle));
        };
        if (uniformInt(random, 0, 2) == 0)
          outline.segments.emplace_back(Line2{corner(k), corner(k + 1)});
        else
          outline.segments.emplace_back(arcBetween(corner(k), corner(k + 1), 4 * std::pow(10, uniform(random, -8, -1.2))));
      }
      const double first = size * uniform(random, 0.01, 1), second = size * uniform(random, 0.01, 1), both = first + second;
      const Region once = minkowskiSum(std::vector{Region{{outline}}, circleRegion(first)}).region;
      const Region twice = minkowskiSum(std::vector{once, circleRegion(second)}).region;
      const double expected = signedArea(outline) + both * length(outline) + pi * both * both;
      COMPARE_NEAR(area(twice), expected, 1e-6 * expected);
      for (const Segment& segment : once.loops.front().segments) QVERIFY(length(segment) > 1e-11 * size);
    }
  }

  /// The way to a hole and back goes; a hole that turns as its outline does is an overlap, as it was drawn.
  void waysToHoles() {
    for (const bool isHole : {true, false}) {
      const double half = isHole ? -pi : pi;
      Path outline;
      outline.closed = true;
      addLines(outline, {{0, 10}, {0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 10}, {6, 10}});
      outline.segments.emplace_back(Arc2{{10, 10}, 4, pi, half});
      outline.segments.emplace_back(Arc2{{10, 10}, 4, 0, half});
      addLines(outline, {{6, 10}, {0, 10}});
      const std::vector<Region> pair{Region{{outline}}, circleRegion(1)};
      if (isHole)
        COMPARE_NEAR(area(minkowskiDifference(pair).region), 324 - 25 * pi, 1e-9);
      else
        VERIFY_ERROR(minkowskiDifference(pair), ErrorCode::InvalidInput);
    }
  }

  void partsOfARing() {
    const Region disc = circleRegion(1);
    // Of the ring of 20 and 15: its outside shrinks, the half disc that is free grows.
    for (const int arcs : {1, 2, 4}) {
      const Region region = halfFilledRing(arcs);
      COMPARE_NEAR(area(minkowskiDifference(std::vector{region, disc}).region),
                   361 * pi - (225 * pi / 2 + 15 * pi + 30 + pi), 1e-9);
      // What is left free is the half disc of 14 below the line that the part's side is moved to.
      const double half = std::acos(1 / 14.0);
      COMPARE_NEAR(area(minkowskiSum(std::vector{region, disc}).region), 441 * pi - 196 * (half - std::sin(2 * half) / 2),
                   1e-9);
    }
  }

  // Chords of both circles meet: a ring that is hardly wider than the tolerance must not fall to pieces.
  void narrowRoomIsOneRing() {
    const Region ring{{circleInArcs(20, 1), reversed(circleInArcs(15, 1))}};
    for (const double radius : {2.4, 2.49, 2.4975, 2.4985, 2.499, 2.4995}) {
      const Region room = minkowskiDifference(std::vector{ring, circleRegion(radius)}).region;
      COMPARE_NEAR(area(room), 35 * pi * (5 - 2 * radius), 1e-9);
      QCOMPARE(room.loops.size(), std::size_t{2});
      QCOMPARE(segmentCountOf<Line2>(room), std::size_t{0});
    }
  }

  // A hole that nearly touches where the disc has to pass: the polygons of both meet there, the arcs do not.
  /// The ends of the room are rounder than the tolerance.
  void endsOfANarrowSlotAreRound() {
    for (const double width : {1e-6, 1e-5, 1e-4, 6e-4, 1e-3, 9e-3}) {
      const double radius = 1 + width / 2;
      Path slot;
      slot.closed = true;
      slot.segments = {Line2{{0, -radius}, {20, -radius}}, Arc2{{20, 0}, radius, -pi / 2, pi},
                       Line2{{20, radius}, {0, radius}}, Arc2{{0, 0}, radius, pi / 2, pi}};
      for (const double tolerance : {2e-4, 0.02}) {
        const Region room =
            minkowskiDifference(std::vector{Region{{slot}}, circleRegion(1)}, {.tolerance = tolerance}).region;
        COMPARE_NEAR(area(room), 20 * width + pi * width * width / 4, 1e-9);
      }
    }
  }

  /// The room is no shape of the user's.
  void anOpeningHardlyWiderThanItsElement() {
    const Region strip = polygonRegion({{0, 0}, {20, 0}, {20, 2 + 1e-8}, {0, 2 + 1e-8}});
    VERIFY_ERROR(opened(strip, circleRegion(1)), ErrorCode::Degenerate);
  }

  void roomNarrowInOnePlaceKeepsItsArcs() {
    for (const double gap : {0.0, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3}) {
      const Region ring{{circleInArcs(6, 1), reversed(circleInArcs(3, 1, {1 - gap, 0}))}};
      const Region room = minkowskiDifference(std::vector{ring, circleRegion(1)}).region;
      COMPARE_NEAR(area(room), 9 * pi, 1e-6);
      QVERIFY2(segmentCount(room) <= 20, qPrintable(QString::number(segmentCount(room))));
    }
  }

  // Far from the origin directions are known to some digits only; parallel sides leave no arcs between them.
  void convexShapesFarFromTheOrigin() {
    const auto rounded = [](double width, double height, double r) {
      return minkowskiSum(std::vector{rectangleRegion({0, 0}, {width - 2 * r, height - 2 * r}), circleRegion(r)}).region;
    };
    const Region wide = rounded(20, 10, 2), narrow = rounded(8, 6, 2);
    for (const double scale : {1.0, 1e-3})
      for (const double angle : {0.0, 0.7345, 2.1}) {
        const auto at = [&](const Region& region, const Vec2& by) {
          Region image = placed(region, angle, by);
          for (Path& loop : image.loops)
            loop = transformed(loop, (Eigen::Matrix<double, 2, 3>() << scale, 0, 0, 0, scale, 0).finished());
          return image;
        };
        const Region sum = minkowskiSum(std::vector{at(wide, {1e6, 2e6}), at(narrow, {-1e6, 1e6})}).region;
        QCOMPARE(segmentCountOf<Line2>(sum), std::size_t{4});
        QCOMPARE(segmentCountOf<Arc2>(sum), std::size_t{4});
        COMPARE_NEAR(area(sum) / (scale * scale), 28 * 16 - (4 - pi) * 16, 1e-6);  // corners of 4
      }
  }
};

BLOSSOM_TEST(MinkowskiSharedTest)
#include "minkowski_shared_test.moc"
