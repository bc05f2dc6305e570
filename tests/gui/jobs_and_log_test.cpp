#include <QAbstractItemModel>
#include <QDockWidget>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>
#include <QTreeView>

#include "tree_fixture.h"
#include "ui/jobs/jobs_list.h"
#include "ui/jobs/jobs_panel.h"
#include "ui/jobs/log_and_jobs.h"
#include "ui/jobs/log_list.h"
#include "ui/jobs/log_panel.h"
#include "ui/window/status_line.h"

using namespace blossom;
using namespace blossom::ui;

class JobsAndLogTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openTestWindow(); }
  void cleanup() { closeTestWindow(); }

  void aLongJobIsListedAndCancelled();
  void finishedWorkIsKeptWithItsMessage();
  void theLogTellsWhatHappened();
  void theLogFollowsTheNewest();
  void theCrossStaysInPlace();
  void whatIsDoneIsReadInFull();
  void aLongHintEndsInDots();
  void aLongHintIsShownPartByPart();
  void everythingIsComputedAnew();
};

void JobsAndLogTest::aLongJobIsListedAndCancelled() {
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

void JobsAndLogTest::finishedWorkIsKeptWithItsMessage() {
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

void JobsAndLogTest::theLogTellsWhatHappened() {
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

void JobsAndLogTest::theLogFollowsTheNewest() {
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

void JobsAndLogTest::theCrossStaysInPlace() {
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

/// Also in the moment in which it changes, before the layout has its turn.
void JobsAndLogTest::whatIsDoneIsReadInFull() {
  StatusLine line;
  line.resize(620, 24);
  line.show();
  line.setHint(QStringLiteral("Drag to pull this point · ").repeated(20));
  line.setWork(QStringLiteral("a"), QStringLiteral("Computing"), 0);
  auto* const work = line.findChild<QToolButton*>(QStringLiteral("work"));
  QVERIFY(work);
  QTRY_VERIFY(work->isVisible());
  const QString where = QStringLiteral("x 1234.567   y -987.65   z 12345.6");
  line.setWhereabouts(where);
  line.setWork(QStringLiteral("a"), QStringLiteral("Finding the boundary"), 0.3);
  QVERIFY2(work->width() >= work->sizeHint().width(), qPrintable(QString::number(work->width())));
  const auto labels = line.findChildren<QLabel*>();
  const auto place = std::find_if(labels.begin(), labels.end(), [&](const QLabel* each) { return each->text() == where; });
  QVERIFY(place != labels.end());
  QVERIFY((*place)->width() >= (*place)->sizeHint().width());
  line.resize(360, 24);  // then the place ends in dots
  QVERIFY((*place)->text().endsWith(QChar(0x2026)));
  QVERIFY(work->width() >= work->sizeHint().width());
  line.resize(900, 24);
  QCOMPARE((*place)->text(), where);
}

void JobsAndLogTest::aLongHintEndsInDots() {
  StatusLine line;
  line.resize(400, 24);
  line.show();
  const QString wanted = QStringLiteral("Drag to pull this point · ").repeated(20);
  line.setHint(wanted);
  QCOMPARE(line.hint(), wanted);
  const auto shown = [&] {
    for (const QLabel* label : line.findChildren<QLabel*>())
      if (label->text().startsWith(QStringLiteral("Drag"))) return label;
    return static_cast<const QLabel*>(nullptr);
  };
  QTRY_VERIFY(shown() && shown()->text().endsWith(QChar(0x2026)));
  QVERIFY(shown()->fontMetrics().horizontalAdvance(shown()->text()) <= shown()->width());
  QCOMPARE(shown()->toolTip(), wanted);
  line.setHint(QStringLiteral("Drag"));
  QCOMPARE(shown()->text(), QStringLiteral("Drag"));
  QVERIFY(shown()->toolTip().isEmpty());
}

void JobsAndLogTest::aLongHintIsShownPartByPart() {
  StatusLine line;
  line.resize(400, 24);
  line.show();
  QStringList parts;
  for (int k = 1; k <= 12; ++k) parts << QStringLiteral("part number %1").arg(k);
  const QString wanted = parts.join(QStringLiteral(" · "));
  QStringList seen;
  const auto allSeen = [&] {
    line.setHint(wanted);  // as with each move of the mouse
    for (const QLabel* label : line.findChildren<QLabel*>())
      if (label->text().contains(QStringLiteral("part number"))) seen << label->text().split(QStringLiteral(" · "));
    return std::all_of(parts.begin(), parts.end(), [&](const QString& part) { return seen.contains(part); });
  };
  QVERIFY(!allSeen());
  QVERIFY(seen.contains(parts.front()));
  QTRY_VERIFY_WITH_TIMEOUT(allSeen(), 60000);
  QCOMPARE(line.hint(), wanted);
}

void JobsAndLogTest::everythingIsComputedAnew() {
  openPropeller();
  const FeatureId id = sweep();
  run("edit.recompute");
  waitUntilComputed();
  QVERIFY(!window_->session().view(id)->result->fromCache);
  QVERIFY(window_->session().view(id)->result->kernelMs > 0);
}

BLOSSOM_WINDOW_TEST(JobsAndLogTest)
#include "jobs_and_log_test.moc"
