#include <QPushButton>

#include "core/file.h"
#include "document/storage.h"
#include "ui/files/recent_files.h"
#include "ui/look/text.h"
#include "ui/panel/result_table.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;
namespace fs = std::filesystem;

/// What the window makes of files: samples stay as they are, and a stranger's document reads nothing unasked.
class DocumentFilesWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup();
  void samplesOpenUntitled();
  void resourcesAreNeverWritten();
  void aStrangersFilesAreReadOnlyWhenAllowed();
  void aBarThatGoesLeavesTheFocusToTheView_data();
  void aBarThatGoesLeavesTheFocusToTheView();
  void filesBelowTheDocumentsFolderAreReadAndSaved();
  void anImportShowsTheOptionsOfItsFormat();

 private:
  [[nodiscard]] fs::path place(const std::string& name) const { return fs::path(home_->path().toStdString()) / name; }
  [[nodiscard]] fs::path writeStranger(const std::string& path) const {
    Feature import;
    import.id = import.name = "import-1";
    import.type = "exchange.import";
    import.parameters["file"] = Value{{"path", path}, { "asset", "" }};
    const fs::path file = place("theirs/s.blossom");
    saveDocument(Document::of({import}), file);
    return file;
  }
  [[nodiscard]] QPushButton* offered() const { return window_->errors().findChild<QPushButton*>(); }

  std::unique_ptr<QTemporaryDir> home_;
};

void DocumentFilesWindowTest::init() {
  home_ = std::make_unique<QTemporaryDir>();
  fs::create_directories(place("theirs"));
  fs::create_directories(place("share/samples"));
  writeAtomically(place("secret.off"), "OFF\n3 1 0\n0 0 0\n6 0 0\n0 5 0\n3 0 1 2\n");
  openWindow();
}

void DocumentFilesWindowTest::cleanup() {
  window_.reset();
  qunsetenv("BLOSSOM_RESOURCES");
}

void DocumentFilesWindowTest::samplesOpenUntitled() {
  fs::copy_file(test::sample("bracket.blossom"), place("share/samples/bracket.blossom"));
  qputenv("BLOSSOM_RESOURCES", place("share").c_str());
  openAndWait(qt(place("share/samples/bracket.blossom").string()));
  Session& session = window_->session();
  QVERIFY(session.file().empty());  // saving asks for a name
  QCOMPARE(session.title(), QStringLiteral("bracket"));
  QCOMPARE(session.suggestedName(), QStringLiteral("bracket"));
  QVERIFY(!session.modified());
  for (const RecentFile& each : RecentFiles::instance().list()) QVERIFY(!each.file.contains(QStringLiteral("bracket")));
  run("edit.show-hide");
  QVERIFY(session.modified());
}

void DocumentFilesWindowTest::resourcesAreNeverWritten() {
  fs::copy_file(test::sample("bracket.blossom"), place("share/samples/bracket.blossom"));
  const std::string before = readFile(place("share/samples/bracket.blossom"));
  qputenv("BLOSSOM_RESOURCES", place("share").c_str());
  openAndWait(qt(place("share/samples/bracket.blossom").string()));
  run("edit.show-hide");
  Session& session = window_->session();
  for (const char* name : {"share/samples/bracket.blossom", "share/samples/mine.blossom", "theirs/../share/mine.blossom"}) {
    session.save(place(name), [] { QFAIL("it was saved"); });
    waitUntilComputed();
    QVERIFY2(window_->errors().message().contains(QStringLiteral("belongs to Blossom")), name);
    QVERIFY(session.modified());
  }
  QCOMPARE(readFile(place("share/samples/bracket.blossom")), before);
  QVERIFY(!fs::exists(place("share/samples/mine.blossom")) && !fs::exists(place("share/mine.blossom")));
  bool saved = false;
  session.save(place("mine.blossom"), [&] { saved = true; });
  waitUntilComputed();
  QVERIFY(saved && !session.modified());
}

