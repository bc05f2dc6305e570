#include <nlohmann/json.hpp>
#include <sstream>

#include "app/app.h"
#include "app/import_feature.h"
#include "app/literal_feature.h"
#include "cli/cli.h"
#include "core/file.h"
#include "exchange/formats.h"
#include "support/support.h"

using namespace blossom;
using Json = nlohmann::ordered_json;

namespace {

enum class CommandMode { Exact, Cubic };

/// One parameter of every kind that a user types; the feature hands back what it got.
struct EchoParameters {
  bool solid = false;
  bool edges = true;
  int turns = 1;
  double t = 0.5;
  double tolerance = 0.01;
  double angle = 0;
  CommandMode mode = CommandMode::Exact;
  std::string text = "none";
  Vec3 axis{0, 0, 1};
  std::vector<double> levels{1, 2};
};

Mesh tetrahedronOf(double size) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
  for (const std::array<int, 3> face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) mesh.addFace(face);
  return mesh;
}

FeatureType echoFeature(const std::string& id, const std::string& command, std::size_t minimum, std::size_t most) {
  using P = EchoParameters;
  return feature<P>(id, "Echo", "Hands back what it was given.")
      .command(command)
      .example("blossom echo tetrahedron:2 --solid")
      .input({"shape", "Any shape.", {}, minimum, most})
      .parameter("solid", &P::solid, flag(), "A flag.")
      .parameter("edges", &P::edges, onlyFor(flag(), "mode", {"cubic"}), "A flag that is on.")
      .parameter("turns", &P::turns, count(1, 9), "A count.")
      .parameter("t", &P::t, ratio(), "A ratio.")
      .parameter("tolerance", &P::tolerance, onlyFor(positiveLength(), "mode", {"cubic"}), "A length.")
      .parameter("angle", &P::angle, angle(), "An angle.")
      .parameter("mode", &P::mode, choice({"exact", "cubic"}), "A choice.")
      .parameter("text", &P::text, text(), "A text.")
      .parameter("axis", &P::axis, vector(), "A vector.")
      .parameter("levels", &P::levels, list(number()), "A list.")
      .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) -> Evaluated {
        progress.report(0.5, "echo");
        if (p.text == "fail") throw Error(ErrorCode::Degenerate, "It collapses.", "Take another text.");
        return {inputs.of(0)[0],
                {{"solid", p.solid},
                 {"edges", p.edges},
                 {"turns", p.turns},
                 {"t", p.t},
                 {"tolerance", p.tolerance},
                 {"angle", p.angle},
                 {"mode", p.mode == CommandMode::Cubic ? "cubic" : "exact"},
                 {"text", p.text},
                 {"axis", {p.axis.x(), p.axis.y(), p.axis.z()}},
                 {"levels", p.levels},
                 {"inputs", inputs.of(0).size()}},
                {"It is an echo."}};
      });
}

/// The size of a tetrahedron, as a number of a unit that reader and writer share as an option.
Format sizeFormat() {
  ParameterSpec unit = positiveLength();
  unit.name = "unit";
  unit.help = "What 1 stands for.";
  unit.fallback = 1.0;
  Format format;
  format.id = "size";
  format.title = "Size of a tetrahedron";
  format.extensions = {"size"};
  format.readOptions = format.writeOptions = {unit};
  format.read = [](const auto& file, const Value& options, const Progress&) -> Imported {
    return {tetrahedronOf(std::stod(readFile(file)) * options.at("unit").get<double>()), {}, {}, {}};
  };
  format.write = [](const Shape& shape, const auto& file, const Value& options, const Progress&) {
    writeAtomically(file, std::to_string(shape.get<Mesh>()->points[1].x() / options.at("unit").get<double>()));
  };
  format.writes = {ShapeKind::Mesh};
  return format;
}

App testApp() {
  auto formats = std::make_shared<FormatRegistry>(standardFormats());
  formats->add(sizeFormat());
  auto registry = std::make_shared<Registry>();
  registry->add(importFeature(*formats));
  registry->add(literalFeature(registry));
  registry->add(echoFeature("test.echo", "echo", 1, anyNumber));
  registry->add(echoFeature("test.info", "info", 1, 1));  // a name that is taken by a command
  registry->add(LiteralForm{"tetrahedron", "tetrahedron:SIZE", "A tetrahedron.",
                            [](std::string_view given) { return Shape(tetrahedronOf(std::stod(std::string(given)))); }});
  App app;
  app.formats = std::move(formats);
  app.registry = std::move(registry);
  return app;
}

struct CommandEnd {
  int code = 0;
  std::string out, err;
  [[nodiscard]] Json json() const { return Json::parse(out); }
  [[nodiscard]] Json stats() const { return json().at("stats"); }
};

