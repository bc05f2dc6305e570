#include "geometry/planar/outline_crossing.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"
#include "modeling/kernel/outline/outline_drawn.h"
#include "modeling/kernel/outline/outline_edit.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::modeling;
using std::numbers::pi;

namespace {

DrawnSegment line(double x, double y) { return {DrawnKind::Line, {x, y}, {}, false}; }
DrawnSegment arc(const Vec2& via, const Vec2& to) { return {DrawnKind::Arc, to, {via}, false}; }
DrawnSegment tangent(double x, double y) { return {DrawnKind::Arc, {x, y}, {}, true}; }
DrawnSegment spline(std::vector<Vec2> through, const Vec2& to, bool smooth = false) {
  return {DrawnKind::Spline, to, std::move(through), smooth};
}

/// Do any two pieces of a polyline that do not follow each other cross? By the sides on which their ends lie.
bool crossesByBruteForce(const std::vector<Vec2>& p) {
  const std::size_t n = p.size();
  const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a) > 0; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Vec2 &a = p[i], &b = p[(i + 1) % n], &c = p[j], &d = p[(j + 1) % n];
      if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) return true;
    }
  return false;
}

DrawnOutline rounded() {
  return {{0, 0}, {line(40, 0), tangent(40, 20), line(0, 20), spline({{-8, 14}, {-4, 6}}, {0, 0})}, true};
}

}  // namespace

/// Drawn outlines: their exact curves, where they meet themselves, and their editing.
class ModelingDrawnTest : public QObject {
  Q_OBJECT
 private slots:
  void arcsPassTheirThreePoints();
  void tangentArcsLeaveInTheirDirection();
  void threePointsOnALine();
  void tangentsJoinSmoothly();
  void aRingIsSmoothAllRound();
  void whatIsNotDeterminedNamesItsSegment();
  void crossingsOfEverySort();
  void neighboursMayMeetInTheirJointOnly();
  void randomPolygonsAgainstBruteForce();
  void movingAPointKeepsTheShapeOfArcs();
  void movingTheStartOfAClosedOutline();
  void insertedPointsLeaveTheCurve();
  void removedPoints();
  void everyPointCanBeMovedAndRemoved();
};

void ModelingDrawnTest::arcsPassTheirThreePoints() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> place(-10, 10);
  for (int round = 0; round < 500; ++round) {
    const Vec2 a(place(random), place(random)), via(place(random), place(random)), b(place(random), place(random));
    if (std::abs(cross(via - a, b - a)) < 1e-2) continue;
    const auto segment = std::get<Arc2>(arcThrough(a, via, b));
    COMPARE_NEAR((startPoint(Segment(segment)) - a).norm(), 0, 1e-6);
    COMPARE_NEAR((endPoint(Segment(segment)) - b).norm(), 0, 1e-6);
    COMPARE_NEAR((via - segment.center).norm(), segment.radius, 1e-6 * segment.radius);
    // The point lies on the run of the arc, not on the rest of the circle.
    const Vec2 offset = via - segment.center;
    double turn = std::fmod((std::atan2(offset.y(), offset.x()) - segment.start) * (segment.sweep > 0 ? 1 : -1), 2 * pi);
    if (turn < 0) turn += 2 * pi;
    QVERIFY(turn < std::abs(segment.sweep));
  }
}

void ModelingDrawnTest::tangentArcsLeaveInTheirDirection() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> place(-10, 10);
  for (int round = 0; round < 500; ++round) {
    const Vec2 a(place(random), place(random)), b(place(random), place(random)), d(place(random), place(random));
    if (std::abs(cross(d, b - a)) < 1e-2) continue;
    const Segment made = tangentArc(a, d, b);
    COMPARE_NEAR((startPoint(made) - a).norm(), 0, 1e-6);
    COMPARE_NEAR((endPoint(made) - b).norm(), 0, 1e-6);
    COMPARE_NEAR((startDirection(made) - d.normalized()).norm(), 0, 1e-9);
  }
}

void ModelingDrawnTest::threePointsOnALine() {
  QVERIFY(std::holds_alternative<Line2>(arcThrough({0, 0}, {1, 1}, {3, 3})));
  VERIFY_ERROR(arcThrough({0, 0}, {5, 5}, {3, 3}), ErrorCode::Degenerate);
  QVERIFY(std::holds_alternative<Line2>(tangentArc({0, 0}, {1, 0}, {3, 0})));
  VERIFY_ERROR(tangentArc({0, 0}, {1, 0}, {-3, 0}), ErrorCode::Degenerate);
  COMPARE_NEAR(std::get<Arc2>(arcThrough({0, 0}, {4, 0}, {0, 0})).sweep, 2 * pi, 1e-12);
}

