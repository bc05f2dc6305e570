#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "support/sweep_formulas.h"
#include "sweep_fixture.h"
#include "ui/tools/view_props.h"
#include "ui/tree/document_tree.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// The factors of a motion are edited pole by pole through the real window: handles in space, the net on its card, numbers.
class SweepFactorsWindowTest : public SweepFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void aPoleOfTheTrajectoryGoesWithTheMouse();
  void anAxisKeepsThePoleOnALine();
  void aPoleOfTheScalingIsDraggedInTheNet();
  void severalPolesAndOneAxis();
  void escapeTakesADragBack();
  void orientationTurnsByNumbersAndByTheBall();
  void weightsAreTyped();
  void escapeTakesTypingBack();
  void theCardIsDraggedOutOfTheWay();
  void aClickInTheMarginInsertsAKnot();
  void theFactorsOpenTheirEditor();
  void whatIsNoMotionIsRefused();
  void theEditorIsSeen();

 private:
  void openWithTool(const char* name);
  void startTool();
  void choose(const char* factor);
  /// Waits until the motion shown is the newest one.
  void waitUntilEditable();
  void dragView(const QPoint& from, const QPoint& to);
  void dragIn(QWidget*, const QPointF& from, const QPointF& by, bool letGo = true);
  void clickIn(QWidget*, const QPointF& at, Qt::KeyboardModifiers = {});
  void type(int field, const char* text);
  [[nodiscard]] QPointF poleAt(int row, int column) const;
  [[nodiscard]] QPointF knotAt(bool alongU, double knot) const;
  template <class T>
  [[nodiscard]] T* part(const char* name) const {
    return window_->view().findChild<T*>(QLatin1String(name));
  }
  [[nodiscard]] QWidget* net() const { return part<QWidget>("factorNet"); }
  [[nodiscard]] const Motion& now() const { return motionOf(document().at(sweep_).inputs.front()); }
};

void SweepFactorsWindowTest::openWithTool(const char* name) {
  openSample(name);
  startTool();
}

void SweepFactorsWindowTest::startTool() {
  run("feature.sweep.factors");
  QVERIFY2(window_->errors().isHidden(), qPrintable(window_->errors().message()));
  QVERIFY(net());
  waitUntilEditable();
}

void SweepFactorsWindowTest::waitUntilEditable() {
  waitUntilComputed();
  QTRY_VERIFY_WITH_TIMEOUT(net() && net()->property("editable").toBool(), 60000);
}

void SweepFactorsWindowTest::choose(const char* factor) {
  for (auto* button : window_->view().findChildren<QToolButton*>())
    if (button->text() == QLatin1String(factor)) return button->click();
  QFAIL(factor);
}

void SweepFactorsWindowTest::dragView(const QPoint& from, const QPoint& to) {
  drag(from, to);
  waitUntilEditable();
}

void SweepFactorsWindowTest::dragIn(QWidget* widget, const QPointF& from, const QPointF& by, bool letGo) {
  mouseIn(widget, QEvent::MouseButtonPress, from);
  for (int k = 1; k <= 6; ++k) mouseIn(widget, QEvent::MouseMove, from + by * k / 6);
  mouseIn(widget, QEvent::MouseMove, from + by);
  if (letGo) mouseIn(widget, QEvent::MouseButtonRelease, from + by);
  waitUntilComputed();
}

void SweepFactorsWindowTest::clickIn(QWidget* widget, const QPointF& at, Qt::KeyboardModifiers modifiers) {
  mouseIn(widget, QEvent::MouseButtonPress, at, modifiers);
  mouseIn(widget, QEvent::MouseButtonRelease, at, modifiers);
  waitUntilComputed();
}

void SweepFactorsWindowTest::type(int field, const char* text) {
  auto* const line = part<QLineEdit>(qPrintable(QStringLiteral("factorField%1").arg(field)));
  QVERIFY(line);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QLatin1String(text));
  QTest::keyClick(line, Qt::Key_Return);
  waitUntilComputed();
}

QPointF SweepFactorsWindowTest::poleAt(int row, int column) const {
  QPointF at;
  QMetaObject::invokeMethod(net(), "polePosition", Q_RETURN_ARG(QPointF, at), Q_ARG(int, row), Q_ARG(int, column));
  return at;
}

