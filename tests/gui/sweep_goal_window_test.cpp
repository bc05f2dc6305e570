#include <QClipboard>
#include <QGuiApplication>
#include <cmath>

#include "support/sweep_formulas.h"
#include "sweep_fixture.h"
#include "ui/tree/document_tree.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// Goals of pulls and twists that are typed, and places that are chosen before a drag, through the real window.
class SweepGoalWindowTest : public SweepFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void aTypedTargetIsReachedExactly();
  void aTargetIsTypedFromWhereThePlaceIs();
  void aTargetIsTypedDuringADrag();
  void theSurfaceFollowsWhatIsTypedSoFar();
  void tabGoesToTheNextCoordinate();
  void anotherFieldEndsTheTyping();
  void whatIsTypedCanBeLeft();
  void keysOfEditingBelongToTheText();
  void aTypedAngleIsThatOfTheTwist();
  void theLastPullIsGivenAnotherTarget();
  void anEarlierPullIsDraggedAtItsPlace();
  void anEarlierTwistKeepsItsAxis();
  void placesGoTogetherAndPinsStay();
  void chosenPlacesAreForgotten();
  void aMirroredPullIsMirrored();

 private:
  void type(const QString& text) { QTest::keyClicks(&window_->view(), text); }
  void clickWithShift(const QPoint& at);
  /// The parameters of the only feature of a type, complete and as numbers.
  [[nodiscard]] Value valuesOf(const char* type) const {
    return completed(window_->page().registry().at(type)->parameters, only(type).parameters);
  }
  [[nodiscard]] Vec3 pointOf(const FeatureId& id, const Value& place) const {
    return PlaceOfMotion(motionOf(id), place["u"].get<double>(), place["v"].get<double>()).x;
  }
};

void SweepGoalWindowTest::clickWithShift(const QPoint& at) {
  hover(at);
  mouse(QEvent::MouseButtonPress, at, Qt::ShiftModifier);
  mouse(QEvent::MouseButtonRelease, at, Qt::ShiftModifier);
}

void SweepGoalWindowTest::aTypedTargetIsReachedExactly() {
  openSample("cylinder.json");
  const Document before = document();
  const Motion motion = motionOf(source_);
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_Return);
  QVERIFY2(hint().startsWith(QStringLiteral("Type where")), qPrintable(hint()));
  type(QStringLiteral("14, -1 cm, 3*7+0.25"));
  mouse(QEvent::MouseMove, from + QPoint(30, 30));  // what is typed counts
  keepPictures("pull-typed", from);
  key(Qt::Key_Return);
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  QVERIFY(!window_->page().tool()->entering());
  const Vec3 target(14, -10, 21.25);
  const Value record = valuesOf("sweep.pull")["pulls"][0];
  QCOMPARE(vectorOf(record["to"]), target);
  QVERIFY(only("sweep.pull").parameters["pulls"][0]["to"][2].is_string());  // as it was typed
  QVERIFY((pointOf(only("sweep.pull").id, record) - target).norm() < 1e-11);
  QVERIFY((screenOf(pointOf(source_, record)) - from).manhattanLength() <= 2);
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
  QVERIFY(motionOf(document().at(sweep_).inputs.front()) == motion);
}

void SweepGoalWindowTest::aTargetIsTypedFromWhereThePlaceIs() {
  openSample("cylinder.json");
  hover(onTheSide());
  key(Qt::Key_Return);
  type(QStringLiteral("@2, , -1.5"));
  key(Qt::Key_Return);
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Value record = valuesOf("sweep.pull")["pulls"][0];
  QVERIFY((vectorOf(record["to"]) - pointOf(source_, record) - Vec3(2, 0, -1.5)).norm() < 1e-11);
}

