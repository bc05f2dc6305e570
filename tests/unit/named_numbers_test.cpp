// Numbers of a document that have names, and values that are kept as they were typed.
#include "document/named_numbers.h"

#include <fmt/format.h>

#include "core/expression.h"
#include "document/edits.h"
#include "document/evaluator.h"
#include "document/storage.h"
#include "parameter/written.h"
#include "support/modeling.h"

using namespace blossom;
using blossom::test::theApp;

class NamedNumbersTest : public QObject {
  Q_OBJECT
 private slots:
  void expressionsUseNames();
  void namesThatCannotBe();
  void wordsOfExpressions();
  void aNameIsWorthItsValue();
  void rowsInAnyOrder();
  void tablesThatCannotBe();
  void parametersFollowTheTable();
  void numbersInUseStay();
  void renamedEverywhere();
  void filesEditedByHand();
  void rubbishIsRefusedOrLeftAlone();
  void whatWasNotEditedStaysAsItWasWritten();

 private:
  static const Registry& registry() { return *theApp().registry; }
  static Document withBox(const Value& parameters, const std::vector<NamedNumber>& table) {
    Feature box;
    box.id = box.name = "box";
    box.type = "modeling.box";
    box.parameters = parameters;
    return withNumbersApplied(withNumbers(Document(), registry(), table).with(std::move(box)), registry());
  }
  static double volume(const Document& document) {
    const Results results = Evaluator(theApp().registry).evaluate(document, Progress::none());
    return results.at("box")->error ? -1 : test::figure(results.at("box")->evaluated.shape, "volume");
  }
};

void NamedNumbersTest::expressionsUseNames() {
  const NamedNumbers names{
      {"width", {60, 1, 0}}, {"n", {5, 0, 0}}, {"turn", {30, 0, 1}}, {"Höhe", {7, 1, 0}}, {"폭_2", {4, 1, 0}}};
  QCOMPARE(parseLength("width/2 + 3", {}, names), 33.0);
  QCOMPARE(parseLength("n", {}, names), 5.0);  // a plain number counts as mm
  QCOMPARE(parseLength("n", {"in", 25.4}, names), 127.0);
  QCOMPARE(parseLength("-width^2/width", {}, names), -60.0);
  QCOMPARE(parseLength("max(width, 폭_2)", {}, names), 60.0);
  QCOMPARE(parseLength("Höhe·2", {}, names), 14.0);
  QCOMPARE(parseAngle("2*turn", names), 60.0);
  QCOMPARE(parseNumber("width/폭_2", names), 15.0);
  VERIFY_ERROR(parseLength("turn", {}, names), ErrorCode::InvalidParameter);
  VERIFY_ERROR(parseLength("width*width", {}, names), ErrorCode::InvalidParameter);
  VERIFY_ERROR(parseLength("widht", {}, names), ErrorCode::InvalidParameter);
  VERIFY_ERROR(parseLength("2 width", {}, names), ErrorCode::InvalidParameter);
  VERIFY_ERROR(parseLength("width mm", {}, names), ErrorCode::InvalidParameter);
  VERIFY_ERROR(parseLength("width"), ErrorCode::InvalidParameter);
}

void NamedNumbersTest::namesThatCannotBe() {
  for (const char* good : {"a", "width", "_x", "w2", "Höhe", "폭", "宽度", "E"}) QVERIFY2(nameProblem(good).empty(), good);
  for (const char* bad :
       {"", "2w", "a b", "a-b", "mm", "in", "m", "deg", "sin", "max", "pi", "tau", "°", "π", "a.b", "a%", "µm"})
    QVERIFY2(!nameProblem(bad).empty(), bad);
}

void NamedNumbersTest::wordsOfExpressions() {
  QCOMPARE(wordsOf("2*width + sin(a1) - 1e3 mm/폭"), (std::vector<std::string>{"width", "sin", "a1", "mm", "폭"}));
  QCOMPARE(withWord("w + 2*w2 - w/(w)", "w", "breite"), std::string("breite + 2*w2 - breite/(breite)"));
  QCOMPARE(wordsOf("1e5e"), (std::vector<std::string>{"e"}));
}

