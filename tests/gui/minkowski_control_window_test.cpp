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
  void influencesAreDrawnOnDemand();
  void curvesOfInfluenceAreTheBasis();
  void picturesOfTheCard();

 private:
  void dragPixels(const QPoint& from, const QPoint& to);
  [[nodiscard]] Value given(const char* name) const {
    return window_->page().document().at(morph_).parameters.value(name, Value::array());
  }
  void set(const char* name, const Value& value);
  [[nodiscard]] QLabel* figures() const { return window_->view().findChild<QLabel*>(QStringLiteral("morphFigures")); }
  [[nodiscard]] QToolButton* ladder() const { return window_->view().findChild<QToolButton*>(QStringLiteral("ladder")); }
  [[nodiscard]] std::size_t drawn() const { return window_->page().tool()->props().size(); }
  void takeThird();
  void keepPictures(const char* name);
  [[nodiscard]] QWidget* chart() const { return window_->view().findChild<QWidget*>(QStringLiteral("influenceChart")); }
  void switchInfluences() const {
    QTest::mouseClick(window_->view().findChild<QToolButton*>(QStringLiteral("influences")), Qt::LeftButton);
  }
  FeatureId first_, morph_;
};

namespace {

double bernstein(int n, int i, double t) {
  double value = 1;
  for (int k = 0; k < i; ++k) value *= t * (n - k) / (k + 1);
  return value * std::pow(1 - t, n - i);
}

/// Of three shapes with knots 0 0 1 2 2: each rises and falls in straight lines.
double hat(int i, double t) { return std::max(0.0, 1 - std::abs(2 * t - i)); }

/// The colour nearest to a wanted one around a point of a widget, as the largest difference of a channel.
int offColor(QWidget& widget, const QPointF& at, const QColor& wanted) {
  const QImage image = widget.grab().toImage();
  const QPoint middle = (at * image.devicePixelRatio()).toPoint();
  int least = 255;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y) {
      const QColor color = image.pixelColor(middle + QPoint(x, y));
      least = std::min(least, std::max({std::abs(color.red() - wanted.red()), std::abs(color.green() - wanted.green()),
                                        std::abs(color.blue() - wanted.blue())}));
    }
  return least;
}

}  // namespace

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

/// A circle as the last shape, at t = 0.5.
void MinkowskiControlWindowTest::takeThird() {
  const FeatureId third = add("modeling.circle", {{"radius", 12}, {"centre", {50, 60, 0}}});
  Feature morph = window_->page().document().at(morph_);
  morph.inputs.push_back(third);
  morph.parameters["t"] = 0.5;
  Document document = window_->page().document().without(morph_).with(morph);  // after what it takes
  window_->session().commit(std::move(document), QStringLiteral("Three"));
  waitUntilComputed();
  window_->tree().select(morph_);
}

void MinkowskiControlWindowTest::theLadderIsDrawnOnDemand() {
  window_->view().setFocus();
  QTest::keyClick(&window_->view(), Qt::Key_L);
  QVERIFY(ladder()->isChecked());
  auto* const note = ladder()->parentWidget()->findChild<QLabel*>(QStringLiteral("note"));
  QTRY_VERIFY(note && note->text().contains(QStringLiteral("Three control shapes")));
  takeThird();
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

void MinkowskiControlWindowTest::influencesAreDrawnOnDemand() {
  QTRY_VERIFY(chart());
  QVERIFY(!chart()->isVisible());
  switchInfluences();
  QTRY_VERIFY(chart()->isVisible());
  QCOMPARE(chart()->property("curves").toList().size(), 2);
  QCOMPARE(chart()->property("cursor").toDouble(), 1.0);
  takeThird();
  QTRY_VERIFY(chart() && chart()->isVisible());  // it stays on
  QTRY_COMPARE(chart()->property("curves").toList().size(), 3);
  QTRY_COMPARE(chart()->property("cursor").toDouble(), 0.5);
  // Half way the second shape has its peak, in its colour.
  QPointF peak;
  QVERIFY(QMetaObject::invokeMethod(chart(), "pixelOf", Q_RETURN_ARG(QPointF, peak), Q_ARG(QPointF, QPointF(0.5, 0.5))));
  QVERIFY(offColor(*chart(), peak, chart()->property("colors").toList().at(1).value<QColor>()) < 24);
  set("frames", 5);
  window_->page().playback().show(3);
  QTRY_COMPARE(chart()->property("cursor").toDouble(), 0.75);
  set("frames", 0);
  set("blossom", Value::parse("[0.2,0.7]"));
  QTRY_VERIFY(!chart()->property("cursor").isValid());
  const QVariantList shares = chart()->property("shares").toList();
  COMPARE_NEAR(shares.at(0).toDouble(), 0.8 * 0.3, 1e-12);
  COMPARE_NEAR(shares.at(1).toDouble(), 0.2 * 0.3 + 0.8 * 0.7, 1e-12);
  COMPARE_NEAR(shares.at(2).toDouble(), 0.2 * 0.7, 1e-12);
  switchInfluences();
  QTRY_VERIFY(!chart()->isVisible());
}

/// B_i^n(t) of the Bezier morph, hat functions of degree 1; the line stands at t with the shares of that t.
void MinkowskiControlWindowTest::curvesOfInfluenceAreTheBasis() {
  takeThird();
  QTRY_VERIFY(chart());
  switchInfluences();
  QTRY_VERIFY(chart()->isVisible());
  for (const int degree : {0, 1}) {
    set("degree", degree);
    const auto basis = [&](int i, double t) { return degree == 0 ? bernstein(2, i, t) : hat(i, t); };
    for (const double seen : {0.125, 0.5, 0.8}) {
      set("t", seen);
      QTRY_COMPARE(chart()->property("cursor").toDouble(), seen);
      const QVariantList curves = chart()->property("curves").toList(), shares = chart()->property("shares").toList();
      QCOMPARE(curves.size(), 3);
      QCOMPARE(shares.size(), 3);
      for (int i = 0; i < 3; ++i) {
        const auto curve = curves.at(i).value<QPolygonF>();
        QVERIFY(curve.size() > 100);
        QVERIFY(curve.front().x() == 0 && curve.back().x() == 1);
        for (const QPointF& value : curve) COMPARE_NEAR(value.y(), basis(i, value.x()), 1e-12);
        COMPARE_NEAR(shares.at(i).toDouble(), basis(i, seen), 1e-12);
      }
    }
  }
  set("degree", 3);  // three shapes have none: the feature tells, and no chart lies
  QTRY_VERIFY(!chart() || !chart()->isVisible());
}

/// Kept where BLOSSOM_PICTURES says, to be looked at, in both themes.
void MinkowskiControlWindowTest::keepPictures(const char* name) {
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
    ThemeManager::instance().apply(choice);
    QVERIFY(!canvas().isNull());  // at rest
    const char* const theme = choice == ThemeChoice::Light ? "light" : "dark";
    const QString file = QStringLiteral("%1-%2.png").arg(QLatin1String(name), QLatin1String(theme));
    if (!folder.isEmpty()) QVERIFY(window_->grab().save(QDir(folder).filePath(file)));
  }
}

/// A ladder of three levels, then the influences of four control shapes.
void MinkowskiControlWindowTest::picturesOfTheCard() {
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
  keepPictures("ladder");
  QTest::mouseClick(ladder(), Qt::LeftButton);
  switchInfluences();
  QTRY_VERIFY(chart()->isVisible());
  keepPictures("influences");
}

BLOSSOM_WINDOW_TEST(MinkowskiControlWindowTest)
#include "minkowski_control_window_test.moc"
