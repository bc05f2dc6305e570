#include <QFile>
#include <QSlider>
#include <QToolButton>

#include "document/edits.h"
#include "ui/timeline/key_marks.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// A morph from a square to one twice as large, frame by frame: frame k of 11 is a square of side 10 + k.
class TimelineWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { window_.reset(); }

  void scrubbingShowsTheFrame();
  void aClickOnTheGrooveJumpsThere();
  void playingMovesOnAndPauses();
  void onionSkinShowsTheOthers();
  void theSkinFollowsTheKeys();
  void keysAddedInThePanelLeaveTheSequenceAsItIs();
  void framesAndBlossomNumbersGiveWayToEachOther();
  void playKeepsTheFocus();
  void theTimelineGoesWithItsSequence();
  void aSelectedSequenceIsExtruded();
  void theFrameThatIsSeenIsTaken();
  void aSequenceThatIsUsedUpPlaysWhileItIsSelected();
  void digitsInTheFieldOfTheTimeAreNoShortcuts();
  void theTimeOfTheMorphIsThatOfTheFrame();
  void keysAreSetAndDragged();

 private:
  [[nodiscard]] QString square(const char* name, int side) const {
    const QString file = folder_.filePath(QLatin1String(name));
    QFile svg(file);
    if (!svg.open(QIODevice::WriteOnly)) qFatal("no room for %s", name);
    svg.write(QStringLiteral("<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm' viewBox='0 0 20 20'>"
                             "<path d='M0 0H%1V%1H0Z'/></svg>")
                  .arg(side)
                  .toLatin1());
    return file;
  }
  [[nodiscard]] QWidget& timeline() const { return *window_->findChild<QWidget*>(QStringLiteral("timeline")); }
  [[nodiscard]] QSlider& slider() const { return *timeline().findChild<QSlider*>(); }
  [[nodiscard]] KeyMarks& marks() const { return *timeline().findChild<KeyMarks*>(); }
  [[nodiscard]] QToolButton& keyButton() const { return *timeline().findChild<QToolButton*>(QStringLiteral("keyframe")); }
  [[nodiscard]] Value keys() const {
    return window_->session().document().at(last()).parameters.value("keys", Value::array());
  }
  [[nodiscard]] Playback& playback() const { return window_->page().playback(); }
  [[nodiscard]] double shownWidth() const {
    const Bounds box = window_->view().extent();
    return box.high.x() - box.low.x();
  }
};

void TimelineWindowTest::init() {
  openWindow();
  openAndWait(square("small.svg", 10));
  window_->session().import({square("large.svg", 20).toStdString()});
  waitUntilComputed();
  std::vector<FeatureId> squares;
  for (const auto& feature : window_->session().document().features()) squares.push_back(feature->id);
  QCOMPARE(squares.size(), std::size_t{2});
  QVERIFY(!timeline().isVisible());
  window_->session().addFeature(*window_->session().app().registry->find("minkowski.morph"), squares);
  waitUntilComputed();
  edit("frames", "11");
  waitUntilComputed();
  Session& session = window_->session();
  session.commit(withOnlyVisible(session.document(), {last()}), QStringLiteral("Isolate"));
  QTRY_VERIFY(timeline().isVisible());
  QCOMPARE(playback().count(), 11);
}

void TimelineWindowTest::scrubbingShowsTheFrame() {
  for (const int frame : {0, 5, 10, 3}) {
    slider().setValue(frame);
    QCOMPARE(playback().frame(), frame);
    COMPARE_NEAR(shownWidth(), 10 + frame, 1e-6);
  }
  run("timeline.next");
  QCOMPARE(slider().value(), 4);
  run("timeline.previous");
  run("timeline.previous");
  COMPARE_NEAR(shownWidth(), 12, 1e-6);
}

