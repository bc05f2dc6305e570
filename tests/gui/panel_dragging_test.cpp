#include <QKeyEvent>
#include <QWheelEvent>

#include "panel_fixture.h"
#include "ui/controls/curve_editor.h"
#include "ui/controls/ratio_slider.h"

using namespace blossom;
using namespace blossom::ui;

/// What is dragged, turned or held down: shown at once, and one step of undo.
class PanelDraggingTest : public PanelFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openPanel(); }
  void cleanup() { closePanel(); }
  void keysAndWheelStepAsOneEdit();
  void theWheelEditsOnlyWhereItsTurnBegan();
  void labelsAreScrubbed();
  void escapeEndsAScrub();
  void ratiosAreDragged();
  void curvesAreDrawn();
  void draggingNeverQueuesUp();
};

void PanelDraggingTest::keysAndWheelStepAsOneEdit() {
  auto* length = editor<QLineEdit>("length");
  length->setFocus();
  oneStep("length", 13.0, [&] {
    for (int i = 0; i < 3; ++i) QTest::keyPress(length, Qt::Key_Up);  // held down
    QVERIFY(session_->history().undoText() == "Begin");
    QTRY_COMPARE(now("length"), Value(13.0));  // shown while it is held
    QTest::keyRelease(length, Qt::Key_Up);
  });
  oneStep("length", 12.9, [&] { QTest::keyClick(length, Qt::Key_Down, Qt::ShiftModifier); });
  auto* count = editor<QLineEdit>("count");
  count->setFocus();
  oneStep("count", 20, [&] {
    for (int i = 0; i < 9; ++i) QTest::keyPress(count, Qt::Key_PageUp);
    QTest::keyRelease(count, Qt::Key_PageUp);
  });
  const auto turn = [](QWidget* widget, int notches) {
    QWheelEvent wheel(middle(widget), widget->mapToGlobal(middle(widget)), {}, QPoint(0, 120 * notches), Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
  };
  auto* angle = editor<QLineEdit>("angle");
  turn(angle, 2);  // without the focus it scrolls
  settle();
  QCOMPARE(now("angle"), Value(45.0));
  angle->setFocus();
  turn(angle, 1);
  turn(angle, 2);
  QTRY_COMPARE(qt(session_->history().undoText()), QStringLiteral("Change angle of All"));
  QCOMPARE(now("angle"), Value(48.0));
  session_->undo();
  QCOMPARE(now("angle"), Value(45.0));
}

// A field that slides under the pointer while the panel scrolls keeps its value.
void PanelDraggingTest::theWheelEditsOnlyWhereItsTurnBegan() {
  auto* length = editor<QLineEdit>("length");
  length->setFocus();
  settle();
  const std::string before = toJson(session_->document());
  const QPoint where = length->mapToGlobal(middle(length));
  const auto turn = [&](QWidget* under, quint64 at, const QPoint& pointer) {
    QWheelEvent wheel(under->mapFromGlobal(pointer), pointer, {}, QPoint(0, -120), Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    wheel.setTimestamp(at);
    QApplication::sendEvent(under, &wheel);
  };
  turn(panel_->viewport(), 5000, where);
  for (quint64 at = 5100; at < 8000; at += 300) turn(length, at, where);
  settle();
  QCOMPARE(toJson(session_->document()), before);
  QCOMPARE(length->text(), QStringLiteral("10 mm"));
  turn(length, 12000, where);  // after a pause, and one edit with what follows
  turn(length, 12300, where);
  QTRY_COMPARE(qt(session_->history().undoText()), QStringLiteral("Change length of All"));
  QCOMPARE(now("length"), Value(8.0));
  session_->undo();
  QCOMPARE(toJson(session_->document()), before);
  turn(panel_->viewport(), 20000, where - QPoint(0, 200));
  turn(length, 20100, where);  // the pointer was moved onto it
  QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
  QApplication::sendEvent(length, &undo);  // undo does not wait for the wheel to rest
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Change length of All"));
  QCOMPARE(now("length"), Value(9.0));
}

void PanelDraggingTest::labelsAreScrubbed() {
  FieldLabel* label = labelOf("length");
  const QPoint from = middle(label);
  oneStep("length", 20.0, [&] {
    QTest::mousePress(label, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 20; ++i) test::moveMouse(label, from + QPoint(2 * i, 0));
    QTRY_COMPARE(now("length"), Value(20.0));
    QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Begin"));
    QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(40, 0));
  });
}

void PanelDraggingTest::escapeEndsAScrub() {
  const std::string before = toJson(session_->document());
  FieldLabel* label = labelOf("angle");
  const QPoint from = middle(label);
  QTest::mousePress(label, Qt::LeftButton, {}, from);
  test::moveMouse(label, from + QPoint(40, 0));
  QTRY_COMPARE(now("angle"), Value(55.0));
  QTest::keyClick(editor<QLineEdit>("angle"), Qt::Key_Escape);
  QCOMPARE(now("angle"), Value(45.0));
  test::moveMouse(label, from + QPoint(80, 0));
  QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(80, 0));
  settle();
  QCOMPARE(toJson(session_->document()), before);
  QCOMPARE(editor<QLineEdit>("angle")->text(), QStringLiteral("45°"));
}

