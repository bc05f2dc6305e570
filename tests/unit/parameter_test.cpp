#include "parameter/parameter.h"

#include <algorithm>
#include <limits>

#include "parameter/binding.h"
#include "support/support.h"

using namespace blossom;

namespace {

enum class ValueMode { Exact, Cubic };

ParameterSpec withName(std::string name, ParameterSpec spec) {
  spec.name = std::move(name);
  spec.help = "What it is for.";
  return spec;
}

std::string messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.message();
  }
  return "nothing was thrown";
}

std::string hintOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.hint();
  }
  return "nothing was thrown";
}

/// Random specs and canonical values that they allow.
class Generator {
 public:
  explicit Generator(std::mt19937_64 random) : random_(random) {}

  ParameterSpec spec(int depth = 0) {
    switch (below(depth < 2 ? 16 : 14)) {
      case 0:
        return withName("value", flag());
      case 1:
        return withName("value", count(-20, 1000));
      case 2:
        return withName("value", number());
      case 3:
        return withName("value", ratio());
      case 4:
        return withName("value", blossom::length());
      case 5:
        return withName("value", positiveLength());
      case 6:
        return withName("value", angle());
      case 7:
        return withName("value", choice({"exact", "cubic", "two words"}));
      case 8:
        return withName("value", blossom::text());
      case 9:
        return withName("value", color());
      case 10:
        return withName("value", point());
      case 11:
        return withName("value", blossom::vector());
      case 12:
        return withName("value", controlCurve());
      case 13:
        return withName("value", subShape("face"));
      case 14:
        return withName("value", list(spec(depth + 1)));
      default: {
        ParameterSpec second = spec(depth + 1);
        second.name = "other";
        return withName("value", record({spec(depth + 1), second}));
      }
    }
  }

  Value value(const ParameterSpec& spec) {
    using enum ParameterKind;
    switch (spec.kind) {
      case Flag:
        return below(2) == 1;
      case Count:
        return static_cast<std::int64_t>(below(1021)) - 20;
      case Ratio:
        return std::uniform_real_distribution(0.0, 1.0)(random_);
      case Number:
      case Angle:
        return real();
      case Length:
        return spec.aboveMinimum ? std::abs(real()) + 1e-300 : real();
      case Choice:
        return spec.choices[below(spec.choices.size())];
      case Text:
        return words();
      case Color:
        return hexColor();
      case Point:
      case Vector:
      case Displacement:
        return Value::array({real(), real(), real()});
      case File:
        return {{"path", "some folder/" + words() + ".json"}, {"asset", ""}};
      case Curve:
        return curve();
      case SubShape:
        return {{"input", below(2) ? "base" : ""}, {"kind", "face"}, {"index", static_cast<std::int64_t>(below(100))}};
      case List:
        return items(spec.fields[0]);
      case Record:
        return {{"value", value(spec.fields[0])}, {"other", value(spec.fields[1])}};
    }
    return {};
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  /// Over all magnitudes, with short and long ones.
  double real() {
    if (below(3) == 0) return static_cast<double>(below(100));
    const double mantissa = std::uniform_real_distribution(-1.0, 1.0)(random_);
    return mantissa * std::pow(10.0, static_cast<double>(below(40)) - 20);
  }

  std::string words() {
    static const std::vector<std::string> parts{"a",  "B", " ", ",", ";",  "[", "]", "\"",
                                                "\\", "{", ":", "ü", "\n", "#", "1"};
    std::string text;
    for (std::size_t n = below(6); n > 0; --n) text += parts[below(parts.size())];
    return text;
  }

  std::string hexColor() {
    std::string text = "#";
    for (int i = 0; i < 6; ++i) text += "0123456789abcdef"[below(16)];
    return text;
  }

  Value curve() {
    std::vector<double> ts(below(5));
    for (double& t : ts) t = real();
    std::sort(ts.begin(), ts.end());
    Value result = Value::array();
    for (const double t : ts) result.push_back({t, real()});
    return result;
  }

  Value items(const ParameterSpec& element) {
    Value result = Value::array();
    for (std::size_t n = below(4); n > 0; --n) result.push_back(value(element));
    return result;
  }

  std::mt19937_64 random_;
};

}  // namespace

class ParameterTest : public QObject {
  Q_OBJECT