/// The handle is 14 pixels wide: frame k of 0..10 stands 7 + k (width - 14) / 10 pixels from the left.
void TimelineWindowTest::aClickOnTheGrooveJumpsThere() {
  const auto at = [&](double frame) {
    return QPoint(qRound(7 + frame * (slider().width() - 14) / 10), slider().height() / 2);
  };
  for (const int frame : {9, 2, 10, 0, 5}) {
    QTest::mouseClick(&slider(), Qt::LeftButton, {}, at(frame + 0.3));
    QCOMPARE(playback().frame(), frame);
    COMPARE_NEAR(shownWidth(), 10 + frame, 1e-6);
  }
  QTest::mousePress(&slider(), Qt::LeftButton, {}, at(1));
  QCOMPARE(playback().frame(), 1);
  for (const int frame : {3, 8, 6}) {
    test::moveMouse(&slider(), at(frame));
    QTRY_COMPARE(playback().frame(), frame);
  }
  QTest::mouseRelease(&slider(), Qt::LeftButton, {}, at(6));
  QVERIFY(!slider().isSliderDown());
  // What takes hold of the handle beside its middle does not move it.
  QTest::mouseClick(&slider(), Qt::LeftButton, {}, at(6) + QPoint(6, 0));
  QCOMPARE(playback().frame(), 6);
}

void TimelineWindowTest::playingMovesOnAndPauses() {
  slider().setValue(8);
  auto* const play = timeline().findChild<QToolButton*>(QStringLiteral("play"));
  QTest::mouseClick(play, Qt::LeftButton);
  QVERIFY(playback().playing());
  QTRY_VERIFY(playback().frame() < 8);  // it has begun anew
  QTest::mouseClick(play, Qt::LeftButton);
  QVERIFY(!playback().playing());
  COMPARE_NEAR(shownWidth(), 10 + playback().frame(), 1e-6);
}

void TimelineWindowTest::onionSkinShowsTheOthers() {
  slider().setValue(10);
  window_->view().fit(false);
  slider().setValue(0);
  const QImage alone = canvas();
  run("timeline.onion-skin");
  const QImage together = canvas();
  // The outlines of later frames lie where nothing was drawn before. (That of the last lies under the control shape.)
  const QPoint late = screenOf({19, 1, 0}), half = screenOf({15, 5, 0});
  const auto changedAround = [&](const QPoint& at) {
    for (int dx = -4; dx <= 4; ++dx)
      for (int dy = -4; dy <= 4; ++dy) {
        const QPoint p = (at + QPoint(dx, dy)) * alone.devicePixelRatio();
        if (alone.rect().contains(p) && alone.pixel(p) != together.pixel(p)) return true;
      }
    return false;
  };
  QVERIFY(changedAround(late));
  QVERIFY(changedAround(half));
  run("timeline.onion-skin");
  QCOMPARE(canvas(), alone);
}

void TimelineWindowTest::theSkinFollowsTheKeys() {
  window_->tree().select(last());
  slider().setValue(10);
  window_->view().fit(false);
  run("timeline.onion-skin");
  const QImage evenly = canvas();
  const Value keys = {{{"frame", 1}, {"t", 0}}, {{"frame", 9}, {"t", 0.1}}, {{"frame", 11}, {"t", 1}}};
  Session& session = window_->session();
  Feature feature = session.document().at(last());
  feature.parameters["keys"] = keys;
  session.commit(session.document().with(feature), QStringLiteral("Keys"));
  waitUntilComputed();
  QVERIFY(canvas() != evenly);
  feature.parameters.erase("keys");
  session.commit(session.document().with(feature), QStringLiteral("No keys"));
  waitUntilComputed();
  QCOMPARE(canvas(), evenly);
}

void TimelineWindowTest::keysAddedInThePanelLeaveTheSequenceAsItIs() {
  window_->tree().select(last());
  slider().setValue(3);
  const auto addKey = [this] {
    for (auto* button : window_->properties().field(QStringLiteral("keys"))->findChildren<QToolButton*>())
      if (button->property("role") == QStringLiteral("add")) return button->click();
  };
  addKey();
  waitUntilComputed();
  QCOMPARE(marks().frames(), (std::vector<int>{1, 4, 11}));
  addKey();  // that frame has one: in the middle of the widest gap
  waitUntilComputed();
  QCOMPARE(marks().frames(), (std::vector<int>{1, 4, 7, 11}));
  for (const int frame : {0, 2, 5, 8, 10}) {
    slider().setValue(frame);
    COMPARE_NEAR(shownWidth(), 10 + frame, 1e-6);
  }
}

