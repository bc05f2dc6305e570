// A side of a drawn outline gets another length, and what follows keeps its angles.
#include "modeling/kernel/outline/outline_sides.h"

#include <numbers>

#include "geometry/planar/planar.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::modeling;

namespace {

DrawnOutline drawnPolygon(const std::vector<Vec2>& corners, bool closed = true, bool returns = false) {
  DrawnOutline outline;
  outline.start = corners.front();
  for (std::size_t k = 1; k < corners.size(); ++k) outline.segments.push_back({DrawnKind::Line, corners[k], {}, false});
  if (returns) outline.segments.push_back({DrawnKind::Line, corners.front(), {}, false});
  outline.closed = closed;
  return outline;
}

std::vector<double> lengthsOf(const DrawnOutline& outline) {
  std::vector<double> lengths;
  for (const StraightSide& side : straightSides(outline)) lengths.push_back((side.to - side.from).norm());
  return lengths;
}

std::vector<double> anglesOf(const DrawnOutline& outline) {
  std::vector<double> angles;
  for (const StraightSide& side : straightSides(outline))
    angles.push_back(std::atan2(side.to.y() - side.from.y(), side.to.x() - side.from.x()));
  return angles;
}

}  // namespace

class OutlineSidesTest : public QObject {
  Q_OBJECT
 private slots:
  void aRectangleStaysOne();
  void rightAnglesOfAnyOutlineStay();
  void roundedCornersStay();
  void whereNothingIsParallelOneCornerMoves();
  void openOutlinesMoveTheirRest();
  void normalsPointOutward();
  void noDirtOfRounding();
  void whatCannotBe();
};

void OutlineSidesTest::aRectangleStaysOne() {
  std::mt19937_64 random = test::seededRandom();
  std::uniform_real_distribution<double> size(1, 100), angle(-3, 3);
  for (int round = 0; round < 200; ++round) {
    const double a = size(random), b = size(random), turn = angle(random), to = size(random);
    const Vec2 x(std::cos(turn), std::sin(turn)), y(-x.y(), x.x()), at(size(random), size(random));
    std::vector<Vec2> corners{at, at + a * x, at + a * x + b * y, at + b * y};
    if (round % 2 == 1) std::reverse(corners.begin(), corners.end());
    const DrawnOutline outline = drawnPolygon(corners, true, round % 3 == 0);
    QCOMPARE(straightSides(outline).size(), std::size_t(4));
    const int side = round % 4;
    const std::vector<double> before = lengthsOf(outline);
    const auto changed = withSideLength(outline, side, to);
    QVERIFY(changed.has_value());
    const std::vector<double> after = lengthsOf(*changed);
    for (int k = 0; k < 4; ++k) {
      const double wanted = k % 2 == side % 2 ? to : before[static_cast<std::size_t>(k)];
      COMPARE_NEAR(after[static_cast<std::size_t>(k)], wanted, 1e-9 * (wanted + 100));
    }
    COMPARE_NEAR(std::abs(area(Region{{toPath(*changed)}})), after[0] * after[1], 1e-7 * after[0] * after[1]);
  }
}

// Outlines of steps to the right and up, which come back: every side is level or upright, and stays so.
void OutlineSidesTest::rightAnglesOfAnyOutlineStay() {
  std::mt19937_64 random = test::seededRandom();
  std::uniform_real_distribution<double> step(5, 20);
  for (int round = 0; round < 100; ++round) {
    std::vector<Vec2> corners{{0, 0}};
    double x = 0, y = 0;
    for (int k = 0; k < 3; ++k) {
      corners.emplace_back(x += step(random), y);
      corners.emplace_back(x, y += step(random));
    }
    corners.emplace_back(0, y);
    const DrawnOutline outline = drawnPolygon(corners);
    const auto side = std::uniform_int_distribution<int>(0, static_cast<int>(corners.size()) - 1)(random);
    const double to = lengthsOf(outline)[static_cast<std::size_t>(side)] + 1.5;
    const auto changed = withSideLength(outline, side, to);
    QVERIFY(changed.has_value());
    COMPARE_NEAR(lengthsOf(*changed)[static_cast<std::size_t>(side)], to, 1e-9);
    const std::vector<double> before = anglesOf(outline), after = anglesOf(*changed);
    for (std::size_t k = 0; k < before.size(); ++k) COMPARE_NEAR(std::cos(before[k] - after[k]), 1, 1e-12);
  }
}

