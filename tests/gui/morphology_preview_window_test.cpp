#include "document/evaluation/quick_preview.h"
#include "support/polyhedra.h"
#include "ui/controls/ratio_slider.h"
#include "ui/panel/result_rows.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;
using namespace blossom::test;

/// What is seen of a sum that takes seconds while something it is made of is dragged: previews of where the hand is.
class MorphologyPreviewWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void aSlowMorphIsPreviewedByItsSlider();
  void aHandThatComesToRestSoonSeesWhereItIs();
  void aSliderThatIsLetGoInAHurryShowsWhereItIs();
  void theOutlineUnderASlowSumIsPreviewed();
  void theTableIsOfWhatIsSelected();
  void whatIsMadeOfAPreviewDoesNotHoldUpTheWhole();
  void whatIsNotComputedIsNotExported();

 private:
  /// A result of `watched_` as it came: how it was made, and its volume.
  struct Seen {
    std::string way;
    double volume = 0;
  };

  FeatureId slowMorph();
  /// As when a slider is let go in a hurry.
  void commitCoarselyFirst(const FeatureId& morph, double t) {
    Session& session = window_->session();
    Feature feature = session.document().at(morph);
    feature.parameters["t"] = t;
    const Document document = session.document().with(feature);
    session.commit(document, QStringLiteral("Change t"), quickPreview(document, *session.app().registry, morph)->document);
  }
  void watch(const FeatureId& id);
  [[nodiscard]] std::string way() const { return seen_.empty() ? std::string() : seen_.back().way; }
  void verifyPreviewOfTheLast();
  [[nodiscard]] bool isPale(const FeatureId& id) const {
    const std::vector<ViewItem> items = window_->page().shownItems();
    return std::any_of(items.begin(), items.end(),
                       [&](const ViewItem& item) { return item.id == id && item.presence == Presence::Outdated; });
  }
  void slideTo(RatioSlider& slider, double share) {
    mouseIn(&slider, QEvent::MouseMove, QPointF(share * slider.width(), slider.height() / 2.0));
  }
  RatioSlider& sliderOnceSlow(const FeatureId& morph);

  std::vector<Seen> seen_;
};

FeatureId MorphologyPreviewWindowTest::slowMorph() {
  openNewDocument();
  const FeatureId outline = add("modeling.star", {{"points", 7}, {"outer", 22}, {"inner", 12}});
  const FeatureId gear = add("modeling.extrude", {{"height", 10}}, {outline});
  const FeatureId ring = add("modeling.torus", {{"position", {60, 0, 0}}});
  return add("morphology.solid-morph", {{"t", 0.5}}, {gear, ring});
}

void MorphologyPreviewWindowTest::watch(const FeatureId& id) {
  seen_.clear();
  connect(&window_->session(), &Session::viewsChanged, window_.get(), [this, id](const std::set<FeatureId>& changed) {
    const auto view = window_->session().view(id);
    if (!changed.contains(id) || !view || view->result->error) return;
    seen_.push_back({view->result->evaluated.stats.value("way", std::string()), measureOf(id, "volume")});
  });
}

/// Of a morph whose previews have begun to come.
RatioSlider& MorphologyPreviewWindowTest::sliderOnceSlow(const FeatureId& morph) {
  window_->tree().selectThese({morph});
  watch(morph);
  auto* const slider = window_->properties().field(QStringLiteral("t"))->findChild<RatioSlider*>();
  mouseIn(slider, QEvent::MouseButtonPress, QPointF(0.5 * slider->width(), slider->height() / 2.0));
  for (int k = 1; k <= 1000 && way() != "field"; ++k) {
    slideTo(*slider, 0.1 + 0.002 * (k % 100));
    QTest::qWait(30);
  }
  return *slider;
}

/// The one before the exact result is of the same place: a grid is off by some percent, other places by much more.
void MorphologyPreviewWindowTest::verifyPreviewOfTheLast() {
  QTRY_VERIFY_WITH_TIMEOUT(!seen_.empty() && way() == "arranged" && !window_->session().evaluating(), 60000);
  QVERIFY(seen_.size() >= 2);
  const Seen& before = seen_[seen_.size() - 2];
  QCOMPARE(before.way, std::string("field"));
  COMPARE_NEAR(before.volume, seen_.back().volume, 0.1 * seen_.back().volume);
}

