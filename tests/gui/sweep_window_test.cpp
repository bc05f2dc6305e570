#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "support/sweep_formulas.h"
#include "sweep_fixture.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// A swept surface is pulled by hand through the real window; the poles that come out are those of the paper's formulas.
class SweepWindowTest : public SweepFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void eachWayAloneMovesItsPolesByTheFormula_data();
  void eachWayAloneMovesItsPolesByTheFormula();
  void turningAndScalingTogetherArrive();
  void sharesAreSetByShiftAndTheWheel();
  void theSamePlaceIsTheSamePull();
  void thereAndBackChangesNothing();
  void pullsChangePlacesInTheTree();
  void aPinnedPlaceIsNotPulled();
  void fourCopiesMakeFourEqualBumps();
  void whatCannotBeReachedIsSaidAndNotKept();
  void anOpenSurfaceIsPulledAtAnEditThatIsSelected();
};

void SweepWindowTest::eachWayAloneMovesItsPolesByTheFormula_data() {
  QTest::addColumn<int>("key");
  QTest::newRow("translate") << static_cast<int>(Qt::Key_T);
  QTest::newRow("scale") << static_cast<int>(Qt::Key_S);
  QTest::newRow("rotate") << static_cast<int>(Qt::Key_R);
}

void SweepWindowTest::eachWayAloneMovesItsPolesByTheFormula() {
  QFETCH(int, key);
  openSample("cylinder.json");
  const Motion before = motionOf(source_);
  const Surface swept = surfaceOf(sweep_);
  const QPoint from = onTheSide(), to = from + QPoint(45, -25);
  hover(from);
  this->key(static_cast<Qt::Key>(key));
  drag(from, to);

  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Feature& pull = only("sweep.pull");
  QCOMPARE(pull.inputs, std::vector<FeatureId>{source_});
  QCOMPARE(document().at(sweep_).inputs, std::vector<FeatureId>{pull.id});
  QCOMPARE(pull.parameters["translate"].get<double>(), key == Qt::Key_T ? 1.0 : 0.0);
  QCOMPARE(pull.parameters["rotate"].get<double>(), key == Qt::Key_R ? 1.0 : 0.0);
  QCOMPARE(pull.parameters["scale"].get<double>(), key == Qt::Key_S ? 1.0 : 0.0);
  const Value& record = pull.parameters["pulls"][0];
  const Vec3 target = vectorOf(record["to"]);
  const PlaceOfMotion at(before, record["u"].get<double>(), record["v"].get<double>());
  QVERIFY((screenOf(at.x) - from).manhattanLength() <= 2);
  if (key == Qt::Key_T) QVERIFY((screenOf(target) - to).manhattanLength() <= 2);
  QVERIFY((target - at.x).norm() > 1);

  const Motion wanted = key == Qt::Key_T   ? translatedBy(before, at, target)
                        : key == Qt::Key_S ? scaledTo(before, at, target)
                                           : turnedTo(before, at, target);
  const Motion& after = motionOf(pull.id);
  QVERIFY(poleDifference(before, after) > 0.01);
  const double off = poleDifference(wanted, after);
  QVERIFY2(off < 1e-12, qPrintable(QString::number(off)));
  QVERIFY((PlaceOfMotion(after, record["u"].get<double>(), at.v).x - target).norm() < 1e-11);
  // What the way does not touch stays to the last bit.
  if (key != Qt::Key_T) QVERIFY(after.trajectory == before.trajectory);
  if (key != Qt::Key_S) QVERIFY(after.scaling == before.scaling);
  if (key != Qt::Key_R) QVERIFY(after.orientation == before.orientation);

  window_->session().undo();
  waitUntilComputed();
  QVERIFY(all("sweep.pull").empty());
  QVERIFY(motionOf(document().at(sweep_).inputs.front()) == before);
  QVERIFY(surfaceOf(sweep_) == swept);
}

void SweepWindowTest::turningAndScalingTogetherArrive() {
  openSample("cylinder.json");
  const Motion before = motionOf(source_);
  const QPoint from = onTheSide(), to = from + QPoint(60, -40);
  drag(from, to);
  const Value& record = only("sweep.pull").parameters["pulls"][0];
  const Vec3 target = vectorOf(record["to"]);
  const double u = record["u"].get<double>(), v = record["v"].get<double>();
  QVERIFY((screenOf(target) - to).manhattanLength() <= 2);
  const Motion turned = turnedTo(before, PlaceOfMotion(before, u, v), target);
  const double off = poleDifference(scaledTo(turned, PlaceOfMotion(turned, u, v), target), motionOf(only("sweep.pull").id));
  QVERIFY2(off < 1e-12, qPrintable(QString::number(off)));

  // Along the normal with Shift: away from the axis, at the same height.
  window_->session().undo();
  waitUntilComputed();
  drag(from, to, Qt::ShiftModifier);
  const Value& straight = only("sweep.pull").parameters["pulls"][0];
  const Vec3 end = vectorOf(straight["to"]), start = PlaceOfMotion(before, u, v).x;
  QVERIFY((end - start).norm() > 1);
  QVERIFY((end - start).normalized().cross(Vec3(start.x(), start.y(), 0).normalized()).norm() < 1e-9);
}