void SweepGoalWindowTest::aTargetIsTypedDuringADrag() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(40, 0));
  key(Qt::Key_Return);
  type(QStringLiteral("12, , 20"));  // y stays where the mouse has it
  mouse(QEvent::MouseMove, from + QPoint(90, 20));
  key(Qt::Key_Enter);
  mouse(QEvent::MouseMove, from + QPoint(95, 20));
  mouse(QEvent::MouseButtonRelease, from + QPoint(95, 20));
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Vec3 to = vectorOf(valuesOf("sweep.pull")["pulls"][0]["to"]);
  QCOMPARE(to.x(), 12.0);
  QCOMPARE(to.z(), 20.0);
  QVERIFY((pointOf(only("sweep.pull").id, only("sweep.pull").parameters["pulls"][0]) - to).norm() < 1e-11);
}

/// Each key leaves the help in sight; coordinates to come stay as they are.
void SweepGoalWindowTest::theSurfaceFollowsWhatIsTypedSoFar() {
  openSample("cylinder.json");
  hover(onTheSide());
  key(Qt::Key_Return);
  double before = 0;
  for (const QString& typed : {QStringLiteral("1"), QStringLiteral("4"), QStringLiteral(","), QStringLiteral(" ")}) {
    type(typed);
    QVERIFY2(hint().startsWith(QStringLiteral("Type where")), qPrintable(typed + u' ' + hint()));
    const auto picture = window_->page().tool()->standIn();
    QVERIFY(picture);
    before = picture->faces->GetLength();
  }
  type(QStringLiteral("60"));  // farther off in y
  QVERIFY2(hint().startsWith(QStringLiteral("Type where")), qPrintable(hint()));
  const auto picture = window_->page().tool()->standIn();
  QVERIFY(picture && picture->faces->GetLength() > before + 10);
  type(QStringLiteral(", 20, 5"));
  QVERIFY2(hint().contains(QStringLiteral("4 coordinates were typed")), qPrintable(hint()));
}

void SweepGoalWindowTest::tabGoesToTheNextCoordinate() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_Return);
  type(QStringLiteral("7*2"));
  key(Qt::Key_Tab);
  QVERIFY(window_->view().hasFocus());
  type(QStringLiteral("-10"));
  key(Qt::Key_Tab);
  type(QStringLiteral("21"));
  key(Qt::Key_Tab);  // there is no fourth one
  key(Qt::Key_Backtab);
  QVERIFY(window_->view().hasFocus());
  QVERIFY(window_->page().tool()->entering());
  key(Qt::Key_Return);
  waitUntilComputed();
  QCOMPARE(vectorOf(valuesOf("sweep.pull")["pulls"][0]["to"]), Vec3(14, -10, 21));

  // At once: the first one stays as it is.
  const Value first = valuesOf("sweep.pull")["pulls"][0];
  hover(screenOf(vectorOf(first["to"])));
  key(Qt::Key_Return);
  key(Qt::Key_Tab);
  type(QStringLiteral("-11"));
  key(Qt::Key_Tab);
  key(Qt::Key_Return);
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  QVERIFY((vectorOf(valuesOf("sweep.pull")["pulls"][0]["to"]) - Vec3(14, -11, 21)).norm() < 1e-9);

  // Where nothing is typed, Tab is for the window.
  window_->view().setFocus();
  key(Qt::Key_Tab);
  QVERIFY(!window_->view().hasFocus());
}

