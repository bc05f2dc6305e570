#include <QDir>
#include <QLabel>
#include <QToolButton>

#include "ui/look/text.h"
#include "ui/timeline/playback.h"
#include "ui/tools/view_props.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// Control shapes of a selected morph in the real window.
class MinkowskiControlWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { window_.reset(); }

  void theNumberIsDraggedLikeItsDot();
  void numbersAtOnePlaceStandSideBySide();
  void theRingScalesAndTurns();
  void theCardTellsWhatIsSeen();
  void aSequenceIsTakenWhereItIsSeen();
  void theLadderIsDrawnOnDemand();
  void picturesOfTheLadder();

 private:
  void dragPixels(const QPoint& from, const QPoint& to);
  [[nodiscard]] Value given(const char* name) const {
    return window_->page().document().at(morph_).parameters.value(name, Value::array());
  }
  void set(const char* name, const Value& value);
  [[nodiscard]] QLabel* figures() const { return window_->view().findChild<QLabel*>(QStringLiteral("morphFigures")); }
  [[nodiscard]] QToolButton* ladder() const { return window_->view().findChild<QToolButton*>(QStringLiteral("ladder")); }
  [[nodiscard]] std::size_t drawn() const { return window_->page().tool()->props().size(); }
  FeatureId first_, morph_;
};

/// A square of side 20 about the origin and one of side 30 about (100, 0), seen from above; the morph is the second.
void MinkowskiControlWindowTest::init() {
  openNewDocument();
  first_ = add("modeling.rectangle", {{"width", 20}, {"height", 20}});
  const FeatureId b = add("modeling.rectangle", {{"width", 30}, {"height", 30}, {"centre", {100, 0, 0}}});
  morph_ = add("minkowski.morph", {{"t", 1}}, {first_, b});
  window_->tree().select(morph_);
  run("view.top");
  window_->view().fitTo({{-60, -90, 0}, {180, 90, 0}}, false);
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  QTRY_VERIFY(window_->view().sharp());
}

void MinkowskiControlWindowTest::dragPixels(const QPoint& from, const QPoint& to) {
  test::moveMouse(&window_->view(), from);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 8; ++i) test::moveMouse(&window_->view(), from + (to - from) * i / 8);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, to);
  waitUntilComputed();
}

void MinkowskiControlWindowTest::theNumberIsDraggedLikeItsDot() {
  const QPoint number = screenOf({100, 0, 0}) - QPoint(0, static_cast<int>(labelGap) + 11);
  const QPoint by = screenOf({120, 40, 0}) - screenOf({100, 0, 0});
  dragPixels(number, number + by);
  const double near = 8 * window_->view().camera().millimetresPerPixel();
  const Value offsets = given("offsets");
  QCOMPARE(offsets.size(), std::size_t{2});
  COMPARE_NEAR(offsets[1][0].get<double>(), 20, near);
  COMPARE_NEAR(offsets[1][1].get<double>(), 40, near);
  // Where it is now it is put back.
  const Vec3 moved(100 + offsets[1][0].get<double>(), offsets[1][1].get<double>(), 0);
  const QPoint again = screenOf(moved) - QPoint(0, static_cast<int>(labelGap) + 11);
  test::moveMouse(&window_->view(), again);
  QTest::mouseDClick(&window_->view(), Qt::LeftButton, {}, again);
  waitUntilComputed();
  QVERIFY(given("offsets").empty());
}

void MinkowskiControlWindowTest::numbersAtOnePlaceStandSideBySide() {
  set("offsets", Value::parse("[[100.0,0.0,0.0]]"));  // the first onto the second
  const QPoint number = screenOf({100, 0, 0}) - QPoint(0, static_cast<int>(labelGap) + 11);
  const QPoint by = screenOf({100, 50, 0}) - screenOf({100, 0, 0});
  test::moveMouse(&window_->view(), number + QPoint(60, -80));  // what a pixel is worth is known from now on
  dragPixels(number + QPoint(26, 0), number + QPoint(26, 0) + by);
  QCOMPARE(given("offsets").size(), std::size_t{2});
  QCOMPARE(given("offsets").at(0), Value::parse("[100.0,0.0,0.0]"));
  dragPixels(number, number + by / 2);
  QVERIFY(given("offsets").at(0) != Value::parse("[100.0,0.0,0.0]"));
}

void MinkowskiControlWindowTest::theRingScalesAndTurns() {
  constexpr int ring = 40;  // pixels
  const QPoint centre = screenOf({100, 0, 0});
  const QImage without = canvas();
  test::moveMouse(&window_->view(), centre + QPoint(ring / 2, ring / 2));  // near it, the ring is drawn
  QVERIFY(canvas() != without);
  dragPixels(centre + QPoint(ring, 0), centre + QPoint(2 * ring, 0));
  QCOMPARE(given("scales"), Value::parse("[1.0,2.0]"));
  COMPARE_NEAR(measureOf(morph_, "area"), 3600, 1e-6);
  dragPixels(centre - QPoint(0, ring), centre - QPoint(ring, ring));  // the dot on top, to the left
  QCOMPARE(given("turns"), Value::parse("[0.0,45.0]"));
  COMPARE_NEAR(measureOf(morph_, "area"), 3600, 1e-6);
  const Bounds box = window_->view().extent();
  COMPARE_NEAR(box.high.x(), 100 + 60 / std::numbers::sqrt2, 1e-6);
  window_->session().undo();
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(given("scales").empty() && given("turns").empty());
}

