// A command begins with what is selected, or asks for it in the view.
#include <QToolButton>
#include <algorithm>
#include <numbers>

#include "ui/fields/parameter_field.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class CommandStartTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openNewDocument(); }
  void cleanup() { window_.reset(); }
  void edgesThatArePickedAreRounded();
  void anEdgeThatIsPickedIsSweptAlong();
  void theSelectModeIsSeenAndTheBackgroundClears();
  void moreEdgesArePickedOnTheInput();
  void whatIsMissingIsAskedForInTheView();
  void theAnswerMayComeFromTheTree();
  void whereOneShapeFitsItIsTaken();
  void whereNothingFitsItIsSaid();
  void whatIsHiddenIsNotTakenUnasked();
  void whatMakesTheMissingShapeIsOffered();
  void inputsAreInTheOrderOfTheSelection();
  void whatThereIsNoRoomForIsTold();

 private:
  void selectNothing() { window_->tree().select({}); }
  [[nodiscard]] std::size_t features() const { return window_->page().document().features().size(); }
  /// Of a box of 60 x 40 x 20 with so many of its edges of one length rounded by 3.
  static double rounded(int edges, double length) { return 48000 - edges * (1 - std::numbers::pi / 4) * 9 * length; }
  FeatureId box() {
    const FeatureId id = add("modeling.box", {{"width", 60}, {"depth", 40}, {"height", 20}});
    window_->view().lookFrom(QStringLiteral("iso"), false);
    return id;
  }
  /// The middle of an edge of the box along x, and of one along y, seen from the view "iso".
  [[nodiscard]] std::vector<Vec3> edgesInSight(const FeatureId& id) {
    const Bounds all = window_->view().extent();
    static_cast<void>(id);
    const Vec3 low = all.low, high = all.high, middle = (low + high) / 2;
    return {{middle.x(), low.y(), high.z()}, {high.x(), middle.y(), high.z()}};
  }
};

void CommandStartTest::edgesThatArePickedAreRounded() {
  const FeatureId id = box();
  run("select.edges");
  selectNothing();
  clickAt(edgesInSight(id)[0]);
  QCOMPARE(window_->view().selectedParts().size(), std::size_t{1});
  run("feature.modeling.fillet");
  waitUntilComputed();
  edit("radius", "3");
  waitUntilComputed();
  QCOMPARE(features(), std::size_t{2});
  QCOMPARE(window_->page().document().at(last()).parameters.at("edges").size(), std::size_t{1});
  COMPARE_NEAR(measureOf(last(), "volume"), rounded(1, 60), 1e-3);
}

void CommandStartTest::anEdgeThatIsPickedIsSweptAlong() {
  const FeatureId id = box();
  run("select.edges");
  selectNothing();
  clickAt(edgesInSight(id)[0]);
  run("feature.sweep.frame");
  waitUntilComputed();
  const Feature& motion = window_->page().document().at(last());
  QCOMPARE(motion.type, std::string("sweep.frame"));
  QCOMPARE(motion.inputs, std::vector<FeatureId>{id});
  QCOMPARE(motion.parameters.at("edges").size(), std::size_t{1});
  const Shape* made = window_->session().shape(motion.id);
  QVERIFY(made && made->get<Motion>());
  const std::vector<ViewItem> items = window_->page().shownItems();
  const auto solid = std::find_if(items.begin(), items.end(), [&](const ViewItem& each) { return each.id == id; });
  QVERIFY(solid != items.end() && solid->presence == Presence::Whole);  // the motion takes nothing but its edge
}

void CommandStartTest::theSelectModeIsSeenAndTheBackgroundClears() {
  const FeatureId id = box();
  const auto* mode = window_->findChild<QToolButton*>(QStringLiteral("pickMode"));
  QVERIFY(mode && mode->isVisible());
  QCOMPARE(mode->text(), QStringLiteral("Select: Features"));
  run("select.edges");
  QCOMPARE(mode->text(), QStringLiteral("Select: Edges"));
  QVERIFY(mode->menu()->actions().contains(window_->commands().action(QStringLiteral("select.faces"))));
  window_->page().select(id);
  clickAt(edgesInSight(id)[0]);
  QCOMPARE(window_->view().selectedParts().size(), std::size_t{1});
  QVERIFY(!window_->page().selection().empty());
  QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, QPoint(6, window_->view().height() - 6));
  QVERIFY(window_->view().selectedParts().empty());
  QVERIFY(window_->page().selection().empty());
}

