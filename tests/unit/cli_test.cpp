#include <fmt/format.h>
#include <sys/stat.h>

#include <QProcess>
#include <QTemporaryDir>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/file.h"
#include "support/support.h"

using blossom::test::buildFolder;
using Json = nlohmann::ordered_json;

namespace {

struct ProcessEnd {
  int code = -1;
  std::string out, err;
  /// Exactly one JSON object and nothing else on standard output.
  [[nodiscard]] Json json() const { return Json::parse(out); }
};

/// The real binary, in a folder of its own, with no display.
ProcessEnd blossomIn(const QString& folder, const QStringList& arguments, const QByteArray& input = {}) {
  QProcess process;
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.remove("DISPLAY");
  process.setProcessEnvironment(environment);
  process.setWorkingDirectory(folder);
  process.start(QString::fromStdString((buildFolder() / "bin/blossom").string()), arguments);
  process.write(input);
  process.closeWriteChannel();
  if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit) return {};
  return {process.exitCode(), process.readAllStandardOutput().toStdString(), process.readAllStandardError().toStdString()};
}

const char* cubeOff =
    "OFF\n8 6 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

}  // namespace

class CliTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void versionAndHelpEndWithZero();
  void wrongUseEndsWithTwoAndNamesTheNearestWord_data();
  void wrongUseEndsWithTwoAndNamesTheNearestWord();
  void wrongUseIsAnErrorObjectToo();
  void infoMeasuresACube();
  void infoOfManyFilesIsStillOneObject();
  void infoTellsWarningsOfFeatures();
  void convertWritesSeveralFilesAtOnce();
  void numbersReadBackAsTheSameDouble();
  void failuresEndWithOneAndAnErrorObject_data();
  void failuresEndWithOneAndAnErrorObject();
  void helpListsOptionsOfFormatsThatCanHoldTheResult();
  void nothingIsWrittenAfterAFailure();
  void anOutputNeverReplacesTheInput();
  void namesThatAreNotUtf8();
  void documentsAreInputsAndOutputs();
  void salvageOpensWhatIsReadableOfADamagedDocument();
  void runSetsParametersAndExports();
  void runReportsEveryFeatureAlsoWhenOneFails();
  void aFullDeviceIsAFailure();
  void completionScriptsAreGoodShell();
  void brokenPluginsAreOneWarning();

 private:
  ProcessEnd blossom(const QStringList& arguments) { return blossomIn(folder_->path(), arguments); }
  [[nodiscard]] std::filesystem::path file(const char* name) const {
    return std::filesystem::path(folder_->path().toStdString()) / name;
  }
  [[nodiscard]] QStringList files() const {
    return QDir(folder_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

void CliTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  blossom::writeAtomically(file("cube.off"), cubeOff);
}

void CliTest::versionAndHelpEndWithZero() {
  const ProcessEnd version = blossom({"--version"});
  QCOMPARE(version.code, 0);
  QVERIFY(version.out.starts_with("blossom "));
  for (const QStringList& words : {QStringList{"--help"},
                                   {"help"},
                                   {"help", "convert"},
                                   {"convert", "--help"},
                                   {"import", "-h"},
                                   {"exchange.import", "--help"}}) {
    const ProcessEnd help = blossom(words);
    QVERIFY2(help.code == 0, qPrintable(words.join(' ')));
    QVERIFY2(help.out.find("Usage") != std::string::npos, qPrintable(words.join(' ')));
    QCOMPARE(help.err, std::string());
  }
}

void CliTest::wrongUseEndsWithTwoAndNamesTheNearestWord_data() {
  QTest::addColumn<QStringList>("words");
  QTest::addColumn<QString>("mentions");
  QTest::newRow("nothing") << QStringList{} << "--help";
  QTest::newRow("command") << QStringList{"convrt", "a", "b"} << "Did you mean convert?";
  QTest::newRow("command with help") << QStringList{"convrt", "--help"} << "Did you mean convert?";
  QTest::newRow("flag") << QStringList{"info", "cube.off", "--jsno"} << "Did you mean --json?";
  QTest::newRow("flag with value") << QStringList{"import", "--fiel=cube.off"} << "Did you mean --file?";
  QTest::newRow("root flag") << QStringList{"--verson"} << "Did you mean --version?";
  QTest::newRow("no input") << QStringList{"info"} << "needs a file";
  QTest::newRow("too many inputs") << QStringList{"import", "cube.off", "--file", "cube.off"} << "takes one file";
  QTest::newRow("convert without output") << QStringList{"convert", "cube.off"} << "file to write";
  QTest::newRow("value missing") << QStringList{"import", "--file"} << "--file needs a value";
  QTest::newRow("parameter missing") << QStringList{"import"} << "file";
  QTest::newRow("empty input") << QStringList{"info", ""} << "empty";
  QTest::newRow("empty output") << QStringList{"convert", "cube.off", ""} << "empty";
  QTest::newRow("option out of range") << QStringList{"convert", "cube.off", "c.stl", "--chord", "-1"} << "--chord must be";
  QTest::newRow("option of no file") << QStringList{"convert", "cube.off", "c.obj", "--stl.ascii"} << "--stl.ascii";
  QTest::newRow("unknown shell") << QStringList{"completion", "tcsh"} << "bash";
  QTest::newRow("huge number") << QStringList{"render", "cube.off", "-o", "c.png", "--size", "1e999x1"} << "size";
  QTest::newRow("twice") << QStringList{"convert", "cube.off", "a.stl", "a.stl"} << "twice";
  QTest::newRow("threads") << QStringList{"info", "cube.off", "--threads", "-3"} << "threads";
}

void CliTest::wrongUseEndsWithTwoAndNamesTheNearestWord() {
  QFETCH(QStringList, words);
  QFETCH(QString, mentions);
  const ProcessEnd plain = blossom(words);
  QCOMPARE(plain.code, 2);
  QCOMPARE(plain.out, std::string());
  QVERIFY2(plain.err.starts_with("blossom: "), plain.err.c_str());
  QVERIFY2(plain.err.find(mentions.toStdString()) != std::string::npos, plain.err.c_str());
  QCOMPARE(files(), QStringList{"cube.off"});
}

void CliTest::wrongUseIsAnErrorObjectToo() {
  const ProcessEnd json = blossom({"convert", "cube.off", "c.stl", "--chord", "-1", "--json"});
  QCOMPARE(json.code, 2);
  QCOMPARE(json.json().at("error").at("code").get<std::string>(), std::string("InvalidParameter"));
  QCOMPARE(blossom({"infoo", "--json"}).json().at("error").at("hint").get<std::string>(), std::string("Did you mean info?"));
}

void CliTest::infoMeasuresACube() {
  const ProcessEnd ran = blossom({"info", "cube.off", "--json"});
  QCOMPARE(ran.code, 0);
  const Json info = ran.json();
  QCOMPARE(info.at("result").at("kind").get<std::string>(), std::string("mesh"));
  COMPARE_NEAR(info.at("result").at("volume").get<double>(), 8, 1e-12);
  COMPARE_NEAR(info.at("result").at("area").get<double>(), 24, 1e-12);
  QCOMPARE(info.at("result").at("faces").get<int>(), 6);
  QVERIFY(info.at("stats").contains("entities"));
  QVERIFY(info.at("stats").at("total_ms").get<double>() > 0);
  const ProcessEnd table = blossom({"info", "cube.off"});
  QCOMPARE(table.code, 0);
  QVERIFY2(table.out.find("mm³") != std::string::npos, table.out.c_str());
}

void CliTest::infoOfManyFilesIsStillOneObject() {
  blossom::writeAtomically(file("other.off"), cubeOff);
  const ProcessEnd ran = blossom({"info", "cube.off", "other.off", "--json"});
  QCOMPARE(ran.code, 0);
  QCOMPARE(ran.json().at("files").size(), std::size_t{2});
}

void CliTest::infoTellsWarningsOfFeatures() {
  blossom::writeAtomically(file("drawing.svg"),
                           "<svg xmlns='http://www.w3.org/2000/svg'><rect width='4' height='2'/><text>note</text></svg>");
  QCOMPARE(blossom({"import", "drawing.svg", "-o", "model.blossom"}).code, 0);
  const ProcessEnd object = blossom({"info", "model.blossom", "--json"}), table = blossom({"info", "model.blossom"});
  QCOMPARE(object.code, 0);
  const Json warnings = object.json().at("features").at(0).at("warnings");
  QCOMPARE(warnings.size(), std::size_t(1));
  const auto warning = warnings.at(0).get<std::string>();
  QVERIFY2(warning.find("1 text") != std::string::npos, warning.c_str());
  QCOMPARE(table.err, "blossom: warning: Import: " + warning + "\n");
}

void CliTest::convertWritesSeveralFilesAtOnce() {
  const ProcessEnd ran =
      blossom({"convert", "cube.off", "cube.obj", "cube.stl,cube.ply", "-o", "a,b.off", "--stl.ascii", "--json"});
  QVERIFY2(ran.code == 0, (ran.out + ran.err).c_str());
  QCOMPARE(ran.json().at("outputs").get<std::vector<std::string>>(),
           (std::vector<std::string>{"cube.obj", "cube.stl", "cube.ply", "a,b.off"}));
  QVERIFY(blossom::readFile(file("cube.stl")).starts_with("solid"));
  for (const char* name : {"cube.obj", "cube.stl", "cube.ply", "a,b.off"}) {
    const Json info = blossom({"info", name, "--json"}).json();
    COMPARE_NEAR(info.at("result").at("volume").get<double>(), 8, 1e-9);
  }
}

void CliTest::numbersReadBackAsTheSameDouble() {
  std::string text(cubeOff);
  const auto place = text.find("2 0 0");
  blossom::writeAtomically(file("odd.off"), text.replace(place, 1, "2.1000000000000001"));
  const double inObject = blossom({"info", "odd.off", "--json"}).json().at("result").at("area").get<double>();
  const std::string table = blossom({"info", "odd.off"}).out;
  QVERIFY2(table.find(fmt::format("{}", inObject)) != std::string::npos, table.c_str());
}

void CliTest::failuresEndWithOneAndAnErrorObject_data() {
  QTest::addColumn<QStringList>("words");
  QTest::addColumn<QString>("code");
  QTest::newRow("missing file") << QStringList{"info", "none.off"} << "FileNotFound";
  QTest::newRow("missing input") << QStringList{"convert", "none.off", "a.obj"} << "FileNotFound";
  QTest::newRow("folder as input") << QStringList{"info", "."} << "FileUnreadable";
  QTest::newRow("folder as document") << QStringList{"run", "folder.blossom"} << "FileUnreadable";
  QTest::newRow("no such folder") << QStringList{"convert", "cube.off", "none/a.obj"} << "FileUnwritable";
  QTest::newRow("output is a folder") << QStringList{"convert", "cube.off", "folder.obj"} << "FileUnwritable";
  QTest::newRow("folder is a file") << QStringList{"convert", "cube.off", "cube.off/a.obj"} << "FileUnwritable";
  QTest::newRow("unknown output") << QStringList{"convert", "cube.off", "a.unknown"} << "FormatUnknown";
  QTest::newRow("no extension") << QStringList{"convert", "cube.off", "a"} << "FormatUnknown";
  QTest::newRow("unknown input") << QStringList{"info", "text.unknown"} << "FormatUnknown";
  QTest::newRow("damaged") << QStringList{"info", "damaged.off"} << "FormatDamaged";
  QTest::newRow("damaged through a feature")
      << QStringList{"import", "--file", "damaged.off", "-o", "a.obj"} << "FormatDamaged";
  QTest::newRow("damaged document") << QStringList{"run", "damaged.blossom"} << "FormatDamaged";
  QTest::newRow("picture that is none") << QStringList{"render", "cube.off", "-o", "a.obj"} << "FormatUnknown";
  QTest::newRow("kind that does not fit") << QStringList{"convert", "cube.off", "a.svg"} << "OutputNotSupported";
  QTest::newRow("unknown feature") << QStringList{"features", "sweeep"} << "NotFound";
}

void CliTest::failuresEndWithOneAndAnErrorObject() {
  QFETCH(QStringList, words);
  QFETCH(QString, code);
  QDir(folder_->path()).mkdir("folder.obj");
  QDir(folder_->path()).mkdir("folder.blossom");
  blossom::writeAtomically(file("text.unknown"), "text");
  blossom::writeAtomically(file("damaged.off"), "OFF\n8 6 0\n0 0");
  blossom::writeAtomically(file("damaged.blossom"), "PK rubbish");
  const QStringList before = files();
  const ProcessEnd json = blossom(words + QStringList{"--json"});
  QVERIFY2(json.code == 1, (json.out + json.err).c_str());
  const Json error = json.json().at("error");
  QCOMPARE(error.at("code").get<std::string>(), code.toStdString());
  QVERIFY(!error.at("message").get<std::string>().empty());
  QVERIFY(error.contains("hint"));
  const ProcessEnd plain = blossom(words);
  QCOMPARE(plain.code, 1);
  QCOMPARE(plain.out, std::string());
  QVERIFY2(plain.err.find(error.at("message").get<std::string>()) != std::string::npos, plain.err.c_str());
  QCOMPARE(files(), before);
}

void CliTest::helpListsOptionsOfFormatsThatCanHoldTheResult() {
  const std::string help = blossom({"pocket", "--help"}).out;  // gives a toolpath
  for (const char* flag : {"--gcode.post", "--post", "--chord"}) QVERIFY2(help.find(flag) != std::string::npos, flag);
  for (const char* flag : {"--stl.", "--step.", "--obj."}) QVERIFY2(help.find(flag) == std::string::npos, flag);
  QCOMPARE(blossom({"pocket", "circle:20", "--stl.ascii", "-o", "a.ngc"}).code, 2);
  // of a feature that may give anything, all
  QVERIFY(blossom({"transform", "--help"}).out.find("--stl.") != std::string::npos);
}

void CliTest::nothingIsWrittenAfterAFailure() {
  blossom::writeAtomically(file("kept.obj"), "old content");
  QCOMPARE(blossom({"convert", "cube.off", "kept.obj", "a.svg"}).code,
           1);  // a mesh is no drawing: said before kept.obj is touched
  QCOMPARE(blossom::readFile(file("kept.obj")), std::string("old content"));
  QCOMPARE(files(), (QStringList{"cube.off", "kept.obj"}));
}

void CliTest::anOutputNeverReplacesTheInput() {
  QVERIFY(QFile::link("cube.off", folder_->path() + "/link.off"));
  for (const char* name : {"cube.off", "./cube.off", "link.off"}) {
    const ProcessEnd ran = blossom({"convert", "cube.off", name});
    QCOMPARE(ran.code, 2);
    QVERIFY2(ran.err.find("replace the input") != std::string::npos, ran.err.c_str());
  }
  QCOMPARE(blossom::readFile(file("cube.off")), std::string(cubeOff));
}

void CliTest::namesThatAreNotUtf8() {
  // QProcess would encode the name: a shell passes the bytes on.
  const auto script = fmt::format(
      "cd {} && cp cube.off \"$(printf 'k\\344fer.off')\" && {} convert \"$(printf 'k\\344fer.off')\" \"$(printf "
      "'k\\344fer.obj')\" --json",
      folder_->path().toStdString(), (buildFolder() / "bin/blossom").string());
  QProcess shell;
  shell.start("sh", {"-c", QString::fromStdString(script)});
  QVERIFY(shell.waitForFinished(-1));
  QCOMPARE(shell.exitCode(), 0);
  const Json result = Json::parse(shell.readAllStandardOutput().toStdString());
  QVERIFY(result.at("outputs").at(0).get<std::string>().ends_with(".obj"));
  QVERIFY(std::filesystem::remove(file("k\344fer.obj")));  // QTemporaryDir cannot name them
  QVERIFY(std::filesystem::remove(file("k\344fer.off")));
}

void CliTest::documentsAreInputsAndOutputs() {
  const ProcessEnd made = blossom({"import", "cube.off", "-o", "model.blossom", "--json"});
  QVERIFY2(made.code == 0, (made.out + made.err).c_str());
  QVERIFY(QFile::remove(folder_->path() + "/cube.off"));  // the document holds its own copy
  const Json info = blossom({"info", "model.blossom", "--json"}).json();
  QCOMPARE(info.at("features").at(0).at("state").get<std::string>(), std::string("done"));
  COMPARE_NEAR(info.at("result").at("volume").get<double>(), 8, 1e-12);
  const std::string id = info.at("features").at(0).at("id").get<std::string>();
  for (const std::string& input : {std::string("model.blossom"), "model.blossom#" + id}) {
    const ProcessEnd converted = blossom({"convert", QString::fromStdString(input), "copy.obj", "--json"});
    QVERIFY2(converted.code == 0, (converted.out + converted.err).c_str());
    COMPARE_NEAR(converted.json().at("result").at("volume").get<double>(), 8, 1e-12);
  }
  const ProcessEnd missing = blossom({"info", "model.blossom#none", "--json"});
  QCOMPARE(missing.code, 1);
  QCOMPARE(missing.json().at("error").at("code").get<std::string>(), std::string("NotFound"));
}

void CliTest::salvageOpensWhatIsReadableOfADamagedDocument() {
  QCOMPARE(blossom({"import", "cube.off", "-o", "model.blossom"}).code, 0);
  std::string bytes = blossom::readFile(file("model.blossom"));
  bytes.resize(bytes.size() - 30);  // the directory at the end of the zip is gone
  blossom::writeAtomically(file("cut.blossom"), bytes);
  const std::vector<QStringList> commands{{"info", "cut.blossom"},
                                          {"run", "cut.blossom", "-o", "a.obj"},
                                          {"convert", "cut.blossom", "b.obj"},
                                          {"render", "cut.blossom", "-o", "c.png"}};
  for (const QStringList& words : commands) {
    const ProcessEnd refused = blossom(words + QStringList{"--json"});
    QCOMPARE(refused.code, 1);
    const Json error = refused.json().at("error");
    QCOMPARE(error.at("code").get<std::string>(), std::string("FormatDamaged"));
    QVERIFY2(error.at("hint").get<std::string>().find("--salvage") != std::string::npos, refused.out.c_str());
    const ProcessEnd opened = blossom(words + QStringList{"--salvage", "--json"});
    QVERIFY2(opened.code == 0, (opened.out + opened.err).c_str());
    QVERIFY2(!opened.json().at("warnings").empty(), opened.out.c_str());
  }
  COMPARE_NEAR(blossom({"info", "b.obj", "--json"}).json().at("result").at("volume").get<double>(), 8, 1e-12);
  // What could not be read must stay where it is.
  QCOMPARE(blossom({"run", "cut.blossom", "--salvage", "-o", "cut.blossom"}).code, 2);
  QCOMPARE(blossom::readFile(file("cut.blossom")), bytes);
  // No promise where nothing is left.
  blossom::writeAtomically(file("rubbish.blossom"), "PK rubbish");
  QVERIFY(blossom({"info", "rubbish.blossom"}).err.find("--salvage") == std::string::npos);
}

void CliTest::runSetsParametersAndExports() {
  QCOMPARE(blossom({"import", "--file", "cube.off", "-o", "model.blossom"}).code, 0);
  const Json info = blossom({"info", "model.blossom", "--json"}).json();
  const QString id = QString::fromStdString(info.at("features").at(0).at("id").get<std::string>());
  std::string larger(cubeOff);
  for (std::size_t at = larger.find("\n", 10); (at = larger.find('2', at)) != std::string::npos && at < larger.find("4 0 3");
       ++at)
    larger[at] = '4';
  blossom::writeAtomically(file("larger.off"), larger);
  const ProcessEnd ran = blossom({"run", "model.blossom", "--set", id + ".file=larger.off", "--export", id + "=larger.obj",
                                  "--export", "larger.blossom", "--json"});
  QVERIFY2(ran.code == 0, (ran.out + ran.err).c_str());
  COMPARE_NEAR(ran.json().at("features").at(0).at("result").at("volume").get<double>(), 64, 1e-9);
  COMPARE_NEAR(blossom({"info", "larger.obj", "--json"}).json().at("result").at("volume").get<double>(), 64, 1e-9);
  const ProcessEnd byType = blossom({"run", "model.blossom", "--set", "import.file=larger.off", "--json"});
  QVERIFY2(byType.code == 0, (byType.out + byType.err).c_str());
  COMPARE_NEAR(byType.json().at("features").at(0).at("result").at("volume").get<double>(), 64, 1e-9);
  QVERIFY(QFile::remove(folder_->path() + "/larger.off"));
  COMPARE_NEAR(blossom({"info", "larger.blossom", "--json"}).json().at("result").at("volume").get<double>(), 64, 1e-9);
  for (const QString& wrong : {id + ".fiel=a.off", QString("other.file=a.off"), QString("file"), QString("=")}) {
    const ProcessEnd refused = blossom({"run", "model.blossom", "--set", wrong});
    QVERIFY2(refused.code == 2, qPrintable(wrong));
  }
}

void CliTest::runReportsEveryFeatureAlsoWhenOneFails() {
  QCOMPARE(blossom({"import", "--file", "cube.off", "-o", "model.blossom"}).code, 0);
  const Json info = blossom({"info", "model.blossom", "--json"}).json();
  const QString id = QString::fromStdString(info.at("features").at(0).at("id").get<std::string>());
  const ProcessEnd ran = blossom({"run", "model.blossom", "--set", id + ".file=none.off", "--export", "a.obj", "--json"});
  QCOMPARE(ran.code, 1);
  QCOMPARE(ran.json().at("features").at(0).at("state").get<std::string>(), std::string("failed"));
  QCOMPARE(ran.json().at("error").at("code").get<std::string>(), std::string("FileNotFound"));
  QVERIFY(!std::filesystem::exists(file("a.obj")));
}

void CliTest::aFullDeviceIsAFailure() {
  QProcess shell;
  shell.start("sh", {"-c", QString::fromStdString((buildFolder() / "bin/blossom").string() + " features > /dev/full")});
  QVERIFY(shell.waitForFinished(-1));
  QCOMPARE(shell.exitCode(), 1);
}

void CliTest::completionScriptsAreGoodShell() {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const ProcessEnd ran = blossom({"completion", shell});
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.out.find("convert") != std::string::npos);
    QVERIFY(ran.out.find("import") != std::string::npos);
  }
  const ProcessEnd bash = blossom({"completion", "bash"});
  blossom::writeAtomically(file("completion.bash"), bash.out);
  QProcess shell;
  shell.start("bash",
              {"-c", "source " + folder_->path() +
                         "/completion.bash && COMP_WORDS=(blossom conv) COMP_CWORD=1 && _blossom && echo ${COMPREPLY[@]} && "
                         "COMP_WORDS=(blossom render --vi) COMP_CWORD=2 && _blossom && echo ${COMPREPLY[@]} && "
                         "COMP_WORDS=(blossom render --view is) COMP_CWORD=3 && _blossom && echo ${COMPREPLY[@]}"});
  QVERIFY(shell.waitForFinished(-1));
  QCOMPARE(shell.readAllStandardOutput(), QByteArray("convert\n--view\niso\n"));
}

void CliTest::brokenPluginsAreOneWarning() {
  QDir(folder_->path()).mkpath("plugins/broken");
  blossom::writeAtomically(file("plugins/broken/plugin.json"), "{\"id\": \"broken\"");
  QProcess process;
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.insert("BLOSSOM_PLUGIN_PATH", folder_->path() + "/plugins");
  process.setProcessEnvironment(environment);
  process.start(QString::fromStdString((buildFolder() / "bin/blossom").string()), {"plugins", "--json"});
  QVERIFY(process.waitForFinished(-1));
  QCOMPARE(process.exitCode(), 0);
  const Json plugins = Json::parse(process.readAllStandardOutput().toStdString()).at("plugins");
  int skipped = 0;
  for (const auto& plugin : plugins) skipped += plugin.at("loaded").get<bool>() ? 0 : 1;
  QCOMPARE(skipped, 1);
  QCOMPARE(process.readAllStandardError().count('\n'), 1);
}

BLOSSOM_TEST(CliTest)
#include "cli_test.moc"
