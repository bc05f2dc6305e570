#include "geometry/planar/planar.h"
#include "modeling/kernel/outline/outline_draft.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::modeling;

namespace {

/// A mouse in an empty scene with a grid of 10 mm.
class Mouse {
 public:
  explicit Mouse(OutlineDraft& draft) : draft_(draft) {}
  void move(double x, double y) { draft_.hover(snappedPoint(draft_.sceneWith(scene), draft_.query({x, y}, 1, 10))); }
  bool click(double x, double y) {
    move(x, y);
    return draft_.place();
  }
  void type(const char* text) {
    for (; *text; ++text) draft_.entry().type(*text);
  }
  SnapScene scene;

 private:
  OutlineDraft& draft_;
};

SnapKind kindAt(const SnapScene& scene, SnapQuery query, double x, double y) {
  query.mouse = {x, y};
  return snappedPoint(scene, query).kind;
}

}  // namespace

/// Snapping, typed measures and the state machine of drawing.
class ModelingDraftTest : public QObject {
  Q_OBJECT
 private slots:
  void strongerThingsCatchFirst();
  void guidesHoldExactly();
  void guidesThatCross();
  void feetOfPerpendiculars();
  void nothingBeyondReach();
  void whatShapesOffer();
  void entriesAreRead_data();
  void entriesAreRead();
  void entriesAreEdited();
  void aRectangleByClicks();
  void typedLengthsGoWhereTheMousePoints();
  void typedAnglesAndPlaces();
  void tangentAndThreePointArcs();
  void aRadiusIsTyped();
  void splinesGoOn();
  void backspaceTakesPointsBack();
  void whatMakesNoSegmentIsNotTaken();
  void randomClicksAndBackspacesEndWhereTheyBegan();
};

void ModelingDraftTest::strongerThingsCatchFirst() {
  SnapScene scene;
  scene.points = {{{3, 4}, SnapKind::Point}, {{3.5, 4}, SnapKind::Midpoint}, {{3, 4.6}, SnapKind::Start}};
  SnapQuery query{Vec2::Zero(), 1, 1, Vec2(0, 4), {}, {}};
  QCOMPARE(kindAt(scene, query, 3, 4), SnapKind::Start);
  QCOMPARE(kindAt(scene, query, 2.8, 3.6), SnapKind::Point);  // before the horizontal guide and the grid
  QCOMPARE(kindAt(scene, query, 3.9, 3.6), SnapKind::Midpoint);
  query.reach = 0.3;
  QCOMPARE(kindAt(scene, query, 8.4, 4.1), SnapKind::Horizontal);
  QCOMPARE(kindAt(scene, query, 8.1, 7.1), SnapKind::Grid);
  QCOMPARE(kindAt(scene, query, 8.5, 7.5), SnapKind::None);
}

void ModelingDraftTest::guidesHoldExactly() {
  SnapQuery query{Vec2::Zero(), 1, 0, Vec2(2, 3), {}, {}};
  query.mouse = {40, 3.4};
  QCOMPARE(snappedPoint({}, query).point, Vec2(40, 3));
  query.mouse = {1.5, -20};
  QCOMPARE(snappedPoint({}, query).point, Vec2(2, -20));
  query.mouse = {12.3, 13};
  const Snap diagonal = snappedPoint({}, query);
  QCOMPARE(diagonal.kind, SnapKind::Diagonal);
  COMPARE_NEAR(diagonal.point.x() - 2, diagonal.point.y() - 3, 1e-12);
  query.grid = 5;
  query.mouse = {29.4, 3.4};
  QCOMPARE(snappedPoint({}, query).point, Vec2(30, 3));  // the guide and a grid line that it crosses
  query.direction = Vec2(0.6, 0.8);
  query.mouse = Vec2(2, 3) + 20 * Vec2(0.6, 0.8) + Vec2(0.1, -0.1);
  QCOMPARE(snappedPoint({}, query).kind, SnapKind::Tangent);
  query.mouse = Vec2(2, 3) + 20 * Vec2(-0.8, 0.6);
  const Snap square = snappedPoint({}, query);
  QCOMPARE(square.kind, SnapKind::Square);
  COMPARE_NEAR((square.point - Vec2(2, 3)).dot(Vec2(0.6, 0.8)), 0, 1e-12);
}

