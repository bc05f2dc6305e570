#include <algorithm>

#include "support/sweep_formulas.h"
#include "sweep_fixture.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// Edits of a motion that are added by the menu, whatever of it is selected.
class SweepMenuWindowTest : public SweepFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void anEditOfASelectedSweepGoesBeforeIt_data();
  void anEditOfASelectedSweepGoesBeforeIt();
  void aHiddenMotionIsFoundToo();
  void anEditOfASelectedMotionGoesBeforeItsSweep();
  void anEditGoesBetweenTwoOthers();
  void theDragGoesOnWithThePullThatWasAdded();
  void theGrowthOfASelectedSweepHasAllSteps();
  void whatNothingSweepsIsNotPulled();
  void aStepThatWarnsIsToldWhereItIsFoldedAway();

 private:
  void addByMenu(const char* command) {
    run(command);
    QVERIFY2(window_->errors().isHidden(), qPrintable(window_->errors().message()));
    QVERIFY(!window_->page().toolStarted());  // nothing is asked
    waitUntilComputed();
  }
  void select(const FeatureId& id) {
    window_->tree().select(id);
    window_->view().setFocus();
  }
  [[nodiscard]] std::vector<FeatureId> inputsOf(const FeatureId& id) const { return document().at(id).inputs; }
  [[nodiscard]] bool sound() const { return !window_->session().view(sweep_)->result->error; }
};

void SweepMenuWindowTest::anEditOfASelectedSweepGoesBeforeIt_data() {
  QTest::addColumn<QString>("type");
  for (const char* type : {"sweep.pull", "sweep.twist", "sweep.refine"}) QTest::newRow(type) << QString::fromLatin1(type);
}

void SweepMenuWindowTest::anEditOfASelectedSweepGoesBeforeIt() {
  QFETCH(QString, type);
  openSample("cylinder.json");
  const Document before = document();
  addByMenu(qPrintable(QStringLiteral("feature.") + type));
  const std::string id = type.toStdString();
  QCOMPARE(all(id.c_str()).size(), std::size_t(1));
  const FeatureId edit = only(id.c_str()).id;
  QCOMPARE(inputsOf(edit), std::vector<FeatureId>{source_});
  QCOMPARE(inputsOf(sweep_), std::vector<FeatureId>{edit});
  QCOMPARE(window_->page().selection(), std::vector<FeatureId>{edit});
  QVERIFY(sound());
  QVERIFY(poleDifference(motionOf(source_), motionOf(edit)) < 1e-12);
  window_->session().undo();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

void SweepMenuWindowTest::aHiddenMotionIsFoundToo() {
  openSample("cylinder.json");
  Feature hidden = document().at(source_);
  hidden.visible = false;
  window_->session().commit(document().with(hidden), QStringLiteral("Hide"));
  waitUntilComputed();
  select(sweep_);
  addByMenu("feature.sweep.pull");
  QCOMPARE(inputsOf(sweep_), std::vector<FeatureId>{only("sweep.pull").id});
}

void SweepMenuWindowTest::anEditOfASelectedMotionGoesBeforeItsSweep() {
  openSample("cylinder.json");
  select(source_);
  addByMenu("feature.sweep.twist");
  QCOMPARE(inputsOf(only("sweep.twist").id), std::vector<FeatureId>{source_});
  QCOMPARE(inputsOf(sweep_), std::vector<FeatureId>{only("sweep.twist").id});
  QVERIFY(sound());
}

void SweepMenuWindowTest::anEditGoesBetweenTwoOthers() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  drag(from, from + QPoint(50, -10));
  const FeatureId pull = only("sweep.pull").id;
  select(source_);
  addByMenu("feature.sweep.refine");
  const FeatureId refine = only("sweep.refine").id;
  QCOMPARE(inputsOf(refine), std::vector<FeatureId>{source_});
  QCOMPARE(inputsOf(pull), std::vector<FeatureId>{refine});
  QCOMPARE(inputsOf(sweep_), std::vector<FeatureId>{pull});
}

