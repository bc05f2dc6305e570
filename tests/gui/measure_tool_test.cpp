#include "ui/tools/measure_tool.h"

#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QListWidget>
#include <QSignalSpy>

#include "support/support.h"
#include "tool_host.h"
#include "ui/look/theme.h"
#include "ui/tools/measure_panel.h"
#include "ui/view/view_widget.h"
#include "widget_test.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

ToolEvent at(const Pick& pick, QPointF where = {50, 50}) {
  ToolEvent event;
  event.at = where;
  event.pick = pick;
  event.button = Qt::LeftButton;
  return event;
}
Pick part(const FeatureId& feature, SubShapeKind kind, int index) {
  Pick pick;
  pick.feature = feature;
  pick.part.kind = kind;
  pick.part.index = index;
  return pick;
}
bool press(Tool& tool, int key, Qt::KeyboardModifiers modifiers = {}) {
  return tool.key(QKeyEvent(QEvent::KeyPress, key, modifiers));
}
bool click(Tool& tool, const Pick& pick) {
  tool.move(at(pick));
  tool.press(at(pick));
  return tool.release(at(pick));
}
double lead(const Measurements& all, int id) { return std::get<double>(all.find(id)->figures.values.front().value); }

}  // namespace

class MeasureToolTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    setUpApplication();
    ThemeManager::instance().apply(ThemeChoice::Dark);
  }
  void init() {
    host_ = std::make_unique<TestHost>();
    host_->put("box", box(10, 20, 30));
    host_->put("rod", Shape(Brep(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(50, 10, 0), gp_Dir(0, 0, 1)), 4, 30).Shape())));
    all_ = std::make_unique<Measurements>(*host_);
  }
  void cleanup() {
    all_.reset();
    host_.reset();
  }

  void oneClickThenAnother();
  void hoveringComputesNothing();
  void draggingIsNoClick();
  void emptyCanvasAndEnterKeepTheFirst();
  void escapeAndDeleteTakeBack();
  void editsAreFollowedAndUndoBringsBack();
  void hiddenAndSuppressedShapes();
  void thePanelListsCopiesAndDeletes();
  void labelsAreDrawnInBothThemes();
  void endingWhileComputingIsSafe();

 private:
  bool ready(int id) { return all_->find(id) && all_->find(id)->state == Measurements::State::Ready; }
  std::unique_ptr<TestHost> host_;
  std::unique_ptr<Measurements> all_;
};

void MeasureToolTest::oneClickThenAnother() {
  MeasureTool tool(*host_, *all_, nullptr);
  QVERIFY(click(tool, part("rod", SubShapeKind::Face, 0)));
  QCOMPARE(all_->entries().size(), std::size_t{1});
  const int first = all_->entries()[0].id;
  QTRY_VERIFY(ready(first));
  COMPARE_NEAR(lead(*all_, first), 8, 1e-12);
  QCOMPARE(all_->headline(*all_->find(first)), QStringLiteral("8 mm"));
  QVERIFY(tool.hint().contains(QStringLiteral("second part")));
  click(tool, part("box", SubShapeKind::Whole, -1));
  QCOMPARE(all_->entries().size(), std::size_t{1});  // the same measurement, now of two parts
  QTRY_VERIFY(ready(first));
  QCOMPARE(all_->find(first)->figures.kind, std::string("distance"));
  COMPARE_NEAR(lead(*all_, first), 36, 1e-9);
  click(tool, part("box", SubShapeKind::Vertex, 0));  // a new one begins
  QCOMPARE(all_->entries().size(), std::size_t{2});
  QTRY_VERIFY(ready(all_->entries()[1].id));
  QCOMPARE(all_->entries()[1].figures.kind, std::string("x"));
}