void ModelingDrawnTest::tangentsJoinSmoothly() {
  const Path path =
      toPath({{0, 0}, {line(40, 0), tangent(40, 20), spline({{20, 30}}, {0, 20}, true), tangent(-20, 0)}, false});
  for (std::size_t k = 0; k + 1 < path.segments.size(); ++k)
    COMPARE_NEAR((endDirection(path.segments[k]) - startDirection(path.segments[k + 1])).norm(), 0, 1e-9);
  COMPARE_NEAR(std::get<Arc2>(path.segments[1]).radius, 10, 1e-12);
}

void ModelingDrawnTest::aRingIsSmoothAllRound() {
  const DrawnOutline outline{{10, 0}, {spline({{0, 10}, {-10, 0}}, {0, -10})}, true};
  const Path ring = toPath(outline);
  QCOMPARE(ring.segments.size(), std::size_t{1});
  COMPARE_NEAR((startPoint(ring) - endPoint(ring)).norm(), 0, 1e-12);
  COMPARE_NEAR((startDirection(ring.segments[0]) - endDirection(ring.segments[0])).norm(), 0, 1e-9);
  QVERIFY(!selfCrossing(ring));
}

void ModelingDrawnTest::whatIsNotDeterminedNamesItsSegment() {
  const auto refused = [](const DrawnOutline& outline, const char* name) {
    try {
      toPath(outline);
    } catch (const Error& e) {
      return e.code() == ErrorCode::InvalidInput && e.message().find(name) != std::string::npos;
    }
    return false;
  };
  QVERIFY(refused({{0, 0}, {line(1, 0), line(1, 0)}, false}, "Segment 2"));
  QVERIFY(refused({{0, 0}, {tangent(1, 0)}, false}, "Segment 1"));
  QVERIFY(refused({{0, 0}, {line(1, 0), tangent(0, 0), line(3, 3)}, false}, "Segment 2"));
  QVERIFY(refused({{0, 0}, {line(1, 0), {DrawnKind::Arc, {2, 2}, {}, false}}, false}, "Segment 2"));
  VERIFY_ERROR(toPath({}), ErrorCode::InvalidInput);
}

void ModelingDrawnTest::crossingsOfEverySort() {
  const auto meets = [](const DrawnOutline& outline) { return selfCrossing(toPath(outline)); };
  QVERIFY(!meets(rounded()));
  // Lines through each other.
  const auto bow = meets({{0, 0}, {line(40, 0), line(0, 20), line(40, 20)}, true});
  QVERIFY(bow);
  COMPARE_NEAR((*bow - Vec2(20, 10)).norm(), 0, 1e-6);
  // A line through an arc, at a place known by Pythagoras.
  const auto cut = meets({{10, 0}, {arc({0, 10}, {-10, 0}), line(-20, 6), line(20, 6)}, false});
  QVERIFY(cut);
  COMPARE_NEAR(cut->norm(), 10, 1e-5);
  COMPARE_NEAR(cut->y(), 6, 1e-6);
  // A spline with a loop.
  QVERIFY(meets({{0, 0}, {spline({{20, 10}, {10, 20}, {0, 10}}, {20, 0})}, false}));
  // A corner that touches a side, and a line that runs back over another.
  QVERIFY(meets({{0, 0}, {line(40, 0), line(40, 20), line(20, 0), line(0, 20)}, true}));
  QVERIFY(meets({{0, 0}, {line(40, 0), line(20, 0), line(20, 20)}, true}));
  // An arc that touches a line from above.
  QVERIFY(meets({{-30, 0}, {line(30, 0), line(30, 10), line(10, 10), arc({0, 0}, {-10, 10})}, true}));
  QVERIFY(!meets({{-30, 0}, {line(30, 0), line(30, 10), line(10, 10), arc({0, 0.001}, {-10, 10})}, true}));
}

void ModelingDrawnTest::neighboursMayMeetInTheirJointOnly() {
  // A half circle closed by its diameter: two segments with both ends in common.
  QVERIFY(!selfCrossing(toPath({{10, 0}, {arc({0, 10}, {-10, 0})}, true})));
  QVERIFY(!selfCrossing(toPath({{10, 0}, {arc({0, 10}, {-10, 0}), arc({0, -10}, {10, 0})}, true})));
  // A line and an arc that leaves along it backwards touch in a cusp.
  QVERIFY(!selfCrossing(toPath({{0, 0}, {line(20, 0), arc({12, 4}, {10, 10})}, false})));
  // An arc that comes back through the line before it.
  QVERIFY(selfCrossing(toPath({{0, 0}, {line(20, 0), arc({15, 5}, {10, -3})}, false})));
}