void MorphologyPreviewWindowTest::aSlowMorphIsPreviewedByItsSlider() {
  const FeatureId morph = slowMorph();
  RatioSlider& slider = sliderOnceSlow(morph);
  QCOMPARE(way(), std::string("field"));  // seen while the slider moves
  for (int k = 1; k <= 60; ++k) {
    slideTo(slider, 0.3 + 0.005 * k);
    QTest::qWait(30);
    QVERIFY(!isPale(morph));
  }
  slideTo(slider, 0.45);
  verifyPreviewOfTheLast();  // the hand rests
  mouseIn(&slider, QEvent::MouseButtonRelease, QPointF(0.45 * slider.width(), slider.height() / 2.0));
  waitUntilComputed();
  QCOMPARE(way(), std::string("arranged"));
  QVERIFY(window_->page().document().at(morph).parameters.value("preview", Value(0)) == 0);
}

/// Before the preview of that place has come: the whole result must not cut it off.
void MorphologyPreviewWindowTest::aHandThatComesToRestSoonSeesWhereItIs() {
  const FeatureId morph = slowMorph();
  RatioSlider& slider = sliderOnceSlow(morph);
  slideTo(slider, 0.95);
  verifyPreviewOfTheLast();
  mouseIn(&slider, QEvent::MouseButtonRelease, QPointF(0.95 * slider.width(), slider.height() / 2.0));
}

void MorphologyPreviewWindowTest::aSliderThatIsLetGoInAHurryShowsWhereItIs() {
  const FeatureId morph = slowMorph();
  RatioSlider& slider = sliderOnceSlow(morph);
  slideTo(slider, 0.95);
  mouseIn(&slider, QEvent::MouseButtonRelease, QPointF(0.95 * slider.width(), slider.height() / 2.0));
  QVERIFY(!window_->session().previewing());
  verifyPreviewOfTheLast();
  QVERIFY(!window_->session().coarse());
  QVERIFY(window_->session().document().at(morph).parameters.value("preview", Value(0)) == 0);
}

void MorphologyPreviewWindowTest::theOutlineUnderASlowSumIsPreviewed() {
  openNewDocument();
  const FeatureId outline = add("modeling.star", {{"points", 12}, {"outer", 22}, {"inner", 15}, {"rotation", 0}});
  const FeatureId gear = add("modeling.extrude", {{"height", 10}}, {outline});
  const FeatureId ring = add("modeling.torus", {{"radius", 8}, {"tube", 2}});
  const FeatureId sum = add("morphology.solid-sum", Value::object(), {gear, ring});
  run("view.top");
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch) > 1.5);
  run("view.fit");
  window_->tree().select(outline);
  QTest::qWait(0);
  watch(sum);
  moveTo({22, 0, 0});
  mouse(QEvent::MouseButtonPress, screenOf({22, 0, 0}));
  // Slowly, so that the hand seems to rest between any two movements.
  for (int k = 1; k <= 10; ++k) {
    mouse(QEvent::MouseMove, screenOf({22 + 1.0 * k, 0, 0}), Qt::ControlModifier);
    QTest::qWait(2 * previewPatience);
  }
  verifyPreviewOfTheLast();
  QVERIFY(std::count_if(seen_.begin(), seen_.end(), [](const Seen& each) { return each.way == "field"; }) >= 2);
  mouse(QEvent::MouseButtonRelease, screenOf({32, 0, 0}), Qt::ControlModifier);
  waitUntilComputed();
  COMPARE_NEAR(window_->session().document().at(outline).parameters.at("outer").get<double>(), 32,
               3 * window_->view().camera().millimetresPerPixel());
  QCOMPARE(way(), std::string("arranged"));
  // Without the sum, what is left is quick again.
  Session& session = window_->session();
  session.undo();
  session.undo();
  QVERIFY(!session.document().contains(sum));
  waitUntilComputed();
  moveTo({22, 0, 0});
  mouse(QEvent::MouseButtonPress, screenOf({22, 0, 0}));
  QSignalSpy previews(&session, &Session::documentChanged);
  for (int k = 1; k <= 60; ++k) {
    mouse(QEvent::MouseMove, screenOf({22 + 0.1 * k, 0, 0}), Qt::ControlModifier);
    QTest::qWait(20);
  }
  QVERIFY2(previews.count() > 10, qPrintable(QString::number(previews.count())));
  mouse(QEvent::MouseButtonRelease, screenOf({28, 0, 0}), Qt::ControlModifier);
}

