#include <algorithm>

#include "geometry/shape/sequence.h"
#include "ui/panel/result_rows.h"
#include "ui/timeline/playback.h"
#include "ui/tools/view_props.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// A morph that takes longer than a frame may: something coarser follows the hand, and the whole comes when it rests. The
/// budget is set so that nothing keeps it, or everything.
class MinkowskiDetailWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { window_.reset(); }

  void theWholeComesAtRest();
  void theTimelineStaysWhereItIs();
  void timeAndFiguresAreThoseOfTheWhole();
  void theTimeStaysThatOfTheFrame();
  void withinTheBudgetNothingIsCoarse();

 private:
  [[nodiscard]] Tool& tool() const { return *window_->page().tool(); }
  [[nodiscard]] int coarse() const { return tool().property("coarsePreviews").toInt(); }
  [[nodiscard]] Playback& playback() const { return window_->page().playback(); }
  /// The frames of the morph as the document says, computed on their own.
  [[nodiscard]] Sequence whole() const;
  [[nodiscard]] const Sequence* shown() const {
    const auto result = window_->page().result(morph_);
    return result ? result->evaluated.shape.get<Sequence>() : nullptr;
  }
  [[nodiscard]] bool showsTheWhole() const;
  void take(double budget);
  void moveBy(int steps, double offset);
  FeatureId morph_;
  QPoint from_;
};

/// Round shapes, whose sums depend on the tolerance, in 25 frames, of which the eighth is seen.
void MinkowskiDetailWindowTest::init() {
  openNewDocument();
  const FeatureId a = add("modeling.ellipse", {{"a", 20}, {"b", 8}});
  const FeatureId b = add("modeling.star", {{"points", 5}, {"outer", 24}, {"inner", 9}, {"centre", {100, 0, 0}}});
  morph_ = add("minkowski.morph", {{"frames", 25}}, {a, b});
  window_->tree().select(morph_);
  run("view.top");
  window_->view().fitTo({{-60, -90, 0}, {180, 90, 0}}, false);
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  QTRY_COMPARE(playback().count(), 25);
  playback().show(7);
  QTRY_VERIFY(window_->view().sharp());
}

Sequence MinkowskiDetailWindowTest::whole() const {
  Evaluator apart(window_->session().app().registry);
  const Results results = apart.evaluate(window_->page().document(), Progress::none());
  const auto* const made = results.at(morph_)->evaluated.shape.get<Sequence>();
  return made ? *made : Sequence();
}

bool MinkowskiDetailWindowTest::showsTheWhole() const {
  const Sequence wanted = whole();
  const Sequence* const now = shown();
  if (!now || now->frames.size() != wanted.frames.size() || now->times != wanted.times) return false;
  for (std::size_t k = 0; k < wanted.frames.size(); ++k)
    if (*now->frames[k].get<Region>() != *wanted.frames[k].get<Region>()) return false;
  return true;
}

/// Hold of the number of the star.
void MinkowskiDetailWindowTest::take(double budget) {
  QVERIFY(tool().setProperty("frameBudget", budget));
  from_ = screenOf({100, 0, 0}) - QPoint(0, static_cast<int>(labelGap) + 11);
  test::moveMouse(&window_->view(), from_);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, from_);
}

void MinkowskiDetailWindowTest::moveBy(int steps, double offset) {
  for (int k = 1; k <= steps; ++k) test::moveMouse(&window_->view(), from_ + QPoint(3 * k, qRound(offset)));
}

