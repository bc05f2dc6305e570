#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>

#include "tree_fixture.h"
#include "ui/window/feature_tool_bar.h"

using namespace blossom;
using namespace blossom::ui;

class MenusAndBarsTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openTestWindow(); }
  void cleanup() { closeTestWindow(); }

  void menusTickWhatIsOn();
  void motionsAreBegunBeforeTheyAreSwept();
  void theToolBarFitsAnyWidth();
  void aNarrowToolBarHidesNoGroup();
  void theSignsOfCrowdedBarsAreSeen();
  void theWindowClosesAtAnyWidth();
};

/// What is on is ticked: the picture of its entry changes where the tick stands, and only there.
void MenusAndBarsTest::menusTickWhatIsOn() {
  const auto action = [&](const char* id) { return window_->commands().action(QLatin1String(id)); };
  QMenu* menu = nullptr;
  for (QAction* each : window_->menuBar()->actions())
    if (each->menu() && each->menu()->actions().contains(action("view.grid"))) menu = each->menu();
  QVERIFY(menu);
  menu->popup(window_->mapToGlobal(QPoint(60, 40)));
  QVERIFY(QTest::qWaitForWindowExposed(menu));
  for (const char* id : {"view.grid", "view.parallel", "view.jobs", "view.log", "view.shaded-edges", "view.measure",
                         "view.section", "timeline.onion-skin"}) {
    QAction* const entry = action(id);
    QVERIFY2(entry->isCheckable(), id);
    const bool on = entry->isChecked();
    const QSignalBlocker quiet(entry);
    const auto picture = [&](bool checked) {
      entry->setChecked(checked);
      return menu->grab(menu->actionGeometry(entry)).toImage();
    };
    const QImage without = picture(false), with = picture(true);
    entry->setChecked(on);
    int leftmost = with.width(), rightmost = -1;
    for (int y = 0; y < with.height(); ++y)
      for (int x = 0; x < with.width(); ++x)
        if (with.pixel(x, y) != without.pixel(x, y)) leftmost = std::min(leftmost, x), rightmost = std::max(rightmost, x);
    QVERIFY2(rightmost - leftmost >= 6, id);
    QVERIFY2(rightmost < 30, id);
  }
  menu->hide();
  // In step with the view, whoever changed it.
  QVERIFY(action("view.grid")->isChecked());
  window_->view().setGridVisible(false);
  window_->view().setParallel(!action("view.parallel")->isChecked());
  emit menu->aboutToShow();
  QVERIFY(!action("view.grid")->isChecked());
  QCOMPARE(action("view.parallel")->isChecked(), window_->view().parallel());
  run("view.measure");
  QVERIFY(action("view.measure")->isChecked());
  run("view.measure");
  QVERIFY(!action("view.measure")->isChecked());
  window_->page().playback().setOnionSkin(true);
  QVERIFY(action("timeline.onion-skin")->isChecked());
}

/// A motion is begun, then swept, then pulled; its poles and its growth come last.
void MenusAndBarsTest::motionsAreBegunBeforeTheyAreSwept() {
  const auto action = [&](const char* id) { return window_->commands().action(QLatin1String(id)); };
  QList<QAction*> entries;
  for (QAction* each : window_->menuBar()->actions())
    if (each->menu() && each->menu()->actions().contains(action("feature.sweep.sweep"))) entries = each->menu()->actions();
  qsizetype before = -1;
  for (const char* id : {"feature.sweep.primitive", "feature.sweep.frame", "feature.sweep.sweep", "feature.sweep.pull",
                         "feature.sweep.twist", "feature.sweep.factors", "feature.sweep.refine", "feature.sweep.growth"}) {
    const qsizetype place = entries.indexOf(action(id));
    QVERIFY2(place > before, id);
    before = place;
  }
}

