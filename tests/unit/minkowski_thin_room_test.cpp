#include <set>

#include "geometry/planar/sums/set_operations.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;
using std::numbers::pi;

namespace {

SetSumResult keptDifference(const PlanarSet& a, const PlanarSet& b) {
  return setDifference(std::vector{a, b}, {.keepDegenerate = true});
}

double lengthOfAll(const std::vector<Path>& paths) {
  double sum = 0;
  for (const Path& path : paths) sum += length(path);
  return sum;
}

Region turnedBy(const Region& region, double angle, const Vec2& by) {
  Eigen::Matrix<double, 2, 3> map;
  map << std::cos(angle), -std::sin(angle), by.x(), std::sin(angle), std::cos(angle), by.y();
  Region image;
  for (const Path& loop : region.loops) image.loops.push_back(transformed(loop, map));
  return image;
}

/// The room of lattice squares: p + B in A holds alike on corners, open sides and open squares of the lattice, on a side
/// where it holds at both its ends, on a square where it holds at all corners.
struct LatticeRoom {
  int squares = 0, sidesAlone = 0, cornersAlone = 0;

  LatticeRoom(const Cells& a, const Cells& b) {
    std::set<std::pair<int, int>> at;
    for (int x = -8; x <= 8; ++x)
      for (int y = -8; y <= 8; ++y)
        if (std::all_of(b.begin(), b.end(), [&](const auto& c) { return a.contains({x + c.first, y + c.second}); }))
          at.insert({x, y});
    const auto side = [&](int x, int y, int dx, int dy) { return at.contains({x, y}) && at.contains({x + dx, y + dy}); };
    const auto square = [&](int x, int y) { return side(x, y, 1, 0) && side(x, y + 1, 1, 0); };
    for (const auto& [x, y] : at) {
      squares += square(x, y) ? 1 : 0;
      sidesAlone += side(x, y, 1, 0) && !square(x, y) && !square(x, y - 1) ? 1 : 0;
      sidesAlone += side(x, y, 0, 1) && !square(x, y) && !square(x - 1, y) ? 1 : 0;
      cornersAlone += !side(x, y, 1, 0) && !side(x, y, 0, 1) && !side(x - 1, y, 1, 0) && !side(x, y - 1, 0, 1) ? 1 : 0;
    }
  }
};

bool turnsLeft(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(Vec2(b - a), Vec2(c - a)) > 0; }

bool sidesCross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return turnsLeft(a, b, c) != turnsLeft(a, b, d) && turnsLeft(c, d, a) != turnsLeft(c, d, b);
}

bool liesWithin(const std::vector<Vec2>& outline, std::vector<Vec2> tool, const Vec2& at) {
  const Vec2 centre = (tool[0] + tool[1] + tool[2]) / 3;
  for (Vec2& p : tool) p = at + centre + (1 - 1e-6) * (p - centre);
  if (windingNumber(polygonPath(outline), tool.front()) == 0) return false;
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (std::size_t j = 0; j < tool.size(); ++j)
      if (sidesCross(outline[i], outline[(i + 1) % outline.size()], tool[j], tool[(j + 1) % tool.size()])) return false;
  return true;
}

/// 0 inside of the area.
double distanceToSet(const PlanarSet& set, const Vec2& p) {
  double nearest = INFINITY;
  int winding = 0;
  const auto toPath = [&](const Path& path) {
    for (const Segment& segment : path.segments) {
      const Vec2 from = startPoint(segment), along = endPoint(segment) - from;
      const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (from + t * along - p).norm());
    }
  };
  for (const Path& loop : set.area.loops) toPath(loop);
  for (const Path& curve : set.curves) toPath(curve);
  for (const Vec2& point : set.points) nearest = std::min(nearest, (point - p).norm());
  if (nearest < 1e-6) return nearest;
  for (const Path& loop : set.area.loops) winding += windingNumber(loop, p);
  return winding > 0 ? 0 : nearest;
}

}  // namespace

/// Room without width: where a shape fits exactly.
class MinkowskiThinRoomTest : public QObject {
  Q_OBJECT