 private slots:
  void messagesNameValueAndBound() {
    const auto t = withName("t", ratio());
    QCOMPARE(messageOf([&] { checked(t, 1.4); }), std::string("t must lie between 0 and 1; it is 1.4."));
    const auto tolerance = withName("tolerance", positiveLength());
    QCOMPARE(messageOf([&] { checked(tolerance, -2); }), std::string("tolerance must be above 0 mm; it is -2."));
    QCOMPARE(messageOf([&] { checked(tolerance, 0); }), std::string("tolerance must be above 0 mm; it is 0."));
    QCOMPARE(hintOf([&] { checked(tolerance, 0); }), std::string("What it is for."));
    QCOMPARE(messageOf([&] { checked(withName("area-preserving", flag()), 3); }),
             std::string("area preserving must be yes or no; it is 3."));
    QCOMPARE(messageOf([&] { checked(withName("spans", count(2)), 1.5); }),
             std::string("spans must be a whole number; it is 1.5."));
    QCOMPARE(messageOf([&] { checked(withName("spans", count(2)), 1); }), std::string("spans must be at least 2; it is 1."));
    const auto mode = withName("mode", choice({"exact", "cubic"}));
    QCOMPARE(messageOf([&] { checked(mode, "exakt"); }), std::string("mode must be exact or cubic; it is \"exakt\"."));
    QCOMPARE(hintOf([&] { checked(mode, "exakt"); }), std::string("Did you mean exact?"));
    const auto pins = withName("pins", list(record({withName("target", point()), withName("weight", ratio())})));
    const Value wrong = Value::parse(R"([{"target": [1,2,3], "weight": 1}, {"target": [0,0], "weight": 2}])");
    QCOMPARE(messageOf([&] { checked(pins, wrong); }),
             std::string("weight of item 2 of pins must lie between 0 and 1; it is 2."));
  }

  void whatIsNoNumberIsRefused() {
    const auto spec = withName("x", number());
    for (const Value& value :
         {Value(std::numeric_limits<double>::quiet_NaN()), Value(std::numeric_limits<double>::infinity()), Value(true),
          Value(), Value::array(), Value::object(), Value("abc"), Value("")})
      VERIFY_ERROR(checked(spec, value), ErrorCode::InvalidParameter);
    VERIFY_ERROR(checked(withName("n", count(0)), 1e300), ErrorCode::InvalidParameter);
    VERIFY_ERROR(checked(withName("n", count(0)), std::uint64_t{1} << 40), ErrorCode::InvalidParameter);
  }

  void valuesBecomeCanonical() {
    QCOMPARE(checked(withName("x", number()), 3).is_number_float(), true);
    QCOMPARE(checked(withName("n", count()), 3.0).is_number_integer(), true);
    COMPARE_NEAR(checked(withName("d", blossom::length()), "1/2 in").get<double>(), 12.7, 0);
    COMPARE_NEAR(checked(withName("a", angle()), "0.25turn").get<double>(), 90, 1e-13);
    QCOMPARE(checked(withName("c", color()), "#F80").get<std::string>(), std::string("#ff8800"));
    QCOMPARE(checked(withName("p", point()), Value::array({1, "1cm"})), Value::array({1.0, 10.0, 0.0}));
    QCOMPARE(checked(withName("p", pointInSpace()), Value::array({1, "1cm", 2})), Value::array({1.0, 10.0, 2.0}));
    VERIFY_ERROR(checked(withName("p", pointInSpace()), Value::array({1, 2})), ErrorCode::InvalidParameter);
    VERIFY_ERROR(parseText(withName("l", list(pointInSpace())), "1,2,3; 4,5"), ErrorCode::InvalidParameter);
    QCOMPARE(describe(withName("p", pointInSpace())), describe(withName("p", point())));
    QCOMPARE(checked(withName("f", file("json")), "a.json"), (Value{{"path", "a.json"}, {"asset", ""}}));
    QCOMPARE(parseText(withName("e", subShape("edge")), "base:edge:4"),
             (Value{{"input", "base"}, {"kind", "edge"}, {"index", 4}}));
    QCOMPARE(parseText(withName("l", list(point())), "1,2,3; 4,5"), Value::parse("[[1.0,2.0,3.0],[4.0,5.0,0.0]]"));
    QCOMPARE(parseText(withName("l", list(blossom::length())), "1, 1cm ,2"), Value::array({1.0, 10.0, 2.0}));
    QCOMPARE(parseText(withName("k", controlCurve()), "0:1, 0.5:2"), Value::parse("[[0.0,1.0],[0.5,2.0]]"));
    for (const auto yes : {"yes", "true", "on", "1", " yes "}) QCOMPARE(parseText(withName("f", flag()), yes), Value(true));
    VERIFY_ERROR(parseText(withName("k", controlCurve()), "1:1, 0.5:2"), ErrorCode::InvalidParameter);
    VERIFY_ERROR(parseText(withName("r", record({withName("a", flag())})), "{\"a\": tru"), ErrorCode::InvalidParameter);
    VERIFY_ERROR(parseText(withName("e", subShape("edge")), "base:face:4"), ErrorCode::InvalidParameter);
    VERIFY_ERROR(parseText(withName("e", subShape("edge")), "base:edge:-4"), ErrorCode::InvalidParameter);
  }