void SweepGoalWindowTest::anotherFieldEndsTheTyping() {
  openSample("cylinder.json");
  const Document before = document();
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  hover(onTheSide());
  key(Qt::Key_Return);
  type(QStringLiteral("14, -10, 21"));
  QVERIFY(window_->page().tool()->entering());
  window_->tree().setFocus();
  QVERIFY(!window_->page().tool()->entering());
  QVERIFY(!window_->page().tool()->standIn());
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

void SweepGoalWindowTest::whatIsTypedCanBeLeft() {
  openSample("cylinder.json");
  const Document before = document();
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_Return);
  type(QStringLiteral("1, 2"));
  key(Qt::Key_Return);
  QVERIFY2(hint().contains(QStringLiteral("three coordinates")), qPrintable(hint()));
  QVERIFY(window_->page().tool()->entering());
  type(QStringLiteral(", bogus"));
  key(Qt::Key_Return);
  QVERIFY(window_->page().tool()->entering());
  QVERIFY(window_->page().tool()->standIn());
  key(Qt::Key_Escape);
  QVERIFY(!window_->page().tool()->entering());
  QVERIFY(!window_->page().tool()->standIn());
  // Scaling alone cannot leave the height of the trajectory there: said, and nothing is done.
  hover(from);
  key(Qt::Key_S);
  hover(from);
  key(Qt::Key_Return);
  type(QStringLiteral("20, 20, 35"));
  key(Qt::Key_Return);
  QVERIFY2(hint().contains(QStringLiteral("axis of the moving frame")), qPrintable(hint()));
  QVERIFY(window_->page().tool()->entering());
  key(Qt::Key_Escape);
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

/// Of all that is typed, not of the document: the last feature must not go, nor all of them be selected.
void SweepGoalWindowTest::keysOfEditingBelongToTheText() {
  openSample("cylinder.json");
  const std::size_t features = document().features().size();
  hover(onTheSide());
  key(Qt::Key_Return);
  type(QStringLiteral("999, 999"));
  const auto withControl = [this](Qt::Key key) { QTest::keyClick(&window_->view(), key, Qt::ControlModifier); };
  withControl(Qt::Key_Z);
  QVERIFY(window_->page().tool()->entering());
  QCOMPARE(document().features().size(), features);
  type(QStringLiteral("888"));
  withControl(Qt::Key_A);
  QVERIFY(window_->page().tool()->entering());
  QGuiApplication::clipboard()->setText(QStringLiteral("9, -10, 1"));
  withControl(Qt::Key_V);
  key(Qt::Key_Left);
  type(QStringLiteral("2"));  // before the last digit
  key(Qt::Key_Home);
  key(Qt::Key_Delete);
  type(QStringLiteral("14"));
  key(Qt::Key_Return);
  waitUntilComputed();
  QCOMPARE(vectorOf(valuesOf("sweep.pull")["pulls"][0]["to"]), Vec3(14, -10, 21));
}

void SweepGoalWindowTest::aTypedAngleIsThatOfTheTwist() {
  openSample("cylinder.json");
  const Motion before = motionOf(source_);
  hover(onTheSide());
  key(Qt::Key_W);
  key(Qt::Key_Return);
  QVERIFY2(hint().startsWith(QStringLiteral("Type the angle")), qPrintable(hint()));
  type(QStringLiteral("360/8 - 0.5"));
  keepPictures("pull-twist-typed", onTheSide());
  key(Qt::Key_Return);
  waitUntilComputed();
  const Value twist = valuesOf("sweep.twist");
  QCOMPARE(twist["angle"].get<double>(), 44.5);
  const Value& place = twist["places"][0];
  const PlaceOfMotion at(before, place["u"].get<double>(), place["v"].get<double>());
  const double off = poleDifference(twistedBy(before, at, Vec3::UnitZ(), 44.5), motionOf(only("sweep.twist").id));
  QVERIFY2(off < 1e-12, qPrintable(QString::number(off)));

  // The same place again: the angle of the whole twist.
  hover(screenOf(pointOf(only("sweep.twist").id, place)));
  key(Qt::Key_Return);
  type(QStringLiteral("-20"));
  key(Qt::Key_Return);
  waitUntilComputed();
  QCOMPARE(all("sweep.twist").size(), std::size_t(1));
  QCOMPARE(valuesOf("sweep.twist")["angle"].get<double>(), -20.0);
}

void SweepGoalWindowTest::theLastPullIsGivenAnotherTarget() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  drag(from, from + QPoint(60, -10));
  const Value first = only("sweep.pull").parameters["pulls"][0];
  hover(screenOf(vectorOf(first["to"])));
  key(Qt::Key_Return);
  type(QStringLiteral("16, 3, 22"));
  key(Qt::Key_Return);
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Value second = only("sweep.pull").parameters["pulls"][0];
  QCOMPARE(second["u"], first["u"]);
  QCOMPARE(second["v"], first["v"]);
  QCOMPARE(vectorOf(second["to"]), Vec3(16, 3, 22));
}