void DocumentFilesWindowTest::aStrangersFilesAreReadOnlyWhenAllowed() {
  for (const std::string& path : {place("secret.off").string(), std::string("../secret.off")}) {
    window_->openFile(qt(writeStranger(path).string()));
    QTRY_VERIFY(!window_->session().document().features().empty());
    waitUntilComputed();
    Session& session = window_->session();
    const auto view = session.view("import-1");
    QVERIFY(view && view->result->error);
    QVERIFY(view->result->error->message().find("outside") != std::string::npos);
    QVERIFY(view->result->error->hint().find("in the window with the button in the bar") != std::string::npos);
    QVERIFY(!window_->errors().isHidden());
    QVERIFY2(window_->errors().hint().contains(qt(place("secret.off").string())), qPrintable(window_->errors().hint()));
    // Saving does not read it either.
    bool saved = false;
    session.save(place("theirs/t.blossom"), [&] { saved = true; });
    waitUntilComputed();
    QVERIFY(saved);
    QVERIFY(openDocument(place("theirs/t.blossom")).document.assets().empty());
    QVERIFY(offered());
    QCOMPARE(offered()->text(), QStringLiteral("Read them"));
    offered()->click();
    waitUntilComputed();
    QTRY_VERIFY(!session.view("import-1")->result->error);
    COMPARE_NEAR(measureOf("import-1", "area"), 15, 1e-12);
    QVERIFY(window_->errors().isHidden());
    QVERIFY(!session.modified());  // to allow it is no edit
    session.save(place("theirs/t.blossom"));
    waitUntilComputed();
    QCOMPARE(openDocument(place("theirs/t.blossom")).document.assets().size(), std::size_t{1});
    session.clear();
  }
}

void DocumentFilesWindowTest::aBarThatGoesLeavesTheFocusToTheView_data() {
  QTest::addColumn<QString>("how");
  for (const char* how : {"pressed", "key", "dismissed", "replaced"}) QTest::newRow(how) << QString::fromLatin1(how);
}

// A key pressed next is a shortcut of the view, and no name is typed over.
void DocumentFilesWindowTest::aBarThatGoesLeavesTheFocusToTheView() {
  QFETCH(QString, how);
  window_->openFile(qt(writeStranger("../secret.off").string()));
  QTRY_VERIFY(!window_->session().document().features().empty());
  waitUntilComputed();
  QTRY_VERIFY(offered() && offered()->isVisible());
  offered()->setFocus(Qt::MouseFocusReason);
  QCOMPARE(QApplication::focusWidget(), offered());
  if (how == QLatin1String("pressed")) QTest::mouseClick(offered(), Qt::LeftButton);
  if (how == QLatin1String("key")) QTest::keyClick(offered(), Qt::Key_Space);
  if (how == QLatin1String("dismissed")) QTest::keyClick(offered(), Qt::Key_Escape);
  if (how == QLatin1String("replaced")) window_->errors().showNote(QStringLiteral("Something else."), {});
  QCOMPARE(QApplication::focusWidget(), &window_->view());
  waitUntilComputed();
  QCOMPARE(QApplication::focusWidget(), &window_->view());
  const std::string before = toJson(window_->session().document());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_F);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  QCOMPARE(toJson(window_->session().document()), before);
}

void DocumentFilesWindowTest::filesBelowTheDocumentsFolderAreReadAndSaved() {
  fs::create_directories(place("theirs/parts"));
  fs::copy_file(place("secret.off"), place("theirs/parts/part.off"));
  openAndWait(qt(writeStranger("parts/part.off").string()));
  COMPARE_NEAR(measureOf("import-1", "area"), 15, 1e-12);
  window_->session().save(place("moved.blossom"));
  waitUntilComputed();
  QCOMPARE(openDocument(place("moved.blossom")).document.assets().size(), std::size_t{1});
}

void DocumentFilesWindowTest::anImportShowsTheOptionsOfItsFormat() {
  const fs::path file = place("roof.cpt");
  writeAtomically(file,
                  "0,0,0;0,10,0;0,20,0;0,30,0\n10,0,5;10,10,5;10,20,5;10,30,5\n20,0,0;20,10,0;20,20,0;20,30,0\n"
                  "30,0,5;30,10,5;30,20,5;30,30,5\n");
  openAndWait(qt(file.string()));
  const auto* options = window_->properties().field(QStringLiteral("control-points"));
  const auto* others = window_->properties().field(QStringLiteral("gcode"));
  QVERIFY(options && options->isVisible());
  QVERIFY(others && others->isHidden());
  auto* const degree = options->findChildren<QLineEdit*>().front();
  degree->setFocus();
  degree->selectAll();
  QTest::keyClicks(degree, QStringLiteral("1"));
  QTest::keyClick(degree, Qt::Key_Return);
  waitUntilComputed();
  // Three rectangles of 30 by sqrt(10^2 + 5^2).
  COMPARE_NEAR(measureOf(last(), "area"), 90 * std::sqrt(125.0), 1e-6);
}

BLOSSOM_WINDOW_TEST(DocumentFilesWindowTest)
#include "document_files_window_test.moc"
