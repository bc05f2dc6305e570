#include <cmath>
#include <numbers>

#include "geometry/planar/polygons/sound_region.h"
#include "minkowski/kernel/outline_sweep.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

Region ring(double outer, double inner) {
  Region region = circleRegion(outer);
  region.loops.push_back(reversed(circleRegion(inner).loops.front()));
  return region;
}

using Ring = std::vector<Vec2>;
std::vector<Ring> ringsOf(const Region& region) {
  std::vector<Ring> rings;
  for (const Path& loop : region.loops) {
    Ring& corners = rings.emplace_back();
    for (const Segment& segment : loop.segments) corners.push_back(startPoint(segment));
  }
  return rings;
}

bool contains(const std::vector<Ring>& rings, const Vec2& p) {
  bool odd = false;
  for (const Ring& corners : rings)
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if ((a.y() > p.y()) != (b.y() > p.y()) && (cross(b - a, p - a) > 0) == (b.y() > a.y())) odd = !odd;
    }
  return odd;
}

/// Whether B, moved so that -B lies at x, meets the boundary of A: sides that cross, or a corner of A's in x - B.
bool meetsBoundary(const std::vector<Ring>& a, const std::vector<Ring>& b, const Vec2& x) {
  std::vector<Ring> moved = b;
  for (Ring& corners : moved)
    for (Vec2& p : corners) p = x - p;
  const auto crossing = [](const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
    return (cross(q - p, r - p) > 0) != (cross(q - p, s - p) > 0) && (cross(s - r, p - r) > 0) != (cross(s - r, q - r) > 0);
  };
  for (const Ring& r : a)
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (contains(moved, r[i])) return true;
      for (const Ring& s : moved)
        for (std::size_t k = 0; k < s.size(); ++k)
          if (crossing(r[i], r[(i + 1) % r.size()], s[k], s[(k + 1) % s.size()])) return true;
    }
  return false;
}

bool linesAndArcs(const Region& region) {
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments)
      if (std::holds_alternative<Spline2>(segment)) return false;
  return true;
}

}  // namespace

/// What a shape covers while it runs along the boundary of another.
class MinkowskiOutlineTest : public QObject {
  Q_OBJECT
 private slots:
  void discAlongASquare() {
    const double s = 10, r = 1;
    const RegionSumResult swept = outlineSweep(rectangleRegion({0, 0}, {s, s}), circleRegion(r), Boundary::All);
    const double expected = s * s + 4 * s * r + pi * r * r - (s - 2 * r) * (s - 2 * r);
    QVERIFY(std::abs(area(swept.region) - expected) < 1e-12 * expected);
    QCOMPARE(swept.region.loops.size(), std::size_t(2));
    QCOMPARE(swept.region.loops[0].segments.size(), std::size_t(8));
    QVERIFY(linesAndArcs(swept.region));
    QCOMPARE(swept.sums, std::size_t(2));
  }

  void discAlongCircles() {
    const auto annulus = [](double radius, double r) {
      return pi * ((radius + r) * (radius + r) - (radius - r) * (radius - r));
    };
    const Region plate = ring(10, 4);
    QVERIFY(std::abs(area(outlineSweep(plate, circleRegion(1), Boundary::Outer).region) - annulus(10, 1)) < 1e-9);
    QVERIFY(std::abs(area(outlineSweep(plate, circleRegion(1), Boundary::Holes).region) - annulus(4, 1)) < 1e-9);
    QVERIFY(std::abs(area(outlineSweep(plate, circleRegion(1), Boundary::All).region) - annulus(10, 1) - annulus(4, 1)) <
            1e-9);
    // Wider than the web: nothing of it is left, only the middle of the hole.
    QVERIFY(std::abs(area(outlineSweep(plate, circleRegion(3.5), Boundary::All).region) - pi * (13.5 * 13.5 - 0.5 * 0.5)) <
            1e-9);
    // Wider than the hole: a disc.
    QVERIFY(std::abs(area(outlineSweep(plate, circleRegion(5), Boundary::Holes).region) - pi * 81) < 1e-9);
  }

  void loopsInOneAnotherAndParts() {
    const auto annulus = [](double radius, double r) { return 4 * pi * radius * r; };
    Region island = ring(10, 6);
    island.loops.push_back(circleRegion(2).loops.front());
    QVERIFY(std::abs(area(outlineSweep(island, circleRegion(1), Boundary::Outer).region) - annulus(10, 1) - annulus(2, 1)) <
            1e-9);
    QVERIFY(std::abs(area(outlineSweep(island, circleRegion(1), Boundary::All).region) - annulus(10, 1) - annulus(6, 1) -
                     annulus(2, 1)) < 1e-9);
    // Two discs make two rings of the same size that cross.
    Region two = circleRegion(1, {-3, 0});
    two.loops.push_back(circleRegion(1, {3, 0}).loops.front());
    const Region swept = outlineSweep(circleRegion(10), two, Boundary::All).region;
    const auto lens = [](double r, double s, double d) {  // of two discs
      const double x = (d * d + r * r - s * s) / (2 * d);
      return r * r * std::acos(x / r) + s * s * std::acos((d - x) / s) - d * std::sqrt(r * r - x * x);
    };
    const double common = lens(11, 11, 6) - 2 * lens(11, 9, 6) + lens(9, 9, 6);
    QVERIFY(std::abs(area(swept) - 2 * annulus(10, 1) + common) < 1e-9);
    QVERIFY(linesAndArcs(swept));
  }

  /// Membership decided without any sum, and shapes that are not symmetric.
  void pointsAreCoveredWhenTheMovedShapeMeetsTheBoundary() {
    Random random = seededRandom();
    for (int round = 0; round < 60; ++round) {
      const Region a = polygonRegion(spikyPoints(random, {0, 0}, 10, uniformInt(random, 3, 12)));
      Region b = polygonRegion(spikyPoints(random, {uniform(random, -2, 2), uniform(random, -2, 2)}, uniform(random, 0.3, 6),
                                           uniformInt(random, 3, 8)));
      if (round % 3 == 0) b.loops.push_back(polygonPath(spikyPoints(random, {15, 0}, uniform(random, 0.3, 4), 5)));
      const std::vector<Ring> swept = ringsOf(outlineSweep(a, b, Boundary::All).region), ringsA = ringsOf(a),
                              ringsB = ringsOf(b);
      for (int k = 0; k < 200; ++k) {
        const Vec2 x(uniform(random, -20, 35), uniform(random, -20, 20));
        QCOMPARE(contains(swept, x), meetsBoundary(ringsA, ringsB, x));
      }
    }
  }

  void roomsMayTouchInAPoint() {
    const Region steps = polygonRegion({{-1, -1}, {2, -1}, {2, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 2}, {-1, 2}});
    const Region square = rectangleRegion({-1, -1}, {1, 1});
    const double sum = area(minkowskiSum(std::vector{steps, square}).region);
    QVERIFY(std::abs(area(outlineSweep(steps, square, Boundary::All, {}).region) - (sum - 2)) < 1e-9);
  }
  void whatCannotBeFollowedIsRefused() {
    const auto messageOf = [](const Region& a, const Region& b, Boundary boundary) -> std::string {
      try {
        (void)outlineSweep(a, b, boundary);
      } catch (const Error& error) {
        return error.message();
      }
      return {};
    };
    QCOMPARE(messageOf(circleRegion(5), circleRegion(1), Boundary::Holes), std::string("Shape 1 has no holes to follow."));
  }
};

BLOSSOM_TEST(MinkowskiOutlineTest)
#include "minkowski_outline_test.moc"