// An expression with names is worth the same as with their values in parentheses, whatever it is.
void NamedNumbersTest::aNameIsWorthItsValue() {
  std::mt19937_64 random = test::seededRandom();
  const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  for (int round = 0; round < 500; ++round) {
    NamedNumbers names;
    std::vector<std::string> written;
    for (int k = 0; k < 3; ++k) {
      const double value = std::uniform_real_distribution<double>(0.5, 20)(random);
      names[fmt::format("v{}", k)] = {value, 1, 0};
      written.push_back(fmt::format("({} mm)", value));
    }
    std::string with = "v0", without = written[0];
    for (int k = below(6); k >= 0; --k) {
      const auto which = static_cast<std::size_t>(below(3));
      const char* const pattern[] = {"({}) + {}", "({}) - {}/3", "max({}, {})", "2*({}) - {}", "({})*{}/(1 mm)"};
      const int chosen = below(5);
      with = fmt::format(fmt::runtime(pattern[chosen]), with, fmt::format("v{}", which));
      without = fmt::format(fmt::runtime(pattern[chosen]), without, written[which]);
    }
    QCOMPARE(parseLength(with, {}, names), parseLength(without));
  }
}

void NamedNumbersTest::rowsInAnyOrder() {
  const NamedNumbers values =
      valuesOf({{"half", "width/2"}, {"area", "sqrt(width*width)"}, {"width", "60 mm"}, {"n", "3"}, {"t", "pi/4 rad"}});
  QCOMPARE(values.at("half").value, 30.0);
  QVERIFY(values.at("half").is(1, 0) && values.at("area").is(1, 0) && values.at("n").plain() && values.at("t").is(0, 1));
  COMPARE_NEAR(values.at("t").value, 45.0, 1e-12);
}

