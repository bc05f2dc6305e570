#include <QSignalSpy>

#include "outline_bench.h"
#include "support/test_main.h"

using namespace blossom;
using namespace blossom::ui;

/// Drawn outlines are edited by their points, the other ones by their handles.
class OutlineHandlesTest : public OutlineFixture {
  Q_OBJECT
 private slots:
  void pointsAreDraggedInsertedAndRemoved();
  void aDragGivenUpLeavesNothing();
  void aFeatureThatGoesEndsItsTool();
  void aChangeByOthersEndsTheDrag();
  void everyHandleMovesItsShape_data();
  void everyHandleMovesItsShape();
  void cornersOfARectangleLeaveTheOppositeOne();
  void handlesTakeOnlyWhatHappensOnThem();
};

void OutlineHandlesTest::pointsAreDraggedInsertedAndRemoved() {
  Workbench bench(app_);
  const FeatureId id = bench.add("modeling.outline", {{"segments", squarePoints()}});
  Tool& tool = bench.draw(id);
  drag(tool, {40, 40}, {60.3, 40.4});
  QCOMPARE(bench.steps(), std::size_t{2});
  QVERIFY(bench.previews > 0);
  COMPARE_NEAR(area(bench.region(id)), 2000, 1e-9);
  // A point on the side that closes the outline, dragged out.
  QVERIFY(tool.doubleClick(at(0.2, 20, Qt::LeftButton)));
  QCOMPARE(bench.region(id).loops[0].segments.size(), std::size_t{5});
  COMPARE_NEAR(area(bench.region(id)), 2000, 1e-9);
  drag(tool, {0, 20}, {-10, 20});
  COMPARE_NEAR(area(bench.region(id)), 2200, 1e-9);
  QVERIFY(key(tool, Qt::Key_Delete));  // the point dragged last
  COMPARE_NEAR(area(bench.region(id)), 2000, 1e-9);
  QCOMPARE(bench.steps(), std::size_t{5});
  for (int k = 0; k < 4; ++k) bench.undo();
  COMPARE_NEAR(area(bench.region(id)), 1600, 1e-9);
  const QSignalSpy finished(&tool, &Tool::finished);
  QVERIFY(key(tool, Qt::Key_Return));
  QCOMPARE(finished.count(), 1);
  QCOMPARE(bench.selection(), std::vector<FeatureId>{FeatureId()});  // else it would get its handles again
}

void OutlineHandlesTest::aDragGivenUpLeavesNothing() {
  Workbench bench(app_);
  const FeatureId id = bench.add("modeling.outline", {{"segments", squarePoints()}});
  Tool& tool = bench.draw(id);
  tool.press(at(40, 40, Qt::LeftButton));
  tool.move(at(70, 70));
  QVERIFY(area(bench.region(id)) > 1700);
  QVERIFY(key(tool, Qt::Key_Escape));
  COMPARE_NEAR(area(bench.region(id)), 1600, 1e-9);
  QVERIFY(!tool.release(at(70, 70, Qt::LeftButton)));
  tool.press(at(40, 40, Qt::LeftButton));
  tool.move(at(70, 70));
  tool.revert();
  COMPARE_NEAR(area(bench.region(id)), 1600, 1e-9);
  QCOMPARE(bench.steps(), std::size_t{1});
}

void OutlineHandlesTest::aFeatureThatGoesEndsItsTool() {
  Workbench bench(app_);
  const FeatureId id = bench.add("modeling.outline", {{"segments", squarePoints()}});
  Tool& tool = bench.draw(id);
  const QSignalSpy finished(&tool, &Tool::finished);
  bench.undo();
  QCOMPARE(finished.count(), 1);
}

void OutlineHandlesTest::aChangeByOthersEndsTheDrag() {
  Workbench bench(app_);
  const FeatureId id = bench.add("modeling.outline", {{"segments", squarePoints()}});
  Tool& tool = bench.draw(id);
  drag(tool, {40, 40}, {70, 70});
  QVERIFY(tool.press(at(70, 70, Qt::LeftButton)));
  tool.move(at(80, 80));
  bench.undo();  // the corner is back at (40, 40) while the mouse holds it
  COMPARE_NEAR(area(bench.region(id)), 1600, 1e-9);
  tool.move(at(90, 90));
  QVERIFY(!tool.release(at(90, 90, Qt::LeftButton)));  // what was undone does not come back
  COMPARE_NEAR(area(bench.region(id)), 1600, 1e-9);
  tool.move(at(70, 70));
  QVERIFY(!tool.press(at(70, 70, Qt::LeftButton)));
  drag(tool, {40, 40}, {50, 40});
  COMPARE_NEAR(area(bench.region(id)), 1800, 1e-9);

  const QSignalSpy finished(&tool, &Tool::finished);
  QVERIFY(tool.press(at(50, 40, Qt::LeftButton)));
  bench.undo();
  QCOMPARE(finished.count(), 0);
  bench.undo();
  QCOMPARE(finished.count(), 1);
}

