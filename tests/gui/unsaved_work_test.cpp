// What the user has done stays, whatever is opened, saved, undone, closed or wrong at that moment.
#include <QPushButton>

#include "document/storage.h"
#include "ui/look/text.h"
#include "ui/session/recovery.h"
#include "ui/window/guarded_application.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;
namespace fs = std::filesystem;

namespace {

Document rectangle(const Value& parameters) {
  Feature feature;
  feature.id = "r";
  feature.type = "modeling.rectangle";
  feature.name = "Plate";
  feature.parameters = parameters;
  return Document().with(std::move(feature));
}

Document withOneMore(const Document& document, const std::string& id) {
  Feature feature;
  feature.id = id;
  feature.type = "modeling.circle";
  feature.name = "Added";
  return document.with(std::move(feature));
}

/// Stands for a handler with a mistake in it.
class Mistaken : public QObject {
 public:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::User) throw std::logic_error("a number is a word");
    return QObject::event(event);
  }
};

}  // namespace

class UnsavedWorkTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() {
    window_.reset();
    Recovery::instance().stop();
    fs::remove_all(Recovery::standardFolder());
  }
  void valuesThatDoNotFitOpenAndAreTold_data();
  void valuesThatDoNotFitOpenAndAreTold();
  void whatIsTypedCountsWhenTheWindowIsClosed();
  void whatIsTypedIsSaved();
  void whatIsUndoneDuringASaveIsUnsaved();
  void whatIsEditedDuringASaveIsUnsaved();
  void whatIsEditedDuringAnImportStays();
  void whatIsEditedWhileAFileIsReadStays();
  void whatWasDrawnBesideADamagedFileStays();
  void closingWaitsForWhatIsWritten();
  void aWindowThatGoesUnaskedLeavesSafetyCopies();
  void aFileThatIsNewerThanTheSafetyCopyIsAskedFor();
  void aMistakeInAHandlerEndsNothing();

 private:
  QString saved(const char* name, const Document& document = rectangle(Value::object())) {
    const QString file = folder_.filePath(QLatin1String(name));
    saveDocument(document, file.toStdString());
    return file;
  }
  void openSaved(const char* name) { openAndWait(saved(name)); }
  QString drawing() {
    const QString file = folder_.filePath(QStringLiteral("drawing.svg"));
    QFile out(file);
    if (out.open(QIODevice::WriteOnly))
      out.write("<svg xmlns='http://www.w3.org/2000/svg'><rect width='40' height='20'/></svg>");
    return file;
  }
  void typeInto(const char* parameter, const char* typed) {
    auto* const line = window_->properties().field(QLatin1String(parameter))->findChild<QLineEdit*>();
    QVERIFY(line);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QLatin1String(typed));
  }
};

void UnsavedWorkTest::valuesThatDoNotFitOpenAndAreTold_data() {
  QTest::addColumn<QByteArray>("parameters");
  QTest::addColumn<QString>("shown");
  QTest::addColumn<bool>("wrong");
  QTest::newRow("out of range") << QByteArray(R"({"width": -3})") << QString() << true;
  QTest::newRow("a word for a length") << QByteArray(R"({"width": [1]})") << QString() << true;
  QTest::newRow("a length with its unit") << QByteArray(R"({"width": "5 mm"})") << QStringLiteral("5 mm") << false;
  QTest::newRow("a point of words") << QByteArray(R"({"centre": ["a", "b", "c"]})") << QString() << false;
  QTest::newRow("of a newer plugin") << QByteArray(R"({"newer-parameter": 3})") << QString() << false;
}

