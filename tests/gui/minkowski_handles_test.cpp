#include <QApplication>

#include "minkowski/kernel/morph/control_centre.h"
#include "outline_bench.h"
#include "support/test_main.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

constexpr double ring = 4;  // mm: forty pixels, ten of which are a millimetre
const Vec2 second(100, 0);  // centre of the second control shape as drawn, 8 x 16

/// The extent of straight outlines.
Vec2 sizeOf(const Region& region) {
  Vec2 low(1e9, 1e9), high(-1e9, -1e9);
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) {
      low = low.cwiseMin(startPoint(segment));
      high = high.cwiseMax(startPoint(segment));
    }
  return high - low;
}

}  // namespace

/// Control shapes of a morph are moved, scaled and turned by their handles, and by numbers that are typed meanwhile. The
/// morph is looked at where it is its second control shape.
class MinkowskiHandlesTest : public OutlineFixture {
  Q_OBJECT
 private slots:
  void theNumberMoves();
  void theSquareScales();
  void theDotOnTheRingTurns();
  void handlesFollowTheShape();
  void aDragCanBeGivenUp();
  void aDoubleClickPutsBack();
  void numbersAreTyped();
  void numbersThatCannotBeAreRefused();
  void dotsComeBeforeTheRingsOfOthers();
  void whatWasWrittenStays();
  void anySequenceOfDragsEndsWhereItsNumbersSay();

 private:
  static FeatureId morphIn(Workbench&, const Vec2& place = second);
  static Value given(const Workbench& bench, const FeatureId& id, const char* name) {
    return bench.document().at(id).parameters.value(name, Value::array());
  }
};

FeatureId MinkowskiHandlesTest::morphIn(Workbench& bench, const Vec2& place) {
  const FeatureId a = bench.add("modeling.rectangle", {{"width", 20}, {"height", 10}});
  const FeatureId b = bench.add("modeling.rectangle", {{"width", 8}, {"height", 16}, {"centre", {place.x(), place.y(), 0}}});
  Feature morph{
      bench.document().freshId("morph"), "minkowski.morph", "Morph", {{"t", 1}}, {a, b}, true, false, Value::object()};
  const FeatureId id = morph.id;
  bench.commit(bench.document().with(std::move(morph)), {});
  return id;
}

void MinkowskiHandlesTest::theNumberMoves() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  const std::size_t before = bench.steps();
  drag(tool, second, {110.2, 20.1});
  QCOMPARE(given(bench, id, "offsets"), Value::parse("[[0.0,0.0,0.0],[10.0,20.0,0.0]]"));
  QCOMPARE(bench.steps(), before + 1);
  QVERIFY(given(bench, id, "scales").empty() && given(bench, id, "turns").empty());
}

void MinkowskiHandlesTest::theSquareScales() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  const std::size_t before = bench.steps();
  drag(tool, second + Vec2(ring, 0), second + Vec2(1.52 * ring, 0));
  QCOMPARE(given(bench, id, "scales"), Value::parse("[1.0,1.5]"));
  QCOMPARE(bench.steps(), before + 1);
  COMPARE_NEAR(area(bench.region(id)), 128 * 1.5 * 1.5, 1e-9);
  // The ring is where it was: once more as much.
  drag(tool, second + Vec2(ring, 0), second + Vec2(0, 2 * ring));
  QCOMPARE(given(bench, id, "scales"), Value::parse("[1.0,3.0]"));
  // Without steps, and never to nothing.
  const Vec2 from = second + Vec2(ring, 0), to = second + Vec2(0.777 * ring, 0);
  QVERIFY(tool.press(at(from.x(), from.y(), Qt::LeftButton)));
  tool.move(at(to.x(), to.y(), Qt::NoButton, Qt::ControlModifier));
  tool.release(at(to.x(), to.y(), Qt::LeftButton, Qt::ControlModifier));
  COMPARE_NEAR(given(bench, id, "scales").at(1).get<double>(), 3 * 0.777, 1e-9);
  drag(tool, from, second);
  QVERIFY(given(bench, id, "scales").at(1).get<double>() > 0);
}

void MinkowskiHandlesTest::theDotOnTheRingTurns() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  drag(tool, second + Vec2(0, ring), second + Vec2(-ring, 0.2));
  QCOMPARE(given(bench, id, "turns"), Value::parse("[0.0,90.0]"));
  QVERIFY(sizeOf(bench.region(id)) == Vec2(16, 8));
  // The dot has gone round with it. To the lower side is 90 more, and 180 is told as such.
  drag(tool, second + Vec2(-ring, 0), second + Vec2(0, -ring));
  QCOMPARE(given(bench, id, "turns"), Value::parse("[0.0,180.0]"));
  drag(tool, second + Vec2(0, -ring), second + Vec2(0, ring));
  QVERIFY(given(bench, id, "turns").empty());
  const double angle = 100.0 * std::numbers::pi / 180;  // ten degrees further, without steps
  const Vec2 to = second + ring * Vec2(std::cos(angle), std::sin(angle));
  QVERIFY(tool.press(at(second.x(), second.y() + ring, Qt::LeftButton)));
  tool.move(at(to.x(), to.y(), Qt::NoButton, Qt::ControlModifier));
  tool.release(at(to.x(), to.y(), Qt::LeftButton, Qt::ControlModifier));
  COMPARE_NEAR(given(bench, id, "turns").at(1).get<double>(), 10, 1e-9);
}