 private slots:
  void aSquareFitsIntoItselfInOnePoint() {
    for (const Vec2& by : {Vec2(0, 0), Vec2(0.1, 0.7), Vec2(1e4, 3.3)}) {
      const Region square = rectangleRegion(by, by + Vec2(2, 2));
      const SetSumResult room = keptDifference({square}, {rectangleRegion({-1, -1}, {1, 1})});
      QVERIFY(room.set.area.loops.empty() && room.set.curves.empty() && room.warnings.empty());
      QCOMPARE(room.set.points.size(), std::size_t{1});
      COMPARE_NEAR((room.set.points.front() - by - Vec2(1, 1)).norm(), 0, 1e-11 + 1e-15 * by.norm());
      QVERIFY(setDifference(std::vector<PlanarSet>{{square}, {rectangleRegion({-1, -1}, {1, 1})}}).set.empty());
    }
    const Region triangle = polygonRegion({{0.3, 0.1}, {4, 1}, {2, 5.5}});
    QCOMPARE(keptDifference({triangle}, {triangle}).set.points.size(), std::size_t{1});
    const SetSumResult none = keptDifference({triangle}, {turnedBy(triangle, 0.1, {0, 0})});
    QVERIFY(none.set.empty() && none.warnings.size() == 1);
  }

  void aStripLeavesASegment() {
    Random random = seededRandom();
    for (int k = 0; k < 50; ++k) {
      const double width = uniform(random, 0.1, 3), length = width + uniform(random, 0.5, 9), turn = uniform(random, 0, 7);
      const Vec2 by(uniform(random, -20, 20), uniform(random, -20, 20));
      const double shorter = uniform(random, 0.1, length - 0.1);
      const SetSumResult room = keptDifference({turnedBy(rectangleRegion({0, 0}, {length, width}), turn, by)},
                                               {turnedBy(rectangleRegion({0, 0}, {shorter, width}), turn, {0, 0})});
      QVERIFY(room.set.area.loops.empty() && room.set.points.empty());
      QCOMPARE(room.set.curves.size(), std::size_t{1});
      COMPARE_NEAR(lengthOfAll(room.set.curves), length - shorter, 1e-8);  // turned sides are parallel but for rounding
      const Vec2 from = startPoint(room.set.curves.front()), to = endPoint(room.set.curves.front());
      const Vec2 end = by + (length - shorter) * Vec2(std::cos(turn), std::sin(turn));
      QVERIFY(std::min((from - by).norm() + (to - end).norm(), (to - by).norm() + (from - end).norm()) < 1e-8);
    }
  }

  /// Two chambers and a corridor just as wide as the tool.
  void aCorridorBetweenChambers() {
    const Region plan = polygonRegion(
        {{0, 0}, {10, 0}, {10, 4}, {20, 4}, {20, 0}, {30, 0}, {30, 10}, {20, 10}, {20, 6}, {10, 6}, {10, 10}, {0, 10}});
    const PlanarSet tool{rectangleRegion({-1, -1}, {1, 1})};
    const SetSumResult room = keptDifference({plan}, tool);
    COMPARE_NEAR(area(room.set.area), 2 * 64, 1e-9);
    QCOMPARE(room.set.curves.size(), std::size_t{1});
    COMPARE_NEAR(lengthOfAll(room.set.curves), 21 - 9, 1e-9);
    const SetSumResult opened = setOpening({plan}, tool, {.keepDegenerate = true});
    COMPARE_NEAR(area(opened.set.area), area(plan), 1e-7);
    COMPARE_NEAR(area(setOpening({plan}, tool).set.area), area(plan) - 20, 1e-7);
  }

  void latticeSquares() {
    Random random = seededRandom();
    int sides = 0, corners = 0;
    for (int k = 0; k < 150; ++k) {
      const Cells a = randomCells(random, 6, 6, uniform(random, 0.6, 0.95)), b = randomCells(random, 3, 2, 0.5);
      const LatticeRoom exact(a, b);
      const SetSumResult room = keptDifference({cellRegion(a)}, {cellRegion(b)});
      COMPARE_NEAR(area(room.set.area), exact.squares, 1e-8);
      COMPARE_NEAR(lengthOfAll(room.set.curves), exact.sidesAlone, 1e-9);
      QCOMPARE(static_cast<int>(room.set.points.size()), exact.cornersAlone);
      sides += exact.sidesAlone;
      corners += exact.cornersAlone;
    }
    QVERIFY(sides > 50 && corners > 20);
  }