/// A click on "+" at the list, beside frames, must not end in an error.
void TimelineWindowTest::framesAndBlossomNumbersGiveWayToEachOther() {
  window_->tree().select(last());
  const auto parameter = [this](const char* name) {
    return window_->page().document().at(last()).parameters.value(name, Value());
  };
  const auto isFine = [this] {
    waitUntilComputed();
    return window_->session().view(last()) && !window_->session().view(last())->result->error;
  };
  for (auto* button : window_->properties().field(QStringLiteral("blossom"))->findChildren<QToolButton*>())
    if (button->property("role") == QStringLiteral("add")) {
      button->click();
      break;
    }
  QVERIFY(isFine());
  QVERIFY(!parameter("blossom").empty());
  QVERIFY(playback().count() < 2);
  edit("frames", "5");
  QVERIFY(isFine());
  QVERIFY(parameter("blossom").empty());
  QTRY_COMPARE(playback().count(), 5);
  // Each was one step.
  window_->session().undo();
  window_->session().undo();
  QVERIFY(isFine());
  QTRY_COMPARE(playback().count(), 11);
}

/// While the frames are computed, the button that was pressed keeps the focus: keys that follow must not end in a field.
void TimelineWindowTest::playKeepsTheFocus() {
  edit("frames", "0");
  waitUntilComputed();
  window_->tree().select(last());
  auto* const play = timeline().findChild<QToolButton*>(QStringLiteral("play"));
  QVERIFY(play && play->isVisible());
  play->setFocus();
  QTest::mouseClick(play, Qt::LeftButton);
  QVERIFY(window_->session().evaluating());
  QVERIFY(timeline().isVisible());
  waitUntilComputed();
  QTRY_VERIFY(playback().count() > 1);
  QVERIFY2(!qobject_cast<QLineEdit*>(QApplication::focusWidget()), "the name field");
}

void TimelineWindowTest::theTimelineGoesWithItsSequence() {
  slider().setValue(10);
  const FeatureId morph = last();
  Session& session = window_->session();
  session.commit(session.document().without(morph), QStringLiteral("Delete"));
  QTRY_VERIFY(!timeline().isVisible());
  QVERIFY(!window_->commands().find(QStringLiteral("timeline.play"))->action->isEnabled());
  session.undo();
  QTRY_VERIFY(timeline().isVisible());
  QVERIFY(window_->commands().find(QStringLiteral("timeline.play"))->action->isEnabled());
}

// The commands that take its frames take it, and what they make of it plays as it did.
void TimelineWindowTest::aSelectedSequenceIsExtruded() {
  const FeatureId morph = last();
  window_->page().select(morph);
  run("feature.modeling.extrude");
  waitUntilComputed();
  const FeatureId solids = last();
  QCOMPARE(window_->page().document().at(solids).inputs, std::vector<FeatureId>{morph});
  edit("height", "4");
  waitUntilComputed();
  const Shape* made = window_->session().shape(solids);
  QVERIFY(made && made->kind() == ShapeKind::Sequence);
  QTRY_COMPARE(playback().count(), 11);
  window_->page().select(solids);
  run("feature.modeling.frame");
  waitUntilComputed();
  edit("number", "6");
  waitUntilComputed();
  COMPARE_NEAR(measureOf(last(), "volume"), 4 * 15 * 15, 1e-6);
}

// Frame k of 11 is the shape at t = k / 10.
// After a single click, in which nothing is typed yet: 0 is Home of the view, 3 a side of it, a point the next frame.
void TimelineWindowTest::theFrameThatIsSeenIsTaken() {
  slider().setValue(6);
  window_->tree().select(last());
  run("feature.modeling.frame");
  waitUntilComputed();
  QCOMPARE(window_->session().document().at(last()).parameters.value("number", 0), 7);
  COMPARE_NEAR(measureOf(last(), "area"), 16 * 16, 1e-9);
}

void TimelineWindowTest::aSequenceThatIsUsedUpPlaysWhileItIsSelected() {
  const FeatureId morph = last();
  slider().setValue(6);
  window_->tree().select(morph);
  run("feature.modeling.frame");
  waitUntilComputed();
  QTRY_COMPARE(playback().count(), 0);
  window_->page().select(morph);
  QTRY_COMPARE(playback().count(), 11);
  for (const int frame : {0, 9, 4}) {
    slider().setValue(frame);
    COMPARE_NEAR(shownWidth(), std::max(10 + frame, 16), 1e-6);  // beside the square of frame 7
  }
}

