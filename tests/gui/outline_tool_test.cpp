#include <vtkProp.h>

#include <QKeyEvent>
#include <QSignalSpy>
#include <numbers>

#include "app/app.h"
#include "geometry/planar/planar.h"
#include "support/support.h"
#include "ui/plugin/tool.h"
#include "ui/window/manipulator_loader.h"

using namespace blossom;
using namespace blossom::ui;
using std::numbers::pi;

namespace {

/// A workbench without a window that evaluates at once and tells its tool of every change.
class Workbench : public ToolHost {
 public:
  explicit Workbench(const App& app) : app_(app), evaluator_(app.registry) {
    QVERIFY(loadManipulators(tools_, app.plugins).empty());
  }

  [[nodiscard]] const Document& document() const override { return shown_ ? *shown_ : documents_.back(); }
  [[nodiscard]] std::shared_ptr<const FeatureResult> result(const FeatureId& id) const override {
    const auto it = results_.find(id);
    return it == results_.end() ? nullptr : it->second;
  }
  [[nodiscard]] const Registry& registry() const override { return *app_.registry; }
  [[nodiscard]] const Look& look() const override { return look_; }
  [[nodiscard]] double gridSpacing() const override { return 10; }
  [[nodiscard]] std::vector<FeatureId> selection() const override { return selected_; }
  void select(const FeatureId& id) override { selected_ = {id}; }
  void preview(Document document) override {
    shown_ = std::move(document);
    ++previews;
    changed();
  }
  void endPreview() override {
    shown_.reset();
    changed();
  }
  void commit(Document document, const QString&) override {
    shown_.reset();
    documents_.push_back(std::move(document));
    changed();
  }

  /// One step back, as the user takes it.
  void undo() {
    shown_.reset();
    documents_.pop_back();
    changed();
  }
  FeatureId add(const char* type, const Value& parameters) {
    Feature feature{document().freshId("outline"), type, "Outline", {}, {}, true, false, Value::object()};
    feature.parameters = completed(registry().at(type)->parameters, parameters);
    const FeatureId id = feature.id;
    commit(document().with(std::move(feature)), {});
    return id;
  }
  Tool& start(const MakeTool& make, const FeatureId& id = {}) {
    tool = make(*this, id);
    QObject::connect(tool.get(), &Tool::changed, tool.get(), [this] { (void)tool->props(); });
    return *tool;
  }
  Tool& draw(const FeatureId& id = {}) { return start(tools_.toolFor("modeling.outline")->make, id); }
  Tool& handles(const FeatureId& id) { return start(*tools_.handles(document().at(id).type), id); }

  [[nodiscard]] std::size_t steps() const { return documents_.size() - 1; }
  [[nodiscard]] Region region(const FeatureId& id) const {
    const auto found = result(id);
    const Region* value = found ? found->evaluated.shape.get<Region>() : nullptr;
    return value ? *value : Region();
  }

  std::unique_ptr<Tool> tool;
  int previews = 0;

 private:
  void changed() {
    results_ = evaluator_.evaluate(document(), Progress::none());
    if (tool) tool->documentChanged();
  }
  const App& app_;
  ManipulatorRegistry tools_;
  Evaluator evaluator_;
  std::vector<Document> documents_{Document()};
  std::optional<Document> shown_;
  Results results_;
  std::vector<FeatureId> selected_;
  Look look_ = Look::dark();
};

/// Looked at from above at ten pixels a millimetre.
ToolEvent at(double x, double y, Qt::MouseButton button = Qt::NoButton, Qt::KeyboardModifiers modifiers = {}) {
  ToolEvent event;
  event.ray = {{x, y, 100}, {0, 0, -1}};
  event.button = button;
  event.modifiers = modifiers;
  event.millimetresPerPixel = 0.1;
  return event;
}

void click(Tool& tool, double x, double y, Qt::KeyboardModifiers modifiers = {}) {
  tool.move(at(x, y, Qt::NoButton, modifiers));
  QVERIFY(tool.press(at(x, y, Qt::LeftButton, modifiers)));
  tool.release(at(x, y, Qt::LeftButton, modifiers));
}

void drag(Tool& tool, const Vec2& from, const Vec2& to) {
  tool.move(at(from.x(), from.y()));
  QVERIFY(tool.press(at(from.x(), from.y(), Qt::LeftButton)));
  for (int k = 1; k <= 4; ++k) {
    const Vec2 p = from + (to - from) * k / 4;
    QVERIFY(tool.move(at(p.x(), p.y(), Qt::NoButton)));
  }
  QVERIFY(tool.release(at(to.x(), to.y(), Qt::LeftButton)));
}

bool key(Tool& tool, int code, const QString& text = {}) {
  return tool.key(QKeyEvent(QEvent::KeyPress, code, Qt::NoModifier, text));
}

void type(Tool& tool, const char* text) {
  for (; *text; ++text) QVERIFY(key(tool, QChar::fromLatin1(*text).toUpper().unicode(), QString(QChar::fromLatin1(*text))));
}

Value squarePoints() { return {{{"to", {40, 0, 0}}}, {{"to", {40, 40, 0}}}, {{"to", {0, 40, 0}}}}; }

}  // namespace

/// The drawing tool and the handles of outlines, as the module of the plugin gives them, driven by mouse and key events.
class OutlineToolTest : public QObject {
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
  void pointsAreDraggedInsertedAndRemoved();
  void aDragGivenUpLeavesNothing();
  void aFeatureThatGoesEndsItsTool();
  void aChangeByOthersEndsTheDrag();
  void everyHandleMovesItsShape_data();
  void everyHandleMovesItsShape();
  void cornersOfARectangleLeaveTheOppositeOne();
  void handlesTakeOnlyWhatHappensOnThem();

 private:
  const App app_ = loadApp();
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

void OutlineToolTest::pointsAreDraggedInsertedAndRemoved() {
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

void OutlineToolTest::aDragGivenUpLeavesNothing() {
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

void OutlineToolTest::aFeatureThatGoesEndsItsTool() {
  Workbench bench(app_);
  const FeatureId id = bench.add("modeling.outline", {{"segments", squarePoints()}});
  Tool& tool = bench.draw(id);
  const QSignalSpy finished(&tool, &Tool::finished);
  bench.undo();
  QCOMPARE(finished.count(), 1);
}

void OutlineToolTest::aChangeByOthersEndsTheDrag() {
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

void OutlineToolTest::everyHandleMovesItsShape_data() {
  QTest::addColumn<QString>("type");
  QTest::addColumn<QPointF>("handle");
  QTest::addColumn<QPointF>("to");
  QTest::addColumn<QString>("parameter");
  QTest::addColumn<double>("value");
  const QPointF centre(0, 0);
  for (const char* name : {"circle", "ellipse", "polygon", "star", "rectangle", "slot"})
    QTest::addRow("centre of %s", name) << name << centre << QPointF(50, 30) << "centre" << 50.0;
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

void OutlineToolTest::everyHandleMovesItsShape() {
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

void OutlineToolTest::cornersOfARectangleLeaveTheOppositeOne() {
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

void OutlineToolTest::handlesTakeOnlyWhatHappensOnThem() {
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

QTEST_MAIN(OutlineToolTest)
#include "outline_tool_test.moc"