  void textAndValueAreInverse() {
    Generator generate(test::seededRandom());
    for (int i = 0; i < 5000; ++i) {
      const ParameterSpec spec = generate.spec();
      const Value value = generate.value(spec);
      const std::string text = formatText(spec, value);
      const Value back = parseText(spec, text);
      QVERIFY2(back == value, (describe(spec) + "\n" + value.dump() + "\n" + text + "\n" + back.dump()).c_str());
      QVERIFY2(checked(spec, value).dump() == value.dump(), "a canonical value is left as it is");
      QVERIFY2(completed({spec}, {{spec.name, value}}).at(spec.name) == value, "completed keeps what is given");
    }
  }

  void anyTextIsUnderstoodOrRefused() {
    Generator generate(test::seededRandom());
    for (int i = 0; i < 5000; ++i) {
      const ParameterSpec spec = generate.spec();
      const ParameterSpec other = generate.spec();
      const std::string text = formatText(other, generate.value(other));
      try {
        const Value value = parseText(spec, text);
        QCOMPARE(parseText(spec, formatText(spec, value)), value);
      } catch (const Error& e) {
        QCOMPARE(e.code(), ErrorCode::InvalidParameter);
        QVERIFY(!e.message().empty() && e.message().back() == '.');
      }
    }
  }

  void absentParametersGetTheirDefaults() {
    auto t = withName("t", ratio());
    t.fallback = 0.5;
    const auto motion = withName("motion", file("json"));
    QCOMPARE(completed({t}, Value::object()), (Value{{"t", 0.5}}));
    QCOMPARE(completed({t}, {{"t", nullptr}}), (Value{{"t", 0.5}}));
    QCOMPARE(messageOf([&] { completed({t, motion}, Value::object()); }), std::string("motion must be given."));
    QCOMPARE(completed({t, optional(motion)}, Value::object()), (Value{{"t", 0.5}, {"motion", nullptr}}));
    QCOMPARE(messageOf([&] {
               completed({withName("tolerance", blossom::length())}, {{"tolerence", 1}});
             }),
             std::string("\"tolerence\" is not a parameter."));
    QCOMPARE(hintOf([&] {
               completed({withName("tolerance", blossom::length())}, {{"tolerence", 1}});
             }),
             std::string("Did you mean tolerance?"));
    // in the order of the declaration, whatever the order given: document, undo and cache see one form
    QCOMPARE(completed({t, motion}, {{"motion", "m.json"}, {"t", 1}}).begin().key(), std::string("t"));
  }

  void bindingIsInverse() {
    const auto mode = withName("mode", choice({"exact", "cubic"}));
    ValueMode out = ValueMode::Exact;
    fromValue(mode, toValue(mode, ValueMode::Cubic), out);
    QVERIFY(out == ValueMode::Cubic);
    Vec3 p(0, 0, 0);
    fromValue(withName("p", point()), toValue(withName("p", point()), Vec3(1, 2.5, -3)), p);
    QVERIFY(p == Vec3(1, 2.5, -3));
    FileValue f;
    fromValue(withName("f", file("")), toValue(withName("f", file("")), FileValue{"a/b.json", "ab12"}), f);
    QVERIFY((f == FileValue{"a/b.json", "ab12"}));
    QVERIFY(toValue(withName("f", file("")), FileValue{}).is_null());
  }