/// Scaled and turned about its centre, wherever that was moved.
void MinkowskiHandlesTest::handlesFollowTheShape() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  const Vec2 moved = second + Vec2(-30, 40);
  drag(tool, second, moved);
  drag(tool, moved + Vec2(0, ring), moved + Vec2(ring, 0));
  drag(tool, moved + Vec2(0, -ring), moved + Vec2(0, -2 * ring));  // the square, at -90 degrees
  QCOMPARE(given(bench, id, "turns"), Value::parse("[0.0,-90.0]"));
  QCOMPARE(given(bench, id, "scales"), Value::parse("[1.0,2.0]"));
  COMPARE_NEAR((minkowski::centreOf(bench.region(id)) - moved).norm(), 0, 1e-9);
  COMPARE_NEAR((sizeOf(bench.region(id)) - Vec2(32, 16)).norm(), 0, 1e-9);
  QVERIFY(!tool.move(at(second.x(), second.y())));
}

void MinkowskiHandlesTest::aDragCanBeGivenUp() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  const std::size_t before = bench.steps();
  for (const Vec2& grip : {Vec2(0, 0), Vec2(ring, 0), Vec2(0, ring)}) {
    const Vec2 from = second + grip;
    QVERIFY(tool.press(at(from.x(), from.y(), Qt::LeftButton)));
    tool.move(at(from.x() + 7, from.y() + 9));
    QVERIFY(bench.document().at(id).parameters.size() > 1);
    QVERIFY(key(tool, Qt::Key_Escape));
    QVERIFY(!tool.release(at(from.x() + 7, from.y() + 9, Qt::LeftButton)));
    QCOMPARE(bench.document().at(id).parameters.size(), std::size_t{1});
  }
  QCOMPARE(bench.steps(), before);
  // What is lit is what lies under the mouse now.
  QVERIFY(tool.press(at(second.x(), second.y(), Qt::LeftButton)));
  tool.move(at(second.x() + 300, second.y() + 300));
  QVERIFY(key(tool, Qt::Key_Escape));
  const QString left = tool.hint();
  tool.move(at(second.x() + 300, second.y() + 300));
  QCOMPARE(tool.hint(), left);
}

void MinkowskiHandlesTest::aDoubleClickPutsBack() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  const Vec2 moved = second + Vec2(20, 0);
  drag(tool, second, moved);
  drag(tool, moved + Vec2(ring, 0), moved + Vec2(2 * ring, 0));
  drag(tool, moved + Vec2(0, ring), moved + Vec2(-ring, 0));
  QVERIFY(tool.doubleClick(at(moved.x(), moved.y() + ring, Qt::LeftButton)));  // the square, on top now
  QVERIFY(given(bench, id, "scales").empty());
  QCOMPARE(given(bench, id, "turns"), Value::parse("[0.0,90.0]"));
  const std::size_t before = bench.steps();
  QVERIFY(tool.doubleClick(at(moved.x(), moved.y(), Qt::LeftButton)));
  for (const char* list : {"offsets", "scales", "turns"}) QVERIFY2(given(bench, id, list).empty(), list);
  QCOMPARE(bench.steps(), before + 1);
  QVERIFY(tool.doubleClick(at(second.x(), second.y(), Qt::LeftButton)));  // nothing to put back is no step
  QCOMPARE(bench.steps(), before + 1);
}

void MinkowskiHandlesTest::numbersAreTyped() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  const std::size_t before = bench.steps();
  QVERIFY(tool.press(at(second.x(), second.y(), Qt::LeftButton)));
  QVERIFY(!tool.entering());
  type(tool, "12.5,-1/2");
  QVERIFY(tool.entering());
  tool.move(at(150, 50));  // the mouse has nothing to say meanwhile
  QVERIFY(key(tool, Qt::Key_Return));
  QVERIFY(!tool.entering());
  QVERIFY(!tool.release(at(150, 50, Qt::LeftButton)));
  QCOMPARE(given(bench, id, "offsets"), Value::parse("[[0.0,0.0,0.0],[12.5,-0.5,0.0]]"));
  const Vec2 moved = second + Vec2(12.5, -0.5);
  QVERIFY(tool.press(at(moved.x() + ring, moved.y(), Qt::LeftButton)));
  type(tool, "1.25");
  QVERIFY(key(tool, Qt::Key_Return));
  QVERIFY(tool.press(at(moved.x(), moved.y() + ring, Qt::LeftButton)));
  type(tool, "-33");
  QVERIFY(key(tool, Qt::Key_Return));
  QCOMPARE(given(bench, id, "scales"), Value::parse("[1.0,1.25]"));
  QCOMPARE(given(bench, id, "turns"), Value::parse("[0.0,-33.0]"));
  QCOMPARE(bench.steps(), before + 3);
}

