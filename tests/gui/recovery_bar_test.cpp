#include <QLabel>
#include <QPushButton>

#include "document/journal_files.h"
#include "documents_fixture.h"
#include "ui/files/recovery_bar.h"
#include "ui/look/text.h"
#include "ui/session/recovery.h"

using namespace blossom;
using namespace blossom::ui;

class RecoveryBarTest : public DocumentsFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() {
    window_.reset();
    Recovery::instance().stop();
  }

  void whatACrashLeftIsOffered();
  void discardedItIsGone();

 private:
  void crashWith(const std::string& name, const QString& file);
};

/// As if an earlier run had been killed with these unsaved.
void RecoveryBarTest::crashWith(const std::string& name, const QString& file) {
  RecoveryArea killed(Recovery::standardFolder());
  Journal journal(killed.newFolder());
  journal.record(part(name), "Change name", {file.toStdString(), QFileInfo(file).fileName().toStdString()});
}

void RecoveryBarTest::whatACrashLeftIsOffered() {
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

void RecoveryBarTest::discardedItIsGone() {
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

BLOSSOM_WINDOW_TEST(RecoveryBarTest)
#include "recovery_bar_test.moc"