void CommandStartTest::moreEdgesArePickedOnTheInput() {
  const FeatureId id = box();
  const std::vector<Vec3> edges = edgesInSight(id);
  run("select.edges");
  clickAt(edges[0]);
  run("feature.modeling.fillet");
  waitUntilComputed();
  const FeatureId fillet = last();
  edit("radius", "3");
  waitUntilComputed();
  const auto buttons = window_->page().properties().findChildren<QToolButton*>(QStringLiteral("fieldButton"));
  const auto isForEdges = [](const QToolButton* each) {
    return each->toolTip().startsWith(QStringLiteral("Pick in the view: edge"));
  };
  const auto button = std::find_if(buttons.begin(), buttons.end(), isForEdges);
  QVERIFY(button != buttons.end());
  (*button)->click();
  QVERIFY(window_->page().toolStarted());
  // The input alone is there, whole, whatever is hidden.
  Feature hidden = window_->page().document().at(id);
  hidden.visible = false;
  window_->session().commit(window_->page().document().with(hidden), QStringLiteral("Hide"));
  waitUntilComputed();
  const std::vector<ViewItem> items = window_->page().shownItems();
  QCOMPARE(items.size(), std::size_t{1});
  QVERIFY(items[0].id == id && items[0].presence == Presence::Whole);
  clickAt(edges[1]);
  waitUntilComputed();
  QCOMPARE(window_->page().document().at(fillet).parameters.at("edges").size(), std::size_t{2});
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QTRY_VERIFY(!window_->page().toolStarted());
  QCOMPARE(window_->page().shownItems().back().id, fillet);
  QVERIFY(measureOf(fillet, "volume") < rounded(1, 60) - 50);
}

void CommandStartTest::whatIsMissingIsAskedForInTheView() {
  const FeatureId left = add("modeling.rectangle", {{"width", 20}, {"height", 20}, {"centre", {-30, 0, 0}}});
  const FeatureId right = add("modeling.rectangle", {{"width", 20}, {"height", 10}, {"centre", {30, 0, 0}}});
  const FeatureId solid = add("modeling.box", {{"width", 5}, {"depth", 5}, {"height", 5}});
  window_->view().lookFrom(QStringLiteral("top"), false);
  selectNothing();
  run("feature.modeling.extrude");
  QVERIFY(window_->page().toolStarted());
  QVERIFY2(window_->page().tool()->hint().startsWith(QStringLiteral("Choose an outline to extrude:")),
           qPrintable(window_->page().tool()->hint()));
  for (const ViewItem& item : window_->page().shownItems())
    QCOMPARE(item.role, item.id == solid ? ItemRole::Plain : ItemRole::Control);
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QTRY_VERIFY(!window_->page().toolStarted());
  QCOMPARE(features(), std::size_t{3});
  for (const ViewItem& item : window_->page().shownItems()) QCOMPARE(item.presence, Presence::Whole);

  run("feature.modeling.extrude");
  clickAt({30, 0, 0});
  QTRY_COMPARE(features(), std::size_t{4});
  QVERIFY(!window_->page().toolStarted());
  QCOMPARE(window_->page().document().at(last()).inputs, std::vector<FeatureId>{right});
  waitUntilComputed();
  QVERIFY(left != right);
}

void CommandStartTest::theAnswerMayComeFromTheTree() {
  add("modeling.rectangle", {{"width", 20}, {"height", 20}, {"centre", {-30, 0, 0}}});
  const FeatureId right = add("modeling.rectangle", {{"width", 20}, {"height", 10}, {"centre", {30, 0, 0}}});
  selectNothing();
  run("feature.modeling.extrude");
  QVERIFY(window_->page().toolStarted());
  window_->tree().select(right);
  QTRY_COMPARE(features(), std::size_t{3});
  QCOMPARE(window_->page().document().at(last()).inputs, std::vector<FeatureId>{right});
}

void CommandStartTest::whereOneShapeFitsItIsTaken() {
  const FeatureId outline = add("modeling.rectangle", {{"width", 20}, {"height", 20}});
  selectNothing();
  run("feature.modeling.extrude");
  QCOMPARE(features(), std::size_t{2});
  QCOMPARE(window_->page().document().at(last()).inputs, std::vector<FeatureId>{outline});
  waitUntilComputed();
  // Of two solids, a Boolean operation leaves no choice; what is selected already counts.
  const FeatureId first = last();
  const FeatureId second = add("modeling.box", {{"width", 5}, {"depth", 5}, {"height", 50}});
  selectNothing();
  run("feature.modeling.boolean");
  QCOMPARE(window_->page().document().at(last()).inputs, (std::vector<FeatureId>{first, second}));
  waitUntilComputed();
}

