#include <QCheckBox>
#include <QClipboard>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "document/journal_files.h"
#include "document/storage.h"
#include "ui/files/document_tabs.h"
#include "ui/files/recent_files.h"
#include "ui/files/recovery_bar.h"
#include "ui/files/start_page.h"
#include "ui/files/tile.h"
#include "ui/files/unsaved_dialog.h"
#include "ui/look/text.h"
#include "ui/session/recovery.h"
#include "ui/tree/document_tree.h"
#include "ui/window/first_size.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

Document part(const std::string& name) {
  Feature feature;
  feature.id = "a";
  feature.type = "test.part";
  feature.name = name;
  return Document().with(std::move(feature));
}

void middleClick(DocumentTabs& tabs, int index) {
  const QPoint at = tabs.tabRect(index).center();
  QTest::mousePress(&tabs, Qt::MiddleButton, {}, at);
  QTest::mouseRelease(&tabs, Qt::MiddleButton, {}, at);
}

}  // namespace

class DocumentsTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() {
    window_.reset();
    Recovery::instance().stop();
  }
  void tabsAreSwitchedAndClosed();
  void manyTabsStayReadable();
  void closingTheWindowAsksOnceForAll();
  void samplesAreSavedOnlyWhenAskedFor();
  void theFirstWindowFitsTheScreen();
  void aFileChangedByOthersIsNotOverwrittenUnasked();
  void whatCannotBeSavedIsSaidWithAWayOut();
  void recentFilesAreShownAndForgotten();
  void anErrorMovesNothing();
  void theStartPageFitsNarrowWindows();
  void aNewDocumentIsAnEmptyCanvas();
  void severalFilesOpenAndBadOnesAreToldTogether();
  void aFolderIsCalledAFolder();
  void droppedGeometryJoinsTheDocument();
  void whatCannotBeReadMakesNoFeature();
  void whatACrashLeftIsOffered();
  void discardedItIsGone();

 private:
  QString saved(const QString& name, const Document& document = part("Saved")) {
    const QString file = folder_.filePath(name);
    saveDocument(document, file.toStdString());
    return file;
  }
  void openAll(const QStringList& files) {
    window_->openFiles(files);
    QTRY_VERIFY(!window_->session().job().running() && !window_->session().document().features().empty());
  }
  DocumentTabs& tabs() { return *window_->findChild<DocumentTabs*>(); }
  void crashWith(const std::string& name, const QString& file);
};

void DocumentsTest::tabsAreSwitchedAndClosed() {
  openAll({saved(QStringLiteral("a.blossom")), saved(QStringLiteral("b.blossom")), saved(QStringLiteral("c.blossom"))});
  QCOMPARE(window_->pageCount(), std::size_t(3));
  QCOMPARE(tabs().count(), 3);
  QCOMPARE(tabs().currentIndex(), 2);
  QTest::keyClick(window_.get(), Qt::Key_Tab, Qt::ControlModifier);
  QCOMPARE(tabs().currentIndex(), 0);
  QCOMPARE(&window_->page(), &window_->page(0));
  QTest::keyClick(window_.get(), Qt::Key_PageDown, Qt::ControlModifier);
  QCOMPARE(tabs().currentIndex(), 1);
  QTest::keyClick(window_.get(), Qt::Key_PageUp, Qt::ControlModifier);
  QCOMPARE(tabs().currentIndex(), 0);
  QVERIFY(window_->windowTitle().startsWith(QStringLiteral("a.blossom")));

  // Opened once more, its tab is shown.
  window_->openFile(folder_.filePath(QStringLiteral("b.blossom")));
  QCOMPARE(tabs().currentIndex(), 1);
  QCOMPARE(window_->pageCount(), std::size_t(3));

  QTRY_VERIFY(!window_->page(0).session().job().running());
  middleClick(tabs(), 0);
  QCOMPARE(window_->pageCount(), std::size_t(2));
  QCOMPARE(tabs().currentIndex(), 0);  // still the same document
  QVERIFY(window_->windowTitle().startsWith(QStringLiteral("b.blossom")));
  QCOMPARE(tabs().tabData(0).toString(), folder_.filePath(QStringLiteral("b.blossom")));

  window_->session().commit(part("Changed"), QStringLiteral("Change"));
  QVERIFY(tabs().tabText(0).contains(QChar(0x2022)));
  window_->session().undo();
  QVERIFY(!tabs().tabText(0).contains(QChar(0x2022)));
  window_->commands().action(QStringLiteral("file.close-others"))->trigger();
  QCOMPARE(window_->pageCount(), std::size_t(1));
  QVERIFY(window_->windowTitle().startsWith(QStringLiteral("b.blossom")));
}

