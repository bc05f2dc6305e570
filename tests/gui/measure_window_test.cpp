#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <QAbstractButton>

#include "ui/tools/measure_panel.h"
#include "ui/tools/measure_tool.h"
#include "ui/tools/section_tool.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// Measuring and cutting in the real window, by mouse and keys.
class MeasureWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openWindow();
    const QString file = folder_.filePath(QStringLiteral("box.brep"));
    QVERIFY(BRepTools::Write(BRepPrimAPI_MakeBox(10., 20., 30.).Shape(), file.toLocal8Bit().constData()));
    openAndWait(file);
    window_->view().setFocus();
  }
  void cleanup() { window_.reset(); }

  void clicksMeasureAndEditsAreFollowed();
  void theSectionIsDraggedAndMeasurementsSurviveIt();

 private:
  [[nodiscard]] ViewWidget& view() { return window_->view(); }
  [[nodiscard]] Measurements& measured() { return window_->page().measurements(); }
  [[nodiscard]] QPoint seen(const Vec3& p) { return view().camera().project(p).toPoint(); }
  void click(const Vec3& p) {
    test::moveMouse(&view(), seen(p));
    QTest::mouseClick(&view(), Qt::LeftButton, {}, seen(p));
  }
  [[nodiscard]] bool ready() {
    const auto* entry = measured().find(measured().selected());
    return entry && entry->state == Measurements::State::Ready;
  }
  [[nodiscard]] const Measurement& figures() { return measured().find(measured().selected())->figures; }
};

void MeasureWindowTest::clicksMeasureAndEditsAreFollowed() {
  QTest::keyClick(&view(), Qt::Key_M);
  QVERIFY(dynamic_cast<MeasureTool*>(window_->page().tool()));
  QVERIFY(view().findChild<MeasurePanel*>()->isVisible());
  click({5, 10, 30});
  QTRY_VERIFY(ready());
  QCOMPARE(figures().kind, std::string("area"));
  COMPARE_NEAR(std::get<double>(figures().values[0].value), 200, 1e-9);
  click({5, 0, 15});
  QTRY_VERIFY(ready() && figures().kind == "angle");
  COMPARE_NEAR(std::get<double>(figures().values[0].value), 90, 1e-9);
  QCOMPARE(measured().entries().size(), std::size_t{1});
  QTest::keyClick(&view(), Qt::Key_Escape);
  QVERIFY(!window_->page().toolStarted());
  QVERIFY(!measured().props().empty());  // it stays in the view
  Session& session = window_->session();
  session.commit(session.document().without(session.document().features().front()->id), QStringLiteral("Delete"));
  QTRY_VERIFY(measured().entries()[0].state == Measurements::State::Lost);
  session.undo();
  QTRY_VERIFY(ready());
  COMPARE_NEAR(std::get<double>(figures().values[0].value), 90, 1e-9);
}

void MeasureWindowTest::theSectionIsDraggedAndMeasurementsSurviveIt() {
  QTest::keyClick(&view(), Qt::Key_M);
  click({5, 10, 30});
  QTRY_VERIFY(ready());
  const Pick front = view().pickAt(seen({5, 0, 10}), PickMode::Face);
  QVERIFY(front.part.kind == SubShapeKind::Face);
  window_->page().startSection();
  QVERIFY(view().section());
  COMPARE_NEAR(view().section()->offset, -10, 1e-9);
  // The front is cut away and no longer picked.
  const Pick behind = view().pickAt(seen({5, 0, 10}), PickMode::Face);
  QVERIFY(behind.feature.empty() || behind.part.kind != SubShapeKind::Face || behind.part.index != front.part.index);
  const QPoint handle = seen({5, 10, 15});
  const Vec3 goal(5, 14, 15);
  test::moveMouse(&view(), handle);
  QTest::mousePress(&view(), Qt::LeftButton, {}, handle);
  for (int i = 1; i <= 8; ++i) test::moveMouse(&view(), handle + (seen(goal) - handle) * i / 8);
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, seen(goal));
  COMPARE_NEAR(view().section()->offset, -14, 0.3);  // as exact as a pixel
  QVERIFY(ready());
  QVERIFY(!measured().props().empty());
  QTest::keyClick(&view(), Qt::Key_Escape);
  QVERIFY(view().section());  // the cut stays
  window_->page().startSection();
  QTest::keyClick(&view(), Qt::Key_Delete);
  QVERIFY(!view().section());
  QVERIFY(!window_->page().toolStarted());
}

BLOSSOM_WINDOW_TEST(MeasureWindowTest)
#include "measure_window_test.moc"