void ModelingDraftTest::guidesThatCross() {
  const SnapQuery query{{0.3, 19.6}, 1, 0, Vec2(40, 20), {}, Vec2(0, 0)};
  const Snap corner = snappedPoint({}, query);
  QCOMPARE(corner.kind, SnapKind::Crossing);
  COMPARE_NEAR((corner.point - Vec2(0, 20)).norm(), 0, 1e-12);
  QCOMPARE(corner.guides.size(), std::size_t{2});
}

void ModelingDraftTest::feetOfPerpendiculars() {
  SnapScene scene;
  scene.curves = {Line2{{0, 0}, {30, 15}}, Arc2{{60, 0}, 10, 0, 2 * std::numbers::pi}};
  SnapQuery query{Vec2::Zero(), 1.5, 0, Vec2(5, 27), {}, {}};
  const Vec2 along = Vec2(30, 15).normalized(), expected = Vec2(5, 27).dot(along) * along;
  query.mouse = expected + Vec2(0.5, 0.5);
  const Snap foot = snappedPoint(scene, query);
  QCOMPARE(foot.kind, SnapKind::Perpendicular);
  COMPARE_NEAR((foot.point - expected).norm(), 0, 1e-12);
  const Vec2 out = (Vec2(5, 27) - Vec2(60, 0)).normalized();
  query.mouse = Vec2(60, 0) + 10.4 * out;
  COMPARE_NEAR((snappedPoint(scene, query).point - (Vec2(60, 0) + 10 * out)).norm(), 0, 1e-12);
  query.mouse = {24, 12.3};
  QCOMPARE(snappedPoint(scene, query).kind, SnapKind::OnCurve);
}

void ModelingDraftTest::nothingBeyondReach() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> place(-50, 50);
  SnapScene scene;
  for (int k = 0; k < 40; ++k) scene.points.push_back({{place(random), place(random)}, SnapKind::Point});
  for (int k = 0; k < 10; ++k)
    scene.curves.emplace_back(Line2{{place(random), place(random)}, {place(random), place(random)}});
  for (int round = 0; round < 2000; ++round) {
    const SnapQuery query{{place(random), place(random)}, 1, 5, Vec2(place(random), place(random)), Vec2(0, 1), Vec2(1, 2)};
    const Snap snap = snappedPoint(scene, query);
    // A guide with a grid line on it may lie a reach along each.
    QVERIFY((snap.point - query.mouse).norm() <= std::sqrt(2.0) + 1e-12);
    if (snap.kind == SnapKind::None) QCOMPARE(snap.point, query.mouse);
  }
}

void ModelingDraftTest::whatShapesOffer() {
  SnapScene scene;
  addToScene(scene, {{Line2{{0, 0}, {10, 0}}, Arc2{{10, 5}, 5, -std::numbers::pi / 2, std::numbers::pi}}, false, {}, {}});
  const auto has = [&](SnapKind kind, double x, double y) {
    return std::any_of(scene.points.begin(), scene.points.end(),
                       [&](const SnapPoint& p) { return p.kind == kind && (p.at - Vec2(x, y)).norm() < 1e-12; });
  };
  QVERIFY(has(SnapKind::Point, 0, 0) && has(SnapKind::Point, 10, 0) && has(SnapKind::Point, 10, 10));
  QVERIFY(has(SnapKind::Midpoint, 5, 0) && has(SnapKind::Midpoint, 15, 5) && has(SnapKind::Centre, 10, 5));
}

void ModelingDraftTest::entriesAreRead_data() {
  QTest::addColumn<QString>("typed");
  QTest::addColumn<double>("length");
  QTest::addColumn<double>("angle");
  QTest::newRow("length") << "25" << 25.0 << -1.0;
  QTest::newRow("length and angle") << "25<30" << 25.0 << 30.0;
  QTest::newRow("angle alone") << "<45" << -1.0 << 45.0;
  QTest::newRow("unit") << "2in" << 50.8 << -1.0;
  QTest::newRow("expression") << "1/2 in<90" << 12.7 << 90.0;
}