void DocumentsTest::manyTabsStayReadable() {
  DocumentTabs tabs;
  for (int i = 0; i < 12; ++i) tabs.addTab(QStringLiteral("pulled-curve-of-outline-%1.blossom").arg(i));
  tabs.resize(790, tabs.sizeHint().height());
  tabs.show();
  QVERIFY(QTest::qWaitForWindowExposed(&tabs));
  QCOMPARE(tabs.elideMode(), Qt::ElideRight);
  for (int i = 0; i < tabs.count(); ++i)
    QVERIFY2(tabs.tabRect(i).width() >= 140, qPrintable(QString::number(tabs.tabRect(i).width())));
  int arrows = 0;
  for (const auto* button : tabs.findChildren<QToolButton*>()) arrows += button->isVisible() ? 1 : 0;
  QCOMPARE(arrows, 2);
  // With room for all of it nothing is cut off, and the whole name is told wherever the mouse rests.
  while (tabs.count() > 2) tabs.removeTab(2);
  for (int i = 0; i < tabs.count(); ++i)
    QVERIFY(tabs.tabRect(i).width() > tabs.fontMetrics().horizontalAdvance(tabs.tabText(i)));
  window_->session().commit(part("Plate"), QStringLiteral("Add"));
  const auto* shown = window_->findChild<DocumentTabs*>();
  QVERIFY(shown->tabToolTip(0).startsWith(window_->session().title() + u'\n'));
}

void DocumentsTest::closingTheWindowAsksOnceForAll() {
  const QStringList files{saved(QStringLiteral("a.blossom")), saved(QStringLiteral("b.blossom")),
                          saved(QStringLiteral("c.blossom"))};
  openAll(files);
  for (std::size_t i = 0; i < 3; ++i) {
    QTRY_VERIFY(!window_->page(i).session().job().running());
    window_->page(i).session().commit(part("Changed"), QStringLiteral("Change"));
  }
  int asked = 0;
  const auto answerBy = [&](const char* button, const std::vector<int>& unticked) {
    QTimer::singleShot(0, window_.get(), [&, button, unticked] {
      auto* question = window_->findChild<UnsavedDialog*>();
      if (!question) return;
      ++asked;
      const auto boxes = question->findChildren<QCheckBox*>();
      if (boxes.size() != 3) return question->reject();
      for (const int place : unticked) boxes[place]->setChecked(false);
      button ? question->findChild<QPushButton*>(QLatin1String(button))->click() : question->reject();
    });
  };
  answerBy(nullptr, {});
  QVERIFY(!window_->close());
  QCOMPARE(asked, 1);
  QVERIFY(window_->isVisible());
  answerBy("saveChosen", {1});
  window_->close();
  QCOMPARE(asked, 2);
  QTRY_VERIFY(!window_->isVisible());
  const auto nameIn = [&](int place) { return openDocument(files[place].toStdString()).document.at("a").name; };
  QCOMPARE(nameIn(0), std::string("Changed"));
  QCOMPARE(nameIn(1), std::string("Saved"));
  QCOMPARE(nameIn(2), std::string("Changed"));
}

