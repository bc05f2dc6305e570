#include <cmath>

#include "support/sweep_formulas.h"
#include "sweep_fixture.h"
#include "ui/tree/document_tree.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// Twists by hand, and their axis turned by the ball at its end, through the real window.
class SweepAxisWindowTest : public SweepFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void aTwistTurnsByTheAngleShown();
  void theBallTakesTheAxisAlong();
  void withShiftTheAxisHasAName();
  void escapeLeavesTheAxis();
  void anAngleIsTypedAtTheBall();
  void theSelectedTwistShowsItsAxis();

 private:
  static constexpr double ballPixels = 90;

  /// A twist about the arm to a place of the cylinder; twisting goes on.
  void twistTheCylinder();
  [[nodiscard]] Vec3 axisOfTwist() const { return vectorOf(only("sweep.twist").parameters["axis"]).normalized(); }
  [[nodiscard]] Vec3 centreOfTwist() const {
    return {0, 0, 40 * only("sweep.twist").parameters["places"][0]["v"].get<double>()};
  }
  [[nodiscard]] QPoint ballOf(const Vec3& axis) const {
    return screenOf(centreOfTwist() + ballPixels * window_->view().camera().millimetresPerPixel() * axis);
  }
};

void SweepAxisWindowTest::twistTheCylinder() {
  openSample("cylinder.json");
  const QPoint place = onTheSide();
  hover(place);
  key(Qt::Key_W);
  key(Qt::Key_A);
  drag(place, place + QPoint(30, 0));
  QCOMPARE(all("sweep.twist").size(), std::size_t(1));
}

void SweepAxisWindowTest::aTwistTurnsByTheAngleShown() {
  openSample("cylinder.json");
  const Motion before = motionOf(source_);
  const QPoint from = onTheSide(), to = from + QPoint(50, 8);
  hover(from);
  key(Qt::Key_W);
  QVERIFY2(hint().startsWith(QStringLiteral("Drag to twist")), qPrintable(hint()));
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, to);
  const QString shown = hint();
  mouse(QEvent::MouseButtonRelease, to);
  waitUntilComputed();
  const Feature& twist = only("sweep.twist");
  QVERIFY(all("sweep.pull").empty());
  const double angle = twist.parameters["angle"].get<double>();
  QVERIFY(std::abs(angle) > 5);
  QVERIFY2(shown.contains(QString::number(angle, 'f', 1)), qPrintable(shown));
  const Vec3 axis = vectorOf(twist.parameters["axis"]);
  QVERIFY((axis - Vec3::UnitZ()).norm() < 1e-12);  // the tangent of the trajectory
  const Value& place = twist.parameters["places"][0];
  const PlaceOfMotion at(before, place["u"].get<double>(), place["v"].get<double>());
  const double off = poleDifference(twistedBy(before, at, axis, angle), motionOf(twist.id));
  QVERIFY2(off < 1e-12, qPrintable(QString::number(off)));

  // The tool goes on twisting; the same place is the same twist.
  const QPoint again = screenOf(PlaceOfMotion(motionOf(twist.id), place["u"].get<double>(), at.v).x);
  drag(again, again - QPoint(30, 0));
  QCOMPARE(all("sweep.twist").size(), std::size_t(1));
  QVERIFY(std::abs(only("sweep.twist").parameters["angle"].get<double>() - angle) > 5);
  hover(again);
  key(Qt::Key_A);
  QVERIFY2(hint().contains(QStringLiteral("arm")), qPrintable(hint()));
}