void ModelingDraftTest::entriesAreRead() {
  QFETCH(const QString, typed);
  TypedEntry entry;
  for (const QChar c : typed) QVERIFY(entry.type(c.toLatin1()));
  const auto values = entry.values();
  QTEST(values.length.value_or(-1), "length");
  QTEST(values.angle.value_or(-1), "angle");
  QVERIFY(!values.place);
}

void ModelingDraftTest::entriesAreEdited() {
  TypedEntry entry;
  QVERIFY(!entry.type('x') && !entry.open());  // a letter is a command until an entry is open
  for (const char c : {'2', '5'}) QVERIFY(entry.type(c));
  entry.switchField();
  QVERIFY(entry.type('9') && entry.inAngle());
  entry.switchField();
  QVERIFY(entry.type('0'));
  COMPARE_NEAR(*entry.values().length, 250, 0);
  COMPARE_NEAR(*entry.values().angle, 9, 0);
  while (entry.open()) QVERIFY(entry.back());
  for (const char c : {'@', '1', ',', '-', '2'}) QVERIFY(entry.type(c));
  QVERIFY(entry.values().relative);
  QCOMPARE(*entry.values().place, Vec2(1, -2));
  entry.clear();
  for (const char c : {'1', '.', '.', '2'}) entry.type(c);
  VERIFY_ERROR(entry.values(), ErrorCode::InvalidParameter);
  QVERIFY(!entry.problem().empty());
}

void ModelingDraftTest::aRectangleByClicks() {
  OutlineDraft draft;
  Mouse mouse(draft);
  QVERIFY(mouse.click(0.4, -0.3));
  QVERIFY(mouse.click(40.3, 0.2));
  QVERIFY(!draft.canClose());
  QVERIFY(mouse.click(39.8, 19.7));
  mouse.move(0.3, 20.4);
  QCOMPARE(draft.hovered()->kind, SnapKind::Crossing);  // level with the last point, plumb above the first
  QVERIFY(draft.place());
  mouse.move(0.6, 0.6);
  QCOMPARE(draft.hovered()->kind, SnapKind::Start);
  QVERIFY(draft.place());
  QVERIFY(draft.closed());
  QCOMPARE(draft.outline().segments.size(), std::size_t{3});
  COMPARE_NEAR(signedArea(toPath(draft.outline())), 800, 1e-12);
  QVERIFY(!mouse.click(5, 5));  // it is closed
}

void ModelingDraftTest::typedLengthsGoWhereTheMousePoints() {
  OutlineDraft draft;
  Mouse mouse(draft);
  QVERIFY(mouse.click(0, 0));
  mouse.move(17, 0.6);
  mouse.type("25");
  QCOMPARE(*draft.target(), Vec2(25, 0));
  QVERIFY(draft.place());
  QVERIFY(!draft.entry().open());
  mouse.move(25.4, -3);
  mouse.type("1.5cm");
  QVERIFY(draft.place());
  QCOMPARE(draft.outline().segments.back().to, Vec2(25, -15));
}

void ModelingDraftTest::typedAnglesAndPlaces() {
  OutlineDraft draft;
  Mouse mouse(draft);
  mouse.type("10,20");
  QVERIFY(draft.place());
  mouse.type("25<30");
  QVERIFY(draft.place());
  const Vec2 end = Vec2(10, 20) + 25 * Vec2(std::sqrt(3) / 2, 0.5);
  COMPARE_NEAR((draft.outline().segments.back().to - end).norm(), 0, 1e-12);
  mouse.type("@-5,0");
  QVERIFY(draft.place());
  COMPARE_NEAR((draft.outline().segments.back().to - end - Vec2(-5, 0)).norm(), 0, 1e-12);
  mouse.type("0");
  QVERIFY(!draft.target());
  QVERIFY(!draft.place());
  QVERIFY(!draft.entry().problem().empty());
}

