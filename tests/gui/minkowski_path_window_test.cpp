#include <QDir>
#include <QLabel>
#include <QToolButton>
#include <array>

#include "geometry/planar/planar.h"
#include "geometry/shape/sequence.h"
#include "ui/timeline/playback.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// The path of a morph on its pad, and the legs of its ladder, in the real window.
class MinkowskiPathWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { window_.reset(); }

  void aPathIsDrawnOnThePad();
  void whatIsUndoneMeanwhileEndsTheDrag();
  void draggedBackThereIsNoSequence();
  void theOtherFramesAreSeenMeanwhile();
  void ofMoreShapesThereAreCurves();
  void knotsLeaveNoRoomForAPath();
  void aClickOnALegShowsItsShape();
  void aLegOfShapesThatAreGoneIsForgotten();
  void picturesOfThePad();

 private:
  [[nodiscard]] QWidget* pad() const { return window_->view().findChild<QWidget*>(QStringLiteral("pathPad")); }
  [[nodiscard]] QToolButton* button(const char* name) const {
    return window_->view().findChild<QToolButton*>(QLatin1String(name));
  }
  [[nodiscard]] QString note() const {
    auto* const label = button("ladder")->parentWidget()->findChild<QLabel*>(QStringLiteral("note"));
    return label ? label->text() : QString();
  }
  [[nodiscard]] const Value& parameters() const { return window_->page().document().at(morph_).parameters; }
  [[nodiscard]] Value path() const { return parameters().value("path", Value::array()); }
  [[nodiscard]] QPoint spot(int point, int argument = 0) const;
  void openPad();
  void drag(const QPoint& from, const QPoint& to);
  FeatureId morph_;
};

/// Discs of radius 10, 30 and 20, 60 mm apart; the morph is at 0.5.
void MinkowskiPathWindowTest::init() {
  openNewDocument();
  std::vector<FeatureId> discs;
  const std::array<double, 3> radii{10, 30, 20};
  for (std::size_t k = 0; k < radii.size(); ++k)
    discs.push_back(
        add("modeling.circle", {{"radius", radii[k]}, {"centre", {60.0 * static_cast<double>(k), k == 1 ? 70 : 0, 0}}}));
  morph_ = add("minkowski.morph", {{"t", 0.5}}, discs);
  window_->tree().select(morph_);
  run("view.top");
  window_->view().fitTo({{-90, -90, 0}, {180, 120, 0}}, false);
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  QTRY_VERIFY(window_->view().sharp());
  QTRY_VERIFY(button("path"));
}

QPoint MinkowskiPathWindowTest::spot(int point, int argument) const {
  QPointF at;
  const bool known = QMetaObject::invokeMethod(pad(), "pixelsOf", Qt::DirectConnection, Q_RETURN_ARG(QPointF, at),
                                               Q_ARG(int, point), Q_ARG(int, argument));
  return known ? at.toPoint() : QPoint(-1, -1);
}

void MinkowskiPathWindowTest::openPad() {
  QTest::mouseClick(button("path"), Qt::LeftButton);
  QTRY_VERIFY(pad() && pad()->isVisible());
}