QPointF SweepFactorsWindowTest::knotAt(bool alongU, double knot) const {
  QPointF at;
  QMetaObject::invokeMethod(net(), "knotPosition", Q_RETURN_ARG(QPointF, at), Q_ARG(bool, alongU), Q_ARG(double, knot));
  return at;
}

void SweepFactorsWindowTest::aPoleOfTheTrajectoryGoesWithTheMouse() {
  openWithTool("cylinder.json");
  choose("Trajectory");
  const Motion before = now();
  const auto swept = window_->session().view(sweep_)->result->evaluated.shape;
  constexpr std::size_t index = 2;
  const Vec3 pole = before.trajectory.poles[index].head<3>() / before.trajectory.poles[index][3];
  const QPoint from = screenOf(pole), to = from + QPoint(50, -12);
  hover(from, QStringLiteral("Drag to move the pole"));
  dragView(from, to);

  const Feature& factors = only("sweep.factors");
  QCOMPARE(factors.inputs, std::vector<FeatureId>{source_});
  QCOMPARE(document().at(sweep_).inputs, std::vector<FeatureId>{factors.id});
  QCOMPARE(factors.parameters["trajectory"].size(), std::size_t(1));
  const Value& change = factors.parameters["trajectory"][0];
  QCOMPARE(change["pole"].get<std::size_t>(), index);
  const Vec3 by = vectorOf(change["vector"]);
  QVERIFY((screenOf(pole + by) - to).manhattanLength() <= 2);
  QVERIFY(by.norm() > 1);
  // In the plane that faces the viewer there.
  const Vec3 sight = window_->view().camera().rayThrough(from).direction;
  QVERIFY(std::abs(by.normalized().dot(sight)) < 1e-6);
  Motion wanted = before;
  wanted.trajectory.poles[index].head<3>() += before.trajectory.poles[index][3] * by;
  const double off = poleDifference(wanted, now());
  QVERIFY2(off < 1e-12, qPrintable(QString::number(off)));
  QVERIFY(now().orientation == before.orientation && now().scaling == before.scaling);

  window_->session().undo();
  waitUntilComputed();
  QVERIFY(all("sweep.factors").empty());
  QVERIFY(now() == before);
  QVERIFY(*window_->session().view(sweep_)->result->evaluated.shape.get<Surface>() == *swept.get<Surface>());
}

void SweepFactorsWindowTest::anAxisKeepsThePoleOnALine() {
  openWithTool("cylinder.json");
  choose("Trajectory");
  const Motion before = now();
  const Vec4& h = before.trajectory.poles[1];
  const Vec3 pole = h.head<3>() / h[3];
  clickIn(net(), poleAt(0, 1));
  const double pixel = window_->view().camera().millimetresPerPixel();
  const QPoint from = screenOf(pole + 45 * pixel * Vec3::UnitX());
  hover(from, QStringLiteral("Drag to move the pole along x"));
  dragView(from, screenOf(pole + 95 * pixel * Vec3::UnitX()));
  const Vec3 by = vectorOf(only("sweep.factors").parameters["trajectory"][0]["vector"]);
  QVERIFY(by.y() == 0 && by.z() == 0);
  QVERIFY2(std::abs(by.x() - 50 * pixel) < 4 * pixel, qPrintable(QString::number(by.x() / pixel)));

  // Dragged again it is the same change, further on.
  hover(screenOf(pole + by + 45 * pixel * Vec3::UnitX()), QStringLiteral("Drag to move the pole along x"));
  const QPoint again = screenOf(pole + by + 45 * pixel * Vec3::UnitX());
  dragView(again, screenOf(pole + by + 65 * pixel * Vec3::UnitX()));
  QCOMPARE(all("sweep.factors").size(), std::size_t(1));
  QCOMPARE(only("sweep.factors").parameters["trajectory"].size(), std::size_t(1));
  QVERIFY(vectorOf(only("sweep.factors").parameters["trajectory"][0]["vector"]).x() > by.x() + 10 * pixel);
}

