#include "ui/tools/section_tool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>

#include "support/support.h"
#include "tool_host.h"
#include "ui/look/theme.h"
#include "ui/tools/section_panel.h"
#include "widget_test.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// The mouse where a point is seen from far along a direction.
ToolEvent towards(const Vec3& point, const Vec3& direction, QPointF at = {}) {
  ToolEvent event;
  event.at = at;
  event.ray = {point - 500 * direction.normalized(), direction.normalized()};
  event.button = Qt::LeftButton;
  event.millimetresPerPixel = 0.1;
  return event;
}
bool pressKey(Tool& tool, int key) { return tool.key(QKeyEvent(QEvent::KeyPress, key, Qt::NoModifier)); }
const Vec3 slanted(0.6, 1, -0.5);

}  // namespace

class SectionToolTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    setUpApplication();
    ThemeManager::instance().apply(ThemeChoice::Dark);
  }
  void init() {
    host_ = std::make_unique<TestHost>();
    host_->put("box", box(10, 20, 30));
  }

  void startsThroughTheMiddleAndStays();
  void theHandleFollowsTheMouse();
  void theFrameIsAHandleToo();
  void endOnUpIsForward();
  void stepsOfTheGrid();
  void keysChooseDirectionsAndSides();
  void aFaceGivesTheDirection();
  void thePanelSetsItAll();
  void offShowsAllAgain();

 private:
  std::unique_ptr<TestHost> host_;
};

void SectionToolTest::startsThroughTheMiddleAndStays() {
  {
    const SectionTool tool(*host_, nullptr);
    COMPARE_NEAR(host_->section()->normal.y(), -1, 0);  // the front is cut away
    COMPARE_NEAR(host_->section()->offset, -10, 0);
    QCOMPARE(tool.props().size(), std::size_t{5});
  }
  QVERIFY(host_->section());
  host_->setSection(CutPlane{Vec3::UnitZ(), 7});
  const SectionTool again(*host_, nullptr);
  QVERIFY(again.plane().axis() == SectionAxis::Z);
  COMPARE_NEAR(again.plane().offset(), 7, 0);
  COMPARE_NEAR(host_->section()->offset, 7, 0);
}

void SectionToolTest::theHandleFollowsTheMouse() {
  SectionTool tool(*host_, nullptr);
  pressKey(tool, Qt::Key_X);
  COMPARE_NEAR(tool.plane().offset(), 5, 0);
  const Vec3 centre(5, 10, 15);
  QVERIFY(!tool.press(towards(centre + Vec3(0, 0, 9), slanted)));  // beside it: left to the camera
  QSignalSpy changes(&tool, &Tool::changed);
  tool.move(towards(centre, slanted));
  QCOMPARE(changes.count(), 1);  // it lights up
  QVERIFY(tool.press(towards(centre, slanted)));
  for (const double x : {6.0, 7.5, 2.0}) {
    QVERIFY(tool.move(towards({x, 10, 15}, slanted)));
    COMPARE_NEAR(tool.plane().offset(), x, 1e-9);
    COMPARE_NEAR(host_->section()->offset, x, 1e-9);  // still the same side
  }
  tool.move(towards({90, 10, 15}, slanted));
  COMPARE_NEAR(tool.plane().offset(), 10.2, 1e-9);  // not far beyond the model
  QVERIFY(tool.release(towards({90, 10, 15}, slanted)));
  QVERIFY(!tool.move(towards({3, 10, 15}, slanted)));
  COMPARE_NEAR(tool.plane().offset(), 10.2, 1e-9);
}

void SectionToolTest::theFrameIsAHandleToo() {
  SectionTool tool(*host_, nullptr);
  pressKey(tool, Qt::Key_Z);
  const double margin = 0.06 * Vec3(10, 20, 30).norm();
  const Vec3 onFrame(10 + margin, 14, 15);
  QVERIFY(tool.press(towards(onFrame, slanted)));
  tool.move(towards(onFrame + Vec3(0, 0, 4), slanted));
  COMPARE_NEAR(tool.plane().offset(), 19, 1e-9);
}

void SectionToolTest::endOnUpIsForward() {
  SectionTool tool(*host_, nullptr);
  pressKey(tool, Qt::Key_Z);
  const Vec3 down = -Vec3::UnitZ();
  QVERIFY(tool.press(towards({5, 10, 15}, down, {0, 100})));
  tool.move(towards({5, 10, 15}, down, {0, 80}));
  COMPARE_NEAR(tool.plane().offset(), 17, 1e-9);
}

void SectionToolTest::stepsOfTheGrid() {
  SectionTool tool(*host_, nullptr);
  pressKey(tool, Qt::Key_Z);
  QVERIFY(tool.press(towards({5, 10, 15}, slanted)));
  ToolEvent event = towards({5, 10, 21}, slanted);
  event.modifiers = Qt::ControlModifier;
  tool.move(event);
  COMPARE_NEAR(tool.plane().offset(), 20, 1e-9);
}