CommandEnd run(std::vector<std::string> words, bool interactive = false, const CancelToken& cancel = {}) {
  static const App app = testApp();
  words.insert(words.begin(), "blossom");
  std::vector<const char*> argv;
  for (const auto& word : words) argv.push_back(word.c_str());
  std::ostringstream out, err;
  const int code = runCli(app, static_cast<int>(argv.size()), argv.data(), {out, err, interactive, cancel});
  return {code, out.str(), err.str()};
}

}  // namespace

class CliGrammarTest : public QObject {
  Q_OBJECT
 private slots:
  void everyKindOfParameterIsAFlag();
  void defaultsAreThoseOfTheDeclaration();
  void flagsCanBeTurnedOff();
  void valuesAreCheckedBeforeTheWork_data();
  void valuesAreCheckedBeforeTheWork();
  void namesThatAreTakenHaveAWayRound();
  void inputsAreCounted();
  void literalsAreInputs();
  void aFailingFeatureSaysWhy();
  void anOptionOfReaderAndWriterIsOneFlag();
  void cancelIsAFailure();
  void progressIsOnlyShownWhereItIsWanted();
  void theTableAlignsAtTheDecimalPoint();
  void featureDescriptionsCarryAllOfTheDeclaration();
  void conditionsAreToldAndRefuseNothing();
  void everyCommandHasHelpWithAnExample();
};

void CliGrammarTest::everyKindOfParameterIsAFlag() {
  const CommandEnd ran = run({"echo",     "tetrahedron:1", "--solid",     "--turns",  "3",
                              "--t",      "3/4",           "--tolerance", "1/2 in",   "--angle",
                              "-30",      "--mode=cubic",  "--text",      "",         "--axis",
                              "-1,0,2.5", "--levels",      "1,2,3",       "--levels", "4",
                              "--json"});
  QVERIFY2(ran.code == 0, (ran.out + ran.err).c_str());
  const Json stats = ran.stats();
  QCOMPARE(stats.at("solid").get<bool>(), true);
  QCOMPARE(stats.at("turns").get<int>(), 3);
  QCOMPARE(stats.at("t").get<double>(), 0.75);
  QCOMPARE(stats.at("tolerance").get<double>(), 12.7);
  QCOMPARE(stats.at("angle").get<double>(), -30.0);
  QCOMPARE(stats.at("mode").get<std::string>(), std::string("cubic"));
  QCOMPARE(stats.at("text").get<std::string>(), std::string());
  QCOMPARE(stats.at("axis").get<std::vector<double>>(), (std::vector<double>{-1, 0, 2.5}));
  QCOMPARE(stats.at("levels").get<std::vector<double>>(), (std::vector<double>{1, 2, 3, 4}));
  QVERIFY(stats.contains("kernel_ms") && stats.contains("total_ms"));
  QCOMPARE(ran.json().at("feature").get<std::string>(), std::string("test.echo"));
  QCOMPARE(ran.json().at("outputs").size(), std::size_t{0});
  QCOMPARE(ran.json().at("warnings").at(0).get<std::string>(), std::string("It is an echo."));
  QCOMPARE(run({"echo", "tetrahedron:1", "--text=", "--json"}).stats().at("text").get<std::string>(), std::string());
}

void CliGrammarTest::defaultsAreThoseOfTheDeclaration() {
  const Json stats = run({"test.echo", "tetrahedron:1", "--json"}).stats();
  QCOMPARE(stats.at("tolerance").get<double>(), 0.01);
  QCOMPARE(stats.at("edges").get<bool>(), true);
  QCOMPARE(stats.at("levels").get<std::vector<double>>(), (std::vector<double>{1, 2}));
}

void CliGrammarTest::flagsCanBeTurnedOff() {
  QCOMPARE(run({"echo", "tetrahedron:1", "--no-edges", "--json"}).stats().at("edges").get<bool>(), false);
  QCOMPARE(run({"echo", "tetrahedron:1", "--edges=no", "--json"}).stats().at("edges").get<bool>(), false);
  QCOMPARE(run({"echo", "tetrahedron:1", "--solid=yes", "--json"}).stats().at("solid").get<bool>(), true);
  QCOMPARE(run({"echo", "--solid", "tetrahedron:1", "--json"}).stats().at("solid").get<bool>(), true);
}

