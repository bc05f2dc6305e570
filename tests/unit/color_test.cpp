#include "geometry/values/color.h"

#include "support/support.h"

using namespace blossom;

class ColorTest : public QObject {
  Q_OBJECT
 private slots:
  void everyByteComesBack() {
    for (int value = 0; value < 256; ++value) {
      const Color color{value / 255.0, (255 - value) / 255.0, (value * 7 % 256) / 255.0};
      const auto back = parseColor(toHex(color));
      QVERIFY(back.has_value());
      QVERIFY(*back == color);
    }
  }
  void shortFormRepeatsEachDigit() {
    for (const char* pair : {"#000", "#fff", "#a3F", "#18c"}) {
      const std::string text = pair;
      std::string full = "#";
      for (const char digit : text.substr(1)) full += {digit, digit};
      QVERIFY(parseColor(text).has_value());
      QVERIFY(parseColor(text) == parseColor(full));
    }
  }
  void namesOfTheWebAreKnown() {
    QCOMPARE(toHex(*parseColor("Red")), std::string("#ff0000"));
    QCOMPARE(toHex(*parseColor("navy")), std::string("#000080"));
    QCOMPARE(toHex(*parseColor("ORANGE")), std::string("#ffa500"));
    QVERIFY(parseColor("gray") == parseColor("grey"));
  }
  void otherTextIsNoColor() {
    for (const char* text :
         {"", "#", "#12", "#1234", "#12345", "#1234567", "#12345g", "#-12345", "# 12345", "reddish", "ff0000"})
      QVERIFY2(!parseColor(text).has_value(), text);
  }
  void channelsOutsideTheRangeAreClamped() { QCOMPARE(toHex({-1, 0.5, 7}), std::string("#0080ff")); }
};

BLOSSOM_TEST(ColorTest)
#include "color_test.moc"