void SectionToolTest::keysChooseDirectionsAndSides() {
  SectionTool tool(*host_, nullptr);
  QVERIFY(pressKey(tool, Qt::Key_Z));
  COMPARE_NEAR(host_->section()->normal.z(), 1, 0);  // what is above is cut away, as the home view looks down
  QVERIFY(pressKey(tool, Qt::Key_F));
  COMPARE_NEAR(host_->section()->offset, -15, 0);
  QVERIFY(pressKey(tool, Qt::Key_F));
  COMPARE_NEAR(host_->section()->offset, 15, 0);
  QVERIFY(pressKey(tool, Qt::Key_Up));
  COMPARE_NEAR(host_->section()->offset, 15.3, 1e-12);
  QVERIFY(!pressKey(tool, Qt::Key_Escape));
  QVERIFY(!pressKey(tool, Qt::Key_Q));
  // Undo and redo are of the window.
  for (const int key : {Qt::Key_Y, Qt::Key_Z, Qt::Key_F, Qt::Key_P})
    QVERIFY(!tool.key(QKeyEvent(QEvent::KeyPress, key, Qt::ControlModifier)));
  COMPARE_NEAR(host_->section()->normal.z(), 1, 0);
  // The model grows: the offset stays.
  host_->put("box", box(10, 20, 60));
  tool.documentChanged();
  COMPARE_NEAR(host_->section()->offset, 15.3, 1e-12);
}

void SectionToolTest::aFaceGivesTheDirection() {
  SectionTool tool(*host_, nullptr);
  QVERIFY(tool.picks() == PickMode::None);
  pressKey(tool, Qt::Key_P);
  QVERIFY(tool.picks() == PickMode::Face);
  QVERIFY(pressKey(tool, Qt::Key_Escape));
  pressKey(tool, Qt::Key_P);
  ToolEvent event = towards({10, 3, 4}, slanted);
  event.pick.feature = "box";
  event.pick.part = {SubShapeKind::Face, 1, {10, 3, 4}, Vec3(3, 0, 4) / 5, 0};
  QVERIFY(tool.press(event));
  QVERIFY(tool.plane().axis() == SectionAxis::Face);
  COMPARE_NEAR(tool.plane().offset(), 0, 0);
  COMPARE_NEAR(host_->section()->offset, 9.2, 1e-12);
  COMPARE_NEAR((host_->section()->normal - Vec3(0.6, 0, 0.8)).norm(), 0, 1e-12);
}

void SectionToolTest::thePanelSetsItAll() {
  QWidget view;
  view.resize(900, 700);
  view.show();
  SectionTool tool(*host_, &view);
  auto* panel = view.findChild<SectionPanel*>();
  QVERIFY(panel && panel->isVisible());
  QVERIFY(view.rect().contains(panel->geometry()));
  const auto buttons = panel->findChildren<QToolButton*>();
  buttons[0]->click();
  QVERIFY(tool.plane().axis() == SectionAxis::X);
  auto* offset = panel->findChild<QLineEdit*>();
  QCOMPARE(offset->text(), QStringLiteral("5 mm"));
  offset->setFocus();
  offset->selectAll();
  QTest::keyClicks(offset, QStringLiteral("0.7cm"));
  QTest::keyClick(offset, Qt::Key_Return);
  COMPARE_NEAR(tool.plane().offset(), 7, 1e-12);
  offset->selectAll();
  QTest::keyClicks(offset, QStringLiteral("seven"));
  QTest::keyClick(offset, Qt::Key_Return);
  COMPARE_NEAR(tool.plane().offset(), 7, 1e-12);  // the old one is kept
  QCOMPARE(offset->text(), QStringLiteral("7 mm"));
  QVERIFY(offset->property("wrong").toBool());
  panel->findChild<QSlider*>()->setValue(250);
  COMPARE_NEAR(tool.plane().offset(), 2.5, 1e-12);
  // Every control is reached with Tab.
  for (QWidget* widget : panel->findChildren<QWidget*>())
    if (qobject_cast<QToolButton*>(widget) || qobject_cast<QSlider*>(widget) || qobject_cast<QLineEdit*>(widget))
      QVERIFY(widget->focusPolicy() & Qt::TabFocus);
}

void SectionToolTest::offShowsAllAgain() {
  SectionTool tool(*host_, nullptr);
  const QSignalSpy finished(&tool, &Tool::finished);
  QVERIFY(pressKey(tool, Qt::Key_Delete));
  QVERIFY(!host_->section());
  QCOMPARE(finished.count(), 1);
}

BLOSSOM_WIDGET_TEST(SectionToolTest)
#include "section_tool_test.moc"