/// The table of results follows the selection, whatever is previewed.
void MorphologyPreviewWindowTest::theTableIsOfWhatIsSelected() {
  const FeatureId morph = slowMorph();
  const FeatureId first = add("modeling.box", Value::object());
  const FeatureId second = add("modeling.box", {{"position", {0, 50, 0}}});
  const FeatureId sequence = add("morphology.solid-morph", {{"frames", 6}}, {first, second});
  waitUntilComputed();
  window_->tree().selectThese({morph});
  watch(morph);
  commitCoarselyFirst(morph, 0.9);
  QTRY_VERIFY_WITH_TIMEOUT(way() == "field", 30000);
  window_->tree().selectThese({sequence});
  const auto told = [&] {
    QStringList names;
    for (const ResultRows* rows : window_->properties().findChildren<ResultRows*>())
      for (const ResultRow& row : rows->rows()) names << row.name;
    return names;
  };
  QTRY_VERIFY2(told().contains(QStringLiteral("Frames")), qPrintable(told().join(u' ')));
  QVERIFY(!told().contains(QStringLiteral("Volume")));
  waitUntilComputed();
  window_->tree().selectThese({morph});
  QTRY_VERIFY(told().contains(QStringLiteral("Volume")));
}

/// A subdivided grid mesh takes longer than the subdivided result, and nobody wants to see it.
void MorphologyPreviewWindowTest::whatIsMadeOfAPreviewDoesNotHoldUpTheWhole() {
  const FeatureId morph = slowMorph();
  const FeatureId smooth = add("subdivision.subdivide", {{"levels", 3}}, {morph});
  Session& session = window_->session();
  watch(morph);
  std::vector<std::string> waysWhenSmoothed;
  connect(&session, &Session::viewsChanged, window_.get(), [&](const std::set<FeatureId>& changed) {
    if (changed.contains(smooth)) waysWhenSmoothed.push_back(way());
  });
  commitCoarselyFirst(morph, 0.9);
  // Once the preview is there, it is seen like a result until the exact one comes, and only then.
  QTRY_VERIFY_WITH_TIMEOUT(way() == "field" && session.awaited(morph), 30000);
  QVERIFY(session.standsIn(morph));
  session.commit(session.document().with(Feature(session.document().at(morph))), QStringLiteral("Same again"));
  QVERIFY(session.standsIn(morph));
  waitUntilComputed();
  QVERIFY(!session.standsIn(morph));
  QVERIFY(seen_.size() >= 2 && seen_.front().way == "field");
  QCOMPARE(way(), std::string("arranged"));
  QVERIFY(!waysWhenSmoothed.empty());
  for (const std::string& each : waysWhenSmoothed) QCOMPARE(each, std::string("arranged"));
  QVERIFY(!session.coarse());
  // Cancelled while only the preview is there: it does not pass for the result.
  seen_.clear();
  commitCoarselyFirst(morph, 0.2);
  QTRY_VERIFY_WITH_TIMEOUT(way() == "field", 30000);
  session.cancelEvaluation();
  QVERIFY(session.cancelled(morph) && session.cancelled(smooth));
  session.compute();
  waitUntilComputed();
  QCOMPARE(way(), std::string("arranged"));
  QVERIFY(!session.cancelled(morph) && !session.coarse());
}

void MorphologyPreviewWindowTest::whatIsNotComputedIsNotExported() {
  const FeatureId morph = slowMorph();
  waitUntilComputed();
  Session& session = window_->session();
  watch(morph);
  const QString file = folder_.filePath(QStringLiteral("morph.off"));
  QSignalSpy refused(&session, &Session::failed);
  const auto begin = [&] { session.exportFeature(morph, file.toStdString(), Value::object()); };
  commitCoarselyFirst(morph, 0.9);
  begin();  // what is seen is of the place before
  QTRY_VERIFY_WITH_TIMEOUT(way() == "field", 30000);
  QVERIFY(!session.job().running() && !QFile::exists(file) && refused.isEmpty());
  session.cancelEvaluation();
  QCOMPARE(refused.count(), 1);
  begin();
  QCOMPARE(refused.count(), 2);
  session.compute();
  begin();
  QTRY_VERIFY_WITH_TIMEOUT(!session.evaluating() && !session.job().running() && QFile::exists(file), 60000);
  QCOMPARE(refused.count(), 2);
  QCOMPARE(way(), std::string("arranged"));
  const Shape written = readShape(*session.app().formats, file.toStdString()).shape;
  COMPARE_NEAR(volumeOf(*written.get<Mesh>()), measureOf(morph, "volume"), 1e-6 * measureOf(morph, "volume"));
}

BLOSSOM_WINDOW_TEST(MorphologyPreviewWindowTest)
#include "morphology_preview_window_test.moc"
