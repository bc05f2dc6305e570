#include "core/expression.h"

#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "core/units.h"
#include "support/support.h"

using namespace blossom;

namespace {

/// A random expression as text, with its value found on the way by plain arithmetic; nothing of the parser is used.
struct Written {
  std::string text;
  double value = 0;
  int lengths = 0;  ///< power of mm
};

class Writer {
 public:
  explicit Writer(std::mt19937_64 random) : random_(random) {}

  /// A length or a plain number, with operators of every precedence.
  Written sum(int depth, int lengths) {
    Written all = product(depth, lengths);
    for (std::size_t n = below(3); n > 0; --n) {
      const Written next = product(depth, lengths);
      const bool minus = below(2) == 0;
      all.text += blank() + (minus ? "-" : "+") + blank() + next.text;
      all.value = minus ? all.value - next.value : all.value + next.value;
    }
    return all;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  std::string blank() { return below(2) ? " " : ""; }

  Written product(int depth, int lengths) {
    Written all = factor(depth, lengths);
    for (std::size_t n = below(3); n > 0; --n) {
      Written next = factor(depth, 0);
      if (below(2) == 0) {
        all.text += blank() + "*" + blank() + next.text;
        all.value *= next.value;
      } else if (next.value != 0) {
        all.text += blank() + "/" + blank() + next.text;
        all.value /= next.value;
      }
    }
    return all;
  }

  Written factor(int depth, int lengths) {
    if (depth > 0 && below(3) == 0) {
      const Written inner = sum(depth - 1, lengths);
      return {"(" + blank() + inner.text + blank() + ")", inner.value, lengths};
    }
    if (depth > 0 && below(4) == 0) return call(depth, lengths);
    if (lengths == 0 && below(5) == 0) return raised();
    const double number = std::round(std::uniform_real_distribution(0.0, 1000.0)(random_) * 100) / 100;
    if (lengths == 0) return {formatNumber(number), number, 0};
    static const std::vector<std::pair<std::string, double>> units{
        {"mm", 1}, {"cm", 10}, {"in", 25.4}, {"m", 1000}, {"ft", 304.8}};
    const auto& [unit, factor] = units[below(units.size())];
    return {formatNumber(number) + blank() + unit, number * factor, 1};
  }

  Written raised() {
    const auto base = static_cast<double>(1 + below(9)), exponent = static_cast<double>(below(4));
    const bool minus = below(3) == 0;  // -2^2 is -4
    const double value = std::pow(base, exponent);
    return {fmt::format("({}{}^{})", minus ? "-" : "", base, exponent), minus ? -value : value, 0};
  }

  Written call(int depth, int lengths) {
    const Written a = sum(depth - 1, lengths), b = sum(depth - 1, lengths);
    switch (below(lengths == 0 ? 5 : 4)) {
      case 0:
        return {"abs(" + a.text + ")", std::abs(a.value), lengths};
      case 1:
        return {"min(" + a.text + "," + blank() + b.text + ")", std::min(a.value, b.value), lengths};
      case 2:
        return {"max(" + a.text + ";" + b.text + ")", std::max(a.value, b.value), lengths};
      case 3:
        return {"hypot(" + a.text + ", " + b.text + ")", std::hypot(a.value, b.value), lengths};
      default:
        return {"sqrt(abs(" + a.text + "))", std::sqrt(std::abs(a.value)), 0};
    }
  }

  std::mt19937_64 random_;
};

std::string messageFor(std::string_view text, Quantity wanted) {
  try {
    evaluateExpression(text, wanted);
  } catch (const Error& error) {
    return error.message();
  }
  return "nothing was thrown";
}

}  // namespace

class ExpressionTest : public QObject {
  Q_OBJECT
 private slots:
  void knownLengths() {
    const std::vector<std::pair<const char*, double>> cases{{"1/2 in + 3*(2 cm)", 72.7},
                                                            {"sqrt(2)*10", 10 * std::numbers::sqrt2},
                                                            {"2*3", 6},
                                                            {"2+3*4", 14},
                                                            {"(2+3)*4", 20},
                                                            {"-2^2", -4},
                                                            {"2^3^2", 512},
                                                            {"2^-1", 0.5},
                                                            {"10 mm/2", 5},
                                                            {"10 cm / 2 mm", 50},
                                                            {"1/4 in * 2", 12.7},
                                                            {"5' 6\"", 1676.4},
                                                            {"5' 6 1/2\"", 1689.1},
                                                            {"5 ft 6 in - 2", 1674.4},
                                                            {"-5' 6\"", -1676.4},
                                                            {"sqrt(3 cm * 12 mm)", std::sqrt(360.0)},
                                                            {"sqrt((3 cm)^2 + (40 mm)^2)", 50},
                                                            {"hypot(3 cm, 40)", 50},
                                                            {"2 cm + 3", 23},
                                                            {"3 − 1", 2},
                                                            {"3 × 2 · 2", 12},
                                                            {"max(1 cm, 2, 0.5 in)", 12.7},
                                                            {"10*sin(30°)", 5},
                                                            {"10 mm*cos(pi/3 rad)", 5},
                                                            {"mod(-1 mm, 3 mm)", 2},
                                                            {"round(2.6)", 3},
                                                            {"2π", 0},
                                                            {"µm", 0}};
    for (const auto& [text, wanted] : cases) {
      if (wanted == 0) {
        VERIFY_ERROR(parseLength(text), ErrorCode::InvalidParameter);
        continue;
      }
      COMPARE_NEAR(parseLength(text), wanted, 1e-12 * std::abs(wanted));
    }
  }