/// Though another edit follows, which is computed anew, and in its own way, whatever is chosen for the next one.
void SweepGoalWindowTest::anEarlierPullIsDraggedAtItsPlace() {
  openSample("cylinder.json");
  const QPoint place = onTheSide(), above = place - QPoint(0, 50);
  drag(place, place + QPoint(30, -5));
  drag(above, above + QPoint(25, -5));
  const std::vector<FeatureId> pulls = all("sweep.pull");
  QCOMPARE(pulls.size(), std::size_t(2));
  const Value earlier = document().at(pulls[0]).parameters, later = document().at(pulls[1]).parameters;
  const Value before = earlier["pulls"][0];
  hover(above);
  key(Qt::Key_T);
  window_->tree().select(pulls[0]);
  const QPoint seen = screenOf(pointOf(pulls[1], before));
  hover(seen, QStringLiteral("Drag to change the selected edit"));
  keepPictures("pull-earlier", seen);
  mouse(QEvent::MouseButtonPress, seen);
  for (int k = 1; k <= 4; ++k) mouse(QEvent::MouseMove, seen + QPoint(5 * k, 4 * k));
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to pull the point here in the selected edit")), qPrintable(hint()));
  keepPictures("pull-earlier-held");
  mouse(QEvent::MouseButtonRelease, seen + QPoint(20, 16));
  waitUntilComputed();
  QCOMPARE(all("sweep.pull"), pulls);
  QCOMPARE(document().at(pulls[1]).parameters, later);
  Value changed = document().at(pulls[0]).parameters;
  const Vec3 goal = vectorOf(changed["pulls"][0]["to"]), was = vectorOf(before["to"]);
  QVERIFY((goal - was).norm() > 0.1);
  QVERIFY((pointOf(pulls[0], before) - goal).norm() < 1e-11);
  QVERIFY((screenOf(goal) - screenOf(was) - QPoint(20, 16)).manhattanLength() <= 3);
  changed["pulls"][0]["to"] = before["to"];
  QCOMPARE(changed, earlier);  // and nothing else of it
}

void SweepGoalWindowTest::anEarlierTwistKeepsItsAxis() {
  openSample("cylinder.json");
  const QPoint place = onTheSide(), above = place - QPoint(0, 50);
  hover(place);
  key(Qt::Key_W);
  key(Qt::Key_A);
  drag(place, place + QPoint(30, 0));
  hover(above);
  key(Qt::Key_W);
  drag(above, above + QPoint(25, -5));
  QCOMPARE(all("sweep.twist").size(), std::size_t(1));
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const FeatureId twist = only("sweep.twist").id, pull = only("sweep.pull").id;
  const Value before = document().at(twist).parameters;
  window_->tree().select(twist);
  const QPoint seen = screenOf(pointOf(pull, before["places"][0]));
  hover(seen, QStringLiteral("Drag to change the selected edit"));
  key(Qt::Key_Return);
  type(QStringLiteral("33"));
  key(Qt::Key_Return);
  waitUntilComputed();
  Value changed = document().at(twist).parameters;
  QCOMPARE(changed["angle"].get<double>(), 33.0);
  changed["angle"] = before["angle"];
  QCOMPARE(changed, before);
}

