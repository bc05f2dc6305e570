#include <vtkProp.h>

#include <QSignalSpy>
#include <numbers>

#include "outline_bench.h"
#include "support/test_main.h"

using namespace blossom;
using namespace blossom::ui;
using std::numbers::pi;

/// Outlines are drawn.
class OutlineToolTest : public OutlineFixture {
  Q_OBJECT
 private slots:
  void drawnByClicksWithSnapping();
  void drawnByTypedLengths();
  void anArcByItsKey();
  void anOpenOutlineEndsWithEnter();
  void escapeLeavesNothing();
  void backspaceTakesBack();
  void undoAndRedoGoByPoints();
  void whatIsTypedStandsOnOneCard();
  void typedAnglesLeaveNoDirt();
  void snapsToOtherFeatures();
  void controlSwitchesSnappingOff();
  void closingAcrossItselfIsRefusedWithThePlace();
  void theHintAlwaysTellsWhatTheMouseWouldDo();
  void everyOutlineHasANameOfItsOwn();
};

void OutlineToolTest::drawnByClicksWithSnapping() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  const QSignalSpy finished(&tool, &Tool::finished);
  for (const auto& [x, y] :
       std::vector<std::pair<double, double>>{{0.4, -0.3}, {40.5, 0.4}, {39.7, 19.6}, {0.4, 20.3}, {0.5, 0.5}})
    click(tool, x, y);
  QCOMPARE(finished.count(), 1);
  QCOMPARE(bench.steps(), std::size_t{1});
  const FeatureId id = bench.selection().at(0);
  COMPARE_NEAR(area(bench.region(id)), 800, 1e-9);
  QCOMPARE(bench.region(id).loops[0].segments.size(), std::size_t{4});
}

void OutlineToolTest::drawnByTypedLengths() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  click(tool, 0, 0);
  tool.move(at(13, 0.4));
  type(tool, "32.5");
  QVERIFY(key(tool, Qt::Key_Return));
  type(tool, "2cm");
  QVERIFY(key(tool, Qt::Key_Tab));
  type(tool, "90");
  QVERIFY(key(tool, Qt::Key_Enter));
  type(tool, "@-32.5,0");
  QVERIFY(key(tool, Qt::Key_Return));
  QVERIFY(key(tool, Qt::Key_C, "c"));
  COMPARE_NEAR(area(bench.region(bench.selection().at(0))), 650, 1e-9);
}

void OutlineToolTest::anArcByItsKey() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  click(tool, 0, 0);
  click(tool, 40, 0);
  QVERIFY(key(tool, Qt::Key_A, "a"));
  click(tool, 40, 20);
  QVERIFY(key(tool, Qt::Key_L, "l"));
  click(tool, 0, 20);
  click(tool, 0, 0);
  COMPARE_NEAR(area(bench.region(bench.selection().at(0))), 800 + 50 * pi, 1e-9);
}

void OutlineToolTest::anOpenOutlineEndsWithEnter() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  const QSignalSpy finished(&tool, &Tool::finished);
  click(tool, 0, 0);
  click(tool, 30, 0);
  click(tool, 30, 40);
  QVERIFY(key(tool, Qt::Key_Return));
  QCOMPARE(finished.count(), 1);
  const auto* curves = bench.result(bench.selection().at(0))->evaluated.shape.get<Curves>();
  QVERIFY(curves);
  COMPARE_NEAR(length(curves->paths[0]), 70, 1e-12);
}

void OutlineToolTest::escapeLeavesNothing() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  click(tool, 0, 0);
  click(tool, 30, 0);
  type(tool, "25");
  QVERIFY(key(tool, Qt::Key_Escape));   // leaves the entry
  QVERIFY(!key(tool, Qt::Key_Escape));  // not taken: the workbench ends the tool
  tool.revert();
  QCOMPARE(bench.steps(), std::size_t{0});
}

void OutlineToolTest::backspaceTakesBack() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  click(tool, 0, 0);
  click(tool, 30, 0);
  click(tool, 77, 77);
  QVERIFY(key(tool, Qt::Key_Backspace));
  click(tool, 30, 40);
  QVERIFY(key(tool, Qt::Key_C, "c"));
  COMPARE_NEAR(area(bench.region(bench.selection().at(0))), 600, 1e-9);
}

void OutlineToolTest::undoAndRedoGoByPoints() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  const auto press = [&](int code, Qt::KeyboardModifiers modifiers) {
    return tool.key(QKeyEvent(QEvent::KeyPress, code, modifiers));
  };
  const auto undo = [&] { return press(Qt::Key_Z, Qt::ControlModifier); };
  QVERIFY(!undo() && tool.undoText().isEmpty());  // nothing yet: the document's last change is meant
  click(tool, 0, 0);
  click(tool, 30, 0);
  click(tool, 77, 77);
  QVERIFY(!press(Qt::Key_Y, Qt::ControlModifier) && tool.redoText().isEmpty());
  QVERIFY(undo());
  QVERIFY(undo());
  QVERIFY(!tool.redoText().isEmpty());
  QVERIFY(press(Qt::Key_Y, Qt::ControlModifier));  // (30, 0) again
  type(tool, "25");
  QVERIFY(undo());  // what is typed goes first
  tool.move(at(30, 40));
  click(tool, 30, 40);
  QVERIFY(tool.redoText().isEmpty());
  QVERIFY(undo());
  tool.redo();
  QVERIFY(key(tool, Qt::Key_C, "c"));
  COMPARE_NEAR(area(bench.region(bench.selection().at(0))), 600, 1e-9);
  QCOMPARE(bench.steps(), std::size_t{1});
  Tool& other = bench.draw();
  click(other, 0, 0);
  other.undo();
  QVERIFY(other.undoText().isEmpty());
  other.redo();
  QVERIFY(!other.undoText().isEmpty() && other.redoText().isEmpty());
}