void TimelineWindowTest::digitsInTheFieldOfTheTimeAreNoShortcuts() {
  auto* const line = window_->properties().field(QStringLiteral("t"))->findChild<QLineEdit*>();
  const QPoint middle = line->rect().center();
  for (const char* typed : {"0.3", ".6", "3/10"}) {
    QTest::mouseClick(line, Qt::LeftButton, {}, middle);
    QCOMPARE(QApplication::focusWidget(), line);
    QTest::keyClicks(line, QLatin1String(typed));
    QCOMPARE(line->text(), QLatin1String(typed));
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(playback().frame(), typed[0] == '.' ? 6 : 3);
  }
  for (const Qt::Key key : {Qt::Key_Comma, Qt::Key_Minus}) {
    QTest::mouseClick(line, Qt::LeftButton, {}, middle);
    const int before = playback().frame();
    QTest::keyClick(line, key);
    QVERIFY(!line->isReadOnly());
    QCOMPARE(playback().frame(), before);
    QTest::keyClick(line, Qt::Key_Escape);
  }
}

void TimelineWindowTest::theTimeOfTheMorphIsThatOfTheFrame() {
  const ParameterField* t = window_->properties().field(QStringLiteral("t"));
  QVERIFY(t);
  for (const int frame : {0, 7, 10}) {
    slider().setValue(frame);
    QCOMPARE(t->value(), Value(frame / 10.0));
  }
  const auto typeTime = [t, this](const char* typed) {
    QTest::keyClick(t->findChild<QLineEdit*>(), Qt::Key_Return);
    edit("t", typed);
  };
  const std::string document = toJson(window_->session().document());
  typeTime("0.808");
  QCOMPARE(playback().frame(), 8);
  QCOMPARE(slider().value(), 8);
  QCOMPARE(t->value(), Value(0.8));
  COMPARE_NEAR(shownWidth(), 18, 1e-6);
  QCOMPARE(toJson(window_->session().document()), document);  // to look at a frame is no edit
  auto* const line = t->findChild<QLineEdit*>();
  for (const int frame : {9, 10, 10}) {  // a key is a frame, though its own step of 0.01 is less
    QTest::keyClick(line, Qt::Key_Right);
    QCOMPARE(playback().frame(), frame);
    QCOMPARE(t->value(), Value(frame / 10.0));
  }
  QTest::keyClick(line, Qt::Key_Left);
  QCOMPARE(playback().frame(), 9);
  QCOMPARE(toJson(window_->session().document()), document);
  // Without frames t is a parameter again, and the bar offers to make a sequence while the morph is selected.
  edit("frames", "0");
  waitUntilComputed();
  QTRY_VERIFY(playback().count() < 2 && playback().playable() && timeline().isVisible());
  QTRY_COMPARE(t->value(), Value(0.5));
  typeTime("0.3");
  waitUntilComputed();
  QCOMPARE(window_->session().document().at(last()).parameters.at("t"), Value(0.3));
  COMPARE_NEAR(shownWidth(), 13, 1e-6);
}