/// What the menu added and nobody has filled in is filled in by the drag.
void SweepMenuWindowTest::theDragGoesOnWithThePullThatWasAdded() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  addByMenu("feature.sweep.pull");
  const FeatureId pull = only("sweep.pull").id;
  window_->view().setFocus();
  drag(from, from + QPoint(60, -20));
  QCOMPARE(all("sweep.pull"), std::vector<FeatureId>{pull});
  QCOMPARE(inputsOf(sweep_), std::vector<FeatureId>{pull});
  const Value& record = only("sweep.pull").parameters["pulls"][0];
  const Vec3 target = vectorOf(record["to"]);
  const PlaceOfMotion at(motionOf(pull), record["u"].get<double>(), record["v"].get<double>());
  QVERIFY((at.x - target).norm() < 1e-10);
  QVERIFY(window_->session().view(pull)->result->evaluated.warnings.empty());

  // A twist is another edit.
  const QPoint other = from + QPoint(0, 40);
  hover(other);
  key(Qt::Key_W);
  drag(other, other + QPoint(40, 0));
  QCOMPARE(inputsOf(only("sweep.twist").id), std::vector<FeatureId>{pull});
}

/// A pull that moves nothing yet warns.
void SweepMenuWindowTest::aStepThatWarnsIsToldWhereItIsFoldedAway() {
  openSample("cylinder.json");
  const auto told = [this](int role) {
    return static_cast<DocumentModel*>(window_->tree().model())->indexOf(sweep_).data(role);
  };
  window_->tree().setFolded(sweep_, true);
  QVERIFY(!told(DocumentModel::WarnedRole).toBool());
  addByMenu("feature.sweep.pull");
  QVERIFY(!window_->session().view(only("sweep.pull").id)->result->evaluated.warnings.empty());
  window_->tree().setFolded(sweep_, true);
  QVERIFY(told(DocumentModel::WarnedRole).toBool());
  QVERIFY(told(DocumentModel::StateRole).toString().startsWith(QStringLiteral("a step warns")));
  window_->tree().setFolded(sweep_, false);  // the row of the pull says it then
  QVERIFY(!told(DocumentModel::WarnedRole).toBool());
  QVERIFY(!told(DocumentModel::StateRole).toString().startsWith(QStringLiteral("a step warns")));
  window_->tree().setFolded(sweep_, true);
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(!told(DocumentModel::WarnedRole).toBool());
}

void SweepMenuWindowTest::theGrowthOfASelectedSweepHasAllSteps() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  drag(from, from + QPoint(50, -10));
  const FeatureId pull = only("sweep.pull").id;
  select(sweep_);
  addByMenu("feature.sweep.growth");
  const FeatureId growth = only("sweep.growth").id;
  QCOMPARE(inputsOf(growth), (std::vector<FeatureId>{source_, pull}));
  QCOMPARE(inputsOf(sweep_), std::vector<FeatureId>{pull});
  QVERIFY(!window_->session().view(growth)->result->error);

  // It shows the steps that it was made for; the sweep goes on.
  select(sweep_);
  addByMenu("feature.sweep.twist");
  QCOMPARE(inputsOf(growth), (std::vector<FeatureId>{source_, pull}));
  QCOMPARE(inputsOf(sweep_), std::vector<FeatureId>{only("sweep.twist").id});
}

/// As in documents in which an edit was added beside the one that is swept.
void SweepMenuWindowTest::whatNothingSweepsIsNotPulled() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  Feature beside;
  beside.id = "beside";
  beside.name = "Beside";
  beside.type = "sweep.pull";
  beside.inputs = {source_};
  window_->session().commit(document().with(beside), QStringLiteral("Add"));
  waitUntilComputed();
  const Document before = document();
  select(beside.id);
  QVERIFY(window_->page().tool());
  QVERIFY2(hint().startsWith(QStringLiteral("No sweep is made of this motion")), qPrintable(hint()));
  mouse(QEvent::MouseMove, from);
  mouse(QEvent::MouseButtonPress, from, Qt::ShiftModifier);
  mouse(QEvent::MouseMove, from + QPoint(50, 0), Qt::ShiftModifier);
  QVERIFY(!window_->page().tool()->standIn());
  mouse(QEvent::MouseButtonRelease, from + QPoint(50, 0), Qt::ShiftModifier);
  waitUntilComputed();
  QVERIFY(std::ranges::equal(document().features(), before.features()));
}

BLOSSOM_WINDOW_TEST(SweepMenuWindowTest)
#include "sweep_menu_window_test.moc"
