// What has gone into a result is not drawn beside it, in the real window.
#include "document/edits.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class SteppingBackTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openNewDocument(); }
  void cleanup() { window_.reset(); }
  void chainsShowTheirEnd();
  void aCutShowsItsHole();
  void controlsOfAMorphLieBeneathIt();
  void aFeatureThatFailsKeepsItsLastShape();
  void sequencesThatAreUsedUpDoNotPlay();

 private:
  void change(const FeatureId& id, const char* parameter, const Value& value) {
    Feature feature = window_->page().document().at(id);
    feature.parameters[parameter] = value;
    window_->session().commit(window_->page().document().with(feature), QStringLiteral("Change"));
    waitUntilComputed();
  }
  [[nodiscard]] std::map<FeatureId, Presence> shown(const FeatureId& selected = {}) {
    window_->tree().select(selected);
    std::map<FeatureId, Presence> found;
    for (const ViewItem& item : window_->page().shownItems()) found[item.id] = item.presence;
    return found;
  }
  [[nodiscard]] Pick pickedAt(const Vec3& p) { return window_->view().pickAt(screenOf(p), PickMode::Feature); }
};

using Presences = std::map<FeatureId, Presence>;

void SteppingBackTest::chainsShowTheirEnd() {
  const FeatureId outline = add("modeling.rectangle", {{"width", 60}, {"height", 40}});
  QCOMPARE(shown(), (Presences{{outline, Presence::Whole}}));
  const FeatureId solid = add("modeling.extrude", {{"height", 20}}, {outline});
  const FeatureId rounded = add("modeling.fillet", {{"radius", 3}}, {solid});
  QCOMPARE(shown(), (Presences{{rounded, Presence::Whole}}));
  // What is edited brings back what it is made of; a step before steps before its result.
  QCOMPARE(shown(rounded), (Presences{{rounded, Presence::Whole}, {solid, Presence::SteppedBack}}));
  QCOMPARE(shown(outline), (Presences{{rounded, Presence::SteppedBack}, {outline, Presence::Whole}}));
  QVERIFY(window_->page().document().at(solid).visible && window_->page().document().at(outline).visible);
  window_->tree().select(rounded);
  window_->view().lookFrom(QStringLiteral("top"), false);
  QCOMPARE(pickedAt({0, 0, 20}).feature, rounded);
  QCOMPARE(pickedAt({29.9, 19.9, 20}).feature, solid);  // a corner that is cut off, where only its hint is
  // It comes back when the feature is gone.
  window_->session().commit(window_->page().document().without(rounded), QStringLiteral("Delete"));
  waitUntilComputed();
  QCOMPARE(shown(), (Presences{{solid, Presence::Whole}}));
}

void SteppingBackTest::aCutShowsItsHole() {
  const FeatureId block = add("modeling.box", {{"width", 60}, {"depth", 40}, {"height", 20}});
  const FeatureId pin = add("modeling.cylinder", {{"radius", 8}, {"height", 60}});
  const FeatureId cut = add("modeling.boolean", {{"operation", "difference"}}, {block, pin});
  QCOMPARE(shown(), (Presences{{cut, Presence::Whole}}));
  window_->view().lookFrom(QStringLiteral("top"), false);
  const double before = measureOf(cut, "volume");
  change(pin, "radius", 4);
  QVERIFY(measureOf(cut, "volume") > before);
  QCOMPARE(shown(cut), (Presences{{cut, Presence::Whole}, {block, Presence::SteppedBack}, {pin, Presence::SteppedBack}}));
}

void SteppingBackTest::controlsOfAMorphLieBeneathIt() {
  const FeatureId circle = add("modeling.circle", {{"radius", 20}}), star = add("modeling.star", Value::object());
  const FeatureId morph = add("minkowski.morph", Value::object(), {circle, star});
  const Presences wanted{{circle, Presence::Beneath}, {star, Presence::Beneath}, {morph, Presence::Whole}};
  QCOMPARE(shown(), wanted);
  QCOMPARE(shown(morph), wanted);
  window_->view().lookFrom(QStringLiteral("top"), false);
  window_->tree().select({});
  QCOMPARE(pickedAt({1, 1, 0}).feature, morph);
}

void SteppingBackTest::aFeatureThatFailsKeepsItsLastShape() {
  const FeatureId block = add("modeling.box", {{"width", 60}, {"depth", 40}, {"height", 20}});
  const FeatureId rounded = add("modeling.fillet", {{"radius", 3}}, {block});
  const FeatureId moved = add("modeling.transform", {{"move", {5, 0, 0}}}, {rounded});
  change(rounded, "radius", 30);
  const auto view = window_->session().view(rounded);
  QVERIFY(view->result->error && !view->scene.empty());
  QCOMPARE(shown(), (Presences{{moved, Presence::Failed}}));
  QCOMPARE(shown(rounded),
           (Presences{{rounded, Presence::Failed}, {moved, Presence::SteppedBack}, {block, Presence::SteppedBack}}));
  change(rounded, "radius", 2);
  QCOMPARE(shown(), (Presences{{moved, Presence::Whole}}));
  // What never had a shape has none to keep.
  const FeatureId never = add("modeling.fillet", {{"radius", 300}}, {moved});
  QCOMPARE(shown(), (Presences{{moved, Presence::Whole}}));
  QVERIFY(window_->session().view(never)->result->error);
}

void SteppingBackTest::sequencesThatAreUsedUpDoNotPlay() {
  const FeatureId circle = add("modeling.circle", {{"radius", 20}}), star = add("modeling.star");
  const FeatureId morph = add("minkowski.morph", {{"frames", 7}}, {circle, star});
  const auto* const timeline = window_->findChild<QWidget*>(QStringLiteral("timeline"));
  const FeatureId moved = add("modeling.transform", {{"move", {5, 0, 0}}}, {morph});
  QTRY_VERIFY(timeline->isVisible());
  Feature hidden = window_->page().document().at(moved);
  hidden.visible = false;
  window_->session().commit(window_->page().document().with(hidden), QStringLiteral("Hide"));
  waitUntilComputed();
  QTRY_VERIFY(!timeline->isVisible());
}

BLOSSOM_WINDOW_TEST(SteppingBackTest)
#include "stepping_back_test.moc"
