// The view while something is drawn or a place is picked in it: it turns to the plane, follows keys and mouse, and shows
// snaps.
#include "ui/controls/pick_button.h"
#include "ui/fields/parameter_field.h"
#include "ui/tools/place_snap.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class DrawingViewTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openNewDocument(); }
  void cleanup() { window_.reset(); }
  void theViewTurnsToThePlaneAndBack();
  void theFirstOutlineGivesTheViewBack();
  void aSolidIsNotLeftSeenFromAbove();
  void whoHasTurnedADrawingKeepsTheView();
  void whoHasTurnedTheViewKeepsIt();
  void digitsTurnTheViewBeforeTheFirstPoint();
  void theMouseMovesTheViewWhileDrawing();
  void undoTakesBackPointsFirst();
  void anotherCommandEndsTheDrawing();
  void placesOfAShape();
  void pickedPositionsSnap();

 private:
  [[nodiscard]] ViewWidget& view() { return window_->view(); }
  [[nodiscard]] double pitch() { return view().camera().turn().pitch; }
  void press(Qt::Key key) { QTest::keyClick(&view(), key); }
  void startDrawing() {
    run("feature.modeling.outline");
    QVERIFY(window_->page().toolStarted());
    QTRY_COMPARE(pitch(), 90.0);
  }
};

void DrawingViewTest::theViewTurnsToThePlaneAndBack() {
  add("modeling.box",
      {{"position", {100, 0, 0}}});  // a planar drawing that was not made by hand is looked at from above at first
  view().lookFrom(QStringLiteral("iso"), false);
  const Turn before = view().camera().turn();
  QVERIFY(before.pitch < 80);
  startDrawing();
  QCOMPARE(view().camera().turn().yaw, 0.0);
  press(Qt::Key_Escape);
  QVERIFY(!window_->page().toolStarted());
  QTRY_COMPARE(pitch(), before.pitch);
  QCOMPARE(view().camera().turn().yaw, before.yaw);
  // Also after an outline was drawn.
  startDrawing();
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(30, 0, 0), Vec3(0, 20, 0), Vec3(0, 0, 0)}) clickAt(p);
  QVERIFY(!window_->page().toolStarted());
  QCOMPARE(window_->page().document().at(last()).type, std::string("modeling.outline"));
  QTRY_COMPARE(pitch(), before.pitch);
}

void DrawingViewTest::theFirstOutlineGivesTheViewBack() {
  const Turn before = view().camera().turn();
  QVERIFY(before.pitch < 80);
  startDrawing();
  const std::vector<Vec3> corners{{0, 0, 0}, {30, 0, 0}, {0, 20, 0}};
  for (const Vec3& p : corners) clickAt(p);
  clickAt(corners.front());
  QVERIFY(!window_->page().toolStarted());
  waitUntilComputed();
  QTRY_COMPARE(pitch(), before.pitch);
  QCOMPARE(view().camera().turn().yaw, before.yaw);
  QVERIFY(!view().parallel());
  QTRY_VERIFY(view().sharp());
  for (const Vec3& p : corners) QVERIFY(view().rect().contains(screenOf(p)));
  // And so it stays when a solid is made of it.
  run("feature.modeling.extrude");
  waitUntilComputed();
  QCOMPARE(window_->page().document().at(last()).type, std::string("modeling.extrude"));
  QCOMPARE(view().camera().heading().pitch, before.pitch);
}

void DrawingViewTest::aSolidIsNotLeftSeenFromAbove() {
  const auto extruded = [&](const FeatureId& outline) { return add("modeling.extrude", {{"height", 20}}, {outline}); };
  const FeatureId rectangle = add("modeling.rectangle", {{"width", 60}, {"height", 40}});
  QCOMPARE(pitch(), 90.0);
  const FeatureId solid = extruded(rectangle);
  QTRY_COMPARE(pitch(), turnOf("iso").pitch);
  QVERIFY(!view().parallel());
  // Once; a view from above that was asked for stays.
  view().lookFrom(QStringLiteral("top"), false);
  window_->session().commit(window_->page().document().without(solid), QStringLiteral("Delete"));
  waitUntilComputed();
  extruded(rectangle);
  QCOMPARE(view().camera().heading().pitch, 90.0);
}

void DrawingViewTest::whoHasTurnedADrawingKeepsTheView() {
  const FeatureId circle = add("modeling.circle");
  QCOMPARE(pitch(), 90.0);
  view().camera().lookFrom({20, 60}, false);
  add("modeling.extrude", {{"height", 20}}, {circle});
  QCOMPARE(view().camera().heading().pitch, 60.0);
}