void SweepFactorsWindowTest::aPoleOfTheScalingIsDraggedInTheNet() {
  openWithTool("cylinder.json");
  const Motion before = now();
  constexpr int row = 3, column = 2;
  dragIn(net(), poleAt(row, column), {4, -70});
  waitUntilEditable();
  const Value& change = only("sweep.factors").parameters["scaling"][0];
  QCOMPARE(change["row"].get<int>(), row);
  QCOMPARE(change["column"].get<int>(), column);
  QCOMPARE(vectorOf(change["factors"]), Vec3(2, 2, 2));  // doubled every 70 pixels
  Motion wanted = before;
  for (std::size_t i = row; i < wanted.scaling.countU(); i += wanted.scaling.countU() - 3)
    wanted.scaling.pole(i, column).head<3>() *= 2;
  QVERIFY(poleDifference(wanted, now()) < 1e-12);
  QVERIFY(now().orientation == before.orientation && now().trajectory == before.trajectory);

  // The same pole again is the same change; each drag is one step of undo.
  dragIn(net(), poleAt(row, column), {0, -70});
  QCOMPARE(vectorOf(only("sweep.factors").parameters["scaling"][0]["factors"]), Vec3(4, 4, 4));
  QCOMPARE(only("sweep.factors").parameters["scaling"].size(), std::size_t(1));
  window_->session().undo();
  waitUntilComputed();
  QCOMPARE(vectorOf(only("sweep.factors").parameters["scaling"][0]["factors"]), Vec3(2, 2, 2));
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(all("sweep.factors").empty());
  QVERIFY(now() == before);
}

void SweepFactorsWindowTest::severalPolesAndOneAxis() {
  openWithTool("cylinder.json");
  const Motion before = now();
  clickIn(net(), poleAt(1, 1));
  clickIn(net(), poleAt(5, 2), Qt::ControlModifier);
  choose("x");  // no longer
  choose("z");
  dragIn(net(), poleAt(5, 2), {0, 70});
  QCOMPARE(only("sweep.factors").parameters["scaling"].size(), std::size_t(2));
  for (const Value& change : only("sweep.factors").parameters["scaling"])
    QCOMPARE(vectorOf(change["factors"]), Vec3(1, 0.5, 1));
  Motion wanted = before;
  for (const auto& [row, column] : {std::pair<std::size_t, std::size_t>{1, 1}, {5, 2}})
    for (std::size_t i = row; i < wanted.scaling.countU(); i += wanted.scaling.countU() - 3)
      wanted.scaling.pole(i, column)[1] *= 0.5;
  QVERIFY(poleDifference(wanted, now()) < 1e-12);
}

void SweepFactorsWindowTest::escapeTakesADragBack() {
  openWithTool("cylinder.json");
  const Document before = document();
  const auto same = [&] { return std::ranges::equal(document().features(), before.features()); };
  dragIn(net(), poleAt(2, 2), {0, -40}, false);
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to scale by")), qPrintable(hint()));
  QTest::keyClick(net(), Qt::Key_Escape);
  mouseIn(net(), QEvent::MouseButtonRelease, poleAt(2, 2) + QPointF(0, -40));
  waitUntilComputed();
  QVERIFY(same());
  QVERIFY(net());  // the tool goes on

  choose("Trajectory");
  const Vec4& h = now().trajectory.poles[2];
  const QPoint from = screenOf(Vec3(h.head<3>() / h[3]));
  hover(from, QStringLiteral("Drag to move the pole"));
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(60, 5));
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to move")), qPrintable(hint()));
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  mouse(QEvent::MouseButtonRelease, from + QPoint(60, 5));
  waitUntilComputed();
  QVERIFY(same());
}