void NamedNumbersTest::tablesThatCannotBe() {
  VERIFY_ERROR(valuesOf({{"a", "b"}, {"b", "a + 1"}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(valuesOf({{"a", "a"}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(valuesOf({{"a", "1"}, {"a", "2"}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(valuesOf({{"mm", "1"}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(valuesOf({{"a", "1 mm * 1 mm"}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(valuesOf({{"a", ""}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(valuesOf({{"a", "nobody"}}), ErrorCode::InvalidParameter);
}

void NamedNumbersTest::parametersFollowTheTable() {
  const std::vector<NamedNumber> table{{"w", "20 mm"}, {"h", "w/2"}};
  Document document = withBox({{"width", "2*w"}, {"depth", "w"}, {"height", 5}, {"position", {"w", 0, "h + 1"}}}, table);
  COMPARE_NEAR(volume(document), 40.0 * 20 * 5, 1e-9);
  QVERIFY(isNamedExpression(document.at("box").parameters.at("width")));
  QCOMPARE(document.at("box").parameters.at("position").at(2).at("value").get<double>(), 11.0);
  document = withNumbers(document, registry(), {{"w", "10 mm"}, {"h", "w/2"}});
  COMPARE_NEAR(volume(document), 20.0 * 10 * 5, 1e-9);
  QCOMPARE(document.at("box").parameters.at("position").at(2).at("value").get<double>(), 6.0);
  QCOMPARE(document.at("box").parameters.at("width").at("expression").get<std::string>(), std::string("2*w"));
  QCOMPARE(numbersOf(document).front().value, std::string("10 mm"));
  // A width of a negative length is the feature's own error, and comes right with the next table.
  document = withNumbers(document, registry(), {{"w", "7 mm"}, {"h", "1"}});
  COMPARE_NEAR(volume(document), 14.0 * 7 * 5, 1e-9);
}

void NamedNumbersTest::numbersInUseStay() {
  const Document document = withBox({{"width", "2*w"}}, {{"w", "20 mm"}, {"idle", "3"}});
  VERIFY_ERROR(withNumbers(document, registry(), {{"idle", "3"}}), ErrorCode::InUse);
  VERIFY_ERROR(withNumbers(document, registry(), {{"w", "20 deg"}}), ErrorCode::InvalidParameter);
  QCOMPARE(numbersOf(withNumbers(document, registry(), {{"w", "20 mm"}})).size(), std::size_t(1));
}

void NamedNumbersTest::renamedEverywhere() {
  Document document = withBox({{"width", "2*w"}, {"depth", "h"}}, {{"w", "20 mm"}, {"h", "w/2"}});
  document = withNumberRenamed(document, registry(), "w", "Breite");
  QCOMPARE(document.at("box").parameters.at("width").at("expression").get<std::string>(), std::string("2*Breite"));
  QCOMPARE(numbersOf(document), (std::vector<NamedNumber>{{"Breite", "20 mm"}, {"h", "Breite/2"}}));
  VERIFY_ERROR(withNumberRenamed(document, registry(), "Breite", "h"), ErrorCode::InvalidParameter);
  VERIFY_ERROR(withNumberRenamed(document, registry(), "nobody", "x"), ErrorCode::NotFound);
  document = withNumbers(document, registry(), {{"Breite", "30 mm"}, {"h", "Breite/2"}});
  QCOMPARE(document.at("box").parameters.at("depth").at("value").get<double>(), 15.0);
}

// The table in the file was changed, or a name written in a parameter, by hand: opening computes the values.
void NamedNumbersTest::filesEditedByHand() {
  const QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "hand.blossom";
  Document document = withBox({{"width", "2*w"}}, {{"w", "20 mm"}});
  Value extra = document.extra();
  extra["numbers"][0]["value"] = "50 mm";
  Feature box = document.at("box");
  box.parameters["depth"] = "w - 10";
  document = document.withExtra(extra).with(box);
  saveDocument(document, file);
  const Document opened = openAny(theApp(), file, false).document;
  QCOMPARE(opened.at("box").parameters.at("width").at("value").get<double>(), 100.0);
  QCOMPARE(opened.at("box").parameters.at("depth").at("value").get<double>(), 40.0);
  saveDocument(opened, file);
  QCOMPARE(numbersOf(openAny(theApp(), file, false).document), numbersOf(opened));
}

void NamedNumbersTest::rubbishIsRefusedOrLeftAlone() {
  const ParameterSpec size = positiveLength();
  QCOMPARE(checked(size, {{"expression", "w"}, {"value", 3}}).get<double>(), 3.0);
  for (const Value& rubbish : {Value{{"expression", 1}, {"value", 2}}, Value{{"expression", "w"}}, Value{{"value", 2}},
                               Value{{"expression", "w"}, {"value", "2"}}, Value{{"expression", "w"}, {"value", -2}}})
    VERIFY_ERROR(checked(size, rubbish), ErrorCode::InvalidParameter);
  for (const Value& table :
       {Value(3), Value::array({1, "a", Value::object()}), Value{{"a", 1}}, Value::array({{{"name", 3}, {"value", "1"}}}),
        Value::array({{{"name", "mm"}, {"value", "1"}}})}) {
    const Document document = Document().withExtra({{"numbers", table}});
    QVERIFY(namedNumbersOf(document).empty());
    QCOMPARE(withNumbersApplied(document, registry()).extra(), document.extra());
  }
  const Document cycle = Document().withExtra(
      {{"numbers", {{{"name", "a"}, {"value", "b"}}, {{"name", "b"}, {"value", "a"}}, {{"name", "c"}, {"value", 4}}}}});
  QCOMPARE(namedNumbersOf(cycle).size(), std::size_t(1));
}

void NamedNumbersTest::whatWasNotEditedStaysAsItWasWritten() {
  const auto& specs = registry().at("modeling.box")->parameters;
  const Value pair{{"expression", "w"}, {"value", 20.0}};
  const Value written{{"width", "2*10 mm"}, {"depth", pair}, {"position", {"1 cm", 0, pair}}};
  Value after = completed(specs, written);
  QCOMPARE(keepWritten(specs, written, after), written);
  after["position"][1] = 7.0;
  after["width"] = 33.0;
  const Value kept = keepWritten(specs, written, after);
  QCOMPARE(kept, (Value{{"width", 33.0}, {"depth", pair}, {"position", {"1 cm", 7.0, pair}}}));
  QCOMPARE(completed(specs, kept), after);
}

BLOSSOM_TEST(NamedNumbersTest)
#include "named_numbers_test.moc"