void UnsavedWorkTest::valuesThatDoNotFitOpenAndAreTold() {
  QFETCH(QByteArray, parameters);
  QFETCH(QString, shown);
  QFETCH(bool, wrong);
  const Document document = rectangle(Value::parse(parameters.toStdString()));
  window_->openFile(saved("wrong.blossom", document));
  QTRY_VERIFY(!window_->session().document().features().empty());
  waitUntilComputed();
  QTRY_VERIFY(window_->properties().field(QStringLiteral("width")));
  QCOMPARE(toJson(window_->session().document()), toJson(document));  // nothing is put right unasked
  ParameterField* const width = window_->properties().field(QStringLiteral("width"));
  QCOMPARE(!width->problem().isEmpty(), wrong);
  if (!shown.isEmpty()) QCOMPARE(width->findChild<QLineEdit*>()->text(), shown);
  edit("width", "12");  // it can be mended
  QCOMPARE(window_->session().document().at("r").parameters.at("width").get<double>(), 12.0);
  QTRY_VERIFY2(width->problem().isEmpty(), qPrintable(width->problem()));
}

void UnsavedWorkTest::whatIsTypedCountsWhenTheWindowIsClosed() {
  openSaved("typed.blossom");
  typeInto("width", "33");
  bool asked = false;
  answer(QMessageBox::Cancel, asked);
  QVERIFY(!window_->close());
  QVERIFY(asked);
  QCOMPARE(window_->session().document().at("r").parameters.at("width").get<double>(), 33.0);
}

void UnsavedWorkTest::whatIsTypedIsSaved() {
  openSaved("typed.blossom");
  QVERIFY(!window_->commands().action(QStringLiteral("file.save"))->isEnabled());
  typeInto("width", "34");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_S, Qt::ControlModifier);
  waitUntilComputed();
  QVERIFY(!window_->session().modified());
  const Document read = openDocument(folder_.filePath(QStringLiteral("typed.blossom")).toStdString()).document;
  QCOMPARE(read.at("r").parameters.at("width").get<double>(), 34.0);
}

void UnsavedWorkTest::whatIsUndoneDuringASaveIsUnsaved() {
  openSaved("undone.blossom");
  Session& session = window_->session();
  session.commit(withOneMore(session.document(), "c"), QStringLiteral("Add"));
  bool clean = false;
  session.save(session.file(), [&] { clean = true; });
  session.undo();
  waitUntilComputed();
  QVERIFY(!clean && session.modified());  // the file has the circle, the window has not
  QCOMPARE(openDocument(session.file()).document.features().size(), std::size_t(2));
  session.redo();
  QVERIFY(!session.modified());
}

void UnsavedWorkTest::whatIsEditedDuringASaveIsUnsaved() {
  openSaved("edited.blossom");
  Session& session = window_->session();
  session.save(session.file());
  session.commit(withOneMore(session.document(), "c"), QStringLiteral("Add"));
  waitUntilComputed();
  QVERIFY(session.modified());
  session.undo();
  QVERIFY(!session.modified());
}

void UnsavedWorkTest::whatIsEditedDuringAnImportStays() {
  openSaved("base.blossom");
  Session& session = window_->session();
  session.import({drawing().toStdString()});
  session.commit(withOneMore(session.document(), "import-1"), QStringLiteral("Add"));  // even under the name it would take
  waitUntilComputed();
  QCOMPARE(session.document().features().size(), std::size_t(3));
  QCOMPARE(session.document().at("import-1").name, std::string("Added"));
  const Feature& imported = *session.document().features().back();
  QCOMPARE(imported.name, std::string("drawing"));
  QVERIFY(session.view(imported.id) && !session.view(imported.id)->result->error);
}

void UnsavedWorkTest::whatIsEditedWhileAFileIsReadStays() {
  Session& session = window_->session();
  session.open(saved("slow.blossom").toStdString());
  session.commit(withOneMore(Document(), "c"), QStringLiteral("Add"));
  waitUntilComputed();
  QVERIFY(session.document().contains("c") && session.file().empty() && session.modified());
  QVERIFY2(window_->errors().message().contains(QStringLiteral("slow.blossom")), qPrintable(window_->errors().message()));
}

