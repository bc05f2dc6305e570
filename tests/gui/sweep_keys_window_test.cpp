#include <QMenu>
#include <QRegularExpression>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>

#include "sweep_fixture.h"
#include "ui/tree/document_tree.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// What mouse and keys mean over a swept surface before, during and beside a pull.
class SweepKeysWindowTest : public SweepFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void escapeTakesBack();
  void undoAndTheRightButtonTakeBack();
  void afterEscapeThePlaceUnderTheMouseIsShown();
  void nothingIsLitWhenTheMouseIsGone();
  void nothingComesBetweenADrag();
  void nothingComesBetweenAnOrbit();
  void keysAreForThePlaceUnderTheMouse();
  void keysAreForThePlaceUnderTheMouseAfterEnterInAField();
  void keysStayInForceWhenSomethingElseIsSelected();
  void theSelectedEditTellsItsOwnWay();
  void nothingIsDraggedWhereTheSweepFails();
  void whereThePointIsIsTold();
  void aClickIsForTheView();
  void alongANormalThatFacesTheViewerThePointKeepsToTheMouse();
  void theHandlesAreSeen();

 private:
  /// A click of a second button while the left one is held.
  void clickBeside(Qt::MouseButton button, const QPointF& at);
};

void SweepKeysWindowTest::clickBeside(Qt::MouseButton button, const QPointF& at) {
  const QPointF global = window_->view().mapToGlobal(at);
  for (const auto& [type, buttons] : {std::pair(QEvent::MouseButtonPress, Qt::LeftButton | button),
                                      std::pair(QEvent::MouseButtonRelease, Qt::MouseButtons(Qt::LeftButton))}) {
    QMouseEvent event(type, at, global, button, buttons, {});
    QApplication::sendEvent(&window_->view(), &event);
  }
}

void SweepKeysWindowTest::escapeTakesBack() {
  openSample("cylinder.json");
  const Document before = document();
  const Surface swept = surfaceOf(sweep_);
  const QPoint from = onTheSide();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(50, 10));
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to pull")), qPrintable(hint()));
  key(Qt::Key_Escape);
  mouse(QEvent::MouseButtonRelease, from + QPoint(50, 10));
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
  QVERIFY(surfaceOf(sweep_) == swept);
}

/// The step before the drag stays, and no menu comes up.
void SweepKeysWindowTest::undoAndTheRightButtonTakeBack() {
  openSample("cylinder.json");
  const QPoint from = onTheSide(), to = from + QPoint(50, 10);
  drag(from, to);
  waitUntilComputed();
  const Document before = document();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  for (const bool byKey : {true, false}) {
    const QPoint other = from + QPoint(0, 60);
    hover(other);
    mouse(QEvent::MouseButtonPress, other);
    mouse(QEvent::MouseMove, other + QPoint(40, 0));
    QVERIFY2(hint().startsWith(QStringLiteral("Let go to pull")), qPrintable(hint()));
    if (byKey)
      QTest::keyClick(&window_->view(), Qt::Key_Z, Qt::ControlModifier);
    else
      clickBeside(Qt::RightButton, other + QPoint(40, 0));
    QVERIFY2(!hint().startsWith(QStringLiteral("Let go to pull")), qPrintable(hint()));
    mouse(QEvent::MouseButtonRelease, other + QPoint(40, 0));
    waitUntilComputed();
    QVERIFY(std::ranges::equal(document().features(), before.features()));
    QVERIFY(!window_->findChild<QMenu*>(QStringLiteral("contextMenu")));
  }
}

/// Not the one where the drag began.
void SweepKeysWindowTest::afterEscapeThePlaceUnderTheMouseIsShown() {
  openSample("cylinder.json");
  const QPoint from = onTheSide(), to = from + QPoint(10, 40);
  hover(to);
  const auto there = window_->page().tool()->whereabouts();
  QVERIFY(there);
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, to);
  key(Qt::Key_Escape);
  const auto shown = window_->page().tool()->whereabouts();
  QVERIFY(shown && (*shown - *there).norm() < 1e-9);
  mouse(QEvent::MouseButtonRelease, to);
}

void SweepKeysWindowTest::nothingIsLitWhenTheMouseIsGone() {
  openSample("cylinder.json");
  hover(onTheSide());
  QVERIFY(window_->page().tool()->whereabouts());
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&window_->view(), &leave);
  QVERIFY(!window_->page().tool()->whereabouts());
  QVERIFY2(hint().startsWith(QStringLiteral("Drag a place on the surface")), qPrintable(hint()));
}

/// Delete would take away what is looked at from all sides.
void SweepKeysWindowTest::nothingComesBetweenAnOrbit() {
  openSample("cylinder.json");
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  const Document during = document();
  ViewWidget& view = window_->view();
  QTest::mousePress(&view, Qt::MiddleButton, Qt::ShiftModifier, QPoint(40, 40));
  QTest::mouseMove(&view, QPoint(80, 60));
  QTest::keyClick(&view, Qt::Key_Delete);
  QTest::mouseRelease(&view, Qt::MiddleButton, Qt::ShiftModifier, QPoint(80, 60));
  QVERIFY(std::ranges::equal(document().features(), during.features()));
  QTest::keyClick(&view, Qt::Key_Delete);
  QVERIFY(document().features().size() < during.features().size());
}