void MinkowskiPathWindowTest::drag(const QPoint& from, const QPoint& to) {
  test::moveMouse(pad(), from);
  QTest::mousePress(pad(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 4; ++i) test::moveMouse(pad(), from + (to - from) * i / 4);
  QTest::mouseRelease(pad(), Qt::LeftButton, {}, to);
  waitUntilComputed();
}

void MinkowskiPathWindowTest::aPathIsDrawnOnThePad() {
  openPad();
  const std::size_t steps = window_->session().history().step();
  const QPoint low = spot(0), high = spot(1), side(high.x() - low.x(), high.y() - low.y());
  // A double click to the left of the diagonal: t1 = 0.2, t2 = 0.9.
  const QPoint between(low.x() + side.x() / 5, low.y() + side.y() * 9 / 10);
  QTest::mouseDClick(pad(), Qt::LeftButton, {}, between);
  waitUntilComputed();
  QCOMPARE(path().size(), std::size_t{3});
  COMPARE_NEAR(path()[1][0].get<double>(), 0.2, 0.02);
  COMPARE_NEAR(path()[1][1].get<double>(), 0.9, 0.02);
  QCOMPARE(path()[0], Value::parse("[0.0,0.0]"));
  QCOMPARE(path()[2], Value::parse("[1.0,1.0]"));
  QCOMPARE(parameters().at("frames"), Value(25));  // a path is the way of a sequence
  QVERIFY(window_->session().history().step() != steps);
  QTRY_COMPARE(window_->page().playback().count(), 25);
  // Frame 13 of 25 is that point: its radius is blended as numbers are.
  const auto result = window_->page().result(morph_);
  const auto* const sequence = result->evaluated.shape.get<Sequence>();
  QVERIFY(sequence);
  const double t1 = path()[1][0].get<double>(), t2 = path()[1][1].get<double>();
  const double radius = 10 * (1 - t1) * (1 - t2) + 30 * (t1 + t2 - 2 * t1 * t2) + 20 * t1 * t2;
  COMPARE_NEAR(area(*sequence->frames[12].get<Region>()), std::numbers::pi * radius * radius, 1e-6);
  // It is dragged, and the drag is one step that can be taken back.
  const Value before = path();
  const QPoint first = spot(0), last = spot(2);  // the card may have become wider
  drag(spot(1), QPoint((first.x() + last.x()) / 2, first.y() + (last.y() - first.y()) * 3 / 10));
  constexpr double pixels = 0.03;  // a few of them, on a pad of some hundred
  COMPARE_NEAR(path()[1][0].get<double>(), 0.5, pixels);
  COMPARE_NEAR(path()[1][1].get<double>(), 0.3, pixels);
  window_->session().undo();
  waitUntilComputed();
  QCOMPARE(path(), before);
  // Esc gives a drag up.
  QTest::mousePress(pad(), Qt::LeftButton, {}, spot(1));
  test::moveMouse(pad(), spot(1) + QPoint(20, 20));
  QVERIFY(path() != before);
  QTest::keyClick(pad(), Qt::Key_Escape);
  QTest::mouseRelease(pad(), Qt::LeftButton, {}, spot(1));
  waitUntilComputed();
  QCOMPARE(path(), before);
  // An arrow key is a hundredth; Delete takes the point out, and the diagonal is no path.
  QTest::mouseClick(pad(), Qt::LeftButton, {}, spot(1));
  QTest::keyClick(pad(), Qt::Key_Right);
  waitUntilComputed();
  COMPARE_NEAR(path()[1][0].get<double>(), before[1][0].get<double>() + 0.01, 1e-9);
  QTest::keyClick(pad(), Qt::Key_Delete);
  waitUntilComputed();
  QVERIFY(path().empty());
  QCOMPARE(window_->page().document().contains(morph_), true);
  // Once more there is nothing to take out, and not the morph either.
  QTest::keyClick(pad(), Qt::Key_Delete);
  QCOMPARE(window_->page().document().contains(morph_), true);
}

void MinkowskiPathWindowTest::whatIsUndoneMeanwhileEndsTheDrag() {
  openPad();
  const QPoint low = spot(0), high = spot(1);
  QTest::mouseDClick(pad(), Qt::LeftButton, {}, QPoint(low.x(), high.y()) + QPoint(20, 20));
  waitUntilComputed();
  const QPoint at = spot(1);
  QTest::mousePress(pad(), Qt::LeftButton, {}, at);
  test::moveMouse(pad(), at + QPoint(20, 20));
  QVERIFY(window_->session().previewing());
  window_->session().undo();
  QVERIFY(path().empty());
  QVERIFY(!window_->session().previewing());
  test::moveMouse(pad(), at + QPoint(30, 20));
  QTest::mouseRelease(pad(), Qt::LeftButton, {}, at + QPoint(30, 20));
  waitUntilComputed();
  QVERIFY(path().empty());
  QVERIFY(!window_->session().previewing());
  QCOMPARE(spot(1), high);  // the pad shows what is there
}

void MinkowskiPathWindowTest::draggedBackThereIsNoSequence() {
  openPad();
  const std::size_t steps = window_->session().history().step();
  const QPoint at = spot(0);
  QTest::mousePress(pad(), Qt::LeftButton, {}, at);
  test::moveMouse(pad(), at + QPoint(30, 0));
  QCOMPARE(parameters().at("frames"), Value(25));
  waitUntilComputed();
  test::moveMouse(pad(), at);
  QTRY_COMPARE(parameters().value("frames", Value(0)), Value(0));
  QTest::mouseRelease(pad(), Qt::LeftButton, {}, at);
  waitUntilComputed();
  QCOMPARE(window_->session().history().step(), steps);
}

void MinkowskiPathWindowTest::theOtherFramesAreSeenMeanwhile() {
  openPad();
  const QPoint low = spot(0), high = spot(1);
  QTest::mouseDClick(pad(), Qt::LeftButton, {}, QPoint(low.x(), high.y()) + QPoint(20, 20));
  waitUntilComputed();
  QVERIFY(!window_->page().playback().onionSkin());
  const QPoint at = spot(1);
  const QImage before = canvas();
  QTest::mousePress(pad(), Qt::LeftButton, {}, at);
  test::moveMouse(pad(), at + QPoint(3, 0));
  test::moveMouse(pad(), at);
  waitUntilComputed();
  QVERIFY(canvas() != before);
  QTest::mouseRelease(pad(), Qt::LeftButton, {}, at);
  test::moveMouse(pad(), QPoint(2, 2));
  QTRY_VERIFY(canvas() == before);
}

void MinkowskiPathWindowTest::ofMoreShapesThereAreCurves() {
  const FeatureId fourth = add("modeling.circle", {{"radius", 15}, {"centre", {180, 70, 0}}});
  Feature morph = window_->page().document().at(morph_);
  morph.inputs.push_back(fourth);
  window_->session().commit(window_->page().document().without(morph_).with(morph), QStringLiteral("Four"));
  waitUntilComputed();
  window_->tree().select(morph_);
  QTRY_VERIFY(button("path"));
  openPad();
  // All three curves lie on the diagonal: the last is in front, and goes up and down only.
  const int bottom = spot(0).y(), height = bottom - spot(1, 2).y();
  drag(spot(0, 2), QPoint(spot(0, 2).x() + 30, bottom - height / 4));
  QCOMPARE(path().size(), std::size_t{2});
  QCOMPARE(path()[0].size(), std::size_t{3});
  COMPARE_NEAR(path()[0][2].get<double>(), 0.25, 0.02);
  QCOMPARE(path()[0][0], Value(0.0));
  QCOMPARE(path()[1], Value::parse("[1.0,1.0,1.0]"));
  // A point that is put in lies where the mouse is, and on the other curves.
  QTest::mouseDClick(pad(), Qt::LeftButton, {}, QPoint((spot(0).x() + spot(1).x()) / 2, bottom - 5));
  waitUntilComputed();
  QCOMPARE(path().size(), std::size_t{3});
  COMPARE_NEAR(path()[1][0].get<double>(), 5.0 / height, 0.02);
  COMPARE_NEAR(path()[1][1].get<double>(), 0.5, 0.02);
  COMPARE_NEAR(path()[1][2].get<double>(), (1 + path()[0][2].get<double>()) / 2, 0.02);
}

void MinkowskiPathWindowTest::knotsLeaveNoRoomForAPath() {
  openPad();
  Feature morph = window_->page().document().at(morph_);
  morph.parameters["degree"] = 1;
  window_->session().commit(window_->page().document().with(morph), QStringLiteral("Degree"));
  waitUntilComputed();
  QTRY_VERIFY(!pad()->isVisible());
  QVERIFY(note().contains(QStringLiteral("no path")));
  window_->session().undo();
  QTRY_VERIFY(pad()->isVisible());
}

/// The first leg of level 1 joins the centres of the first two discs; at 0.5 the shape on it has radius 20.
void MinkowskiPathWindowTest::aClickOnALegShowsItsShape() {
  QTest::mouseClick(button("ladder"), Qt::LeftButton);
  const auto drawn = [this] { return window_->page().tool()->props().size(); };
  QTRY_VERIFY_WITH_TIMEOUT(drawn() >= 12, 60000);
  const std::size_t whole = drawn();
  const Vec3 onLeg(15, 17.5, 0);
  clickAt(onLeg);
  QTRY_VERIFY(note().startsWith(QStringLiteral("Level 1, leg 1: t 0.5")));
  QVERIFY(drawn() > whole);
  QCOMPARE(window_->tree().selected(), std::vector<FeatureId>{morph_});  // not the disc behind it
  clickAt({75, 52.5, 0});
  QTRY_VERIFY(note().startsWith(QStringLiteral("Level 1, leg 2: t 0.5")));
  clickAt({75, 52.5, 0});
  QTRY_VERIFY(note().isEmpty());
}

/// The ladder of four shapes is drawn when only three are left.
void MinkowskiPathWindowTest::aLegOfShapesThatAreGoneIsForgotten() {
  const FeatureId fourth = add("modeling.circle", {{"radius", 15}, {"centre", {180, 70, 0}}});
  const Feature three = window_->page().document().at(morph_);
  Feature four = three;
  four.inputs.push_back(fourth);
  window_->session().commit(window_->page().document().without(morph_).with(four), QStringLiteral("Four"));
  waitUntilComputed();
  window_->tree().select(morph_);
  QTRY_VERIFY(button("ladder"));
  QTest::mouseClick(button("ladder"), Qt::LeftButton);
  const auto drawn = [this] { return window_->page().tool()->props().size(); };
  QTRY_VERIFY_WITH_TIMEOUT(drawn() >= 15, 60000);
  clickAt({135, 17.5, 0});
  QTRY_VERIFY(note().startsWith(QStringLiteral("Level 1, leg 3")));
  window_->session().commit(window_->page().document().with(three), QStringLiteral("Three"));
  QVERIFY(drawn() > 0);
  QVERIFY(!note().startsWith(QStringLiteral("Level")));
  waitUntilComputed();
  QVERIFY(drawn() > 0);
}

/// Kept where BLOSSOM_PICTURES says, to be looked at.
void MinkowskiPathWindowTest::picturesOfThePad() {
  window_->resize(1280, 800);
  openPad();
  const QPoint low = spot(0), high = spot(1);
  QTest::mouseDClick(pad(), Qt::LeftButton, {}, QPoint(low.x(), high.y()) + QPoint(30, 20));
  waitUntilComputed();
  window_->page().playback().show(9);
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
    ThemeManager::instance().apply(choice);
    QVERIFY(!canvas().isNull());
    const char* const name = choice == ThemeChoice::Light ? "path-light.png" : "path-dark.png";
    if (!folder.isEmpty()) QVERIFY(window_->grab().save(QDir(folder).filePath(QLatin1String(name))));
  }
}

BLOSSOM_WINDOW_TEST(MinkowskiPathWindowTest)
#include "minkowski_path_window_test.moc"