void CliGrammarTest::valuesAreCheckedBeforeTheWork_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::newRow("ratio") << QStringList{"--t", "1.4"};
  QTest::newRow("count") << QStringList{"--turns", "1.5"};
  QTest::newRow("huge count") << QStringList{"--turns", "99999999999999999999"};
  QTest::newRow("huge length") << QStringList{"--tolerance", "1e999"};
  QTest::newRow("not a number") << QStringList{"--tolerance", "nan"};
  QTest::newRow("zero") << QStringList{"--tolerance", "0"};
  QTest::newRow("word") << QStringList{"--angle", "steep"};
  QTest::newRow("choice") << QStringList{"--mode", "cubc"};
  QTest::newRow("vector") << QStringList{"--axis", "1,2,x"};
  QTest::newRow("list") << QStringList{"--levels", "1,x"};
  QTest::newRow("twice") << QStringList{"--t", "0.1", "--t", "0.2"};
  QTest::newRow("empty") << QStringList{"--t", ""};
  QTest::newRow("flag value") << QStringList{"--solid=maybe"};
}

void CliGrammarTest::valuesAreCheckedBeforeTheWork() {
  QFETCH(QStringList, flags);
  std::vector<std::string> words{"echo", "tetrahedron:1", "--json"};
  for (const QString& flag : flags) words.push_back(flag.toStdString());
  const CommandEnd ran = run(words);
  QCOMPARE(ran.code, 2);
  const std::string message = ran.json().at("error").at("message").get<std::string>();
  QVERIFY2(message.find(flags[0].section('=', 0, 0).mid(2).toStdString()) != std::string::npos, message.c_str());
}

void CliGrammarTest::namesThatAreTakenHaveAWayRound() {
  const CommandEnd byId = run({"test.info", "tetrahedron:1", "--json"});
  QCOMPARE(byId.json().at("feature").get<std::string>(), std::string("test.info"));
  QVERIFY(!run({"info", "tetrahedron:1", "--json"}).json().contains("feature"));
}

void CliGrammarTest::inputsAreCounted() {
  QCOMPARE(run({"echo", "--json"}).code, 2);
  QCOMPARE(run({"test.info", "tetrahedron:1", "tetrahedron:2", "--json"}).code, 2);
  QCOMPARE(run({"echo", "tetrahedron:1", "tetrahedron:2", "tetrahedron:3", "--json"}).stats().at("inputs").get<int>(), 3);
  QCOMPARE(run({"echo", "echo", "--json"}).code, 1);  // the name of a command is a file name here
}

void CliGrammarTest::literalsAreInputs() {
  const Json result = run({"echo", "tetrahedron:3", "--json"}).json().at("result");
  QCOMPARE(result.at("kind").get<std::string>(), std::string("mesh"));
  COMPARE_NEAR(result.at("volume").get<double>(), 4.5, 1e-12);
  COMPARE_NEAR(run({"literal", "--text", "tetrahedron:3", "--json"}).json().at("result").at("volume").get<double>(), 4.5,
               1e-12);
  const CommandEnd unknown = run({"echo", "tetrahedrn:3", "--json"});
  QCOMPARE(unknown.code, 1);
  QVERIFY(unknown.json().at("error").at("hint").get<std::string>().find("tetrahedron:SIZE") != std::string::npos);
}

void CliGrammarTest::aFailingFeatureSaysWhy() {
  const CommandEnd json = run({"echo", "tetrahedron:1", "--text", "fail", "--json"});
  QCOMPARE(json.code, 1);
  QCOMPARE(json.json().at("error").at("code").get<std::string>(), std::string("Degenerate"));
  const CommandEnd plain = run({"echo", "tetrahedron:1", "--text", "fail"});
  QCOMPARE(plain.out, std::string());
  QCOMPARE(plain.err, std::string("blossom: It collapses.\n  Take another text.\n"));
}