void MinkowskiHandlesTest::numbersThatCannotBeAreRefused() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  QVERIFY(tool.press(at(second.x() + ring, second.y(), Qt::LeftButton)));
  tool.move(at(second.x() + 2 * ring, second.y()));
  type(tool, "0");
  QVERIFY(key(tool, Qt::Key_Return));
  QVERIFY2(tool.hint().contains(QStringLiteral("scale must be above 0")), qPrintable(tool.hint()));
  QVERIFY(key(tool, Qt::Key_Escape));  // back to the mouse
  QCOMPARE(given(bench, id, "scales"), Value::parse("[1.0,2.0]"));
  type(tool, "3");
  tool.keysLost();
  QVERIFY(!tool.entering());
  QCOMPARE(given(bench, id, "scales"), Value::parse("[1.0,2.0]"));
  QVERIFY(key(tool, Qt::Key_Escape));
  QVERIFY(given(bench, id, "scales").empty());
}

void MinkowskiHandlesTest::dotsComeBeforeTheRingsOfOthers() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench, {ring, 0});  // its centre lies on the square of the first
  Tool& tool = bench.handles(id);
  click(tool, 0, 0);
  drag(tool, {ring, 0}, {ring + 10, 10});
  QCOMPARE(given(bench, id, "offsets"), Value::parse("[[0.0,0.0,0.0],[10.0,10.0,0.0]]"));
  drag(tool, {ring, 0}, {2 * ring, 0});
  QCOMPARE(given(bench, id, "scales"), Value::parse("[2.0]"));
}

void MinkowskiHandlesTest::whatWasWrittenStays() {
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Feature written = bench.document().at(id);
  written.parameters["offsets"] = Value::parse(R"([["2*5",0,0]])");
  bench.commit(bench.document().with(written), {});
  Tool& tool = bench.handles(id);
  drag(tool, second + Vec2(ring, 0), second + Vec2(2 * ring, 0));
  QCOMPARE(given(bench, id, "scales"), Value::parse("[1.0,2.0]"));
  QCOMPARE(given(bench, id, "offsets").at(0).at(0), Value("2*5"));
}

void MinkowskiHandlesTest::anySequenceOfDragsEndsWhereItsNumbersSay() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> place(-20, 20), size(0.2, 4), direction(-180, 180);
  std::uniform_int_distribution<int> grips(0, 2);
  Workbench bench(app_);
  const FeatureId id = morphIn(bench);
  Tool& tool = bench.handles(id);
  Vec2 centre = second;
  double scale = 1, turn = 0;
  for (int round = 0; round < 60; ++round) {
    const int grip = grips(random);
    const auto onRing = [&](double degrees, double times) -> Vec2 {
      const double angle = degrees * std::numbers::pi / 180;
      return centre + times * ring * Vec2(std::cos(angle), std::sin(angle));
    };
    if (grip == 0) drag(tool, centre, second + Vec2(place(random), place(random)));
    if (grip == 1) drag(tool, onRing(turn, 1), onRing(direction(random), size(random) / scale));
    if (grip == 2) drag(tool, onRing(turn + 90, 1), onRing(direction(random), size(random)));
    const Value offsets = given(bench, id, "offsets"), scales = given(bench, id, "scales"),
                turns = given(bench, id, "turns");
    const bool isMoved = offsets.size() > 1;
    centre = isMoved ? Vec2(second + Vec2(offsets[1][0].get<double>(), offsets[1][1].get<double>())) : second;
    scale = scales.size() > 1 ? scales[1].get<double>() : 1;
    turn = turns.size() > 1 ? turns[1].get<double>() : 0;
    COMPARE_NEAR(scale * 10, std::round(scale * 10), 1e-9);
    COMPARE_NEAR(turn / 15, std::round(turn / 15), 1e-9);
    const Region region = bench.region(id);
    COMPARE_NEAR(area(region), 128 * scale * scale, 1e-9 * area(region));
    COMPARE_NEAR((minkowski::centreOf(region) - centre).norm(), 0, 1e-9 * (1 + scale) * 100);
  }
}

BLOSSOM_TEST_RUN(MinkowskiHandlesTest, (&blossom::test::runTest<MinkowskiHandlesTest, QApplication>))
#include "minkowski_handles_test.moc"