void SweepWindowTest::sharesAreSetByShiftAndTheWheel() {
  openSample("cylinder.json");
  const Motion before = motionOf(source_);
  const QPoint from = onTheSide(), to = from + QPoint(60, -40);
  const auto turnWheel = [&](const QPoint& at, int notches, Qt::KeyboardModifiers modifiers) {
    QWheelEvent event(at, window_->view().mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&window_->view(), &event);
  };
  const double scale = window_->view().camera().millimetresPerPixel();
  hover(from);
  QTest::keyClick(&window_->view(), Qt::Key_T, Qt::ShiftModifier);
  QVERIFY2(hint().contains(QStringLiteral("by moving 50 %, turning, scaling")), qPrintable(hint()));
  turnWheel(from, -2, Qt::ShiftModifier);
  QVERIFY2(hint().contains(QStringLiteral("by moving 30 %, turning, scaling")), qPrintable(hint()));
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, to);
  turnWheel(to, 1, {});
  QVERIFY2(hint().contains(QStringLiteral("by moving 40 %")), qPrintable(hint()));
  QCOMPARE(window_->view().camera().millimetresPerPixel(), scale);
  mouse(QEvent::MouseButtonRelease, to);
  waitUntilComputed();

  const Feature& pull = only("sweep.pull");
  QCOMPARE(pull.parameters["translate"].get<double>(), 0.4);
  QCOMPARE(pull.parameters["rotate"].get<double>(), 1.0);
  QCOMPARE(pull.parameters["scale"].get<double>(), 1.0);
  const Value& record = pull.parameters["pulls"][0];
  const Vec3 target = vectorOf(record["to"]);
  QVERIFY((screenOf(target) - to).manhattanLength() <= 2);
  const double u = record["u"].get<double>(), v = record["v"].get<double>();
  const PlaceOfMotion at(before, u, v);
  const Motion moved = translatedBy(before, at, at.x + 0.4 * (target - at.x));
  const Motion turned = turnedTo(moved, PlaceOfMotion(moved, u, v), target);
  const double off = poleDifference(scaledTo(turned, PlaceOfMotion(turned, u, v), target), motionOf(pull.id));
  QVERIFY2(off < 1e-11, qPrintable(QString::number(off)));

  // Without Shift, the wheel is for the camera.
  hover(screenOf(target));
  turnWheel(screenOf(target), 1, {});
  QVERIFY(window_->view().camera().millimetresPerPixel() < scale);
}

void SweepWindowTest::theSamePlaceIsTheSamePull() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  drag(from, from + QPoint(60, 0));
  const Value first = only("sweep.pull").parameters["pulls"];
  const Vec3 tip = vectorOf(first[0]["to"]);
  drag(screenOf(tip), screenOf(tip) + QPoint(10, -50));
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Value second = only("sweep.pull").parameters["pulls"];
  QCOMPARE(second[0]["u"], first[0]["u"]);
  QCOMPARE(second[0]["v"], first[0]["v"]);
  QVERIFY((vectorOf(second[0]["to"]) - tip).norm() > 1);

  // Another way is another pull, after the first one, at exactly the same place.
  const Vec3 now = vectorOf(second[0]["to"]);
  hover(screenOf(now));
  key(Qt::Key_T);
  drag(screenOf(now), screenOf(now) + QPoint(0, 30));
  QCOMPARE(all("sweep.pull").size(), std::size_t(2));
  const Feature& last = document().at(document().at(sweep_).inputs.front());
  QCOMPARE(document().at(last.inputs.front()).inputs, std::vector<FeatureId>{source_});
  QCOMPARE(last.parameters["pulls"][0]["u"], first[0]["u"]);
}

void SweepWindowTest::thereAndBackChangesNothing() {
  openSample("cylinder.json");
  const Document before = document();
  const QPoint from = onTheSide();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  for (const int x : {10, 40, 80, 40, 10, 0}) mouse(QEvent::MouseMove, from + QPoint(x, -x / 2));
  mouse(QEvent::MouseButtonRelease, from);
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));

  // By way of somewhere else the same place makes the same pull: nothing drifts.
  drag(from, from + QPoint(48, -24));
  const Value straight = only("sweep.pull").parameters;
  window_->session().undo();
  waitUntilComputed();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  for (const int x : {90, -60, 30, 120, 48}) mouse(QEvent::MouseMove, from + QPoint(x, -x / 2));
  mouse(QEvent::MouseButtonRelease, from + QPoint(48, -24));
  waitUntilComputed();
  QCOMPARE(only("sweep.pull").parameters, straight);
}