// Buttons lie beside each other within the bar; what has no button is in the menu of its group.
void MenusAndBarsTest::theToolBarFitsAnyWidth() {
  auto* bar = window_->findChild<FeatureToolBar*>();
  QVERIFY(bar);
  for (const int width : {1280, 1600, 1920, 2600}) {
    window_->resize(width, 720);
    QTRY_COMPARE(window_->width(), width);
    QCoreApplication::processEvents();
    QRect covered;
    int shown = 0;
    for (const QToolButton* button : bar->findChildren<QToolButton*>()) {
      if (button->isHidden()) continue;
      ++shown;
      QVERIFY2(bar->rect().contains(button->geometry()), qPrintable(QString::number(width) + ": " + button->text()));
      for (const QToolButton* other : bar->findChildren<QToolButton*>())
        QVERIFY(other == button || other->isHidden() || !other->geometry().intersects(button->geometry()));
    }
    QVERIFY(shown >= 2);
    const auto* field = window_->findChild<QPushButton*>(QStringLiteral("findCommand"));
    QVERIFY(field && field->isVisible() && field->mapTo(window_.get(), field->rect().topRight()).x() <= width);
  }
}

// The field gives way first; groups that find no room are behind one button, and the bar is used up to its end.
void MenusAndBarsTest::aNarrowToolBarHidesNoGroup() {
  auto* bar = window_->findChild<FeatureToolBar*>();
  auto* const others = bar->findChild<QToolButton*>(QStringLiteral("otherGroups"));
  auto* const find = bar->findChild<QPushButton*>(QStringLiteral("findCommand"));
  QVERIFY(others && find);
  for (const int width : {760, 900, 1100}) {
    window_->resize(width, 600);
    QCoreApplication::processEvents();
    QVERIFY(bar->isVisible() && find->isVisible() && bar->rect().contains(find->geometry()));
    qsizetype hidden = 0, widestLeft = 0;
    for (const QToolButton* group : bar->findChildren<QToolButton*>(QStringLiteral("featureGroup"))) {
      const QList<QAction*> entries = group->menu()->actions();
      bool reachable = group->isVisible();
      for (const QToolButton* button : bar->findChildren<QToolButton*>())
        reachable = reachable || (button->isVisible() && entries.contains(button->defaultAction()));
      if (!reachable) ++hidden;
    }
    for (const QToolButton* button : bar->findChildren<QToolButton*>())
      if (button->isVisible()) widestLeft = std::max<qsizetype>(widestLeft, button->geometry().right());
    QCOMPARE(others->isVisible(), hidden > 0);
    if (hidden > 0) {
      emit others->menu()->aboutToShow();
      QCOMPARE(others->menu()->actions().size(), hidden);
      QVERIFY2(find->width() <= 60, "the field gives way first");
    }
    QVERIFY(widestLeft <= find->x());
  }
}

void MenusAndBarsTest::theSignsOfCrowdedBarsAreSeen() {
  window_->resize(640, 600);
  QCoreApplication::processEvents();
  for (const char* name : {"qt_toolbar_ext_button", "qt_menubar_ext_button"}) {
    const auto* sign = window_->findChild<QToolButton*>(QLatin1String(name));
    QVERIFY2(sign, name);
    const QImage picture = sign->icon().pixmap(16, 16).toImage();
    int drawn = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        if (picture.pixelColor(x, y).alpha() > 200 &&
            std::abs(picture.pixelColor(x, y).lightness() - theme().color("text").lightness()) < 30)
          ++drawn;
    QVERIFY2(drawn > 8, name);
    QVERIFY2(sign->sizeHint().width() >= 20, name);
  }
}

// The tool bar is styled once more when it goes; the actions of its buttons have gone by then.
void MenusAndBarsTest::theWindowClosesAtAnyWidth() {
  for (const int width : {1280, 1440, 1600, 1760, 1920, 2600}) {
    window_->resize(width, 720);
    QTRY_COMPARE(window_->width(), width);
    QCoreApplication::processEvents();
    window_.reset();
    openTestWindow();
  }
}

BLOSSOM_WINDOW_TEST(MenusAndBarsTest)
#include "menus_and_bars_test.moc"
