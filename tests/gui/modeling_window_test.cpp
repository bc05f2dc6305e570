#include <QLineEdit>
#include <numbers>

#include "ui/fields/parameter_field.h"
#include "ui/panel/property_panel.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// From an empty document to a rounded solid, with mouse and keys in the real window.
class ModelingWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openWindow();
    window_->commands().action(QStringLiteral("file.new"))->trigger();
  }
  void cleanup() { window_.reset(); }
  void anOutlineIsDrawnExtrudedAndRounded();
  void clicksSnapToTheGridAndToPoints();
  void aDrawingCanBeGivenUp();
  void aTooLargeFilletKeepsItsPlaceAndSaysWhy();
};

void ModelingWindowTest::anOutlineIsDrawnExtrudedAndRounded() {
  run("feature.modeling.outline");
  QVERIFY(window_->page().toolStarted());
  // A rectangle of 40 x 25 in typed lengths and angles, closed by a click on its start.
  moveTo({0, 0, 0});
  clickAt({0, 0, 0});
  for (const char* entry : {"40<0", "25<90", "40<180"}) {
    moveTo({11, 7, 0});
    QTest::keyClicks(&window_->view(), QLatin1String(entry));
    QTest::keyClick(&window_->view(), Qt::Key_Return);
  }
  clickAt({0, 0, 0});
  QTRY_VERIFY(!window_->page().toolStarted());
  waitUntilComputed();
  const FeatureId outline = last();
  COMPARE_NEAR(measureOf(outline, "area"), 1000, 1e-9);
  QCOMPARE(measureOf(outline, "lines"), 4.0);

  window_->tree().select(outline);
  run("feature.modeling.extrude");
  waitUntilComputed();
  const FeatureId solid = last();
  QVERIFY(solid != outline);
  edit("height", "1/2 in + 12.3 mm");
  waitUntilComputed();
  COMPARE_NEAR(measureOf(solid, "volume"), 1000 * 25.0, 1e-6);

  window_->tree().select(solid);
  run("feature.modeling.fillet");
  edit("radius", "3 mm");
  waitUntilComputed();
  const FeatureId rounded = last();
  const auto view = window_->session().view(rounded);
  QVERIFY2(!view->result->error, view->result->error ? view->result->error->what() : "");
  // A box rounded by r at every edge: Steiner's formula of the box less r on each side.
  const double r = 3, a = 40 - 2 * r, b = 25 - 2 * r, c = 25 - 2 * r, pi = std::numbers::pi;
  const double volume = a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) + 4 * pi * r * r * r / 3;
  COMPARE_NEAR(measureOf(rounded, "volume"), volume, 1e-5 * volume);

  // All of it can be undone, a step each, and done again.
  int steps = 0;
  while (!window_->session().history().undoText().empty()) {
    window_->session().undo();
    ++steps;
  }
  QVERIFY(window_->page().document().features().empty());
  QCOMPARE(steps, 5);
  while (!window_->session().history().redoText().empty()) window_->session().redo();
  waitUntilComputed();
  COMPARE_NEAR(measureOf(rounded, "volume"), volume, 1e-5 * volume);
}

void ModelingWindowTest::clicksSnapToTheGridAndToPoints() {
  run("feature.modeling.outline");
  const double grid = window_->page().gridSpacing();
  const double beside = 3 * window_->view().camera().millimetresPerPixel();  // three pixels off
  const Vec3 corners[] = {{0, 0, 0}, {grid, 0, 0}, {grid, grid, 0}};
  for (const Vec3& corner : corners) clickAt(corner + Vec3(beside, -beside, 0));
  clickAt(Vec3(-beside, beside, 0));  // the start, nearly: closes
  QTRY_VERIFY(!window_->page().toolStarted());
  waitUntilComputed();
  COMPARE_NEAR(measureOf(last(), "area"), grid * grid / 2, 1e-9 * grid * grid);
}

void ModelingWindowTest::aDrawingCanBeGivenUp() {
  run("feature.modeling.outline");
  clickAt({0, 0, 0});
  clickAt({30, 0, 0});
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QTRY_VERIFY(!window_->page().toolStarted());
  QVERIFY(window_->page().document().features().empty());
  QVERIFY(window_->session().history().undoText().empty());
}

void ModelingWindowTest::aTooLargeFilletKeepsItsPlaceAndSaysWhy() {
  run("feature.modeling.box");
  waitUntilComputed();
  window_->tree().select(last());
  run("feature.modeling.fillet");
  edit("radius", "500 mm");
  waitUntilComputed();
  const auto view = window_->session().view(last());
  QVERIFY(view->result->error);
  QVERIFY(!view->result->error->message().empty() && !view->result->error->hint().empty());
  edit("radius", "1 mm");
  waitUntilComputed();
  QVERIFY(!window_->session().view(last())->result->error);
}

BLOSSOM_WINDOW_TEST(ModelingWindowTest)
#include "modeling_window_test.moc"