void PanelDraggingTest::ratiosAreDragged() {
  auto* slider = editor<RatioSlider>("ratio");
  const auto at = [&](double share) { return QPoint(int(share * slider->width()), slider->height() / 2); };
  QTest::mousePress(slider, Qt::LeftButton, {}, at(0.3));
  test::moveMouse(slider, at(0.8));
  QTRY_VERIFY(now("ratio").get<double>() > 0.7);
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Begin"));
  QTest::keyClick(slider, Qt::Key_Escape);
  QTest::mouseRelease(slider, Qt::LeftButton, {}, at(0.8));
  QCOMPARE(now("ratio"), Value(0.25));
  // Undo leaves the drag; what was done before it stays.
  QTest::mousePress(slider, Qt::LeftButton, {}, at(0.3));
  test::moveMouse(slider, at(0.8));
  QTRY_VERIFY(now("ratio").get<double>() > 0.7);
  QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
  QApplication::sendEvent(slider, &undo);
  QVERIFY(undo.isAccepted());
  QTRY_COMPARE(now("ratio"), Value(0.25));
  test::moveMouse(slider, at(0.9));
  QTest::mouseRelease(slider, Qt::LeftButton, {}, at(0.9));
  QCOMPARE(now("ratio"), Value(0.25));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Begin"));
  // A click is for typing: the number stays until another one is there.
  const std::string before = toJson(session_->document());
  QTest::mouseClick(slider, Qt::LeftButton, {}, at(0.8));
  QVERIFY(slider->typing());
  QTest::keyClick(slider, Qt::Key_Escape);
  QVERIFY(!slider->typing());
  settle();
  QCOMPARE(toJson(session_->document()), before);
  oneStep("ratio", 1.0, [&] {
    QTest::mousePress(slider, Qt::LeftButton, {}, at(0.3));
    test::moveMouse(slider, at(0.5));
    test::moveMouse(slider, at(1.5));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, at(1.5));
  });
  oneStep("ratio", 0.98, [&] {
    QTest::keyPress(slider, Qt::Key_Left);
    QTest::keyPress(slider, Qt::Key_Left);
    QTest::keyRelease(slider, Qt::Key_Left);
  });
}

void PanelDraggingTest::curvesAreDrawn() {
  auto* curve = editor<CurveEditor>("curve");
  panel_->ensureWidgetVisible(curve);
  const std::string before = toJson(session_->document());
  const QPoint where = curve->toPixels({0.5, 0.75}).toPoint();
  QTest::mousePress(curve, Qt::LeftButton, {}, where);
  QTRY_COMPARE(now("curve").size(), std::size_t(3));  // previewed
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Begin"));
  QTest::mouseRelease(curve, Qt::LeftButton, {}, where);
  COMPARE_NEAR(now("curve").at(1).at(0).get<double>(), 0.5, 0.01);
  COMPARE_NEAR(now("curve").at(1).at(1).get<double>(), 0.75, 0.01);
  session_->undo();
  QCOMPARE(toJson(session_->document()), before);
  session_->redo();
  curve->choose(1);
  type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveValue")), QStringLiteral("1/2"));
  type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveT")), QStringLiteral("1/4"));
  QCOMPARE(now("curve"), Value::parse("[[0.0,0.5],[0.25,0.5],[1.0,0.5]]"));
  const QPoint at = curve->toPixels({0.25, 0.5}).toPoint();
  QTest::mousePress(curve, Qt::LeftButton, {}, at);
  test::moveMouse(curve, at + QPoint(1000, 0));  // stops at its neighbour
  QTRY_COMPARE(now("curve").at(1).at(0), Value(1.0));
  QTest::keyClick(curve, Qt::Key_Escape);
  QTest::mouseRelease(curve, Qt::LeftButton, {}, at);
  QCOMPARE(now("curve").at(1).at(0), Value(0.25));
  oneStep("curve", Value::parse("[[0.0,0.5],[1.0,0.5]]"), [&] {
    curve->choose(1);
    QTest::keyClick(curve, Qt::Key_Delete);
  });
  curve->choose(1);
  oneStep("curve", Value::parse("[[0.0,0.5],[1.0,0.25]]"),
          [&] { type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveValue")), QStringLiteral("1/4")); });
  type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveT")), QStringLiteral("-1"));
  QVERIFY(!field("curve")->problem().isEmpty());
}

// However fast the mouse goes: one evaluation is under way and the newest value waits for it.
void PanelDraggingTest::draggingNeverQueuesUp() {
  FieldLabel* label = labelOf("length");
  const QPoint from = middle(label);
  gate_.close();
  QTest::mousePress(label, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 100; ++i) test::moveMouse(label, from + QPoint(4 * i, 0));
  QTRY_COMPARE(gate_.count(), 1);
  QCoreApplication::processEvents();
  QCOMPARE(gate_.count(), 1);                                               // ninety-nine values later
  QCOMPARE(editor<QLineEdit>("length")->text(), QStringLiteral("110 mm"));  // the hand is ahead of the document
  QVERIFY(now("length").get<double>() < 20);
  gate_.open();
  QTRY_COMPARE(now("length"), Value(110.0));
  settle();
  QCOMPARE(gate_.count(), 2);
  QCOMPARE(gate_.maximumInside, 1);
  QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(400, 0));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Change length of All"));
  session_->undo();
  QCOMPARE(now("length"), Value(10.0));
}

BLOSSOM_WIDGET_TEST(PanelDraggingTest)
#include "panel_dragging_test.moc"