  // With another unit preferred a number that says none counts in it, and nothing else changes.
  void numbersCountInTheUnitGiven() {
    const LengthUnit inch{"in", 25.4}, foot{"ft", 304.8};
    const std::vector<std::pair<const char*, double>> inches{{"1/2", 12.7},          {"1 1/2", 38.1},
                                                             {"10 mm + 1", 35.4},    {"1 - 10 mm", 15.4},
                                                             {"2 cm", 20},           {"-3", -76.2},
                                                             {"2*3", 152.4},         {"2*(3 mm)", 6},
                                                             {"sqrt(4)", 50.8},      {"5' 6\"", 1676.4},
                                                             {"max(1 cm, 2)", 50.8}, {"min(3, 1 cm)", 10},
                                                             {"hypot(3, 4)", 127},   {"hypot(76.2 mm, 4)", 127},
                                                             {"mod(30 mm, 1)", 4.6}};
    for (const auto& [text, wanted] : inches) COMPARE_NEAR(parseLength(text, inch), wanted, 1e-12 * std::abs(wanted));
    COMPARE_NEAR(parseLength("2", foot), 609.6, 1e-12);
    VERIFY_ERROR(parseLength("1e308", inch), ErrorCode::InvalidParameter);
    VERIFY_ERROR(parseLength("3 deg", inch), ErrorCode::InvalidParameter);
    try {
      parseLength("3 apples", inch);
      QFAIL("apples are no unit");
    } catch (const Error& error) {
      QVERIFY2(error.hint().find("without a unit it is in") != std::string::npos, error.hint().c_str());
    }
  }

  void lengthsReadBackInEveryUnit() {
    auto random = test::seededRandom();
    for (const char* name : {"mm", "cm", "m", "in", "ft"}) {
      const LengthUnit unit{name, millimetresPer(name)};
      for (int i = 0; i < 5000; ++i) {
        const double size = std::pow(10, std::uniform_real_distribution(-6.0, 9.0)(random));
        const double length = i % 2 ? size : -size;
        const std::string text = formatLength(length, unit);
        QVERIFY2(text.ends_with(std::string(" ") + name), text.c_str());
        const double bare = parseLength(std::string_view(text).substr(0, text.find(' ')), unit);
        COMPARE_NEAR(parseLength(text, unit), length, 1e-12 * size);
        COMPARE_NEAR(parseLength(text), length, 1e-12 * size);
        COMPARE_NEAR(bare, length, 1e-12 * size);
      }
      // What was typed with few digits is written with few.
      for (int tenth = 1; tenth <= 1000; ++tenth) {
        const std::string typed = formatNumber(tenth / 10.0);
        QCOMPARE(formatLength(parseLength(typed, unit), unit), typed + ' ' + name);
      }
    }
    QCOMPARE(formatLength(25.4, {"in", 25.4}), std::string("1 in"));
    QCOMPARE(formatLength(12.5), std::string("12.5 mm"));
  }

  void knownAngles() {
    COMPARE_NEAR(parseAngle("pi/4 rad"), 45, 1e-13);
    COMPARE_NEAR(parseAngle("45 deg"), 45, 0);
    COMPARE_NEAR(parseAngle("1/8 turn + 5"), 50, 1e-13);
    COMPARE_NEAR(parseAngle("360/7"), 360.0 / 7, 1e-13);
    COMPARE_NEAR(parseAngle("asin(0.5)"), 30, 1e-13);
    COMPARE_NEAR(parseAngle("atan2(1 cm, 10 mm)"), 45, 1e-13);
    COMPARE_NEAR(parseAngle("100gon"), 90, 1e-13);
    COMPARE_NEAR(parseNumber("cos(90)"), 0, 0);
    COMPARE_NEAR(parseNumber("sin(180)"), 0, 0);
    COMPARE_NEAR(parseNumber("cos(180) + cos(360)"), 0, 0);
    COMPARE_NEAR(parseNumber("tan(45)"), 1, 1e-15);
    COMPARE_NEAR(parseNumber("1 in / 1 mm"), 25.4, 1e-13);
    COMPARE_NEAR(parseNumber("tau/pi"), 2, 0);
    COMPARE_NEAR(parseNumber("exp(ln(5))"), 5, 1e-14);
    COMPARE_NEAR(parseNumber("log(1000)"), 3, 1e-14);
  }

