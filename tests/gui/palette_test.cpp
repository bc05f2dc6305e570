#include <QAbstractItemModel>
#include <QDockWidget>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeView>

#include "tree_fixture.h"
#include "ui/jobs/jobs_list.h"
#include "ui/jobs/jobs_panel.h"
#include "ui/jobs/log_and_jobs.h"
#include "ui/jobs/log_list.h"
#include "ui/jobs/log_panel.h"
#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/palette/command_palette.h"
#include "ui/palette/palette_match.h"
#include "ui/window/feature_tool_bar.h"
#include "ui/window/status_line.h"

using namespace blossom;
using namespace blossom::ui;

class PaletteTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    letGo_ = false;
    openTestWindow();
  }
  void cleanup() {
    letGo_ = true;
    window_.reset();
  }
  void lettersMatchInOrder();
  void everyCommandIsFound();
  void aCommandIsRunByKeys();
  void themesAreFound();
  void menusTickWhatIsOn();
  void aFeatureIsAdded();
  void aSampleIsOpened();
  void featuresAndPagesAreFound();
  void whatWasUsedStandsFirst();
  void theWholeNameStandsBeforeWhatWasUsed();
  void theWordsOfTheTradeAreKnown();
  void aBooleanBeginsAsItWasAskedFor();
  void whatCannotBeDoneSaysWhy();
  void theStatusIsAsBeforeWhenItCloses();
  void itClosesWithoutDoingAnything();
  void theToolBarFitsAnyWidth();
  void aNarrowToolBarHidesNoGroup();
  void theSignsOfCrowdedBarsAreSeen();
  void theWindowClosesAtAnyWidth();
  void aLongJobIsListedAndCancelled();
  void finishedWorkIsKeptWithItsMessage();
  void theLogTellsWhatHappened();
  void theLogFollowsTheNewest();
  void theCrossStaysInPlace();
  void everythingIsComputedAnew();

 private:
  [[nodiscard]] CommandPalette& palette() { return window_->palette(); }
  void openPalette(const QString& pattern) {
    QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
    QVERIFY(palette().isVisible());
    QTRY_VERIFY(palette().field()->hasFocus());
    QTest::keyClicks(palette().field(), pattern);
  }
  [[nodiscard]] QStringList found() {
    QStringList ids;
    for (int row = 0; row < palette().model().rowCount(); ++row) ids << palette().model().at(row).id;
    return ids;
  }
};

void PaletteTest::lettersMatchInOrder() {
  const auto score = [](const char* pattern, const char* text) {
    const auto match = paletteMatch(QLatin1String(pattern), QLatin1String(text));
    return match ? match->score : -1;
  };
  QCOMPARE(score("zz", "Zoom in"), -1);
  QCOMPARE(score("niz", "Zoom in"), -1);
  QVERIFY(score("zi", "Zoom in") > 0);
  QVERIFY(score("", "Anything") == 0);
  QVERIFY2(score("exp", "Export") > score("exp", "Textile pattern"), "letters that follow each other count more");
  QVERIFY2(score("si", "Select invisible") > score("si", "Passing"), "beginnings of words count more");
  QVERIFY2(score("fit", "Fit") > score("fit", "Fitting"), "whole words count more");
  const auto match = paletteMatch(QStringLiteral("in zo"), QStringLiteral("Zoom in"));
  QVERIFY(match);
  QCOMPARE(match->letters, (QList<int>{0, 1, 5, 6}));
}

void PaletteTest::everyCommandIsFound() {
  QVERIFY(window_->commands().all().size() > 30);
  openPalette({});
  QCOMPARE(palette().model().rowCount() >= static_cast<int>(window_->commands().all().size()), true);
  for (const Command& command : window_->commands().all()) {
    palette().field()->setText(QString(command.action->text()).remove(u'&'));
    QVERIFY2(found().mid(0, 3).contains(command.id), qPrintable(command.id + ": " + found().mid(0, 3).join(u' ')));
  }
  for (const auto& type : window_->session().app().registry->types()) {
    const Command* command = window_->commands().find(QStringLiteral("feature.") + qt(type->id));
    if (command) QVERIFY(!command->help.isEmpty());
  }
}