void MinkowskiControlWindowTest::set(const char* name, const Value& value) {
  Feature morph = window_->page().document().at(morph_);
  morph.parameters[name] = value;
  window_->session().commit(window_->page().document().with(morph), QStringLiteral("Set"));
  waitUntilComputed();
}

/// t and area, of the frame that is seen, and while something is dragged.
void MinkowskiControlWindowTest::theCardTellsWhatIsSeen() {
  const auto says = [this](const char* t, double area) {
    const QString wanted = readable(Measure{"area", area, MeasureUnit::Area});
    return QTest::qWaitFor([&] {
      return figures() && figures()->text().startsWith(QStringLiteral("t %1 ").arg(QLatin1String(t))) &&
             figures()->text().endsWith(wanted);
    });
  };
  QVERIFY2(says("1", 900), qPrintable(figures()->text()));
  set("t", 0.5);
  QVERIFY2(says("0.5", 625), qPrintable(figures()->text()));
  set("frames", 5);
  Playback& playback = window_->page().playback();
  playback.show(1);
  QVERIFY2(says("0.25", 22.5 * 22.5), qPrintable(figures()->text()));
  playback.show(4);
  QVERIFY2(says("1", 900), qPrintable(figures()->text()));
  const QPoint square = screenOf({100, 0, 0}) + QPoint(40, 0);
  test::moveMouse(&window_->view(), square);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, square);
  test::moveMouse(&window_->view(), square + QPoint(20, 0));
  test::moveMouse(&window_->view(), square + QPoint(40, 0));
  QVERIFY2(says("1", 3600), qPrintable(figures()->text()));  // still held
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, square + QPoint(40, 0));
  QVERIFY2(says("1", 900), qPrintable(figures()->text()));
  window_->tree().select(first_);
  QTRY_VERIFY(!figures());
}

/// The last frame of the morph is the square about (100, 0).
void MinkowskiControlWindowTest::aSequenceIsTakenWhereItIsSeen() {
  set("frames", 5);
  morph_ = add("minkowski.morph", {{"t", 0}}, {morph_, first_});
  window_->tree().select(morph_);
  window_->page().playback().show(4);
  QTRY_VERIFY(figures() && figures()->text().startsWith(QStringLiteral("t 0 ")));  // of the morph, not of the frame
  dragPixels(screenOf({100, 0, 0}), screenOf({100, 50, 0}));
  const double near = 8 * window_->view().camera().millimetresPerPixel();
  QCOMPARE(given("offsets").size(), std::size_t{1});
  COMPARE_NEAR(given("offsets")[0][0].get<double>(), 0, near);
  COMPARE_NEAR(given("offsets")[0][1].get<double>(), 50, near);
}

void MinkowskiControlWindowTest::theLadderIsDrawnOnDemand() {
  window_->view().setFocus();
  QTest::keyClick(&window_->view(), Qt::Key_L);
  QVERIFY(ladder()->isChecked());
  auto* const note = ladder()->parentWidget()->findChild<QLabel*>(QStringLiteral("note"));
  QTRY_VERIFY(note && note->text().contains(QStringLiteral("Three control shapes")));
  const FeatureId third = add("modeling.circle", {{"radius", 12}, {"centre", {50, 60, 0}}});
  Feature morph = window_->page().document().at(morph_);
  morph.inputs.push_back(third);
  morph.parameters["t"] = 0.5;
  Document document = window_->page().document().without(morph_).with(morph);  // after what it takes
  window_->session().commit(std::move(document), QStringLiteral("Three"));
  waitUntilComputed();
  window_->tree().select(morph_);
  QTRY_VERIFY(ladder() && ladder()->isChecked());  // it stays on
  const auto click = [this] { QTest::mouseClick(ladder(), Qt::LeftButton); };
  click();
  QVERIFY(!ladder()->isChecked());
  const std::size_t without = drawn();
  const QImage before = canvas();
  click();
  // Two shapes between three control shapes and the result, and the line between their centres.
  QTRY_COMPARE(drawn(), without + 2);
  QVERIFY(canvas() != before);
  click();
  QCOMPARE(drawn(), without);
}

/// Kept where BLOSSOM_PICTURES says, to be looked at: a ladder of three levels, with a ring.
void MinkowskiControlWindowTest::picturesOfTheLadder() {
  window_->resize(1280, 800);
  openAndWait(QString::fromStdString(test::sample("triangle-to-star.blossom").string()));
  morph_ = last();
  window_->tree().select(morph_);
  QTRY_VERIFY(ladder());
  run("view.top");
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  window_->page().playback().show(12);
  const std::size_t without = drawn();
  QTest::mouseClick(ladder(), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(drawn() >= without + 4, 300000);  // two levels between four shapes and the result
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
    ThemeManager::instance().apply(choice);
    QVERIFY(!canvas().isNull());  // at rest
    const char* const name = choice == ThemeChoice::Light ? "ladder-light.png" : "ladder-dark.png";
    if (!folder.isEmpty()) QVERIFY(window_->grab().save(QDir(folder).filePath(QLatin1String(name))));
  }
}

BLOSSOM_WINDOW_TEST(MinkowskiControlWindowTest)
#include "minkowski_control_window_test.moc"
