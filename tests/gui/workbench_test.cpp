#include <atomic>

#include "document/storage.h"
#include "ui/look/text.h"
#include "ui/palette/command_palette.h"
#include "ui/thread/stall_watch.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// One sitting at the workbench, from the file dropped on it to the document saved, as a user goes through it.
class WorkbenchTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void aSittingFromDropToSave();
  void aFaceIsPickedForAParameter();
  void anEditPreviewsLiveAndIsOneStep();
  void theStateOfTheViewBelongsToTheTab();

 private:
  [[nodiscard]] Vec3 centreOfTop(const FeatureId&) const;
  StallWatch stalls_;
};

Vec3 WorkbenchTest::centreOfTop(const FeatureId& id) const {
  const Bounds box = bounds(window_->session().view(id)->result->evaluated.shape);
  return {box.center().x(), box.center().y(), box.high.z()};
}

void WorkbenchTest::aSittingFromDropToSave() {
  QVERIFY(drop({propeller()}));
  QTRY_VERIFY_WITH_TIMEOUT(!sweep().empty() && !window_->session().evaluating(), 60000);
  const FeatureId surface = sweep();
  window_->tree().select(surface);

  // A box beside it, by the palette.
  run("edit.find-command");
  QTRY_VERIFY(window_->palette().isVisible());
  QTest::keyClicks(window_->palette().field(), QStringLiteral("box"));
  QTRY_VERIFY(window_->palette().model().rowCount() > 0);
  QTest::keyClick(window_->palette().field(), Qt::Key_Return);
  QTRY_VERIFY(window_->palette().isHidden());
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t(3));
  waitUntilComputed();
  const FeatureId box = last();
  edit("width", "2 cm");
  waitUntilComputed();
  QCOMPARE(window_->page().document().at(box).parameters.value("width", 0.0), 20.0);

  // The box may stand first: it takes nothing.
  window_->session().commit(window_->page().document().moved(box, 0), QStringLiteral("Move"));
  QCOMPARE(window_->page().document().features().front()->id, box);
  window_->session().undo();
  QCOMPARE(window_->page().document().features().back()->id, box);
  window_->session().redo();
  QCOMPARE(window_->page().document().features().front()->id, box);

  const QString file = folder_.filePath(QStringLiteral("sitting.blossom"));
  bool saved = false;
  window_->session().save(file.toStdString(), [&] { saved = true; });
  QTRY_VERIFY(saved);
  QVERIFY(!window_->session().modified());
  QCOMPARE(toJson(openDocument(file.toStdString()).document), toJson(window_->page().document()));
  stalls_.print();
}

void WorkbenchTest::aFaceIsPickedForAParameter() {
  run("file.new");
  run("feature.modeling.box");
  waitUntilComputed();
  const FeatureId box = last();
  run("view.top");
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  window_->view().setPickMode(PickMode::Face);
  clickAt(centreOfTop(box));
  QCOMPARE(window_->view().selectedParts().size(), std::size_t(1));
  const Pick picked = window_->view().selectedParts().front();
  QCOMPARE(picked.feature, box);
  QCOMPARE(picked.part.kind, SubShapeKind::Face);
  COMPARE_NEAR(picked.part.normal.z(), 1, 1e-9);
  COMPARE_NEAR(picked.part.point.z(), centreOfTop(box).z(), 1e-6);
}

void WorkbenchTest::anEditPreviewsLiveAndIsOneStep() {
  run("file.new");
  run("feature.modeling.cylinder");
  waitUntilComputed();
  const FeatureId id = last();
  ParameterField* const field = window_->properties().field(QStringLiteral("radius"));
  QVERIFY(field);
  const std::string before = window_->session().history().undoText();
  const double start = window_->page().document().at(id).parameters.value("radius", 10.0);
  for (int i = 1; i <= 10; ++i) emit field->previewed(Value(start + i));
  QTRY_COMPARE(window_->page().document().at(id).parameters.value("radius", 0.0), start + 10);
  QCOMPARE(window_->session().history().undoText(), before);  // shown, not remembered
  emit field->edited(Value(start + 10));
  waitUntilComputed();
  QVERIFY(window_->session().history().undoText() != before);
  window_->session().undo();
  QCOMPARE(window_->session().history().undoText(), before);
  QCOMPARE(window_->page().document().at(id).parameters.value("radius", start), start);
}

void WorkbenchTest::theStateOfTheViewBelongsToTheTab() {
  openPropeller();
  const double pitch = window_->view().camera().turn().pitch;
  window_->addPage();
  run("view.top");
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  window_->showPage(0);
  QCOMPARE(window_->view().camera().turn().pitch, pitch);
  QCOMPARE(window_->pageCount(), std::size_t(2));
}

BLOSSOM_WINDOW_TEST(WorkbenchTest)
#include "workbench_test.moc"