void MeasureToolTest::hoveringComputesNothing() {
  MeasureTool tool(*host_, *all_, nullptr);
  const QSignalSpy changes(&tool, &Tool::changed);
  QSignalSpy measured(all_.get(), &Measurements::changed);
  for (int i = 0; i < 100; ++i) tool.move(at(part("box", SubShapeKind::Face, i / 50)));
  QCOMPARE(changes.count(), 2);  // once for each part
  QCOMPARE(measured.count(), 0);
  QVERIFY(all_->entries().empty());
  QVERIFY2(tool.hint().contains(QStringLiteral("box, face 1")), qPrintable(tool.hint()));
  tool.move(at({}));
  QVERIFY(!tool.hint().contains(QStringLiteral("box")));
}

void MeasureToolTest::draggingIsNoClick() {
  MeasureTool tool(*host_, *all_, nullptr);
  const Pick face = part("box", SubShapeKind::Face, 0);
  QVERIFY(!tool.press(at(face)));  // left to the camera
  QVERIFY(!tool.release(at(face, {90, 50})));
  QVERIFY(all_->entries().empty());
}

void MeasureToolTest::emptyCanvasAndEnterKeepTheFirst() {
  MeasureTool tool(*host_, *all_, nullptr);
  click(tool, part("box", SubShapeKind::Edge, 0));
  click(tool, {});
  click(tool, part("box", SubShapeKind::Edge, 1));
  QVERIFY(press(tool, Qt::Key_Return));
  click(tool, part("box", SubShapeKind::Edge, 2));
  click(tool, part("box", SubShapeKind::Edge, 2));  // twice the same is one
  click(tool, part("box", SubShapeKind::Edge, 3));
  QCOMPARE(all_->entries().size(), std::size_t{4});
  for (const auto& entry : all_->entries()) QVERIFY(!entry.second);
}

void MeasureToolTest::escapeAndDeleteTakeBack() {
  MeasureTool tool(*host_, *all_, nullptr);
  click(tool, part("box", SubShapeKind::Edge, 0));
  QVERIFY(press(tool, Qt::Key_Escape));
  QVERIFY(all_->entries().empty());
  QVERIFY(!press(tool, Qt::Key_Escape));  // now it ends the tool
  const int one = all_->add({"box", SubShapeKind::Edge, 0}), two = all_->add({"box", SubShapeKind::Edge, 1});
  all_->select(one);
  QVERIFY(press(tool, Qt::Key_Delete));
  QVERIFY(!all_->find(one));
  QCOMPARE(all_->selected(), two);
}

void MeasureToolTest::editsAreFollowedAndUndoBringsBack() {
  const int gap = all_->add({"box", SubShapeKind::Whole, -1}, PartReference{"rod", SubShapeKind::Face, 0});
  QTRY_VERIFY(ready(gap));
  COMPARE_NEAR(lead(*all_, gap), 36, 1e-9);
  host_->put("box", box(16, 20, 30));
  all_->documentChanged();
  QTRY_VERIFY(ready(gap));
  COMPARE_NEAR(lead(*all_, gap), 30, 1e-9);
  const Document before = host_->document();
  host_->setDocument(before.without("rod"));
  all_->documentChanged();
  QVERIFY(all_->find(gap)->state == Measurements::State::Lost);
  QVERIFY(all_->text(*all_->find(gap)).contains(QStringLiteral("no longer in the document")));
  QVERIFY(all_->props().empty());
  host_->setDocument(before);
  all_->documentChanged();
  QTRY_VERIFY(ready(gap));
  COMPARE_NEAR(lead(*all_, gap), 30, 1e-9);
  // A part that the new shape does not have.
  const int edge = all_->add({"box", SubShapeKind::Edge, 11});
  QTRY_VERIFY(ready(edge));
  host_->put("box", Shape(Brep(BRepPrimAPI_MakeCylinder(1, 2).Shape())));
  all_->documentChanged();
  QTRY_VERIFY(all_->find(edge)->state == Measurements::State::Lost);
  QVERIFY2(all_->find(edge)->problem.contains(QStringLiteral("edge 11")), qPrintable(all_->find(edge)->problem));
  QTRY_VERIFY(ready(gap));
}