void MinkowskiDetailWindowTest::theWholeComesAtRest() {
  take(-1);
  moveBy(8, 20);
  QVERIFY(coarse() > 0);
  const Value moved = window_->page().document().at(morph_).parameters;
  QVERIFY(!moved.at("offsets").empty());
  // What is shown stands for the document, which says nothing of it.
  QCOMPARE(moved.at("frames"), Value(25));
  QVERIFY(!moved.contains("keys") || moved.at("keys").empty());
  QVERIFY(!moved.contains("tolerance") || moved.at("tolerance").is_null());
  // Still held, at rest.
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().coarse() && !window_->session().evaluating(), 300000);
  QVERIFY(showsTheWhole());
  // And let go of in the middle of a movement.
  const int before = coarse();
  moveBy(12, 35);
  QVERIFY(coarse() > before);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, from_ + QPoint(36, 35));
  waitUntilComputed();
  QVERIFY(!window_->session().coarse());
  QVERIFY(showsTheWhole());
  QVERIFY(window_->page().document().at(morph_).parameters.at("offsets") != moved.at("offsets"));
  // Given up.
  const Value kept = window_->page().document().at(morph_).parameters.at("offsets");
  from_ += QPoint(36, 35);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, from_);
  moveBy(6, -20);
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, from_);
  waitUntilComputed();
  QCOMPARE(window_->page().document().at(morph_).parameters.at("offsets"), kept);
  QVERIFY(showsTheWhole());
}

void MinkowskiDetailWindowTest::theTimelineStaysWhereItIs() {
  const auto stays = [this] { return playback().count() == 25 && playback().frame() == 7; };
  take(-1);
  for (int k = 1; k <= 12; ++k) {
    moveBy(2, 4.0 * k);
    QCoreApplication::processEvents();
    QVERIFY(stays());
    if (const Sequence* const now = shown()) QVERIFY(now->frames.size() == 25 || now->frames.size() == 3);
  }
  QVERIFY(coarse() > 0);
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().coarse() && !window_->session().evaluating(), 300000);
  QVERIFY(stays());
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, from_ + QPoint(6, 48));
  waitUntilComputed();
  QVERIFY(stays());
}

/// While it plays on, t follows, and the few frames are not told as the result.
void MinkowskiDetailWindowTest::timeAndFiguresAreThoseOfTheWhole() {
  const auto countTold = [this] {
    const auto& rows = window_->properties().findChild<ResultRows*>()->rows();
    return std::any_of(rows.begin(), rows.end(), [](const ResultRow& row) { return row.value() == QStringLiteral("25"); });
  };
  const auto shownTime = [this] { return window_->properties().field(QStringLiteral("t"))->value().get<double>(); };
  QVERIFY(countTold());
  COMPARE_NEAR(shownTime(), 7.0 / 24, 1e-12);
  take(-1);
  for (int k = 1; k <= 12; ++k) {
    moveBy(2, 4.0 * k);
    playback().show(7 + k);
    QCoreApplication::processEvents();
    QVERIFY(countTold());
    COMPARE_NEAR(shownTime(), (7.0 + k) / 24, 1e-12);
  }
  QVERIFY(coarse() > 0);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, from_ + QPoint(6, 48));
  waitUntilComputed();
}

/// From the first movement until all is computed, not the default of t, which the document does not hold.
void MinkowskiDetailWindowTest::theTimeStaysThatOfTheFrame() {
  const auto shownTime = [this] { return window_->properties().field(QStringLiteral("t"))->value().get<double>(); };
  COMPARE_NEAR(shownTime(), 7.0 / 24, 1e-12);
  take(-1);
  for (int k = 1; k <= 6; ++k) {
    moveBy(2, 4.0 * k);
    COMPARE_NEAR(shownTime(), 7.0 / 24, 1e-12);
  }
  QVERIFY(coarse() > 0);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, from_ + QPoint(6, 24));
  COMPARE_NEAR(shownTime(), 7.0 / 24, 1e-12);
  waitUntilComputed();
  COMPARE_NEAR(shownTime(), 7.0 / 24, 1e-12);
}

void MinkowskiDetailWindowTest::withinTheBudgetNothingIsCoarse() {
  take(1e9);
  moveBy(8, 20);
  waitUntilComputed();
  QCOMPARE(coarse(), 0);
  QVERIFY(showsTheWhole());
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, from_ + QPoint(24, 20));
  waitUntilComputed();
  QCOMPARE(coarse(), 0);
}

BLOSSOM_WINDOW_TEST(MinkowskiDetailWindowTest)
#include "minkowski_detail_window_test.moc"