void SweepAxisWindowTest::theBallTakesTheAxisAlong() {
  twistTheCylinder();
  const Document before = document();
  const Value earlier = only("sweep.twist").parameters;
  const Motion motion = motionOf(source_);
  const QPoint ball = ballOf(axisOfTwist()), to = ball + QPoint(14, -25);
  hover(ball, QStringLiteral("Drag to turn the axis of this twist"));
  mouse(QEvent::MouseButtonPress, ball);
  mouse(QEvent::MouseMove, ball + QPoint(8, -12));
  mouse(QEvent::MouseMove, to);
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to twist about this axis")), qPrintable(hint()));
  QVERIFY(window_->page().tool()->standIn());
  keepPictures("twist-axis", to);
  mouse(QEvent::MouseButtonRelease, to);
  waitUntilComputed();
  QVERIFY2((ballOf(axisOfTwist()) - to).manhattanLength() <= 2, qPrintable(hint()));
  Value changed = only("sweep.twist").parameters;
  const Value& place = changed["places"][0];
  const PlaceOfMotion at(motion, place["u"].get<double>(), place["v"].get<double>());
  const Motion wanted = twistedBy(motion, at, axisOfTwist(), changed["angle"].get<double>());
  QVERIFY(poleDifference(wanted, motionOf(only("sweep.twist").id)) < 1e-12);
  changed["axis"] = earlier["axis"];
  QCOMPARE(changed, earlier);  // and nothing else of it
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

void SweepAxisWindowTest::withShiftTheAxisHasAName() {
  twistTheCylinder();
  const QPoint ball = ballOf(axisOfTwist()), nearZ = ballOf(Vec3(0.1, -0.1, 1).normalized());
  hover(ball, QStringLiteral("Drag to turn the axis of this twist"));
  drag(ball, nearZ, Qt::ShiftModifier);
  QVERIFY((axisOfTwist() - Vec3::UnitZ()).norm() < 1e-12);
}

void SweepAxisWindowTest::escapeLeavesTheAxis() {
  twistTheCylinder();
  const Document before = document();
  const QPoint ball = ballOf(axisOfTwist());
  hover(ball, QStringLiteral("Drag to turn the axis of this twist"));
  mouse(QEvent::MouseButtonPress, ball);
  mouse(QEvent::MouseMove, ball + QPoint(20, -20));
  key(Qt::Key_Escape);
  mouse(QEvent::MouseButtonRelease, ball + QPoint(20, -20));
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

/// Also when the ball came back to the axis that it had, by Shift: then the angle alone is another one.
void SweepAxisWindowTest::anAngleIsTypedAtTheBall() {
  twistTheCylinder();
  const Value before = only("sweep.twist").parameters;
  const auto type = [&](const char* angle) {
    key(Qt::Key_Return);
    QTest::keyClicks(&window_->view(), QString::fromLatin1(angle));
    key(Qt::Key_Return);
  };
  const QPoint ball = ballOf(axisOfTwist());
  hover(ball, QStringLiteral("Drag to turn the axis of this twist"));
  type("33");
  waitUntilComputed();
  Value changed = only("sweep.twist").parameters;
  QCOMPARE(changed["angle"].get<double>(), 33.0);
  changed["angle"] = before["angle"];
  QCOMPARE(changed, before);

  hover(ball, QStringLiteral("Drag to turn the axis of this twist"));
  mouse(QEvent::MouseButtonPress, ball);
  mouse(QEvent::MouseMove, ball + QPoint(9, -9), Qt::ShiftModifier);
  mouse(QEvent::MouseMove, ball + QPoint(2, 1), Qt::ShiftModifier);
  type("44");
  mouse(QEvent::MouseButtonRelease, ball);
  waitUntilComputed();
  changed = only("sweep.twist").parameters;
  QCOMPARE(changed["angle"].get<double>(), 44.0);
  QVERIFY((vectorOf(changed["axis"]) - vectorOf(before["axis"])).norm() < 1e-12);
}

/// Also where pulls follow it, and places are pulled.
void SweepAxisWindowTest::theSelectedTwistShowsItsAxis() {
  twistTheCylinder();
  const QPoint above = onTheSide() - QPoint(0, 50);
  hover(above);
  key(Qt::Key_W);
  drag(above, above + QPoint(25, -5));
  const Value pull = only("sweep.pull").parameters;
  const QPoint ball = ballOf(axisOfTwist());
  window_->tree().select(only("sweep.twist").id);
  hover(ball, QStringLiteral("Drag to turn the axis of this twist"));
  drag(ball, ball + QPoint(10, -20));
  QVERIFY((ballOf(axisOfTwist()) - ball - QPoint(10, -20)).manhattanLength() <= 2);
  QCOMPARE(only("sweep.pull").parameters, pull);
}

BLOSSOM_WINDOW_TEST(SweepAxisWindowTest)
#include "sweep_axis_window_test.moc"