void CommandStartTest::inputsAreInTheOrderOfTheSelection() {
  const FeatureId circle = add("modeling.circle", {{"radius", 5}});
  const FeatureId rectangle = add("modeling.rectangle", {{"width", 60}, {"height", 40}});
  window_->tree().select(rectangle);
  window_->tree().select(circle, true);
  run("feature.minkowski.minkowski-difference");
  waitUntilComputed();
  QCOMPARE(window_->page().document().at(last()).inputs, (std::vector<FeatureId>{rectangle, circle}));
  COMPARE_NEAR(measureOf(last(), "area"), 50 * 30, 1e-6);
}

void CommandStartTest::whatThereIsNoRoomForIsTold() {
  std::vector<FeatureId> circles;
  for (const double radius : {5.0, 10.0, 15.0}) circles.push_back(add("modeling.circle", {{"radius", radius}}));
  window_->tree().select(circles[0]);
  for (const FeatureId& id : {circles[1], circles[2]}) window_->tree().select(id, true);
  run("feature.minkowski.morph-solid");
  QCOMPARE(window_->page().document().at(last()).inputs, (std::vector<FeatureId>{circles[0], circles[1]}));
  const ErrorBar& told = window_->page().errors();
  QVERIFY(!told.isHidden());
  QCOMPARE(told.message(), QStringLiteral("Morph as solid takes 2 of the 3 selected shapes."));
  QCOMPARE(told.hint(), QStringLiteral("Left out: %1.").arg(QString::fromStdString(circles[2])));
  waitUntilComputed();
  window_->session().undo();
  QVERIFY(told.isHidden());
  // A shape that no input takes is no news.
  const FeatureId solid = add("modeling.box");
  window_->tree().select(circles[0]);
  for (const FeatureId& id : {circles[1], solid}) window_->tree().select(id, true);
  run("feature.minkowski.morph-solid");
  QVERIFY(told.isHidden());
  waitUntilComputed();
}

void CommandStartTest::whereNothingFitsItIsSaid() {
  run("feature.modeling.fillet");
  QVERIFY(!window_->page().toolStarted());
  QCOMPARE(features(), std::size_t{0});
  QCOMPARE(window_->page().errors().message(),
           QStringLiteral("There is nothing here yet for Fillet: it takes a solid to round."));
  run("feature.minkowski.morph-solid");
  QCOMPARE(window_->page().errors().message(),
           QStringLiteral("There is too little here for Morph as solid, which takes 2 of these: an outline of the solid."));
}

void CommandStartTest::whatIsHiddenIsNotTakenUnasked() {
  std::vector<FeatureId> circles;
  for (const double radius : {5.0, 10.0, 15.0}) circles.push_back(add("modeling.circle", {{"radius", radius}}));
  for (const FeatureId& id : circles) {
    Feature hidden = window_->page().document().at(id);
    hidden.visible = false;
    window_->session().commit(window_->page().document().with(hidden), QStringLiteral("Hide"));
  }
  waitUntilComputed();
  selectNothing();
  run("feature.minkowski.morph-solid");
  const ErrorBar& told = window_->page().errors();
  QVERIFY2(told.message().startsWith(QStringLiteral("Morph as solid takes nothing hidden")), qPrintable(told.message()));
  QVERIFY(told.hint().contains(QStringLiteral("select in the tree")));
  QCOMPARE(features(), std::size_t{3});
  window_->tree().select(circles[0]);
  window_->tree().select(circles[1], true);
  run("feature.minkowski.morph-solid");
  waitUntilComputed();
  QCOMPARE(window_->page().document().at(last()).inputs, (std::vector<FeatureId>{circles[0], circles[1]}));
}

/// What makes the missing shape is at hand, that of the same plugin first.
void CommandStartTest::whatMakesTheMissingShapeIsOffered() {
  run("feature.sweep.pull");
  const auto offers = window_->page().errors().findChildren<QPushButton*>();
  QVERIFY(!offers.empty());
  QTest::mouseClick(offers.front(), Qt::LeftButton);
  waitUntilComputed();
  QVERIFY(features() > 0);
  const auto result = window_->session().view(last())->result;
  QVERIFY(result && !result->error);
  run("feature.sweep.pull");
  QVERIFY(window_->page().errors().isHidden());
}

BLOSSOM_WINDOW_TEST(CommandStartTest)
#include "command_start_test.moc"
