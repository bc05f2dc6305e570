#include <QRegularExpression>

#include "support/support.h"
#include "support/translations.h"

using namespace blossom::test;

namespace {

QStringList placeholders(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("%\\d|%n"));
  QStringList found;
  for (auto it = pattern.globalMatch(text); it.hasNext();) found << it.next().captured();
  found.sort();
  return found;
}

qsizetype mnemonics(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("&\\w"), QRegularExpression::UseUnicodePropertiesOption);
  return text.count(pattern);
}

}  // namespace

class TranslationTest : public QObject {
  Q_OBJECT
 private slots:
  void everyMessageIsFinished_data() { languages(); }
  void everyMessageIsFinished();
  void placeholdersAgree_data() { languages(); }
  void placeholdersAgree();
  void keysStayReadable_data() { languages(); }
  void keysStayReadable();
  void languagesHaveTheSameMessages();

 private:
  static void languages();
  static QString file(const QString& code) { return blossom::test::translationFile(QStringLiteral("blossom_") + code); }
};

void TranslationTest::languages() {
  QTest::addColumn<QString>("code");
  QTest::newRow("German") << QStringLiteral("de");
  QTest::newRow("Korean") << QStringLiteral("ko");
}

void TranslationTest::everyMessageIsFinished() {
  QFETCH(QString, code);
  const auto messages = messagesOf(file(code));
  QVERIFY(messages.size() > 500);
  for (const TranslatedMessage& each : messages)
    QVERIFY2(each.finished && !each.translation.isEmpty(), qPrintable(each.context + QStringLiteral(": ") + each.source));
}

void TranslationTest::placeholdersAgree() {
  QFETCH(QString, code);
  for (const TranslatedMessage& each : messagesOf(file(code))) {
    QVERIFY2(placeholders(each.source) == placeholders(each.translation), qPrintable(each.translation));
    QVERIFY2(mnemonics(each.source) == mnemonics(each.translation), qPrintable(each.translation));
    QVERIFY2(each.source.startsWith(u' ') == each.translation.startsWith(u' '), qPrintable(each.translation));
    QVERIFY2(each.source.endsWith(u' ') == each.translation.endsWith(u' '), qPrintable(each.translation));
  }
}

// Texts that name keys for Qt to read are not for people: a translated one would be no key at all.
void TranslationTest::keysStayReadable() {
  QFETCH(QString, code);
  static const QRegularExpression keys(QStringLiteral("^(?:(?:Ctrl|Alt|Shift)\\+)+\\S+$|^F\\d+$|^[A-Z0-9]$"));
  int found = 0;
  for (const TranslatedMessage& each : messagesOf(file(code)))
    if (keys.match(each.source).hasMatch()) {
      QCOMPARE(each.translation, each.source);
      ++found;
    }
  QVERIFY(found > 10);
}

void TranslationTest::languagesHaveTheSameMessages() {
  const auto german = messagesOf(file(QStringLiteral("de"))), korean = messagesOf(file(QStringLiteral("ko")));
  QCOMPARE(german.size(), korean.size());
  for (std::size_t i = 0; i < german.size(); ++i) QCOMPARE(german[i].source, korean[i].source);
}

BLOSSOM_TEST(TranslationTest)
#include "translation_test.moc"