void OutlineSidesTest::roundedCornersStay() {
  // 40 x 20 with corners of radius 5, drawn as lines and tangent arcs.
  DrawnOutline outline;
  outline.start = {5, 0};
  const auto line = [&](double x, double y) { outline.segments.push_back({DrawnKind::Line, {x, y}, {}, false}); };
  const auto arc = [&](double x, double y) { outline.segments.push_back({DrawnKind::Arc, {x, y}, {}, true}); };
  line(35, 0), arc(40, 5), line(40, 15), arc(35, 20), line(5, 20), arc(0, 15), line(0, 5), arc(5, 0);
  outline.closed = true;
  const auto changed = withSideLength(outline, 0, 50);
  QVERIFY(changed.has_value());
  const double round = std::numbers::pi * 25;
  COMPARE_NEAR(area(Region{{toPath(*changed)}}), 60.0 * 20 - 100 + round, 1e-9);
  const auto higher = withSideLength(*changed, 2, 30);
  QVERIFY(higher.has_value());
  COMPARE_NEAR(area(Region{{toPath(*higher)}}), 60.0 * 40 - 100 + round, 1e-9);
}

void OutlineSidesTest::whereNothingIsParallelOneCornerMoves() {
  const DrawnOutline triangle = drawnPolygon({{0, 0}, {10, 0}, {3, 8}});
  const auto changed = withSideLength(triangle, 0, 14);
  QVERIFY(changed.has_value());
  QCOMPARE(changed->segments[0].to, Vec2(14, 0));
  QCOMPARE(changed->segments[1].to, Vec2(3, 8));
  QCOMPARE(changed->start, Vec2(0, 0));
  // The line that closes it moves the start.
  const auto closing = withSideLength(triangle, 2, 2 * std::hypot(3, 8));
  QVERIFY(closing.has_value());
  COMPARE_NEAR((closing->start - Vec2(-3, -8)).norm(), 0, 1e-12);
  QCOMPARE(closing->segments[0].to, Vec2(10, 0));
}

void OutlineSidesTest::openOutlinesMoveTheirRest() {
  const DrawnOutline path = drawnPolygon({{0, 0}, {10, 0}, {13, 8}, {20, 9}}, false);
  QCOMPARE(straightSides(path).size(), std::size_t(3));
  const auto changed = withSideLength(path, 0, 12);
  QVERIFY(changed.has_value());
  QCOMPARE(changed->segments[2].to, Vec2(22, 9));
  QCOMPARE(changed->segments[1].to, Vec2(15, 8));
}

void OutlineSidesTest::normalsPointOutward() {
  for (const bool reversed : {false, true}) {
    std::vector<Vec2> corners{{0, 0}, {10, 0}, {10, 5}, {0, 5}};
    if (reversed) std::reverse(corners.begin(), corners.end());
    for (const StraightSide& side : straightSides(drawnPolygon(corners)))
      QVERIFY(((side.from + side.to) / 2 + side.outward - Vec2(5, 2.5)).norm() >
              ((side.from + side.to) / 2 - Vec2(5, 2.5)).norm());
  }
}

// As drawn by 60<0, 40<90, 60<180: what is 1e-15 beside a whole number is one.
void OutlineSidesTest::noDirtOfRounding() {
  const double up = std::numbers::pi / 2;
  const std::vector<Vec2> corners{
      {0, 0}, {60, 0}, Vec2(60, 0) + 40 * Vec2(std::cos(up), std::sin(up)), {60 * std::cos(2 * up) + 60, 40.00000000000001}};
  const auto changed = withSideLength(drawnPolygon(corners), 2, 101);
  QVERIFY(changed.has_value());
  QCOMPARE(changed->start.x(), -41.0);
  QCOMPARE(changed->start.y(), 0.0);
  const std::vector<Vec2> wanted{{60, 0}, {60, 40}, {-41, 40}};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    QVERIFY(changed->segments[k].to.x() == wanted[k].x());
    QVERIFY(changed->segments[k].to.y() == wanted[k].y());
  }
  // Decimals stay those that were meant.
  const auto tenth = withSideLength(drawnPolygon({{0, 0}, {0.1, 0}, {0.1, 5}, {0, 5}}), 0, 0.1 + 0.2);
  QVERIFY(tenth && tenth->segments[0].to.x() == 0.3);
}

void OutlineSidesTest::whatCannotBe() {
  const DrawnOutline outline = drawnPolygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}});
  QVERIFY(!withSideLength(outline, 4, 3) && !withSideLength(outline, -1, 3));
  QVERIFY(!withSideLength(outline, 0, 0) && !withSideLength(outline, 0, -2));
  QCOMPARE(*withSideLength(outline, 0, 10), outline);
  DrawnOutline arc = outline;
  arc.segments[1] = {DrawnKind::Arc, {10, 5}, {{12, 2}}, false};
  QVERIFY(!withSideLength(arc, 1, 3));
  QCOMPARE(straightSides(arc).size(), std::size_t(3));
}

BLOSSOM_TEST(OutlineSidesTest)
#include "outline_sides_test.moc"