void UnsavedWorkTest::whatWasDrawnBesideADamagedFileStays() {
  const QString file = saved("cut.blossom");
  QFile whole(file);
  QVERIFY(whole.open(QIODevice::ReadWrite) && whole.resize(whole.size() - 30));
  whole.close();
  window_->openFile(file);
  QTRY_VERIFY(window_->errors().message().contains(QStringLiteral("cut.blossom")));
  window_->session().commit(withOneMore(Document(), "c"), QStringLiteral("Add"));
  auto* const offer = window_->errors().findChild<QPushButton*>();
  QVERIFY(offer && offer->isVisible());
  offer->click();
  QCOMPARE(window_->pageCount(), std::size_t(2));
  QTRY_VERIFY(!window_->page(1).session().job().running());
  QVERIFY(window_->page(0).document().contains("c"));
  QVERIFY(window_->page(1).document().contains("r"));
}

void UnsavedWorkTest::closingWaitsForWhatIsWritten() {
  openSaved("first.blossom");
  window_->session().save(folder_.filePath(QStringLiteral("no such folder/second.blossom")).toStdString());
  QVERIFY(!window_->close());  // not yet
  QTRY_VERIFY(window_->errors().isVisible());
  QCoreApplication::processEvents();
  QVERIFY(window_->isVisible());  // what went wrong is to be seen
  const QString other = folder_.filePath(QStringLiteral("second.blossom"));
  window_->session().save(other.toStdString());
  QVERIFY(!window_->close());
  QTRY_VERIFY(!window_->isVisible());
  QCOMPARE(openDocument(other.toStdString()).document.features().size(), std::size_t(1));
}

void UnsavedWorkTest::aWindowThatGoesUnaskedLeavesSafetyCopies() {
  Recovery::instance().start();
  openSaved("lost.blossom");
  window_->session().commit(withOneMore(window_->session().document(), "c"), QStringLiteral("Add circle"));
  window_.reset();
  Recovery::instance().stop();
  Recovery::instance().start();
  QTRY_COMPARE(Recovery::instance().lost().size(), std::size_t(1));
  QCOMPARE(Recovery::instance().lost().front().summary.lastStep, std::string("Add circle"));
  // Closed by the user, who does not want it, it leaves none.
  openWindow();
  Recovery::instance().discard(Recovery::instance().lost().front().folder);
  window_->session().commit(withOneMore(Document(), "c"), QStringLiteral("Add circle"));
  bool asked = false;
  answer(QMessageBox::Discard, asked);
  window_->close();
  QTRY_VERIFY(asked && !window_->isVisible());
  window_.reset();
  Recovery::instance().stop();
  QVERIFY(RecoveryArea(Recovery::standardFolder()).lost().empty());
}

void UnsavedWorkTest::aFileThatIsNewerThanTheSafetyCopyIsAskedFor() {
  const QString file = saved("both.blossom");
  {
    RecoveryArea killed(Recovery::standardFolder());
    Journal journal(killed.newFolder());
    journal.record(withOneMore(Document(), "c"), "Add", {file.toStdString(), "both.blossom"});
  }
  fs::last_write_time(file.toStdString(), fs::file_time_type::clock::now() + std::chrono::seconds(5));
  const auto lost = RecoveryArea(Recovery::standardFolder()).lost();
  QCOMPARE(lost.size(), std::size_t(1));
  window_->session().recover(lost.front());
  waitUntilComputed();
  QVERIFY(window_->session().document().contains("c"));
  QVERIFY(window_->session().changedOnDisk());
}

void UnsavedWorkTest::aMistakeInAHandlerEndsNothing() {
  std::vector<Error> told;
  connect(static_cast<GuardedApplication*>(qApp), &GuardedApplication::escaped, this,
          [&told](const Error& error) { told.push_back(error); });
  Mistaken mistaken;
  QCoreApplication::postEvent(&mistaken, new QEvent(QEvent::User));
  QCoreApplication::processEvents();
  disconnect(qApp, nullptr, this, nullptr);
  QCOMPARE(told.size(), std::size_t(1));
  QVERIFY2(qt(told.front().message()).contains(QStringLiteral("a number is a word")), told.front().message().c_str());
  QVERIFY(!told.front().hint().empty());
}

BLOSSOM_TEST_RUN(UnsavedWorkTest, (&blossom::test::runWindowTest<UnsavedWorkTest, GuardedApplication>))
#include "unsaved_work_test.moc"