void DocumentsTest::samplesAreSavedOnlyWhenAskedFor() {
  const QString share = folder_.filePath(QStringLiteral("share"));
  std::filesystem::create_directories(share.toStdString() + "/samples");
  for (const char* name : {"share/samples/star.blossom", "own.blossom"}) saved(QLatin1String(name));
  qputenv("BLOSSOM_RESOURCES", share.toLocal8Bit());
  openAll({share + QStringLiteral("/samples/star.blossom"), folder_.filePath(QStringLiteral("own.blossom"))});
  for (int untitled = 0; untitled < 2; ++untitled) run("file.new");
  for (std::size_t i = 0; i < window_->pageCount(); ++i) {
    QTRY_VERIFY(!window_->page(i).session().job().running());
    window_->page(i).session().commit(part("Changed"), QStringLiteral("Change"));
  }
  QCOMPARE(window_->page(0).session().fromSample(), true);
  QCOMPARE(window_->page(1).session().fromSample(), false);
  QStringList names, ticked;
  QString button;
  QTimer::singleShot(0, window_.get(), [&] {
    auto* question = window_->findChild<UnsavedDialog*>();
    if (!question) return;
    for (const QCheckBox* box : question->findChildren<QCheckBox*>()) {
      names << box->text();
      if (box->isChecked()) ticked << box->text();
    }
    button = question->findChild<QPushButton*>(QStringLiteral("saveChosen"))->text();
    question->reject();
  });
  QVERIFY(!window_->close());
  qunsetenv("BLOSSOM_RESOURCES");
  const QStringList wanted{QStringLiteral("star (sample, untitled)"), QStringLiteral("own.blossom"),
                           QStringLiteral("Untitled, tab 3"), QStringLiteral("Untitled, tab 4")};
  QCOMPARE(names, wanted);
  QCOMPARE(ticked, wanted.mid(1));
  QCOMPARE(button, QStringLiteral("Save 3 of 4"));
  // Saved under a name of its own, it is a document like others.
  window_->page(0).session().save(folder_.filePath(QStringLiteral("mine.blossom")).toStdString());
  QTRY_VERIFY(!window_->page(0).session().job().running());
  QVERIFY(!window_->page(0).session().fromSample());
}

void DocumentsTest::theFirstWindowFitsTheScreen() {
  QCOMPARE(firstSize({2560, 1600}), QSize(1440, 900));
  const QSize small = firstSize({1280, 800});
  QVERIFY(small.width() <= 1280 && small.width() > 1200);
  QVERIFY(small.height() < 800 && small.height() > 700);
}

void DocumentsTest::aFileChangedByOthersIsNotOverwrittenUnasked() {
  const QString file = saved(QStringLiteral("shared.blossom"));
  openAll({file});
  QVERIFY(!window_->session().changedOnDisk());
  window_->session().commit(part("Mine"), QStringLiteral("Change"));
  saveDocument(part("Theirs, with a longer name"), file.toStdString());
  QVERIFY(window_->session().changedOnDisk());
  QString said;
  const auto press = [&](const QString& text) {
    QTimer::singleShot(0, window_.get(), [&, text] {
      auto* question = window_->findChild<QMessageBox*>();
      if (!question) return;
      said = question->text();
      for (QAbstractButton* button : question->buttons())
        if (button->text().remove(u'&') == text) return button->click();
      question->reject();
    });
  };
  press(QStringLiteral("Cancel"));
  window_->commands().action(QStringLiteral("file.save"))->trigger();
  QVERIFY2(said.startsWith(QStringLiteral("shared.blossom was changed")), qPrintable(said));
  QCOMPARE(openDocument(file.toStdString()).document.at("a").name, std::string("Theirs, with a longer name"));
  QVERIFY(window_->session().modified());
  press(QStringLiteral("Replace"));
  window_->commands().action(QStringLiteral("file.save"))->trigger();
  QTRY_VERIFY(!window_->session().modified());
  QCOMPARE(openDocument(file.toStdString()).document.at("a").name, std::string("Mine"));
  QVERIFY(!window_->session().changedOnDisk());
}

void DocumentsTest::whatCannotBeSavedIsSaidWithAWayOut() {
  const QString file = saved(QStringLiteral("protected.blossom"));
  openAll({file});
  window_->session().commit(part("Mine"), QStringLiteral("Change"));
  QVERIFY(QFile::setPermissions(file, QFile::ReadOwner));
  window_->commands().action(QStringLiteral("file.save"))->trigger();
  QTRY_VERIFY(window_->errors().isVisible());
  QVERIFY2(window_->errors().message().contains(QStringLiteral("write-protected")), qPrintable(window_->errors().message()));
  QVERIFY(!window_->errors().hint().isEmpty());
  bool offered = false;
  for (const QPushButton* button : window_->errors().findChildren<QPushButton*>())
    offered = offered || (button->text() == QStringLiteral("Save as…") && button->isVisible());
  QVERIFY(offered);
  QVERIFY(window_->session().modified());
  QCOMPARE(openDocument(file.toStdString()).document.at("a").name, std::string("Saved"));

  window_->session().save((folder_.path() + QStringLiteral("/no/such/folder/x.blossom")).toStdString());
  QTRY_VERIFY(window_->errors().message().contains(QStringLiteral("/no/such/folder")));
  QVERIFY(window_->session().modified());
  window_->session().undo();
}