void OutlineHandlesTest::everyHandleMovesItsShape_data() {
  QTest::addColumn<QString>("type");
  QTest::addColumn<QPointF>("handle");
  QTest::addColumn<QPointF>("to");
  QTest::addColumn<QString>("parameter");
  QTest::addColumn<double>("value");
  const QPointF centre(0, 0);
  for (const char* name : {"circle", "ellipse", "polygon", "star", "rectangle", "slot"})
    QTest::addRow("centre of %s", name) << name << centre << QPointF(50, 30) << "centre" << 50.0;
  QTest::newRow("point") << "point" << centre << QPointF(20, 10) << "at" << 20.0;
  QTest::newRow("text") << "text" << centre << QPointF(20, 10) << "at" << 20.0;
  QTest::newRow("circle") << "circle" << QPointF(10, 0) << QPointF(30, 0) << "radius" << 30.0;
  QTest::newRow("ellipse a") << "ellipse" << QPointF(20, 0) << QPointF(0, 30) << "rotation" << 90.0;
  QTest::newRow("ellipse b") << "ellipse" << QPointF(0, 10) << QPointF(3, 40) << "b" << 40.0;
  QTest::newRow("polygon") << "polygon" << QPointF(10, 0) << QPointF(20, 20) << "rotation" << 45.0;
  QTest::newRow("star outer") << "star" << QPointF(0, 20) << QPointF(0, 50) << "outer" << 50.0;
  QTest::newRow("rectangle") << "rectangle" << QPointF(20, 10) << QPointF(40, 30) << "width" << 60.0;
  QTest::newRow("slot end") << "slot" << QPointF(20, 0) << QPointF(40, 0) << "length" << 60.0;
  QTest::newRow("slot side") << "slot" << QPointF(0, 5) << QPointF(0, 10) << "width" << 20.0;
}

void OutlineHandlesTest::everyHandleMovesItsShape() {
  QFETCH(const QString, type);
  QFETCH(const QPointF, handle);
  QFETCH(const QPointF, to);
  QFETCH(const QString, parameter);
  Workbench bench(app_);
  const FeatureId id = bench.add(qPrintable("modeling." + type), Value::object());
  const double before = area(bench.region(id));
  Tool& tool = bench.handles(id);
  drag(tool, {handle.x(), handle.y()}, {to.x(), to.y()});
  QCOMPARE(bench.steps(), std::size_t{2});
  const Value changed = bench.document().at(id).parameters.at(parameter.toStdString());
  QFETCH(const double, value);
  COMPARE_NEAR(changed.is_array() ? changed.at(0).get<double>() : changed.get<double>(), value, 1e-6);
  QVERIFY(!bench.result(id)->error);
  bench.undo();
  COMPARE_NEAR(area(bench.region(id)), before, 1e-12);
}

void OutlineHandlesTest::cornersOfARectangleLeaveTheOppositeOne() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> angle(-180, 180), place(-30, 30);
  for (int round = 0; round < 50; ++round) {
    Workbench bench(app_);
    const FeatureId id = bench.add("modeling.rectangle", {{"rotation", angle(random)}});
    const Path before = bench.region(id).loops[0];
    const Vec2 grabbed = startPoint(before.segments[0]), opposite = startPoint(before.segments[2]);
    Tool& tool = bench.handles(id);
    const Vec2 to = grabbed + 0.3 * (grabbed - opposite) + Vec2(place(random), place(random)) / 30;
    tool.press(at(grabbed.x(), grabbed.y(), Qt::LeftButton));
    tool.move(at(to.x(), to.y(), Qt::NoButton, Qt::ControlModifier));
    tool.release(at(to.x(), to.y(), Qt::LeftButton));
    const Path after = bench.region(id).loops[0];
    COMPARE_NEAR((startPoint(after.segments[0]) - to).norm(), 0, 1e-9);
    COMPARE_NEAR((startPoint(after.segments[2]) - opposite).norm(), 0, 1e-9);
  }
}

void OutlineHandlesTest::handlesTakeOnlyWhatHappensOnThem() {
  Workbench bench(app_);
  const FeatureId id = bench.add("modeling.circle", Value::object());
  Tool& tool = bench.handles(id);
  QVERIFY(!tool.move(at(5, 5)));
  QVERIFY(!tool.press(at(5, 5, Qt::LeftButton)));
  QVERIFY(!tool.press(at(10, 0, Qt::MiddleButton)));
  QVERIFY(!key(tool, Qt::Key_Delete));
  QVERIFY(!key(tool, Qt::Key_Escape));
  QVERIFY(tool.move(at(10, 0)));
  // Pressed and let go without a move is no edit.
  QVERIFY(tool.press(at(10, 0, Qt::LeftButton)));
  QVERIFY(tool.release(at(10, 0, Qt::LeftButton)));
  QCOMPARE(bench.steps(), std::size_t{1});
}

BLOSSOM_TEST_RUN(OutlineHandlesTest, (&blossom::test::runTest<OutlineHandlesTest, QApplication>))
#include "outline_handles_test.moc"
