#include "support/support.h"
#include "ui/look/text.h"

using namespace blossom;
using namespace blossom::ui;

class ReadableTextTest : public QObject {
  Q_OBJECT
 private slots:
  void figuresReadWell();
  void longNumbersAreShownWithTheDigitsThatFit();
  void theStateOfAToolpathIsItsLength();
  void oneFrameIsNoFrames();
};

void ReadableTextTest::figuresReadWell() {
  QCOMPARE(counted(QStringLiteral("84"), QStringLiteral("vertex")), QStringLiteral("84 vertices"));
  QCOMPARE(counted(QStringLiteral("4"), QStringLiteral("assembly")), QStringLiteral("4 assemblies"));
  QCOMPARE(counted(QStringLiteral("1"), QStringLiteral("face")), QStringLiteral("1 face"));
  QCOMPARE(counted(QStringLiteral("29"), QStringLiteral("LINE")), QStringLiteral("29 LINE"));
  QCOMPARE(measureLabel("trajectory_degree_u"), QStringLiteral("Trajectory degree in u"));
  QCOMPARE(measureLabel("length_mm") + statUnit("length_mm"), QStringLiteral("Length mm"));
  QVERIFY(!worthReading("refinements", 0) && worthReading("refinements", 2) && !worthReading("skipped", Value::object()));
  QVERIFY(worthReading("kernel_ms", 2.5) && !worthReading("unite_ms", 2.5));  // a stage of the kernel
  QVERIFY(worthReading("min_normal_place", {1, 2, 3}) && !worthReading("min_normal_at", {0.5, 0.25}));
  const QString thin(QChar(0x2009));
  QCOMPARE(readable(1842.6), QStringLiteral("1") + thin + QStringLiteral("842.6"));
  QCOMPARE(readable(0.0), QStringLiteral("0"));
  QCOMPARE(readable(0.25), QStringLiteral("0.25"));
  QCOMPARE(readable(-1234567.0),
           QChar(0x2212) + QStringLiteral("1") + thin + QStringLiteral("234") + thin + QStringLiteral("567"));
  QCOMPARE(readable(std::int64_t(999)), QStringLiteral("999"));
  QCOMPARE(readable(3e-7), QStringLiteral("3.00e") + QChar(0x2212) + QStringLiteral("07"));
}

void ReadableTextTest::longNumbersAreShownWithTheDigitsThatFit() {
  const auto within = [](qsizetype room) { return [room](const QString& each) { return each.size() <= room; }; };
  QCOMPARE(fittingNumber(QStringLiteral("-31.534218"), within(20)), QStringLiteral("-31.534218"));
  QCOMPARE(fittingNumber(QStringLiteral("-31.534218"), within(5)), QStringLiteral("-31.5"));
  QCOMPARE(fittingNumber(QStringLiteral("-31.534218 mm"), within(8)), QStringLiteral("-31.5 mm"));
  QCOMPARE(fittingNumber(QStringLiteral("44.49871°"), within(5)), QStringLiteral("44.5°"));
  QCOMPARE(fittingNumber(QStringLiteral("-1.32198e-14"), within(9)), QStringLiteral("-1.32e-14"));
  QCOMPARE(fittingNumber(QStringLiteral("-1.32198e-14"), within(6)), QStringLiteral("-1e-14"));
  // No other number than what was meant.
  for (const char* whole : {"1/3 + 0.123456", "1 1/2 in", "wall * 2.00001", "5' 6\"", "-1.32198e-14"})
    QCOMPARE(fittingNumber(QLatin1String(whole), within(4)), QLatin1String(whole));

  QCOMPARE(withoutNoise(-1.32198e-14, 26.1), 0.0);
  QCOMPARE(withoutNoise(1e-9, 26.1), 1e-9);
  QCOMPARE(withoutNoise(-3e-15, 3e-15), -3e-15);
}

void ReadableTextTest::theStateOfAToolpathIsItsLength() {
  Toolpath path;
  path.moves = {{MoveKind::Rapid, {3, 4, 0}}};
  QCOMPARE(stateLine(measure(path)), QStringLiteral("toolpath, 5 mm"));
}

void ReadableTextTest::oneFrameIsNoFrames() {
  const auto stateOf = [](std::int64_t frames) {
    Measures measures;
    measures.kind = "sequence";
    measures.values = {{"frames", frames}};
    return stateLine(measures);
  };
  QCOMPARE(stateOf(1), QStringLiteral("sequence, 1 frame"));
  QCOMPARE(stateOf(11), QStringLiteral("sequence, 11 frames"));
}

BLOSSOM_TEST(ReadableTextTest)
#include "readable_text_test.moc"