void ModelingDrawnTest::randomPolygonsAgainstBruteForce() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> place(-10, 10);
  int crossed = 0;
  for (int round = 0; round < 600; ++round) {
    std::vector<Vec2> corners;
    for (int k = 0; k < 4 + round % 4; ++k) corners.emplace_back(place(random), place(random));
    Path path{{}, true, {}, {}};
    for (std::size_t k = 0; k < corners.size(); ++k)
      path.segments.emplace_back(Line2{corners[k], corners[(k + 1) % corners.size()]});
    const bool expected = crossesByBruteForce(corners);
    crossed += expected ? 1 : 0;
    QCOMPARE(selfCrossing(path).has_value(), expected);
  }
  QVERIFY(crossed > 50 && crossed < 590);
}

void ModelingDrawnTest::movingAPointKeepsTheShapeOfArcs() {
  const DrawnOutline before{{0, 0}, {line(20, 0), arc({30, 10}, {20, 20}), line(0, 20)}, true};
  const DrawnOutline after = moved(before, {1, -1, {20, 20}}, {20, 40});
  QCOMPARE(after.segments[1].to, Vec2(20, 40));
  // Half a circle it was, half a circle it is.
  COMPARE_NEAR(std::abs(std::get<Arc2>(segmentOf(after, 1)).sweep), pi, 1e-9);
  const DrawnOutline bent = moved(before, {1, 0, {30, 10}}, {22, 10});
  COMPARE_NEAR(std::abs(std::get<Arc2>(segmentOf(bent, 1)).radius), (100 + 4) / 4.0, 1e-9);  // (c^2 + h^2) / 2h
}

void ModelingDrawnTest::movingTheStartOfAClosedOutline() {
  const DrawnOutline after = moved(rounded(), {-1, -1, {0, 0}}, {-5, -5});
  QCOMPARE(after.start, Vec2(-5, -5));
  QCOMPARE(after.segments.back().to, after.start);
  QCOMPARE(handlesOf(after).size(), std::size_t{1 + 3 + 2});
}

void ModelingDrawnTest::insertedPointsLeaveTheCurve() {
  DrawnOutline outline{{0, 0}, {line(40, 0), arc({50, 10}, {40, 20}), tangent(20, 30), line(0, 20)}, true};
  const double before = signedArea(toPath(outline)), around = length(toPath(outline));
  for (const Vec2& near : {Vec2(11, 1), Vec2(49, 11), Vec2(31, 21), Vec2(-1, 10)}) {
    const auto place = nearestPlace(outline, near);
    QVERIFY(place);
    const std::size_t count = outline.segments.size();
    outline = withPointAt(outline, *place);
    QCOMPARE(outline.segments.size(), count + 1);
    COMPARE_NEAR(signedArea(toPath(outline)), before, 1e-7);
    COMPARE_NEAR(length(toPath(outline)), around, 1e-8);
  }
  // A spline gets a point on its way and passes it.
  const DrawnOutline curve{{0, 0}, {spline({{10, 10}, {20, 0}}, {30, 10})}, false};
  const auto place = nearestPlace(curve, {15, 6});
  const DrawnOutline more = withPointAt(curve, *place);
  QCOMPARE(more.segments[0].through.size(), std::size_t{3});
  QCOMPARE(more.segments[0].through[1], place->at);
}

void ModelingDrawnTest::removedPoints() {
  const DrawnOutline square{{0, 0}, {line(10, 0), line(10, 10), line(0, 10)}, true};
  const auto triangle = without(square, {1, -1, {10, 10}});
  QVERIFY(triangle);
  COMPARE_NEAR(signedArea(toPath(*triangle)), 50, 1e-12);
  const auto other = without(square, {-1, -1, {0, 0}});
  QVERIFY(other);
  QCOMPARE(other->start, Vec2(10, 0));
  const auto straight = without({{0, 0}, {line(10, 0), arc({15, 5}, {10, 10})}, true}, {1, 0, {15, 5}});
  QVERIFY(straight && straight->segments[1].kind == DrawnKind::Line);
  QVERIFY(!without({{0, 0}, {line(10, 0)}, false}, {0, -1, {10, 0}}));
}

void ModelingDrawnTest::everyPointCanBeMovedAndRemoved() {
  const DrawnOutline outline = rounded();
  for (const OutlineHandle& handle : handlesOf(outline)) {
    QVERIFY(!toPath(moved(outline, handle, handle.at + Vec2(0.7, -0.4))).segments.empty());
    const auto less = without(outline, handle);
    QVERIFY(less);
    QVERIFY(handlesOf(*less).size() < handlesOf(outline).size());
    QVERIFY(!toPath(*less).segments.empty());
  }
}

BLOSSOM_TEST(ModelingDrawnTest)
#include "modeling_drawn_test.moc"

#include <numbers>  // not first: moc stumbles over it