void SweepFactorsWindowTest::orientationTurnsByNumbersAndByTheBall() {
  openWithTool("cylinder.json");
  choose("Orientation");
  const Motion before = now();
  clickIn(net(), poleAt(2, 1));
  type(0, "1");
  type(1, "1");
  type(2, "0");
  type(3, "25");
  for (auto* button : window_->view().findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Turn")) button->click();
  waitUntilComputed();
  const Value change = only("sweep.factors").parameters["orientation"][0];
  QCOMPARE(vectorOf(change["axis"]), Vec3(1, 1, 0));
  QCOMPARE(change["angle"].get<double>(), 25.0);
  const Vec4 q = before.orientation.pole(2, 1);
  const Eigen::Quaterniond dq(Eigen::AngleAxisd(25 * std::numbers::pi / 180, Vec3(1, 1, 0).normalized()));
  const Eigen::Quaterniond wanted = dq * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  const Vec4 is = now().orientation.pole(2, 1);
  QVERIFY((is - Vec4(wanted.w(), wanted.x(), wanted.y(), wanted.z())).norm() < 1e-12);

  // A drag across the ball turns about an axis across the line of sight.
  auto* const ball = part<QWidget>("turnBall");
  QVERIFY(ball);
  waitUntilEditable();
  dragIn(ball, QRectF(ball->rect()).center(), {20, 0});
  QVERIFY(now().orientation.pole(2, 1) != is);
  QCOMPARE(all("sweep.factors").size(), std::size_t(1));
  QVERIFY(std::abs(now().orientation.pole(2, 1).norm() - is.norm()) < 1e-12);
}

void SweepFactorsWindowTest::weightsAreTyped() {
  openWithTool("cylinder.json");
  choose("Trajectory");
  const Motion before = now();
  clickIn(net(), poleAt(0, 1));
  type(3, "3");
  QCOMPARE(only("sweep.factors").parameters["weights"][0]["weight"].get<double>(), 3.0);
  const Vec4 pole = now().trajectory.poles[1], was = before.trajectory.poles[1];
  QCOMPARE(pole[3], 3.0);
  QVERIFY((pole.head<3>() / pole[3] - was.head<3>() / was[3]).norm() < 1e-13);

  waitUntilEditable();
  const Document kept = document();
  type(3, "0");
  const auto* const problem = part<QLabel>("fieldError");
  QVERIFY(problem && problem->isVisible());
  QVERIFY2(problem->text().contains(QStringLiteral("weight would be 0")), qPrintable(problem->text()));
  QVERIFY(std::ranges::equal(document().features(), kept.features()));
  auto* const field = part<QLineEdit>("factorField3");
  QCOMPARE(field->text(), QStringLiteral("0"));  // what was refused stays beside the reason
  clickIn(net(), poleAt(0, 0));
  clickIn(net(), poleAt(0, 1));
  QVERIFY(!problem->isVisible());
  QCOMPARE(field->text(), QStringLiteral("3"));
}

void SweepFactorsWindowTest::escapeTakesTypingBack() {
  openWithTool("cylinder.json");
  choose("Trajectory");
  clickIn(net(), poleAt(0, 1));
  auto* const line = part<QLineEdit>("factorField3");
  const QString before = line->text();
  const Document kept = document();
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("42"));
  QTest::keyClick(line, Qt::Key_Escape);
  QCOMPARE(line->text(), before);
  QVERIFY(net() && window_->page().toolStarted());
  QVERIFY(std::ranges::equal(document().features(), kept.features()));
  QTest::keyClick(line, Qt::Key_Escape);  // nothing is being typed: the tool ends
  QTRY_VERIFY(!net());
}

void SweepFactorsWindowTest::theCardIsDraggedOutOfTheWay() {
  window_->resize(1280, 720);
  openWithTool("cylinder.json");
  auto* const card = part<QFrame>("toolPanel");
  QVERIFY(card);
  const QPoint place = card->pos();
  const auto dragBy = [&](const QPointF& by) {
    mouseIn(card, QEvent::MouseButtonPress, {4, 4});
    mouseIn(card, QEvent::MouseMove, QPointF(4, 4) + by);
    mouseIn(card, QEvent::MouseButtonRelease, {4, 4});  // it has come along
  };
  dragBy({150, 20});
  QCOMPARE(card->pos(), place + QPoint(150, 20));
  dragBy({5000, 0});  // as far as the view goes
  QCOMPARE(card->geometry().right(), window_->view().width() - 1);
  choose("Orientation");  // a wider content leaves it there
  QTRY_COMPARE(card->geometry().right(), window_->view().width() - 1);
  mouseIn(card, QEvent::MouseButtonDblClick, {4, 4});
  QCOMPARE(card->pos(), place);
}

