#include <QSignalSpy>

#include "documents_fixture.h"
#include "ui/look/text.h"

using namespace blossom;
using namespace blossom::ui;

class OpeningFilesTest : public DocumentsFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void anErrorMovesNothing();
  void aFolderIsCalledAFolder();
  void severalFilesOpenAndBadOnesAreToldTogether();
  void droppedGeometryJoinsTheDocument();
  void whatCannotBeReadMakesNoFeature();
};

// What is told lies over the view, which keeps its place and size; the cube stays free.
void OpeningFilesTest::anErrorMovesNothing() {
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

void OpeningFilesTest::aFolderIsCalledAFolder() {
  window_->openFiles({folder_.path()});
  QTRY_VERIFY(window_->errors().isVisible());
  QVERIFY2(window_->errors().hint().contains(QStringLiteral("is a folder")), qPrintable(window_->errors().hint()));
  QVERIFY(window_->errors().hint().contains(folder_.path()));
}

void OpeningFilesTest::severalFilesOpenAndBadOnesAreToldTogether() {
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

void OpeningFilesTest::droppedGeometryJoinsTheDocument() {
  openAll({saved(QStringLiteral("base.blossom"))});
  QStringList drawings;
  for (const char* name : {"one.svg", "two.svg"}) {
    drawings << folder_.filePath(QLatin1String(name));
    QFile out(drawings.back());
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write("<svg xmlns='http://www.w3.org/2000/svg'><rect width='40' height='20'/></svg>");
  }
  QVERIFY(drop(
      {drawings[0], drawings[1], folder_.filePath(QStringLiteral("absent.svg")), saved(QStringLiteral("other.blossom"))}));
  QTRY_COMPARE(window_->page(0).document().features().size(), std::size_t(3));
  QCOMPARE(window_->pageCount(), std::size_t(2));
  QTRY_VERIFY(window_->page(0).errors().message().size() > 0);
  QCOMPARE(qt(window_->page(0).session().history().undoText()), QStringLiteral("Import 3 files"));
  window_->page(0).session().undo();
}

void OpeningFilesTest::whatCannotBeReadMakesNoFeature() {
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

BLOSSOM_WINDOW_TEST(OpeningFilesTest)
#include "opening_files_test.moc"