  void errorsNameThePlace() {
    const std::vector<std::pair<const char*, const char*>> cases{
        {"3 apples", "\"3 apples\" is not a length: \"apples\" is not a unit (character 3)."},
        {"2*(3+4", "\"2*(3+4\" is not a length: this parenthesis is not closed (character 3)."},
        {"2 + ", "\"2 +\" is not a length: something is missing at the end (character 4)."},
        {"2 ++ 3 )", "\"2 ++ 3 )\" is not a length: \")\" is not expected here (character 8)."},
        {"1,5", "\"1,5\" is not a length: the decimal sign is a point, not a comma (character 2)."},
        {"4/(2-2)", "\"4/(2-2)\" is not a length: it divides by zero (character 2)."},
        {"3 cm * 2 cm", "\"3 cm * 2 cm\" is not a length: it comes to an area (character 1)."},
        {"3 deg", "\"3 deg\" is not a length: it comes to an angle (character 1)."},
        {"3 mm + 3 deg", "\"3 mm + 3 deg\" is not a length: these cannot be added (character 6)."},
        {"größe", "\"größe\" is not a length: \"größe\" is not known (character 1)."},
        {"2 + ü", "\"2 + ü\" is not a length: \"ü\" is not known (character 5)."},
        {"sqrt 2", "\"sqrt 2\" is not a length: sqrt needs its value in parentheses (character 6)."},
        {"sqrt(-1)", "\"sqrt(-1)\" is not a length: this has no value (character 1)."},
        {"10^400", "\"10^400\" is not a length: this is too large (character 1)."},
        {"1e305'9e306\"", "\"1e305'9e306\"\" is not a length: this is too large (character 7)."},
        {"1e300*1e300", "\"1e300*1e300\" is not a length: this is too large (character 6)."},
        {"hypot(1)", "\"hypot(1)\" is not a length: hypot takes 2 values (character 1)."},
        {"", "\"\" is not a length: nothing is written (character 1)."},
        {"in", "\"in\" is not a length: before \"in\" there is no number (character 1)."}};
    for (const auto& [text, message] : cases) QCOMPARE(messageFor(text, Quantity::Length), std::string(message));
    QCOMPARE(messageFor("2 mm", Quantity::Number),
             std::string("\"2 mm\" is not a number: it comes to a length (character 1)."));
  }

  void randomTreesHaveTheirValue() {
    auto random = test::seededRandom();
    Writer write(random);
    for (int i = 0; i < 20000; ++i) {
      const int lengths = i % 2;
      const Written tree = write.sum(4, lengths);
      const auto wanted = lengths == 0 ? Quantity::Number : Quantity::Length;
      if (!std::isfinite(tree.value) || std::abs(tree.value) > 1e100) continue;
      try {
        const double value = evaluateExpression(tree.text, wanted);
        const double tolerance = 1e-9 * std::max(1.0, std::abs(tree.value));
        QVERIFY2(std::abs(value - tree.value) <= tolerance,
                 fmt::format("{} = {}, expected {}", tree.text, value, tree.value).c_str());
      } catch (const Error& error) {
        QFAIL((tree.text + ": " + error.message()).c_str());
      }
    }
  }

  // Whatever is typed is a finite number or a clear refusal; nothing overflows the stack.
  void anyTextIsUnderstoodOrRefused() {
    auto random = test::seededRandom();
    const std::vector<std::string> parts{"1",   "2.5",  "(",   ")",  "+",     "-",  "*",      "/", "^",    " ",
                                         "mm",  "in",   "'",   "\"", "deg",   "pi", "sqrt",   ",", "e9",   "°",
                                         "rad", "min(", "1/2", "0",  "1e308", ".",  "hypot(", "ü", "\xff", "tan("};
    for (int i = 0; i < 20000; ++i) {
      std::string text;
      for (std::size_t n = random() % 12; n > 0; --n) text += parts[random() % parts.size()];
      for (const auto wanted : {Quantity::Number, Quantity::Length, Quantity::Angle}) {
        try {
          QVERIFY(std::isfinite(evaluateExpression(text, wanted)));
        } catch (const Error& error) {
          QCOMPARE(error.code(), ErrorCode::InvalidParameter);
          QVERIFY(error.message().find("(character ") != std::string::npos && !error.hint().empty());
        }
      }
    }
    for (const char* piece : {"(", "-", "sqrt(", "2^", "1+"}) {
      std::string deep;
      for (int i = 0; i < 100000; ++i) deep += piece;
      VERIFY_ERROR(evaluateExpression(deep, Quantity::Number), ErrorCode::InvalidParameter);
    }
  }
};

BLOSSOM_TEST(ExpressionTest)
#include "expression_test.moc"