void ModelingDraftTest::tangentAndThreePointArcs() {
  OutlineDraft draft;
  Mouse mouse(draft);
  mouse.click(0, 0);
  mouse.click(40, 0);
  draft.choose(DrawnKind::Arc);
  QVERIFY(draft.tangent());
  QVERIFY(mouse.click(40, 20));
  COMPARE_NEAR(std::get<Arc2>(segmentOf(draft.outline(), 1)).radius, 10, 1e-12);
  draft.choose(DrawnKind::Arc);
  QVERIFY(!draft.tangent());
  QVERIFY(mouse.click(0, 20));
  QVERIFY(draft.wantsMiddle());
  mouse.move(20, 30);
  QVERIFY(draft.rubber().has_value());
  QVERIFY(mouse.click(20, 30));
  QVERIFY(!draft.wantsMiddle());
  QCOMPARE(draft.outline().segments.back().through, std::vector<Vec2>{Vec2(20, 30)});
  QVERIFY(draft.close());  // the end of an arc on the start: its middle is still wanted
  QVERIFY(draft.wantsMiddle());
  QVERIFY(mouse.click(-5, 10));
  QVERIFY(draft.closed());
  QCOMPARE(draft.outline().segments.back().to, draft.outline().start);
}

void ModelingDraftTest::aRadiusIsTyped() {
  OutlineDraft draft;
  Mouse mouse(draft);
  draft.choose(DrawnKind::Arc);
  mouse.click(0, 0);
  mouse.click(40, 0);
  mouse.move(20, -3);
  mouse.type("25");
  QVERIFY(draft.place());
  const auto arc = std::get<Arc2>(segmentOf(draft.outline(), 0));
  COMPARE_NEAR(arc.radius, 25, 1e-9);
  COMPARE_NEAR(arc.center.y(), 15, 1e-9);  // it bulges to the side of the mouse
}

void ModelingDraftTest::splinesGoOn() {
  OutlineDraft draft;
  Mouse mouse(draft);
  draft.choose(DrawnKind::Spline);
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{{0, 0}, {20, 0}, {20, 20}, {0, 20}})
    QVERIFY(mouse.click(x, y));
  QCOMPARE(draft.outline().segments.size(), std::size_t{1});
  QCOMPARE(draft.outline().segments[0].through.size(), std::size_t{2});
  mouse.move(0.3, 0.3);
  QVERIFY(draft.place());
  QVERIFY(draft.closed());
  const Path ring = toPath(draft.outline());
  COMPARE_NEAR((startDirection(ring.segments[0]) - endDirection(ring.segments[0])).norm(), 0, 1e-9);
}

void ModelingDraftTest::backspaceTakesPointsBack() {
  OutlineDraft draft;
  Mouse mouse(draft);
  mouse.click(0, 0);
  mouse.click(20, 0);
  draft.choose(DrawnKind::Spline);
  mouse.click(30, 10);
  mouse.click(20, 20);
  QVERIFY(draft.back());
  COMPARE_NEAR((draft.outline().segments.back().to - Vec2(30, 10)).norm(), 0, 1e-12);
  mouse.click(40, 30);
  QCOMPARE(draft.outline().segments.size(), std::size_t{2});  // the same spline goes on
  for (int k = 0; k < 4; ++k) QVERIFY(draft.back());
  QVERIFY(!draft.started() && !draft.back());
}

void ModelingDraftTest::whatMakesNoSegmentIsNotTaken() {
  OutlineDraft draft;
  Mouse mouse(draft);
  mouse.click(0, 0);
  QVERIFY(!mouse.click(0, 0));
  mouse.click(20, 0);
  draft.choose(DrawnKind::Arc);
  QVERIFY(!mouse.click(5, 0));  // straight behind
  QVERIFY(!draft.rubber().has_value());
  QCOMPARE(draft.outline().segments.size(), std::size_t{1});
}

void ModelingDraftTest::randomClicksAndBackspacesEndWhereTheyBegan() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> place(-50, 50);
  for (int round = 0; round < 200; ++round) {
    OutlineDraft draft;
    Mouse mouse(draft);
    for (int k = 0; k < 12; ++k) {
      if (random() % 3 == 0) draft.choose(static_cast<DrawnKind>(random() % 3));
      mouse.click(place(random), place(random));
      (void)draft.preview();
      if (draft.complete()) QVERIFY(!toPath(draft.outline()).segments.empty());
    }
    int steps = 0;
    while (draft.back()) QVERIFY(++steps < 50);
    QVERIFY(!draft.started() && draft.outline().segments.empty());
  }
}

BLOSSOM_TEST(ModelingDraftTest)
#include "modeling_draft_test.moc"

#include <numbers>  // not first: moc stumbles over it