/// Neither commands by their keys nor the middle button.
void SweepKeysWindowTest::nothingComesBetweenADrag() {
  openSample("cylinder.json");
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  const QPoint from = onTheSide();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(50, 10));
  const Document during = document();
  for (const Qt::Key pressed : {Qt::Key_Delete, Qt::Key_X}) QTest::keyClick(&window_->view(), pressed);
  QTest::keyClick(&window_->view(), Qt::Key_N, Qt::ControlModifier);
  clickBeside(Qt::MiddleButton, from + QPoint(50, 10));
  QVERIFY(std::ranges::equal(document().features(), during.features()));
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to pull")), qPrintable(hint()));
  mouse(QEvent::MouseButtonRelease, from + QPoint(50, 10));
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
}

/// Whatever was clicked before, such as the row of the sweep in the tree.
void SweepKeysWindowTest::keysAreForThePlaceUnderTheMouse() {
  openSample("cylinder.json");
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  window_->tree().setFocus();
  QVERIFY(!window_->view().hasFocus());
  hover(onTheSide());
  QTRY_VERIFY(window_->view().hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_4);
  QVERIFY2(hint().contains(QStringLiteral("4 copies")), qPrintable(hint()));
}

/// What is typed and not entered stays where it is typed.
void SweepKeysWindowTest::keysAreForThePlaceUnderTheMouseAfterEnterInAField() {
  openSample("cylinder.json");
  const QPoint from = onTheSide(), other = from + QPoint(0, 60);
  drag(from, from + QPoint(50, 10));
  window_->tree().select(all("sweep.pull").front());
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  auto* const line = window_->properties().field(QStringLiteral("level"))->findChild<QLineEdit*>();
  edit("level", "0");
  QVERIFY(line->hasFocus());  // Tab and undo go on from there
  hover(other);
  QTRY_VERIFY(window_->view().hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_4);
  QVERIFY2(hint().contains(QStringLiteral("not 4-fold")), qPrintable(hint()));  // which it was before the pull
  QCOMPARE(line->text(), QStringLiteral("0"));

  edit("level", "0");
  QTest::keyClick(line, Qt::Key_1);
  hover(other);
  QVERIFY(line->hasFocus());
  QCOMPARE(line->text(), QStringLiteral("10"));
  QTest::keyClick(line, Qt::Key_Escape);
}

/// Not that of the keys, which are for the next one.
void SweepKeysWindowTest::theSelectedEditTellsItsOwnWay() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_S);
  drag(from, from + QPoint(50, 0));
  hover(from + QPoint(0, 60));
  key(Qt::Key_R);
  key(Qt::Key_4);
  window_->tree().select(all("sweep.pull").front());
  QEvent leave(QEvent::Leave);
  const auto idle = [&] {
    QApplication::sendEvent(&window_->view(), &leave);
    return hint().contains(QStringLiteral("selected edit: by scaling alone"));
  };
  QTRY_VERIFY2(idle(), qPrintable(hint()));
  QVERIFY2(!hint().contains(QStringLiteral("turning")) && !hint().contains(QStringLiteral("copies")), qPrintable(hint()));
  window_->tree().select(sweep_);
  const auto ofKeys = [&] {
    QApplication::sendEvent(&window_->view(), &leave);
    return hint().contains(QStringLiteral("by turning alone")) && hint().contains(QStringLiteral("4 copies"));
  };
  QTRY_VERIFY2(ofKeys(), qPrintable(hint()));
}

void SweepKeysWindowTest::nothingIsDraggedWhereTheSweepFails() {
  openSample("cylinder.json");
  hover(onTheSide());
  Feature failing = document().at(sweep_);
  failing.parameters["mode"] = "no such mode";
  window_->session().commit(document().with(failing), QStringLiteral("Break it"));
  waitUntilComputed();
  QVERIFY(window_->session().view(sweep_)->result->error);
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&window_->view(), &leave);
  QVERIFY2(!hint().startsWith(QStringLiteral("Drag a place")), qPrintable(hint()));
}

void SweepKeysWindowTest::keysStayInForceWhenSomethingElseIsSelected() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_S);
  key(Qt::Key_4);
  window_->tree().select({});
  QVERIFY(!window_->page().tool());
  window_->tree().select(sweep_);
  window_->view().setFocus();
  hover(from);
  QVERIFY2(hint().contains(QStringLiteral("by scaling alone")), qPrintable(hint()));
  QVERIFY2(hint().contains(QStringLiteral("4 copies")), qPrintable(hint()));
  drag(from, from + QPoint(40, 0));
  QCOMPARE(only("sweep.pull").parameters["fold"].get<int>(), 4);
  QCOMPARE(only("sweep.pull").parameters["rotate"].get<double>(), 0.0);
}