void MeasureToolTest::hiddenAndSuppressedShapes() {
  const int face = all_->add({"box", SubShapeKind::Face, 0});
  QTRY_VERIFY(ready(face));
  QVERIFY(!all_->props().empty());
  Feature feature = host_->document().at("box");
  feature.visible = false;
  host_->setDocument(host_->document().with(feature));
  all_->documentChanged();
  QVERIFY(ready(face));
  QVERIFY(all_->props().empty());
  feature.visible = true;
  feature.suppressed = true;
  host_->setDocument(host_->document().with(feature));
  all_->documentChanged();
  QVERIFY(all_->find(face)->state == Measurements::State::Lost);
}

void MeasureToolTest::thePanelListsCopiesAndDeletes() {
  QWidget view;
  view.resize(900, 700);
  view.show();
  MeasureTool tool(*host_, *all_, &view);
  auto* panel = view.findChild<MeasurePanel*>();
  QVERIFY(panel && panel->isVisible());
  click(tool, part("rod", SubShapeKind::Face, 0));
  press(tool, Qt::Key_Return);
  click(tool, part("box", SubShapeKind::Face, 1));
  QTRY_VERIFY(ready(all_->entries()[0].id) && ready(all_->entries()[1].id));
  auto* list = panel->findChild<QListWidget*>();
  QCOMPARE(list->count(), 2);
  QVERIFY2(list->item(0)->text().contains(QStringLiteral("8 mm")), qPrintable(list->item(0)->text()));
  QVERIFY(view.rect().contains(panel->geometry()));
  list->setFocus();
  list->setCurrentRow(0);
  QCOMPARE(all_->selected(), all_->entries()[0].id);
  QTest::keyClick(list, Qt::Key_C, Qt::ControlModifier);
  const QString copied = QGuiApplication::clipboard()->text();
  QVERIFY2(copied.startsWith(QStringLiteral("rod, face 0\nDiameter\t8 mm\nRadius\t4 mm")), qPrintable(copied));
  QTest::keyClick(list, Qt::Key_Delete);
  QCOMPARE(all_->entries().size(), std::size_t{1});
  QCOMPARE(list->count(), 1);
}

void MeasureToolTest::labelsAreDrawnInBothThemes() {
  for (const ThemeChoice choice : {ThemeChoice::Dark, ThemeChoice::Light}) {
    ThemeManager::instance().apply(choice);
    ViewWidget view;
    view.resize(500, 400);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    const Measurement none;
    const QImage before = view.grabFramebuffer();
    const int gap = all_->add({"box", SubShapeKind::Whole, -1}, PartReference{"rod", SubShapeKind::Face, 0});
    QTRY_VERIFY(ready(gap));
    view.setOverlay(all_->props());
    const QImage after = view.grabFramebuffer();
    qint64 cards = 0, accents = 0;
    const QColor card = theme().color("panel"), accent = theme().color("made");
    const auto like = [](const QColor& a, const QColor& b) {
      return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 24;
    };
    for (int y = 0; y < after.height(); ++y)
      for (int x = 0; x < after.width(); ++x) {
        const QColor now = after.pixelColor(x, y);
        if (now == before.pixelColor(x, y)) continue;
        cards += like(now, card) ? 1 : 0;
        accents += like(now, accent) ? 1 : 0;
      }
    QVERIFY2(cards > 200, qPrintable(QString::number(cards)));
    QVERIFY2(accents > 30, qPrintable(QString::number(accents)));
    all_->clear();
  }
  ThemeManager::instance().apply(ThemeChoice::Dark);
}

void MeasureToolTest::endingWhileComputingIsSafe() {
  for (int i = 0; i < 40; ++i) {
    Measurements passing(*host_);
    passing.add({"box", SubShapeKind::Whole, -1}, PartReference{"rod", SubShapeKind::Whole, -1});
    passing.extend(passing.add({"box", SubShapeKind::Face, 0}), {"rod", SubShapeKind::Edge, 0});
    if (i % 2 == 0) passing.clear();
    if (i % 3 == 0) QCoreApplication::processEvents();
  }
}

BLOSSOM_WIDGET_TEST(MeasureToolTest)
#include "measure_tool_test.moc"
