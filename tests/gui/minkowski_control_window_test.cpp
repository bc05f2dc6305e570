#include <QToolButton>

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
  void theRingScalesAndTurns();

 private:
  void dragPixels(const QPoint& from, const QPoint& to);
  [[nodiscard]] Value given(const char* name) const {
    return window_->page().document().at(morph_).parameters.value(name, Value::array());
  }
  FeatureId morph_;
};

/// A square of side 20 about the origin and one of side 30 about (100, 0), seen from above; the morph is the second.
void MinkowskiControlWindowTest::init() {
  openNewDocument();
  const FeatureId a = add("modeling.rectangle", {{"width", 20}, {"height", 20}});
  const FeatureId b = add("modeling.rectangle", {{"width", 30}, {"height", 30}, {"centre", {100, 0, 0}}});
  morph_ = add("minkowski.morph", {{"t", 1}}, {a, b});
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

BLOSSOM_WINDOW_TEST(MinkowskiControlWindowTest)
#include "minkowski_control_window_test.moc"