/// The point of the surface, and during a drag where it is taken, not the ground behind it.
void SweepKeysWindowTest::whereThePointIsIsTold() {
  openSample("cylinder.json");
  QSignalSpy told(&window_->view(), &ViewWidget::whereabouts);
  const auto toldPoint = [&told] {
    static const QRegularExpression three(QStringLiteral("^x (\\S+)   y (\\S+)   z (\\S+) mm$"));
    const auto found = three.match(told.isEmpty() ? QString() : told.back().front().toString());
    return found.hasMatch() ? std::optional(Vec3(found.captured(1).toDouble(), found.captured(2).toDouble(),
                                                 found.captured(3).toDouble()))
                            : std::nullopt;
  };
  const QPoint from = onTheSide(), to = from + QPoint(60, -10);
  hover(from);
  const auto place = toldPoint();
  QVERIFY2(place, qPrintable(told.back().front().toString()));
  QVERIFY(std::abs(place->head<2>().norm() - 10) < 0.1);
  QVERIFY((screenOf(*place) - from).manhattanLength() <= 3);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, to);
  const auto dragged = toldPoint();
  QVERIFY2(dragged, qPrintable(told.back().front().toString()));
  mouse(QEvent::MouseButtonRelease, to);
  waitUntilComputed();
  QVERIFY((*dragged - vectorOf(only("sweep.pull").parameters["pulls"][0]["to"])).norm() < 0.1);
  mouse(QEvent::MouseMove, QPoint(5, 5));
  QVERIFY(!toldPoint());
}

/// The handles cover the whole surface, whose faces can be selected all the same.
void SweepKeysWindowTest::aClickIsForTheView() {
  openSample("cylinder.json");
  const Document before = document();
  const QPoint at = onTheSide();
  hover(at);
  window_->view().setPickMode(PickMode::Face);
  mouse(QEvent::MouseButtonPress, at);
  mouse(QEvent::MouseButtonRelease, at);
  QCOMPARE(window_->view().selectedParts().size(), std::size_t(1));
  QVERIFY(window_->view().selectedParts().front().feature == sweep_);
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

/// Shift drags along the normal. Where that points at the viewer, the way of the mouse up counts, and the point does not run
/// away.
void SweepKeysWindowTest::alongANormalThatFacesTheViewerThePointKeepsToTheMouse() {
  openSample("cylinder.json");
  window_->view().lookFrom(QStringLiteral("front"), false);
  const Vec3 near(0, -10, 21);
  const QPoint from = screenOf(near), to = from - QPoint(0, 60);
  const double way = (screenOf(near + Vec3(0, 0, 10)) - from).y() / -10.0;  // pixels of a millimetre
  hover(from);
  drag(from, to, Qt::ShiftModifier);
  waitUntilComputed();
  const Value pull = only("sweep.pull").parameters["pulls"][0];
  const Vec3 moved = vectorOf(pull["to"]) - near;
  COMPARE_NEAR(moved.norm(), 60 / way, 0.05 * 60 / way);
  QVERIFY2(moved.y() < -0.98 * moved.norm(), qPrintable(QString::number(moved.y())));  // towards the viewer
}

void SweepKeysWindowTest::theHandlesAreSeen() {
  window_->resize(1280, 720);
  openSample("cylinder.json");
  const QPoint from = onTheSide(), to = from + QPoint(70, -30);
  hover(from);
  mouse(QEvent::MouseMove, from);
  const Look look = Look::dark();
  keepPictures("pull-hover", from);
  QVERIFY(colored(canvas(), qtColor(look.made)) > 1e-4);
  QVERIFY(colored(canvas(), qtColor(look.control)) > 3e-4);
  // The letter of scaling stands on a plate that hides the surface.
  const QImage picture = canvas();
  const double ratio = picture.width() / static_cast<double>(window_->view().width());
  const QPointF letter = from + 37.5 * QPointF(-std::cos(M_PI / 6), std::sin(M_PI / 6));
  for (const QPointF& beside : {QPointF(-7, 0), QPointF(7, 0), QPointF(0, -7), QPointF(0, 7)}) {
    const QColor seen = picture.pixelColor(((letter + beside) * ratio).toPoint()), plate = qtColor(look.backgroundBottom);
    const int off =
        std::abs(seen.red() - plate.red()) + std::abs(seen.green() - plate.green()) + std::abs(seen.blue() - plate.blue());
    QVERIFY2(off < 30, qPrintable(seen.name()));
  }
  key(Qt::Key_4);
  keepPictures("pull-four-hover", from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, to);
  keepPictures("pull-drag", to);
  QVERIFY(colored(canvas(), qtColor(look.made)) > 1e-3);
  key(Qt::Key_W);
  keepPictures("pull-twist", to);
  key(Qt::Key_Escape);
  mouse(QEvent::MouseButtonRelease, to);
}

BLOSSOM_WINDOW_TEST(SweepKeysWindowTest)
#include "sweep_keys_window_test.moc"