  void descriptions() {
    QCOMPARE(describe(withName("d", positiveLength())), std::string("length in mm, above 0 mm"));
    QCOMPARE(describe(withName("t", ratio())), std::string("number, from 0 to 1"));
    QCOMPARE(describe(withName("m", choice({"a", "b", "c"}))), std::string("a, b or c"));
    QCOMPARE(describe(whenNone(list(subShape("edge")), "all sharp edges")),
             std::string("list; each item: edge as input:edge:number; none: all sharp edges"));
    QCOMPARE(label(withName("area-preserving", flag())), std::string("area preserving"));
  }

  void conditions() {
    const ParameterSpec always = withName("size", positiveLength()),
                        some = withName("turns", onlyFor(positiveLength(), "kind-of-it", {"ring", "tube"}));
    QCOMPARE(describeCondition(always), std::string());
    QCOMPARE(describeCondition(some), std::string("only if kind of it is ring or tube"));
    QCOMPARE(describe(some), std::string("length in mm, above 0 mm; only if kind of it is ring or tube"));
    QCOMPARE(describeCondition(onlyWithout(always, "the-other")), std::string("only without the other"));
    QCOMPARE(describeCondition(onlyWith(some, "other")), std::string("only if kind of it is ring or tube, with other"));
    ParameterSpec kind = withName("kind-of-it", choice({"ball", "ring", "tube"}));
    kind.fallback = "ball";
    std::vector<ParameterSpec> specs{kind, always, some};
    for (const char* value : {"ball", "ring", "tube"}) {
      const Value given{{"kind-of-it", value}, {"size", 3.0}};
      QVERIFY(applies(kind, specs, given) && applies(always, specs, given));
      QCOMPARE(applies(some, specs, given), value != std::string("ball"));
    }
    // What is absent or no value of the choice counts as the default.
    for (const char* fallback : {"ball", "tube"}) {
      specs[0].fallback = fallback;
      const bool wanted = fallback != std::string("ball");
      for (const Value& given : {Value::object(), Value(), Value{{"kind-of-it", nullptr}}, Value{{"kind-of-it", 3}},
                                 Value{{"kind-of-it", "cube"}}})
        QVERIFY2(applies(some, specs, given) == wanted, given.dump().c_str());
    }
    // A value is accepted and completed as without a condition, also where it does not apply.
    const Value all = completed(specs, {{"kind-of-it", "ball"}, {"size", 1}, {"turns", "2 cm"}});
    QCOMPARE(all, (Value{{"kind-of-it", "ball"}, {"size", 1.0}, {"turns", 20.0}}));
    QVERIFY(messageOf([&] {
              (void)completed(specs, {{"kind-of-it", "ball"}, {"size", 1}, {"turns", -1}});
            }).starts_with("turns must be above 0 mm"));
  }

  void nearestNames() {
    const std::vector<std::string> known{"sweep", "morph", "minkowski-sum", "area-preserving", "t"};
    QCOMPARE(nearestName("swepe", known), std::string("sweep"));
    QCOMPARE(nearestName("Morph", known), std::string("morph"));
    QCOMPARE(nearestName("mink", known), std::string("minkowski-sum"));
    QCOMPARE(nearestName("area-perserving", known), std::string("area-preserving"));
    QCOMPARE(nearestName("x", known), std::string());
    QCOMPARE(nearestName("", known), std::string());
    QCOMPARE(nearestName(std::string(100000, 'a'), known), std::string());
  }

  void hostileJsonIsRefused() {
    VERIFY_ERROR(parseJson(std::string(100000, '[')), ErrorCode::LimitExceeded);
    VERIFY_ERROR(parseJson(""), ErrorCode::FormatDamaged);
    VERIFY_ERROR(parseJson("{\"a\": 1"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(parseJson("\xff\xfe"), ErrorCode::FormatDamaged);
    std::string wide = "{";
    for (int i = 0; i < 10000; ++i) wide += "\"k" + std::to_string(i) + "\":0,";
    VERIFY_ERROR(parseJson(wide + "\"z\":0}"), ErrorCode::LimitExceeded);
  }
};

BLOSSOM_TEST(ParameterTest)
#include "parameter_test.moc"