/// The later one stands above: up in the tree is on in the document, and what is seen moves as the key says.
void SweepWindowTest::pullsChangePlacesInTheTree() {
  openSample("cylinder.json");
  for (const int by : {-60, 60}) {
    const QPoint from = onTheSide() + QPoint(0, by / 3);
    drag(from, from + QPoint(45, by));
    waitUntilComputed();
  }
  const std::vector<FeatureId> pulls = all("sweep.pull");
  QCOMPARE(pulls.size(), std::size_t(2));
  const FeatureId &first = pulls[0], &second = pulls[1];
  QCOMPARE(document().at(second).inputs, std::vector<FeatureId>{first});
  DocumentTree& tree = window_->tree();
  const auto rowOf = [&](const FeatureId& id) {
    for (int row = 0; row < tree.model()->rowCount(); ++row)
      if (tree.model()->index(row, 0).data(DocumentModel::IdRole).toString().toStdString() == id) return row;
    return -1;
  };
  tree.select(first);
  QVERIFY(rowOf(second) < rowOf(first));
  tree.stepSelected(-1);
  waitUntilComputed();
  QCOMPARE(document().at(first).inputs, std::vector<FeatureId>{second});
  QCOMPARE(document().at(sweep_).inputs.front(), first);
  QVERIFY(rowOf(first) < rowOf(second));
  QCOMPARE(tree.selected(), std::vector<FeatureId>{first});
  tree.stepSelected(1);
  waitUntilComputed();
  QCOMPARE(document().at(second).inputs, std::vector<FeatureId>{first});
  QVERIFY(rowOf(second) < rowOf(first));
}

/// What its pins hold does not become a pull that moves nothing.
void SweepWindowTest::aPinnedPlaceIsNotPulled() {
  openSample("cylinder.json");
  const Document before = document();
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_S);
  key(Qt::Key_P);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(40, 0));
  QVERIFY2(hint().startsWith(QStringLiteral("Nothing will be changed here")), qPrintable(hint()));
  mouse(QEvent::MouseButtonRelease, from + QPoint(40, 0));
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

void SweepWindowTest::fourCopiesMakeFourEqualBumps() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_4);
  QVERIFY2(hint().contains(QStringLiteral("4 copies")), qPrintable(hint()));
  drag(from, from + QPoint(60, -10));
  const Feature& pull = only("sweep.pull");
  QCOMPARE(pull.parameters["fold"].get<int>(), 4);
  const Value& record = pull.parameters["pulls"][0];
  const Motion& after = motionOf(pull.id);
  const double u = record["u"].get<double>(), v = record["v"].get<double>();
  const Vec3 target = vectorOf(record["to"]);
  const Eigen::Matrix3d quarter = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()).toRotationMatrix();
  Vec3 wanted = target;
  for (int k = 0; k < 4; ++k) {
    const double at = std::fmod(u + k / 4.0, 1.0);
    const double off = (PlaceOfMotion(after, at, v).x - wanted).norm();
    QVERIFY2(off < 1e-10, qPrintable(QString::number(off)));
    // Between two bumps the surface bulges least, and everywhere alike.
    QVERIFY(PlaceOfMotion(after, std::fmod(at + 0.125, 1.0), v).x.head<2>().norm() < target.head<2>().norm());
    wanted = quarter * wanted;
  }
}

void SweepWindowTest::whatCannotBeReachedIsSaidAndNotKept() {
  openSample("cylinder.json");
  const Document before = document();
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_3);  // eight rows cannot be parted in three
  QVERIFY2(hint().contains(QStringLiteral("rows")), qPrintable(hint()));
  QVERIFY2(!hint().contains(QStringLiteral(". ·")), qPrintable(hint()));
  QVERIFY2(hint().endsWith(QStringLiteral("1: no copies")), qPrintable(hint()));
  drag(from, from + QPoint(50, 0));
  QVERIFY(std::ranges::equal(document().features(), before.features()));

  hover(from);
  key(Qt::Key_4);
  key(Qt::Key_T);  // one trajectory cannot go four ways
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(50, 0));
  QVERIFY2(hint().startsWith(QStringLiteral("Nothing will be changed here")), qPrintable(hint()));
  QVERIFY2(hint().contains(QStringLiteral("copies of the place")), qPrintable(hint()));
  mouse(QEvent::MouseButtonRelease, from + QPoint(50, 0));
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));

  hover(from);
  key(Qt::Key_1);
  drag(from, from + QPoint(50, 0));
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
}

/// An edit stays selected while more are added after it; what is seen is what is pulled.
void SweepWindowTest::anOpenSurfaceIsPulledAtAnEditThatIsSelected() {
  openSample("helicoid.json");
  const Motion before = motionOf(source_);
  window_->view().lookFrom(QStringLiteral("top"), false);
  window_->view().fit(false);
  const QPoint from = screenOf(PlaceOfMotion(before, 0.9, 0.97).x);
  drag(from, from + QPoint(20, 10));
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const FeatureId pulled = all("sweep.pull").front();
  window_->tree().select(pulled);
  window_->view().setFocus();
  const QPoint other = screenOf(PlaceOfMotion(before, 0.9, 0.8).x);
  drag(other, other + QPoint(15, 15));
  QCOMPARE(all("sweep.pull").size(), std::size_t(2));
  const FeatureId last = document().at(sweep_).inputs.front();
  QCOMPARE(document().at(last).inputs, std::vector<FeatureId>{pulled});
  QVERIFY(!window_->session().view(sweep_)->result->error);
}

BLOSSOM_WINDOW_TEST(SweepWindowTest)
#include "sweep_window_test.moc"