void PaletteTest::aCommandIsRunByKeys() {
  const bool before = window_->view().parallel();
  openPalette(QStringLiteral("parall"));
  QCOMPARE(found().value(0), QStringLiteral("view.parallel"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QVERIFY(palette().isHidden());
  QCOMPARE(window_->view().parallel(), !before);
}

void PaletteTest::themesAreFound() {
  openPalette(QStringLiteral("theme"));
  for (const char* id : {"view.theme-dark", "view.theme-light", "view.theme-system"})
    QVERIFY2(found().mid(0, 4).contains(QLatin1String(id)), id);
  for (const auto& [typed, wanted] : {std::pair{"light", "Light"}, std::pair{"dark", "Dark"}}) {
    palette().dismiss();
    openPalette(QLatin1String(typed));
    QCOMPARE(found().value(0), QStringLiteral("view.theme-") + QLatin1String(typed));
    QTest::keyClick(palette().field(), Qt::Key_Return);
    QCOMPARE(theme().name, QLatin1String(wanted));
    QVERIFY(window_->commands().action(QStringLiteral("view.theme-") + QLatin1String(typed))->isChecked());
  }
  Preferences::instance().set("theme", "light");
  QVERIFY(window_->commands().action(QStringLiteral("view.theme-light"))->isChecked());
  QVERIFY(!window_->commands().action(QStringLiteral("view.theme-dark"))->isChecked());
  Preferences::instance().set("theme", "dark");
}

/// What is on is ticked: the picture of its entry changes where the tick stands, and only there.
void PaletteTest::menusTickWhatIsOn() {
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

void PaletteTest::aFeatureIsAdded() {
  openPropeller();
  window_->tree().select(document().at(sweep()).inputs.front());
  openPalette(QStringLiteral("sweep"));
  const qsizetype row = found().indexOf(QStringLiteral("feature.sweep.sweep"));
  QVERIFY(row >= 0 && row < 4);
  for (qsizetype i = 0; i < row; ++i) QTest::keyClick(palette().field(), Qt::Key_Down);
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QCOMPARE(document().features().size(), std::size_t(3));
  QCOMPARE(undoText(), QStringLiteral("Add Sweep"));
  undo();
  QCOMPARE(document().features().size(), std::size_t(2));
}

void PaletteTest::aSampleIsOpened() {
  openPalette(QStringLiteral("propeller"));
  QVERIFY(found().value(0).startsWith(QStringLiteral("sample:")));
  auto* list = palette().findChild<QListView*>();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  QVERIFY(palette().isHidden());
  QTRY_VERIFY_WITH_TIMEOUT(!sweep().empty() && !window_->session().evaluating(), 60000);
}

void PaletteTest::featuresAndPagesAreFound() {
  showChain();
  window_->session().commit(document().with(feature("lid", "test.block", {}, "Lid of the box")), {});
  waitUntilComputed();
  openPalette(QStringLiteral("lidbox"));
  QCOMPARE(found().value(0), QStringLiteral("go-to:lid"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QCOMPARE(window_->tree().selected(), std::vector<FeatureId>{"lid"});
  openPalette(QStringLiteral("manual"));
  const QStringList pages = found().filter(QStringLiteral("manual:"));
  QVERIFY(!pages.isEmpty());
}

void PaletteTest::whatWasUsedStandsFirst() {
  openPalette(QStringLiteral("grid"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  openPalette({});
  QCOMPARE(found().value(0), QStringLiteral("view.grid"));
}

void PaletteTest::theWholeNameStandsBeforeWhatWasUsed() {
  PaletteModel model;
  PaletteEntry pocket, simulate;
  pocket.id = QStringLiteral("pocket");
  pocket.text = pocket.group = QStringLiteral("Pocket");
  simulate.id = QStringLiteral("simulate");
  simulate.text = QStringLiteral("Simulate");
  simulate.group = QStringLiteral("Pocket");
  pocket.enabled = false;  // what cannot be done now comes later otherwise
  simulate.enabled = true;
  QStringList lately{simulate.id};
  for (int k = 0; k < 20; ++k) lately << QString::number(k);
  model.setEntries({simulate, pocket}, lately);
  model.setPattern(QStringLiteral("pocket"));
  QCOMPARE(model.rowCount(), 2);
  QCOMPARE(model.at(0).id, pocket.id);
}

void PaletteTest::theWordsOfTheTradeAreKnown() {
  for (const auto& [word, wanted] : {std::pair{"subtract", "boolean"},
                                     {"union", "boolean"},
                                     {"intersect", "boolean"},
                                     {"hole", "boolean"},
                                     {"3d", "extrude"},
                                     {"push pull", "extrude"},
                                     {"rotate", "transform"},
                                     {"move", "transform"},
                                     {"scale", "transform"},
                                     {"mirror", "mirror"},
                                     {"round", "fillet"},
                                     {"bevel", "chamfer"},
                                     {"array", "pattern"}}) {
    openPalette(QLatin1String(word));
    QVERIFY2(found().mid(0, 2).contains(QStringLiteral("feature.modeling.") + QLatin1String(wanted)),
             qPrintable(QLatin1String(word) + QStringLiteral(": ") + found().mid(0, 3).join(u' ')));
    palette().dismiss();
  }
  openPalette(QStringLiteral("measure"));
  QCOMPARE(found().value(0), QStringLiteral("view.measure"));
  palette().dismiss();
  openPalette(QStringLiteral("cut"));
  QCOMPARE(found().mid(0, 2), (QStringList{QStringLiteral("edit.cut"), QStringLiteral("feature.modeling.boolean")}));
}

void PaletteTest::aBooleanBeginsAsItWasAskedFor() {
  const auto type = window_->session().app().registry->find("modeling.boolean");
  QVERIFY(type);
  window_->session().commit(
      Document::of({feature("a", "modeling.box", {}, "Plate"), feature("b", "modeling.box", {}, "Pin")}), {});
  waitUntilComputed();
  openPalette(QStringLiteral("subtract"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QCOMPARE(document().features().size(), std::size_t(3));
  QCOMPARE(document().features().back()->parameters.value("operation", std::string()), std::string("difference"));
}

void PaletteTest::whatCannotBeDoneSaysWhy() {
  openPalette(QStringLiteral("delete"));
  const int row = static_cast<int>(found().indexOf(QStringLiteral("edit.delete")));
  QVERIFY(row >= 0);
  const QModelIndex index = palette().model().index(row);
  QVERIFY(!index.data(PaletteModel::EnabledRole).toBool());
  QCOMPARE(index.data(PaletteModel::HelpRole).toString(), QStringLiteral("Select a feature first."));
}

void PaletteTest::theStatusIsAsBeforeWhenItCloses() {
  showChain();
  run("view.measure");
  const auto* status = window_->findChild<StatusLine*>();
  const QString wanted = window_->view().restingHint();
  QVERIFY(window_->page().measuring() && !wanted.isEmpty());
  openPalette(QStringLiteral("grid"));
  QTest::keyClick(palette().field(), Qt::Key_Escape);
  QTRY_COMPARE_WITH_TIMEOUT(status->hint(), wanted, 10000);
}

void PaletteTest::itClosesWithoutDoingAnything() {
  const std::size_t features = document().features().size();
  openPalette(QStringLiteral("box"));
  QTest::keyClick(palette().field(), Qt::Key_Escape);
  QVERIFY(palette().isHidden());
  openPalette({});
  QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, QPoint(10, window_->view().height() - 10));
  QVERIFY(palette().isHidden());
  QCOMPARE(document().features().size(), features);
}

// Buttons lie beside each other within the bar; what has no button is in the menu of its group.
void PaletteTest::theToolBarFitsAnyWidth() {
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
void PaletteTest::aNarrowToolBarHidesNoGroup() {
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

void PaletteTest::theSignsOfCrowdedBarsAreSeen() {
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
void PaletteTest::theWindowClosesAtAnyWidth() {
  for (const int width : {1280, 1440, 1600, 1760, 1920, 2600}) {
    window_->resize(width, 720);
    QTRY_COMPARE(window_->width(), width);
    QCoreApplication::processEvents();
    window_.reset();
    openTestWindow();
  }
}

void PaletteTest::aLongJobIsListedAndCancelled() {
  JobsList& jobs = window_->logAndJobs().jobs();
  window_->session().commit(Document::of({feature("w", "test.waiting")}), QStringLiteral("Add Waiting"));
  QTRY_COMPARE(jobs.running(), 1);
  window_->commands().action(QStringLiteral("view.jobs"))->trigger();
  QVERIFY(window_->logAndJobs().jobsDock().isVisible());
  QVERIFY(window_->commands().action(QStringLiteral("view.jobs"))->isChecked());
  const QModelIndex row = jobs.index(0);
  QTRY_VERIFY(row.data(JobsList::StageRole).toString().contains(QStringLiteral("waiting")));
  QVERIFY(row.data(JobsList::FractionRole).toDouble() > 0);
  auto* panel = window_->findChild<JobsPanel*>();
  panel->setCurrentIndex(row);
  QTest::keyClick(panel, Qt::Key_Delete);
  QTRY_COMPARE(jobs.running(), 0);
  QCOMPARE(static_cast<JobsList::State>(jobs.index(0).data(JobsList::StateRole).toInt()), JobsList::State::Cancelled);
  QVERIFY(!window_->session().evaluating());
  // Another document may work at the same time; each has a row of its own.
  window_->session().commit(Document::of({feature("w2", "test.waiting")}), {});
  QTRY_COMPARE(jobs.running(), 1);
  window_->addPage();
  window_->session().commit(Document::of({feature("w3", "test.waiting")}), {});
  QTRY_COMPARE(jobs.running(), 2);
  jobs.cancel(0);
  QTRY_COMPARE(jobs.running(), 1);
  QVERIFY(window_->page(0).session().evaluating());
  letGo_ = true;
  QTRY_COMPARE(jobs.running(), 0);
  QCOMPARE(static_cast<JobsList::State>(jobs.index(1).data(JobsList::StateRole).toInt()), JobsList::State::Done);
  window_->commands().action(QStringLiteral("view.jobs"))->trigger();
  QVERIFY(!window_->logAndJobs().jobsDock().isVisible());
}

void PaletteTest::finishedWorkIsKeptWithItsMessage() {
  JobsList& jobs = window_->logAndJobs().jobs();
  window_->openFile(QStringLiteral("/nowhere/missing.step"));
  QTRY_VERIFY(jobs.rowCount() == 1 && jobs.running() == 0);
  const QModelIndex row = jobs.index(0);
  QCOMPARE(static_cast<JobsList::State>(row.data(JobsList::StateRole).toInt()), JobsList::State::Failed);
  QVERIFY2(row.data(JobsList::MessageRole).toString().contains(QStringLiteral("missing.step")),
           qPrintable(row.data(JobsList::MessageRole).toString()));
  QVERIFY(row.data(JobsList::TimeRole).toString().endsWith(u's'));
  jobs.clearFinished();
  QCOMPARE(jobs.rowCount(), 0);
}

void PaletteTest::theLogTellsWhatHappened() {
  LogList& log = window_->logAndJobs().log();
  const auto messages = [&](LogList::Level minimum) {
    QStringList all;
    for (int row = 0; row < log.rowCount(); ++row)
      if (log.index(row, 0).data(LogList::LevelRole).toInt() >= static_cast<int>(minimum))
        all << log.index(row, LogList::MessageColumn).data().toString();
    return all;
  };
  openPropeller();
  QVERIFY(messages(LogList::Level::Note).first().startsWith(QStringLiteral("Opened ")));
  const qsizetype before = messages(LogList::Level::Error).size();
  window_->session().commit(document().with(feature("f", "test.failing", {}, "Pocket")), {});
  waitUntilComputed();
  const QStringList errors = messages(LogList::Level::Error);
  QCOMPARE(errors.size(), before + 1);
  QCOMPARE(errors.last(), QStringLiteral("Pocket: The tool of 12 mm is too large. A tool of 4.8 mm would fit."));
  window_->tree().toggleVisible("f");  // said once
  waitUntilComputed();
  QCOMPARE(messages(LogList::Level::Error).size(), before + 1);
  auto* panel = window_->findChild<LogPanel*>();
  panel->filter().setLevel(static_cast<int>(LogList::Level::Error));
  QCOMPARE(panel->filter().rowCount(), static_cast<int>(before + 1));
  QVERIFY(panel->text().contains(QStringLiteral("Pocket")));
  log.clear();
  QCOMPARE(log.rowCount(), 0);
  // What is refused is told there, too.
  window_->tree().select(document().features().front()->id);
  run("edit.delete");
  const ErrorBar& bar = window_->page().errors();
  QVERIFY(bar.message().contains(QStringLiteral("is used by")));
  QCOMPARE(messages(LogList::Level::Error), QStringList{bar.message() + u' ' + bar.hint()});
}

void PaletteTest::theLogFollowsTheNewest() {
  LogList& log = window_->logAndJobs().log();
  for (int k = 0; k < 80; ++k) log.add(LogList::Level::Note, QStringLiteral("a"), QString::number(k));
  run("view.log");
  const auto* rows = window_->findChild<QTreeView*>(QStringLiteral("log"));
  QVERIFY(rows && rows->isVisible());
  const QScrollBar& bar = *rows->verticalScrollBar();
  QTRY_VERIFY(bar.maximum() > 0 && bar.value() == bar.maximum());
  for (int k = 0; k < 20; ++k) log.add(LogList::Level::Note, QStringLiteral("a"), QString::number(k));
  const int rowHeight = rows->visualRect(rows->model()->index(0, 0)).height();
  QTRY_VERIFY(bar.maximum() > 90 * rowHeight - rows->viewport()->height() && bar.value() == bar.maximum());
  rows->verticalScrollBar()->setValue(0);  // something older is read
  log.add(LogList::Level::Note, QStringLiteral("a"), QStringLiteral("newest"));
  QCoreApplication::processEvents();
  QCOMPARE(bar.value(), 0);
  window_->session().commit(Document::of({feature("w", "test.waiting")}), {});
  QTRY_VERIFY(window_->session().evaluating());
  window_->session().cancel();
  QTRY_VERIFY(log.index(log.rowCount() - 1, LogList::MessageColumn)
                  .data()
                  .toString()
                  .startsWith(QStringLiteral("Computing was cancelled")));
}

void PaletteTest::theCrossStaysInPlace() {
  StatusLine line;
  line.resize(900, 24);
  line.show();
  line.setWork(QStringLiteral("a"), QStringLiteral("Extrude"), 0.1);
  auto* const cross = line.findChild<QToolButton*>(QStringLiteral("cancelWork"));
  QVERIFY(cross);
  QTRY_VERIFY(cross->isVisible());
  QCoreApplication::processEvents();
  const QRect before = cross->geometry();
  line.setWhereabouts(QStringLiteral("x 1234.567   y -987.65   z 12345.6"));
  line.setWork(QStringLiteral("a"), QStringLiteral("A feature with a long name: Joining faces"), 0.99);
  QCoreApplication::processEvents();
  QCOMPARE(cross->geometry(), before);
}

void PaletteTest::everythingIsComputedAnew() {
  openPropeller();
  const FeatureId id = sweep();
  run("edit.recompute");
  waitUntilComputed();
  QVERIFY(!window_->session().view(id)->result->fromCache);
  QVERIFY(window_->session().view(id)->result->kernelMs > 0);
}

BLOSSOM_WINDOW_TEST_MAIN(PaletteTest)
#include "palette_test.moc"