/// At frame k of 11 the square has side 10 + 10 t.
void TimelineWindowTest::keysAreSetAndDragged() {
  const FeatureId morph = last();
  window_->tree().select(morph);
  QTRY_VERIFY(marks().isVisible() && keyButton().isVisible());
  QVERIFY(marks().frames().empty());
  // The first key brings those of the ends: nothing moves.
  slider().setValue(4);
  QTest::mouseClick(&keyButton(), Qt::LeftButton);
  waitUntilComputed();
  QVERIFY(keyButton().isChecked());
  QCOMPARE(marks().frames(), (std::vector<int>{1, 5, 11}));
  COMPARE_NEAR(keys()[1].at("t").get<double>(), 0.4, 1e-12);
  COMPARE_NEAR(shownWidth(), 14, 1e-6);
  // It is dragged: the same shape comes later.
  const QPoint from = marks().placeOf(5), to = marks().placeOf(9);
  test::moveMouse(&marks(), from);
  QTest::mousePress(&marks(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 4; ++i) test::moveMouse(&marks(), from + (to - from) * i / 4);
  waitUntilComputed();
  COMPARE_NEAR(shownWidth(), 12, 1e-6);  // previewed
  QTest::mouseRelease(&marks(), Qt::LeftButton, {}, to);
  waitUntilComputed();
  QCOMPARE(keys()[1].at("frame"), Value(9));
  for (const auto& [frame, side] : std::vector<std::pair<int, double>>{{8, 14}, {4, 12}, {9, 17}, {10, 20}}) {
    slider().setValue(frame);
    COMPARE_NEAR(shownWidth(), side, 1e-6);
  }
  window_->session().undo();
  waitUntilComputed();
  QCOMPARE(marks().frames(), (std::vector<int>{1, 5, 11}));
  // Esc gives a drag up; past its neighbours it does not go.
  QTest::mousePress(&marks(), Qt::LeftButton, {}, from);
  test::moveMouse(&marks(), marks().placeOf(11) + QPoint(30, 0));
  QCOMPARE(keys()[1].at("frame"), Value(10));
  QTest::keyClick(&marks(), Qt::Key_Escape);
  QTest::mouseRelease(&marks(), Qt::LeftButton, {}, from);
  waitUntilComputed();
  QCOMPARE(keys()[1].at("frame"), Value(5));
  // A click shows its frame; a double click beside sets one, Delete takes it out again.
  QTest::mouseClick(&marks(), Qt::LeftButton, {}, marks().placeOf(5));
  QCOMPARE(playback().frame(), 4);
  QTest::mouseDClick(&marks(), Qt::LeftButton, {}, marks().placeOf(8));
  waitUntilComputed();
  QCOMPARE(marks().frames(), (std::vector<int>{1, 5, 8, 11}));
  QTest::mouseClick(&marks(), Qt::LeftButton, {}, marks().placeOf(8));
  QTest::keyClick(&marks(), Qt::Key_Left);
  waitUntilComputed();
  QCOMPARE(marks().frames(), (std::vector<int>{1, 5, 7, 11}));
  QTest::keyClick(&marks(), Qt::Key_Delete);
  waitUntilComputed();
  QCOMPARE(marks().frames(), (std::vector<int>{1, 5, 11}));
  QVERIFY(window_->session().document().contains(morph));
  slider().setValue(4);
  QTest::mouseClick(&keyButton(), Qt::LeftButton);
  waitUntilComputed();
  QCOMPARE(marks().frames(), (std::vector<int>{1, 11}));
  // Without a key that is chosen, Delete takes nothing; a key where there is one already is no step.
  const std::size_t steps = window_->session().history().step();
  QTest::mouseClick(&marks(), Qt::LeftButton, {}, marks().placeOf(6));
  QTest::keyClick(&marks(), Qt::Key_Delete);
  QVERIFY(window_->session().document().contains(morph));
  emit marks().added(11);
  QCOMPARE(window_->session().history().step(), steps);
  // A drag ends with what is undone meanwhile, and when the marks are hidden.
  QTest::mousePress(&marks(), Qt::LeftButton, {}, marks().placeOf(1));
  test::moveMouse(&marks(), marks().placeOf(3));
  QCOMPARE(keys()[0].at("frame"), Value(3));
  window_->session().undo();
  const Value undone = keys();
  test::moveMouse(&marks(), marks().placeOf(4));
  QTest::mouseRelease(&marks(), Qt::LeftButton, {}, marks().placeOf(4));
  QCOMPARE(keys(), undone);
  QTest::mousePress(&marks(), Qt::LeftButton, {}, marks().placeOf(1));
  test::moveMouse(&marks(), marks().placeOf(3));
  QVERIFY(window_->session().previewing());
  // They belong to the sequence that is selected.
  window_->tree().select(window_->session().document().features().front()->id);
  QTRY_VERIFY(!marks().isVisible());
  QVERIFY(!window_->session().previewing());
  QCOMPARE(keys(), undone);
}

BLOSSOM_WINDOW_TEST(TimelineWindowTest)
#include "timeline_window_test.moc"
