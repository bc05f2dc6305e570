#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>

#include "documents_fixture.h"
#include "ui/files/recent_files.h"
#include "ui/files/start_page.h"
#include "ui/files/tile.h"
#include "ui/window/first_size.h"

using namespace blossom;
using namespace blossom::ui;

class StartPageTest : public DocumentsFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void theFirstWindowFitsTheScreen();
  void recentFilesAreShownAndForgotten();
  void theStartPageFitsNarrowWindows();
  void aNewDocumentIsAnEmptyCanvas();
};

void StartPageTest::theFirstWindowFitsTheScreen() {
  QCOMPARE(firstSize({2560, 1600}), QSize(1440, 900));
  const QSize small = firstSize({1280, 800});
  QVERIFY(small.width() <= 1280 && small.width() > 1200);
  QVERIFY(small.height() < 800 && small.height() > 700);
}

void StartPageTest::recentFilesAreShownAndForgotten() {
  RecentFiles::instance().clear();
  const QString here = saved(QStringLiteral("here.blossom")), gone = saved(QStringLiteral("gone.blossom"));
  openAll({here});
  window_->openFile(gone);
  QTRY_COMPARE(RecentFiles::instance().list().size(), std::size_t(2));
  QVERIFY(QFile::remove(gone));
  RecentFiles::instance().setPinned(here, true);
  const auto list = RecentFiles::instance().list();
  QCOMPARE(list[0].file, here);
  QVERIFY(list[0].pinned && !list[0].missing);
  QVERIFY(list[1].missing);
  window_->commands().action(QStringLiteral("file.start-page"))->trigger();
  auto* start = window_->findChild<StartPage*>();
  QVERIFY(start->isVisible());
  const auto tileOf = [&](const QString& file) -> Tile* {
    for (Tile* tile : start->findChildren<Tile*>())
      if (tile->file() == file && tile->isVisible()) return tile;
    return nullptr;
  };
  QVERIFY(tileOf(here) && tileOf(gone));
  QCOMPARE(tileOf(gone)->accessibleDescription(), QStringLiteral("Not there any more"));
  RecentFiles::instance().remove(gone);
  QTRY_VERIFY(!tileOf(gone));
  QTest::mouseClick(tileOf(here), Qt::LeftButton);
  QVERIFY(!start->isVisible());
  QVERIFY(window_->windowTitle().startsWith(QStringLiteral("here.blossom")));
  RecentFiles::instance().setPinned(here, false);
}

void StartPageTest::theStartPageFitsNarrowWindows() {
  auto* start = window_->findChild<StartPage*>();
  QVERIFY(start->isVisible());
  for (const int width : {640, 900, 1280}) {
    window_->resize(width, 600);
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    const auto* scroll = start->findChild<QScrollArea*>();
    QCOMPARE(scroll->horizontalScrollBar()->maximum(), 0);
    for (const QPushButton* each : start->findChildren<QPushButton*>()) {
      if (!each->isVisible()) continue;
      const int right = each->mapTo(scroll->viewport(), QPoint(each->width(), 0)).x();
      QVERIFY2(right <= scroll->viewport()->width(), qPrintable(each->accessibleName() + each->text()));
    }
  }
  // What the bar tells is seen above it.
  window_->errors().showError(QStringLiteral("This cannot be done."), QStringLiteral("Do something else."));
  QCoreApplication::processEvents();
  const int bottom = window_->errors().mapToGlobal(QPoint(0, window_->errors().height())).y();
  QVERIFY(start->mapToGlobal(QPoint()).y() >= bottom);
  window_->errors().hide();
}

void StartPageTest::aNewDocumentIsAnEmptyCanvas() {
  auto* start = window_->findChild<StartPage*>();
  QVERIFY(start->isVisible());
  window_->commands().action(QStringLiteral("file.new"))->trigger();
  QVERIFY(!start->isVisible());
  QCOMPARE(window_->pageCount(), std::size_t(1));
  window_->commands().action(QStringLiteral("file.start-page"))->trigger();
  QVERIFY(start->isVisible());
  QCOMPARE(window_->pageCount(), std::size_t(1));
  // Every tile is reached by the keyboard, in a narrow window as well.
  window_->resize(1280, 720);
  int reached = 0;
  for (Tile* tile : start->findChildren<Tile*>())
    if (tile->isVisibleTo(start) && (tile->focusPolicy() & Qt::TabFocus)) ++reached;
  QVERIFY(reached >= sampleFiles().size());
}

BLOSSOM_WINDOW_TEST(StartPageTest)
#include "start_page_test.moc"