void DocumentsTest::recentFilesAreShownAndForgotten() {
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

// What is told lies over the view, which keeps its place and size; the cube stays free.
void DocumentsTest::anErrorMovesNothing() {
  openAll({saved(QStringLiteral("here.blossom"))});
  const auto place = [&] { return QRect(window_->view().mapToGlobal(QPoint()), window_->view().size()); };
  const QRect before = place();
  window_->errors().showError(QStringLiteral("This cannot be done."), QStringLiteral("Do something else."));
  QCoreApplication::processEvents();
  QVERIFY(window_->errors().isVisible() && window_->errors().height() >= 30);
  QCOMPARE(place(), before);
  const QPoint bar = window_->errors().mapToGlobal(QPoint(0, 0));
  QVERIFY(before.contains(bar));
  QVERIFY(bar.x() + window_->errors().width() < before.right() - 110);
  window_->errors().hide();
  QCoreApplication::processEvents();
  QCOMPARE(place(), before);
}

void DocumentsTest::theStartPageFitsNarrowWindows() {
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

void DocumentsTest::aNewDocumentIsAnEmptyCanvas() {
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

void DocumentsTest::aFolderIsCalledAFolder() {
  window_->openFiles({folder_.path()});
  QTRY_VERIFY(window_->errors().isVisible());
  QVERIFY2(window_->errors().hint().contains(QStringLiteral("is a folder")), qPrintable(window_->errors().hint()));
  QVERIFY(window_->errors().hint().contains(folder_.path()));
}

void DocumentsTest::severalFilesOpenAndBadOnesAreToldTogether() {
  const QString good = saved(QStringLiteral("good.blossom"));
  const QString odd = folder_.filePath(QStringLiteral("odd.xyzzy"));
  QFile out(odd);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("?");
  out.close();
  window_->openFiles({good, odd, folder_.filePath(QStringLiteral("absent.step"))});
  QTRY_VERIFY(!window_->session().document().features().empty());
  QCOMPARE(window_->pageCount(), std::size_t(1));
  QTRY_VERIFY(window_->errors().isVisible());
  QCOMPARE(window_->errors().message(), QStringLiteral("2 of 3 files cannot be opened."));
  QVERIFY(window_->errors().hint().contains(QStringLiteral("odd.xyzzy")));
}

void DocumentsTest::droppedGeometryJoinsTheDocument() {
  openAll({saved(QStringLiteral("base.blossom"))});
  QStringList drawings;
  for (const char* name : {"one.svg", "two.svg"}) {
    drawings << folder_.filePath(QLatin1String(name));
    QFile out(drawings.back());
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write("<svg xmlns='http://www.w3.org/2000/svg'><rect width='40' height='20'/></svg>");
  }
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(drawings[0]), QUrl::fromLocalFile(drawings[1]),
                QUrl::fromLocalFile(folder_.filePath(QStringLiteral("absent.svg"))),
                QUrl::fromLocalFile(saved(QStringLiteral("other.blossom")))});
  QDragEnterEvent enter(QPoint(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(window_.get(), &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent event(QPointF(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(window_.get(), &event);
  QVERIFY(event.isAccepted());
  QTRY_COMPARE(window_->page(0).document().features().size(), std::size_t(3));
  QCOMPARE(window_->pageCount(), std::size_t(2));
  QTRY_VERIFY(window_->page(0).errors().message().size() > 0);
  QCOMPARE(qt(window_->page(0).session().history().undoText()), QStringLiteral("Import 3 files"));
  window_->page(0).session().undo();
}

void DocumentsTest::whatCannotBeReadMakesNoFeature() {
  openAll({saved(QStringLiteral("base.blossom"))});
  const auto write = [&](const char* name, const char* text) {
    QFile out(folder_.filePath(QLatin1String(name)));
    if (out.open(QIODevice::WriteOnly)) out.write(text);
    return folder_.filePath(QLatin1String(name)).toStdString();
  };
  const auto drawing = write("fine.svg", "<svg xmlns='http://www.w3.org/2000/svg'><rect width='40' height='20'/></svg>");
  const auto rubbish = write("rubbish.svg", "There is no drawing in here."), other = write("other.stl", "Nor a mesh.");
  Session& session = window_->page(0).session();
  QSignalSpy warned(&session, &Session::warned), failed(&session, &Session::failed), begun(&session.job(), &Job::finished);
  const std::size_t before = session.document().features().size();

  // Nothing good among them: the document stays as it was.
  session.import({rubbish});
  QTRY_COMPARE(begun.count(), 1);
  QCOMPARE(failed.count(), 1);
  session.import({rubbish, other});
  QTRY_COMPARE(begun.count(), 2);
  QTRY_COMPARE(warned.count(), 1);
  QCOMPARE(session.document().features().size(), before);
  QVERIFY(!session.modified());

  session.import({rubbish, drawing, other});
  QTRY_COMPARE(begun.count(), 3);
  QTRY_COMPARE(session.document().features().size(), before + 1);
  QTRY_COMPARE(warned.count(), 2);
  const QStringList told = warned.back().front().toStringList();
  QCOMPARE(told.size(), 2);
  QVERIFY2(told[0].contains(QStringLiteral("rubbish.svg")) && told[1].contains(QStringLiteral("other.stl")),
           qPrintable(told.join(u'\n')));
  QTRY_VERIFY(!session.evaluating());
  const FeatureId made = session.document().features().back()->id;
  QTRY_VERIFY(session.view(made) && !session.view(made)->result->error);
  session.undo();
}

/// As if an earlier run had been killed with these unsaved.
void DocumentsTest::crashWith(const std::string& name, const QString& file) {
  RecoveryArea killed(Recovery::standardFolder());
  Journal journal(killed.newFolder());
  journal.record(part(name), "Change name", {file.toStdString(), QFileInfo(file).fileName().toStdString()});
}

void DocumentsTest::whatACrashLeftIsOffered() {
  const QString file = saved(QStringLiteral("wheel.blossom"));
  crashWith("Unsaved", file);
  Recovery::instance().start();
  auto* bar = window_->findChild<RecoveryBar*>();
  QTRY_VERIFY(bar->isVisible());
  QStringList words;
  for (const QLabel* label : bar->findChildren<QLabel*>()) words << label->text();
  QVERIFY(words.join(u'\n').contains(QStringLiteral("wheel.blossom")));
  QVERIFY(words.join(u'\n').contains(QStringLiteral("Change name")));
  for (QPushButton* button : bar->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Recover")) {
      QTest::mouseClick(button, Qt::LeftButton);
      break;
    }
  QTRY_VERIFY(!window_->session().document().features().empty());
  QCOMPARE(window_->session().document().at("a").name, std::string("Unsaved"));
  QVERIFY(window_->session().modified());
  QCOMPARE(qt(window_->session().file().string()), file);
  QTRY_VERIFY(Recovery::instance().lost().empty());
  QTRY_VERIFY(!bar->isVisible());
  QCOMPARE(QApplication::focusWidget(), &window_->view());  // and not what can be typed over
  // It has a safety copy of its own now.
  const auto copies = [] {
    int found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(Recovery::standardFolder()))
      if (entry.path().filename().string().starts_with("base-")) ++found;
    return found;
  };
  QTRY_COMPARE(copies(), 1);
  // Saved over the file it came from, which is as it was; then there is nothing left to recover.
  window_->commands().action(QStringLiteral("file.save"))->trigger();
  QTRY_VERIFY(!window_->session().modified());
  QCOMPARE(openDocument(file.toStdString()).document.at("a").name, std::string("Unsaved"));
  QTRY_COMPARE(copies(), 0);
}

void DocumentsTest::discardedItIsGone() {
  crashWith("Unwanted", {});
  Recovery::instance().start();
  auto* bar = window_->findChild<RecoveryBar*>();
  QTRY_VERIFY(bar->isVisible());
  for (QPushButton* button : bar->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Discard")) button->click();
  QTRY_VERIFY(!bar->isVisible());
  Recovery::instance().stop();
  QVERIFY(RecoveryArea(Recovery::standardFolder()).lost().empty());
}

BLOSSOM_WINDOW_TEST_MAIN(DocumentsTest)
#include "documents_test.moc"