void DrawingViewTest::whoHasTurnedTheViewKeepsIt() {
  startDrawing();
  view().camera().lookFrom({20, 60}, false);
  press(Qt::Key_Escape);
  QTest::qWait(50);
  QCOMPARE(view().camera().heading().pitch, 60.0);
  // From below, too, the plane is seen without being turned to.
  view().camera().lookFrom(turnOf("bottom"), false);
  run("feature.modeling.outline");
  QCOMPARE(view().camera().heading().pitch, -90.0);
}

void DrawingViewTest::digitsTurnTheViewBeforeTheFirstPoint() {
  startDrawing();
  press(Qt::Key_1);
  QTRY_COMPARE(pitch(), 0.0);  // front
  QVERIFY(window_->page().toolStarted());
  press(Qt::Key_5);
  QTRY_COMPARE(pitch(), 90.0);  // top
  QTest::keyClicks(&view(), QStringLiteral("@10,20"));
  press(Qt::Key_Return);
  QTest::keyClicks(&view(), QStringLiteral("15<0"));
  press(Qt::Key_Return);
  QCOMPARE(pitch(), 90.0);
  QTest::keyClicks(&view(), QStringLiteral("15<90"));
  press(Qt::Key_Return);
  press(Qt::Key_C);
  QVERIFY(!window_->page().toolStarted());
  waitUntilComputed();
  COMPARE_NEAR(measureOf(last(), "area"), 15.0 * 15 / 2, 1e-9);
  const Value start = window_->page().document().at(last()).parameters.at("start");
  QCOMPARE(start, Value::array({10.0, 20.0, 0.0}));
}

void DrawingViewTest::theMouseMovesTheViewWhileDrawing() {
  startDrawing();
  clickAt({0, 0, 0});
  const Vec3 target = view().camera().target();
  const QPoint middle = view().rect().center();
  QTest::mousePress(&view(), Qt::MiddleButton, {}, middle);
  QTest::mouseMove(&view(), middle + QPoint(60, 30));
  QTest::mouseMove(&view(), middle + QPoint(90, 40));
  QTest::mouseRelease(&view(), Qt::MiddleButton, {}, middle + QPoint(90, 40));
  QVERIFY((view().camera().target() - target).norm() > 1);
  QTest::mousePress(&view(), Qt::MiddleButton, Qt::ShiftModifier, middle);
  QTest::mouseMove(&view(), middle + QPoint(20, -40));
  QTest::mouseMove(&view(), middle + QPoint(20, -80));
  QTest::mouseRelease(&view(), Qt::MiddleButton, Qt::ShiftModifier, middle + QPoint(20, -80));
  QVERIFY(pitch() < 89);
  QVERIFY(window_->page().toolStarted());
}

void DrawingViewTest::undoTakesBackPointsFirst() {
  const FeatureId box = add("modeling.box", {{"position", {100, 0, 0}}});
  const auto* undo = window_->commands().find(QStringLiteral("edit.undo"))->action;
  const QString ofDocument = undo->text();
  startDrawing();
  clickAt({0, 0, 0});
  const auto draw = [&](const char* entry) {
    QTest::keyClicks(&view(), QLatin1String(entry));
    press(Qt::Key_Return);
  };
  draw("30<0");
  QVERIFY(undo->isEnabled() && undo->text() != ofDocument);
  QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
  run("edit.undo");  // by the menu, too
  QVERIFY(window_->page().document().contains(box));
  QCOMPARE(undo->text(), ofDocument);
  QTest::keyClick(&view(), Qt::Key_Y, Qt::ControlModifier);
  run("edit.redo");
  draw("20<90");
  press(Qt::Key_C);
  waitUntilComputed();
  COMPARE_NEAR(measureOf(last(), "area"), 300, 1e-9);
}

void DrawingViewTest::anotherCommandEndsTheDrawing() {
  startDrawing();
  clickAt({0, 0, 0});
  clickAt({30, 0, 0});
  run("feature.modeling.box");
  waitUntilComputed();
  QVERIFY(!window_->page().toolStarted());
  // What was drawn stays, as it was, in a step of undo of its own; Esc throws it away.
  const auto drawn = [&] { return window_->page().document().features(); };
  QCOMPARE(drawn().size(), std::size_t{2});
  QCOMPARE(drawn().front()->type, std::string("modeling.outline"));
  COMPARE_NEAR(measureOf(drawn().front()->id, "length"), 30, 1e-9);
  // A single point is nothing that could stay.
  startDrawing();
  clickAt({0, 0, 0});
  run("edit.duplicate");
  QVERIFY(!window_->page().toolStarted());
  QCOMPARE(drawn().size(), std::size_t{3});
  QCOMPARE(drawn().back()->type, std::string("modeling.box"));
  for (int step = 0; step < 3; ++step) run("edit.undo");
  QVERIFY(drawn().empty());
  startDrawing();
  clickAt({0, 0, 0});
  clickAt({30, 0, 0});
  press(Qt::Key_Escape);
  QVERIFY(!window_->page().toolStarted() && drawn().empty());
}