  /// A convex shape cancels out: what it sweeps along a segment leaves it the segment.
  void sweptAlongASegmentAndBack() {
    Random random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const auto corner = [&](int reach) {
        return Vec2(uniformInt(random, -reach, reach), uniformInt(random, -reach, reach));
      };
      const Vec2 a = corner(9), b = corner(9), c = corner(9), from = corner(20), to = corner(20);
      if (std::abs(cross(Vec2(b - a), Vec2(c - a))) < 1 || from == to) continue;
      const bool left = cross(Vec2(b - a), Vec2(c - a)) > 0;
      const PlanarSet triangle{polygonRegion({a, left ? b : c, left ? c : b})};
      const PlanarSet segment{{}, {Path{{Line2{from, to}}, false, {}, {}}}};
      const SetSumResult swept = setSum(std::vector{triangle, segment});
      const SetSumResult room = keptDifference(swept.set, triangle);
      QVERIFY(room.set.area.loops.empty() && room.set.points.empty());
      QCOMPARE(room.set.curves.size(), std::size_t{1});
      const Vec2 start = startPoint(room.set.curves.front()), end = endPoint(room.set.curves.front());
      QVERIFY(std::min((start - from).norm() + (end - to).norm(), (start - to).norm() + (end - from).norm()) < 1e-9);
    }
  }

  /// p + B in A for all lattice points p, decided for a B made smaller by a millionth, which then touches nothing.
  void latticePolygons() {
    Random random = seededRandom();
    int inside = 0;
    for (int k = 0; k < 60; ++k) {
      std::vector<Vec2> outline = spikyPoints(random, {0, 0}, 14, uniformInt(random, 4, 9));
      for (Vec2& p : outline) p = p.array().round();
      std::vector<Vec2> tool{{0, 0}};
      tool.emplace_back(uniformInt(random, 1, 4), uniformInt(random, -2, 0));
      tool.emplace_back(uniformInt(random, -1, 2), uniformInt(random, 1, 4));
      SetSumResult room;
      try {
        room = keptDifference({polygonRegion(outline)}, {polygonRegion(tool)});
      } catch (const Error&) {
        continue;  // rounded, the outline crosses itself
      }
      for (int x = -14; x <= 14; ++x)
        for (int y = -14; y <= 14; ++y) {
          const bool fits = liesWithin(outline, tool, Vec2(x, y));
          inside += fits ? 1 : 0;
          QCOMPARE(distanceToSet(room.set, Vec2(x, y)) < 1e-6, fits);
        }
    }
    QVERIFY(inside > 500);
  }

  /// A slot of the width of a cutter: what its centre runs along.
  void aSlotForADisc() {
    Random random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const double r = uniform(random, 0.5, 3), length = 2 * r + uniform(random, 4, 20), turn = uniform(random, 0, 7);
      const PlanarSet slot{turnedBy(rectangleRegion({0, 0}, {length, 2 * r}), turn, {3, -4})};
      const SetSumResult room = keptDifference(slot, {circleRegion(r)});
      QCOMPARE(room.set.curves.size(), std::size_t{1});
      QCOMPARE(room.set.curves.front().segments.size(), std::size_t{1});
      COMPARE_NEAR(lengthOfAll(room.set.curves), length - 2 * r, 0.1);
      QVERIFY(!room.warnings.empty());
    }
  }

  /// The corners of a square and of a hexagon lie on circles, and so may points on their sides.
  void ringsOfStraightCorridors() {
    const auto ringOf = [](const std::vector<Vec2>& corners, double inner) {
      Region ring = polygonRegion(corners);
      std::vector<Vec2> hole;
      for (const Vec2& p : corners) hole.push_back(inner * p);
      ring.loops.push_back(reversed(polygonPath(hole)));
      return ring;
    };
    std::vector<Vec2> hexagon;
    for (int k = 0; k < 6; ++k) hexagon.push_back(10 * Vec2(std::cos(pi * k / 3), std::sin(pi * k / 3)));
    std::vector<Vec2> sixth;  // fits the corridor between hexagons of 10 and 6: one of 2
    for (const Vec2& p : hexagon) sixth.push_back(0.2 * p);
    const std::vector<Vec2> square{{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
    const std::pair<PlanarSet, PlanarSet> cases[] = {
        {{ringOf(square, 0.5)}, {rectangleRegion({-2.5, -2.5}, {2.5, 2.5})}},
        {{ringOf(hexagon, 0.6)}, {polygonRegion(sixth)}},
    };
    const double lengths[] = {4 * 15, 6 * 8};
    for (int k = 0; k < 2; ++k) {
      const auto& [ring, tool] = cases[k];
      const SetSumResult room = keptDifference(ring, tool);
      QVERIFY(room.set.area.loops.empty() && room.set.points.empty());
      QCOMPARE(room.set.curves.size(), std::size_t{1});
      const Path& curve = room.set.curves.front();
      QVERIFY(curve.closed);
      for (const Segment& segment : curve.segments) QVERIFY(std::holds_alternative<Line2>(segment));
      COMPARE_NEAR(length(curve), lengths[k], 1e-8);
      COMPARE_NEAR(area(setOpening(ring, tool, {.keepDegenerate = true}).set.area), area(ring.area), 1e-6);
    }
  }

  /// The disc has some width in the corners, and none along the sides between.
  void aSquareRingForADisc() {
    Region ring = rectangleRegion({0, 0}, {20, 20});
    ring.loops.push_back(reversed(rectanglePath({5, 5}, {15, 15})));
    const SetSumResult room = keptDifference({ring}, {circleRegion(2.5)});
    COMPARE_NEAR(area(room.set.area), (4 - pi) * 2.5 * 2.5, 0.05);
    QCOMPARE(room.set.curves.size(), std::size_t{4});
    COMPARE_NEAR(lengthOfAll(room.set.curves), 4 * 10, 1);
  }

  void aRingForADisc() {
    Region ring = circleRegion(12, {1, 2});
    ring.loops.push_back(reversed(circleRegion(8, {1, 2}).loops.front()));
    const SetSumResult room = keptDifference({ring}, {circleRegion(2)});
    QVERIFY(room.set.area.loops.empty());
    QCOMPARE(room.set.curves.size(), std::size_t{1});
    const auto* circle = std::get_if<Arc2>(&room.set.curves.front().segments.front());
    QVERIFY(circle && room.set.curves.front().closed);
    COMPARE_NEAR(circle->radius, 10, 0.05);
    COMPARE_NEAR((circle->center - Vec2(1, 2)).norm(), 0, 0.05);
  }

  void roomForASegmentAsLongAsTheShape() {
    const PlanarSet tool{{}, {Path{{Line2{{0, 0}, {6, 0}}}, false, {}, {}}}};
    const SetSumResult room = keptDifference({rectangleRegion({0, 0}, {6, 3})}, tool);
    QVERIFY(room.set.area.loops.empty());
    COMPARE_NEAR(lengthOfAll(room.set.curves), 3, 1e-8);
  }

  void wideRoomHasNoCurves() {
    Random random = seededRandom();
    for (int k = 0; k < 30; ++k) {
      const Region a = randomRegion(random, 10), b = randomRegion(random, 0.5);
      const SetSumResult kept = keptDifference({a}, {b});
      QVERIFY(kept.set.curves.empty() && kept.set.points.empty());
      COMPARE_NEAR(area(kept.set.area), area(setDifference(std::vector<PlanarSet>{{a}, {b}}).set.area), 0);
    }
  }

  void severalToolsAreRefused() {
    const PlanarSet square{rectangleRegion({0, 0}, {1, 1})};
    VERIFY_ERROR(setDifference(std::vector{square, square, square}, {.keepDegenerate = true}), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(MinkowskiThinRoomTest)
#include "minkowski_thin_room_test.moc"
