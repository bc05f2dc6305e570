#include <QCheckBox>
#include <QPushButton>
#include <QToolButton>

#include "documents_fixture.h"
#include "ui/files/document_tabs.h"
#include "ui/files/unsaved_dialog.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

void middleClick(DocumentTabs& tabs, int index) {
  const QPoint at = tabs.tabRect(index).center();
  QTest::mousePress(&tabs, Qt::MiddleButton, {}, at);
  QTest::mouseRelease(&tabs, Qt::MiddleButton, {}, at);
}

}  // namespace

class DocumentsTest : public DocumentsFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void tabsAreSwitchedAndClosed();
  void manyTabsStayReadable();
  void closingTheWindowAsksOnceForAll();
  void samplesAreSavedOnlyWhenAskedFor();
  void aFileChangedByOthersIsNotOverwrittenUnasked();
  void whatCannotBeSavedIsSaidWithAWayOut();

 private:
  DocumentTabs& tabs() { return *window_->findChild<DocumentTabs*>(); }
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

BLOSSOM_WINDOW_TEST(DocumentsTest)
#include "documents_test.moc"