void DrawingViewTest::placesOfAShape() {
  using Kind = SnapPlace::Kind;
  const FeatureId box = add("modeling.box", {{"width", 10}, {"depth", 20}, {"height", 30}});
  const auto count = [](const std::vector<SnapPlace>& places, Kind kind) {
    return std::count_if(places.begin(), places.end(), [&](const SnapPlace& place) { return place.kind == kind; });
  };
  const auto boxes = snapPlaces(window_->page().result(box)->evaluated.shape);
  QCOMPARE(count(boxes, Kind::Point), 8);
  QCOMPARE(count(boxes, Kind::Midpoint), 12);
  QCOMPARE(count(boxes, Kind::Centre), 0);
  const FeatureId cylinder = add("modeling.cylinder", {{"radius", 5}, {"height", 30}});
  const auto round = snapPlaces(window_->page().result(cylinder)->evaluated.shape);
  QCOMPARE(count(round, Kind::Centre), 2);
  QCOMPARE(count(round, Kind::Midpoint), 1);  // of the seam
  // Straight down beside a corner, beside nothing, and beside what lies behind the face that is hit.
  SnapAim aim{{{5.4, 9.7, 100}, -Vec3::UnitZ()}, 1, 10, SubPick{SubShapeKind::Face, 0, {5.4, 9.7, 30}, Vec3::UnitZ(), 70}};
  const std::vector<SnapPlace> corners{{{5, 10, 30}, Kind::Point}, {{5.4, 9.7, 0}, Kind::Point}};
  const auto snapped = snappedPlace(corners, aim);
  QVERIFY(snapped && snapped->at == Vec3(5, 10, 30));
  aim.reach = 0.2;
  const auto onFace = snappedPlace(corners, aim);
  QVERIFY(onFace && onFace->at == Vec3(5.4, 9.7, 30) && onFace->kind == Kind::Face);
  aim.hit.reset();
  aim.reach = 1;
  const auto grid = snappedPlace({}, {{{10.3, 19.8, 100}, -Vec3::UnitZ()}, 1, 10, {}});
  QVERIFY(grid && grid->at == Vec3(10, 20, 0) && grid->kind == Kind::Grid);
  QVERIFY(!snappedPlace({}, {{{0, 0, 1}, Vec3::UnitX()}, 1, 10, {}}));
}

void DrawingViewTest::pickedPositionsSnap() {
  add("modeling.box", {{"width", 40}, {"depth", 40}, {"height", 20}, {"anchor", "base"}});
  const FeatureId drill = add("modeling.cylinder", {{"radius", 3}, {"height", 5}});
  view().lookFrom(QStringLiteral("iso"), false);
  window_->tree().select(drill);
  auto* position = window_->page().properties().field(QStringLiteral("position"));
  QVERIFY(position);
  const auto pick = [&](const Vec3& near, QPoint beside, Qt::KeyboardModifiers modifiers = {}) {
    position->findChild<PickButton*>()->click();
    QVERIFY(window_->page().toolStarted());
    const QPoint at = screenOf(near) + beside;
    test::moveMouse(&view(), at);
    QTest::mouseClick(&view(), Qt::LeftButton, modifiers, at);
    waitUntilComputed();
  };
  const auto now = [&] {
    const Value& p = window_->page().document().at(drill).parameters.at("position");
    return Vec3(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
  };
  pick({-20, -20, 20}, {3, 2});
  QCOMPARE(now(), Vec3(-20, -20, 20));
  pick({0, -20, 20}, {-2, 3});  // the middle of an edge
  QCOMPARE(now(), Vec3(0, -20, 20));
  pick({-20, -20, 20}, {3, 2}, Qt::ControlModifier);
  QVERIFY((now() - Vec3(-20, -20, 20)).norm() > 1e-6);
  // Beside the block, where there is nothing but the ground.
  const double grid = window_->page().gridSpacing();
  const Vec3 ground(std::round(60 / grid) * grid, std::round(-60 / grid) * grid, 0);
  pick(ground, {2, 2});
  QCOMPARE(now(), ground);
}

BLOSSOM_WINDOW_TEST(DrawingViewTest)
#include "drawing_view_test.moc"