void CliGrammarTest::anOptionOfReaderAndWriterIsOneFlag() {
  const TemporaryFolder folder;
  const std::string in = (folder.path() / "in.size").string(), out = (folder.path() / "out.size").string(),
                    mesh = (folder.path() / "out.off").string();
  writeAtomically(in, "3");
  const auto volume = [](const CommandEnd& ran) { return ran.json().at("result").at("volume").get<double>(); };
  for (const std::vector<std::string>& words : {std::vector<std::string>{"import", in, "-o", out}, {"convert", in, out}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--size.unit", "2", "--json"});
    const CommandEnd ran = run(all);
    QVERIFY2(ran.code == 0, (ran.out + ran.err).c_str());
    COMPARE_NEAR(volume(ran), 36, 1e-9);  // 6^3 / 6
    COMPARE_NEAR(std::stod(readFile(out)), 3, 1e-9);
    std::filesystem::remove(out);
  }
  const CommandEnd read = run({"import", in, "--size.unit", "2", "-o", mesh, "--json"});  // by the reader alone
  QVERIFY2(read.code == 0, (read.out + read.err).c_str());
  COMPARE_NEAR(volume(read), 36, 1e-9);
  const CommandEnd unused = run({"echo", in, "--size.unit", "2", "-o", mesh, "--json"});
  QCOMPARE(unused.code, 2);
}

void CliGrammarTest::cancelIsAFailure() {
  const CancelToken cancel;
  cancel.cancel();
  const CommandEnd ran = run({"echo", "tetrahedron:1", "--json"}, false, cancel);
  QCOMPARE(ran.code, 1);
  QCOMPARE(ran.json().at("error").at("code").get<std::string>(), std::string("Cancelled"));
}

void CliGrammarTest::progressIsOnlyShownWhereItIsWanted() {
  QCOMPARE(run({"echo", "tetrahedron:1", "--json"}).err, std::string());
  QCOMPARE(run({"echo", "tetrahedron:1", "--json"}, true).err, std::string());  // short work shows no bar
  QVERIFY(run({"echo", "tetrahedron:1", "--progress", "--json"}).err.find("%") != std::string::npos);
}

void CliGrammarTest::theTableAlignsAtTheDecimalPoint() {
  const std::string table = run({"echo", "tetrahedron:3"}).out;
  std::istringstream lines(table);
  std::string line;
  std::size_t volume = 0, faces = 0;
  while (std::getline(lines, line)) {
    if (line.find("volume") != std::string::npos) volume = line.find('4');
    if (line.find("faces") != std::string::npos) faces = line.find('4');
  }
  QVERIFY(volume > 0);
  QCOMPARE(volume, faces);  // 4.5 and 4
}

void CliGrammarTest::featureDescriptionsCarryAllOfTheDeclaration() {
  const Json echo = run({"features", "echo", "--json"}).json();
  QCOMPARE(echo.at("id").get<std::string>(), std::string("test.echo"));
  QCOMPARE(echo.at("parameters").size(), std::size_t{10});
  const Json& turns = echo.at("parameters").at(2);
  QCOMPARE(turns.at("least").get<double>(), 1.0);
  QCOMPARE(turns.at("greatest").get<double>(), 9.0);
  QCOMPARE(turns.at("default").get<int>(), 1);
  const std::string text = run({"features", "echo"}).out;
  for (const char* word : {"--tolerance", "A length.", "exact", "blossom echo"})
    QVERIFY2(text.find(word) != std::string::npos, word);
  const QString help = QString::fromStdString(run({"echo", "--help"}).out).simplified();  // lines may be broken anywhere
  for (const char* word : {"--tolerance", "A length.", "exact|cubic", "blossom echo", "--[no-]edges", "default 0.01 mm"})
    QVERIFY2(help.contains(QLatin1String(word)), qPrintable(help));
}

void CliGrammarTest::conditionsAreToldAndRefuseNothing() {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"echo", "--help"}, {"help", "echo"}}) {
    const QString help = QString::fromStdString(run(words).out).simplified();
    for (const char* part : {"A length. (length in mm, above 0 mm; only if mode is cubic; default 0.01 mm)",
                             "A flag that is on. (only if mode is cubic) [on]"})
      QVERIFY2(help.contains(QLatin1String(part)), qPrintable(help));
    QCOMPARE(help.count(QLatin1String("only if")), 2);
  }
  const std::string page = run({"features", "echo", "--markdown"}).out;
  QVERIFY2(page.find("length in mm, above 0 mm; only if mode is cubic") != std::string::npos, page.c_str());
  const Json parameters = run({"features", "echo", "--json"}).json().at("parameters");
  for (const Json& each : parameters) {
    const std::string name = each.at("name").get<std::string>();
    QCOMPARE(each.contains("only_for"), name == "edges" || name == "tolerance");
    if (each.contains("only_for")) QVERIFY(each.at("only_for") == (Json{{"parameter", "mode"}, {"values", {"cubic"}}}));
  }
  const CommandEnd made = run({"echo", "tetrahedron:2", "--mode", "exact", "--tolerance", "3", "--no-edges", "--json"});
  QCOMPARE(made.code, 0);
  QCOMPARE(made.json().at("stats").at("tolerance").get<double>(), 3.0);
  QCOMPARE(made.json().at("stats").at("edges").get<bool>(), false);
}

void CliGrammarTest::everyCommandHasHelpWithAnExample() {
  for (const char* command :
       {"convert", "info", "run", "features", "formats", "plugins", "completion", "help", "import", "echo"}) {
    const CommandEnd help = run({command, "--help"});
    QCOMPARE(help.code, 0);
    QVERIFY2(help.out.find("Example") != std::string::npos, command);
    QCOMPARE(run({"help", command}).code, 0);
  }
}

BLOSSOM_TEST(CliGrammarTest)
#include "cli_grammar_test.moc"