void SweepFactorsWindowTest::aClickInTheMarginInsertsAKnot() {
  openWithTool("cylinder.json");
  const Motion before = now();
  clickIn(net(), knotAt(true, 0.3));
  const Value parameters = only("sweep.refine").parameters;
  QCOMPARE(parameters["factors"].get<std::string>(), std::string("scaling"));
  QVERIFY(std::abs(parameters["u"][0].get<double>() - 0.3) < 0.01);
  QCOMPARE(now().scaling.countU(), before.scaling.countU() + 1);
  QVERIFY(now().orientation == before.orientation && now().trajectory == before.trajectory);
  // The next knot goes into the same feature.
  waitUntilEditable();
  QVERIFY(poleAt(static_cast<int>(now().scaling.countU()) - 4, 0).x() >= 0);
  clickIn(net(), knotAt(false, 0.6));
  QCOMPARE(all("sweep.refine").size(), std::size_t(1));
  QVERIFY(std::abs(only("sweep.refine").parameters["v"][0].get<double>() - 0.6) < 0.01);
  QCOMPARE(now().scaling.countV(), before.scaling.countV() + 1);
}

void SweepFactorsWindowTest::theFactorsOpenTheirEditor() {
  openWithTool("cylinder.json");
  dragIn(net(), poleAt(3, 2), {0, -70});
  waitUntilEditable();
  const FeatureId factors = only("sweep.factors").id;
  window_->page().endTool();
  // Selected, they open their editor by themselves.
  window_->tree().select(factors);
  QTRY_VERIFY(net());
  QVERIFY(!window_->page().toolStarted());
  window_->tree().select(sweep_);
  QTRY_VERIFY(!net());

  // So they do when they are hidden beside the sweep that they go into, as in the samples.
  if (document().at(factors).visible) window_->tree().toggleVisible(factors);
  QVERIFY(!document().at(factors).visible);
  window_->tree().select(factors);
  QTRY_VERIFY(net());
  window_->tree().select(sweep_);
  QTRY_VERIFY(!net());
  window_->tree().toggleVisible(sweep_);  // nothing is seen of it any more
  window_->tree().select(factors);
  waitUntilComputed();
  QVERIFY(!net());
  window_->tree().toggleVisible(sweep_);
  QTRY_VERIFY(net());
  window_->tree().select(sweep_);

  // Its cross closes the card, and does not let it come again.
  window_->tree().select(factors);
  QTRY_VERIFY(net());
  part<QToolButton>("closeCard")->click();
  QTRY_VERIFY(!net());
  QVERIFY(window_->page().selection().empty());
  window_->tree().select(sweep_);
  startTool();
  part<QToolButton>("closeCard")->click();
  QTRY_VERIFY(!net());
  QVERIFY(!window_->page().toolStarted());
  QCOMPARE(window_->page().selection(), std::vector<FeatureId>{sweep_});
}

void SweepFactorsWindowTest::whatIsNoMotionIsRefused() {
  openNewDocument();
  add("modeling.box");
  window_->tree().select(last());
  run("feature.sweep.factors");
  QTRY_VERIFY(!window_->errors().isHidden());
  QVERIFY2(window_->errors().hint().contains(QStringLiteral("Select a sweep")), qPrintable(window_->errors().hint()));
  QVERIFY(!net());
}

void SweepFactorsWindowTest::theEditorIsSeen() {
  window_->resize(1280, 720);
  openWithTool("twisted-tube.json");
  const Look look = Look::dark();
  clickIn(net(), poleAt(2, 2));
  keepPictures("factors-scaling");
  QVERIFY(colored(canvas(), qtColor(look.control)) > 1e-4);
  QVERIFY(colored(canvas(), qtColor(look.made)) > 1e-5);
  dragIn(net(), poleAt(2, 2), {0, -60}, false);
  keepPictures("factors-scaling-drag");
  QVERIFY(colored(canvas(), qtColor(look.made)) > 3e-4);
  QTest::keyClick(net(), Qt::Key_Escape);
  mouseIn(net(), QEvent::MouseButtonRelease, poleAt(2, 2));
  choose("Orientation");
  clickIn(net(), poleAt(1, 2));
  choose("Along u");
  keepPictures("factors-orientation");
  choose("Trajectory");
  clickIn(net(), poleAt(0, 1));
  keepPictures("factors-trajectory");
  choose("Frames");
  keepPictures("factors-frames");
  choose("Frames");
  choose("Iso-curves");
  keepPictures("factors-iso-curves");
}

BLOSSOM_WINDOW_TEST(SweepFactorsWindowTest)
#include "sweep_factors_window_test.moc"