// A second card with the length of a short segment would lie over what is typed.
void OutlineToolTest::whatIsTypedStandsOnOneCard() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  const auto cards = [&] {
    int count = 0;
    for (const auto& prop : tool.props()) count += prop->IsA("vtkTexturedActor2D");
    return count;
  };
  click(tool, 0, 0);
  tool.move(at(3, 0.2));
  QCOMPARE(cards(), 1);
  type(tool, "25<30");
  QCOMPARE(cards(), 1);
}

void OutlineToolTest::typedAnglesLeaveNoDirt() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  click(tool, 0, 0);
  for (const char* entry : {"60<0", "40<90", "60<180"}) {
    type(tool, entry);
    QVERIFY(key(tool, Qt::Key_Return));
  }
  QVERIFY(key(tool, Qt::Key_C, "c"));
  const Value& parameters = bench.document().at(bench.selection().at(0)).parameters;
  QCOMPARE(parameters.at("segments").at(1).at("to"), Value::array({60.0, 40.0, 0.0}));
  QCOMPARE(parameters.at("segments").at(2).at("to"), Value::array({0.0, 40.0, 0.0}));
}

void OutlineToolTest::snapsToOtherFeatures() {
  Workbench bench(app_);
  const FeatureId circle = bench.add("modeling.circle", {{"radius", 7}, {"centre", {33.3, 21.7, 0}}});
  Tool& tool = bench.draw();
  click(tool, 33.7, 21.3);  // the centre
  click(tool, 40.6, 21.2);  // the end of the arc
  click(tool, 0.4, 0.4);    // the origin
  QVERIFY(key(tool, Qt::Key_Return));
  const auto segments = bench.document().at(bench.selection().at(0)).parameters;
  COMPARE_NEAR(segments.at("start").at(0).get<double>(), 33.3, 1e-12);
  COMPARE_NEAR(segments.at("segments").at(0).at("to").at(0).get<double>(), 40.3, 1e-9);
  COMPARE_NEAR(segments.at("segments").at(1).at("to").at(0).get<double>(), 0, 1e-12);
  QVERIFY(bench.document().contains(circle));
}

void OutlineToolTest::controlSwitchesSnappingOff() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  click(tool, 0.4, 0.3, Qt::ControlModifier);
  click(tool, 30.2, 0.4, Qt::ControlModifier);
  QVERIFY(key(tool, Qt::Key_Return));
  const auto drawn = bench.document().at(bench.selection().at(0)).parameters;
  QCOMPARE(drawn.at("start").at(0).get<double>(), 0.4);
  QCOMPARE(drawn.at("segments").at(0).at("to").at(0).get<double>(), 30.2);
}

void OutlineToolTest::closingAcrossItselfIsRefusedWithThePlace() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{{0, 0}, {40, 0}, {0, 20}, {40, 20}, {0, 0}})
    click(tool, x, y);
  QCOMPARE(bench.steps(), std::size_t{0});
  QVERIFY2(tool.hint().contains(QStringLiteral("(20, 10)")), qPrintable(tool.hint()));
  // It goes on: the last point is taken back and set elsewhere.
  QVERIFY(key(tool, Qt::Key_Backspace));
  click(tool, -20, 20);
  click(tool, 0, 0);
  QCOMPARE(bench.steps(), std::size_t{1});
}

void OutlineToolTest::theHintAlwaysTellsWhatTheMouseWouldDo() {
  Workbench bench(app_);
  Tool& tool = bench.draw();
  QStringList hints{tool.hint()};
  click(tool, 0, 0);
  hints << tool.hint();
  key(tool, Qt::Key_A, "a");
  hints << tool.hint();
  click(tool, 20, 0);
  hints << tool.hint();
  key(tool, Qt::Key_S, "s");
  hints << tool.hint();
  type(tool, "2");
  hints << tool.hint();
  QCOMPARE(QSet<QString>(hints.begin(), hints.end()).size(), hints.size());
  for (const QString& hint : hints) QVERIFY(!hint.isEmpty());
  QVERIFY(!tool.props().empty());
}

void OutlineToolTest::everyOutlineHasANameOfItsOwn() {
  Workbench bench(app_);
  const auto drawn = [&] {
    Tool& tool = bench.draw();
    for (const Vec2& p : {Vec2(0, 0), Vec2(40, 0), Vec2(0, 30), Vec2(0, 0)}) click(tool, p.x(), p.y());
    return bench.document().at(bench.selection().at(0)).name;
  };
  QCOMPARE(drawn(), std::string("Outline"));
  QCOMPARE(drawn(), std::string("Outline 2"));
  Feature renamed = bench.document().at(bench.selection().at(0));
  renamed.name = "Lid";
  bench.commit(bench.document().with(renamed), {});
  QCOMPARE(drawn(), std::string("Outline 2"));
  bench.undo();
  QCOMPARE(drawn(), std::string("Outline 2"));
  QCOMPARE(drawn(), std::string("Outline 3"));
  QCOMPARE(bench.document().features()[1]->name, std::string("Lid"));
}

BLOSSOM_TEST_RUN(OutlineToolTest, (&blossom::test::runTest<OutlineToolTest, QApplication>))
#include "outline_tool_test.moc"