/// Two places along the cylinder go the same way, one between them stays.
void SweepGoalWindowTest::placesGoTogetherAndPinsStay() {
  openSample("cylinder.json");
  window_->view().lookFrom(QStringLiteral("front"), false);
  window_->view().fit(false);
  const auto inFront = [&](double height) { return screenOf(Vec3(0, -10, height)); };
  clickWithShift(inFront(12));
  hover(inFront(28));
  key(Qt::Key_P);
  hover(inFront(20));
  QVERIFY2(hint().contains(QStringLiteral("chosen: 1, pinned: 1")), qPrintable(hint()));
  key(Qt::Key_T);
  mouse(QEvent::MouseButtonPress, inFront(20));
  for (int k = 1; k <= 5; ++k) mouse(QEvent::MouseMove, inFront(20) + QPoint(8 * k, 0));
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to pull 2 places")), qPrintable(hint()));
  QVERIFY2(hint().contains(QStringLiteral("1 pinned")), qPrintable(hint()));
  keepPictures("pull-several", inFront(20) + QPoint(40, 0));
  mouse(QEvent::MouseButtonRelease, inFront(20) + QPoint(40, 0));
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Value values = valuesOf("sweep.pull");
  const FeatureId pulled = only("sweep.pull").id;
  QCOMPARE(values["pulls"].size(), std::size_t(2));
  QCOMPARE(values["pins"].size(), std::size_t(1));
  const Vec3 pinned = pointOf(source_, values["pins"][0]);
  QVERIFY((pointOf(pulled, values["pins"][0]) - pinned).norm() < 1e-9);
  QVERIFY(std::abs(pinned.z() - 28) < 0.5);
  std::vector<Vec3> ways;
  for (const Value& each : values["pulls"]) {
    const Vec3 to = vectorOf(each["to"]), start = pointOf(source_, each);
    ways.push_back(to - start);
    QVERIFY((pointOf(pulled, each) - to).norm() < 1e-9);
  }
  QVERIFY(ways[0].norm() > 1);
  QVERIFY((ways[0] - ways[1]).norm() < 1e-9);

  // Taken at one of its places again, the other one still goes along.
  const Vec3 tip = pointOf(pulled, values["pulls"][1]);
  drag(screenOf(tip), screenOf(tip) + QPoint(-20, 0));
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Value again = valuesOf("sweep.pull");
  QCOMPARE(again["pins"], values["pins"]);
  const Vec3 first = vectorOf(again["pulls"][0]["to"]) - vectorOf(values["pulls"][0]["to"]),
             second = vectorOf(again["pulls"][1]["to"]) - vectorOf(values["pulls"][1]["to"]);
  QVERIFY(first.norm() > 0.5);
  QVERIFY((first - second).norm() < 1e-9);
}

void SweepGoalWindowTest::chosenPlacesAreForgotten() {
  openSample("cylinder.json");
  const Document before = document();
  const QPoint at = onTheSide();
  clickWithShift(at);
  hover(at);
  QVERIFY2(hint().contains(QStringLiteral("chosen: 1, pinned: 0")), qPrintable(hint()));
  key(Qt::Key_P);  // one of both
  QVERIFY2(hint().contains(QStringLiteral("chosen: 0, pinned: 1")), qPrintable(hint()));
  key(Qt::Key_P);
  QVERIFY2(hint().contains(QStringLiteral("P: pin it")), qPrintable(hint()));
  clickWithShift(at);
  key(Qt::Key_Escape);
  QVERIFY2(hint().contains(QStringLiteral("P: pin it")), qPrintable(hint()));
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

/// Over the plane through the axis and the seam, far from which the place lies.
void SweepGoalWindowTest::aMirroredPullIsMirrored() {
  openSample("cylinder.json");
  const Vec3 eye = window_->view().camera().turn().toCamera();
  const double azimuth = std::atan2(eye.y(), eye.x()) - 0.5;
  const QPoint from = screenOf(Vec3(10 * std::cos(azimuth), 10 * std::sin(azimuth), 21));
  hover(from);
  key(Qt::Key_M);
  QVERIFY2(hint().contains(QStringLiteral("mirrored")), qPrintable(hint()));
  drag(from, from + QPoint(-30, -5));
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Value values = valuesOf("sweep.pull");
  QVERIFY(values["mirror"].get<bool>());
  const Value& record = values["pulls"][0];
  const Motion &before = motionOf(source_), &after = motionOf(only("sweep.pull").id);
  const auto [first, last] = after.domainU();
  const double u = record["u"].get<double>(), v = record["v"].get<double>();
  const Vec3 target = vectorOf(record["to"]), seam = PlaceOfMotion(before, first, v).x;
  QVERIFY((PlaceOfMotion(after, u, v).x - target).norm() < 1e-10);
  const Vec3 across = Vec3::UnitZ().cross(seam).normalized();
  const Vec3 image = PlaceOfMotion(after, first + last - u, v).x;
  QVERIFY((image - (target - 2 * target.dot(across) * across)).norm() < 1e-10);
}

BLOSSOM_WINDOW_TEST(SweepGoalWindowTest)
#include "sweep_goal_window_test.moc"
