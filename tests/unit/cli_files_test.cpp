#include <fmt/format.h>

#include <QTemporaryDir>
#include <cmath>
#include <filesystem>

#include "core/file.h"
#include "document/storage.h"
#include "support/command_line.h"

using namespace blossom;
using test::answerOf;
namespace fs = std::filesystem;

/// What the command line makes of files: a document says what its command said, and reads nothing of others.
class CliFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanupTestCase();

  void aConvertedDocumentHoldsTheOptionsOfItsReader();
  void anImportTakesTheOptionsOfTheFormat();
  void optionsOfAnotherFormatAreTold();
  void programsKeepHowTheyAreRead();

  void aStrangersDocumentReadsNothingOutsideItsFolder_data();
  void aStrangersDocumentReadsNothingOutsideItsFolder();
  void whatLiesBelowTheFolderIsReadFromWhereverOneStands();
  void filesThatTheUserNamesAreRead();
  void aStrangersFeatureStaysAStrangersInAnotherDocument();
  void aSavedDocumentTellsNoFolder();
  void resourcesAreNotWritten();
  void framesReplaceNoInput();

 private:
  /// A roof of four rows of control points: of degree 1 along them, three rectangles of 30 by sqrt(10^2 + 5^2).
  static constexpr double slope = 11.180339887498949;
  static constexpr double roofArea = 3 * 30 * slope;

  [[nodiscard]] fs::path place(const std::string& name) const { return fs::path(folder_->path().toStdString()) / name; }
  test::Answer blossom(const QStringList& words, const std::string& in = "") {
    return answerOf(QString::fromStdString(place(in).string()), words);
  }
  /// A document with one import of that path, without its content.
  void writeStranger(const std::string& name, const Value& path) const {
    Feature import;
    import.id = import.name = "import-1";
    import.type = "exchange.import";
    import.parameters["file"] = path;
    saveDocument(Document::of({import}), place(name));
  }
  static std::string errorOf(const test::Answer& info) {
    return info.json.at("features").at(0).at("error").at("message").get<std::string>();
  }

  std::unique_ptr<QTemporaryDir> folder_;
  int ways_ = 0, read_ = 0, allowed_ = 0;
};

namespace {

const char* const secret = "OFF\n3 1 0\n0 0 0\n6 0 0\n0 5 0\n3 0 1 2\n";  // area 15

}  // namespace

void CliFilesTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  writeAtomically(place("roof.cpt"),
                  "0,0,0;0,10,0;0,20,0;0,30,0\n10,0,5;10,10,5;10,20,5;10,30,5\n20,0,0;20,10,0;20,20,0;20,30,0\n"
                  "30,0,5;30,10,5;30,20,5;30,30,5\n");
  writeAtomically(place("secret.off"), secret);
  fs::create_directories(place("theirs/below"));
  fs::create_directories(place("elsewhere"));
}

void CliFilesTest::cleanupTestCase() {
  fmt::print("figure strangers_ways {}\nfigure strangers_read {}\nfigure strangers_allowed {}\n", ways_, read_, allowed_);
}

void CliFilesTest::aConvertedDocumentHoldsTheOptionsOfItsReader() {
  const auto converted = blossom({"convert", "roof.cpt", "o.blossom", "--control-points.degree-u", "1"});
  QCOMPARE(converted.code, 0);
  COMPARE_NEAR(converted.result("area"), roofArea, 1e-9 * roofArea);
  const auto again = blossom({"info", "o.blossom"});
  COMPARE_NEAR(again.result("area"), roofArea, 1e-9 * roofArea);
  QCOMPARE(again.json["result"]["degree_u"], Value(1));
  QCOMPARE(again.json["result"]["degree_v"], Value(3));
  const Document document = openDocument(place("o.blossom")).document;
  QCOMPARE(document.at("import-1").parameters.at("control-points"), (Value{{"degree-u", 1}}));
  // Without the option it is another surface.
  QVERIFY(blossom({"info", "roof.cpt"}).result("area") < 0.99 * roofArea);
}

void CliFilesTest::anImportTakesTheOptionsOfTheFormat() {
  const auto imported = blossom({"import", "roof.cpt", "--control-points.degree-u", "1", "-o", "i.blossom"});
  QCOMPARE(imported.code, 0);
  COMPARE_NEAR(imported.result("area"), roofArea, 1e-9 * roofArea);
  COMPARE_NEAR(blossom({"info", "i.blossom"}).result("area"), roofArea, 1e-9 * roofArea);
  const auto set = blossom({"run", "i.blossom", "--set", "import-1.control-points.degree-v=2", "-o", "two.blossom"});
  QCOMPARE(set.code, 0);
  const auto two = blossom({"info", "two.blossom"});
  QCOMPARE(two.json["result"]["degree_u"], Value(1));  // what was set before stays
  QCOMPARE(two.json["result"]["degree_v"], Value(2));
  QCOMPARE(blossom({"import", "roof.cpt", "--control-points.degree-u", "26"}).code, 2);
  QCOMPARE(blossom({"run", "i.blossom", "--set", "import-1.control-points.degree-w=2"}).code, 2);
}

void CliFilesTest::optionsOfAnotherFormatAreTold() {
  const auto imported = blossom({"import", "secret.off", "--control-points.degree-u", "1"});
  QCOMPARE(imported.code, 0);
  QCOMPARE(imported.json.at("warnings").size(), std::size_t{1});
  QVERIFY(imported.json.at("warnings").at(0).get<std::string>().find("not used") != std::string::npos);
  QVERIFY(blossom({"import", "secret.off"}).json.at("warnings").empty());
}

void CliFilesTest::programsKeepHowTheyAreRead() {
  writeAtomically(place("a.ngc"), "G21 G90 G94 G17\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X10\nG0 Z5\nM5\nM2\n");
  const auto converted = blossom({"convert", "a.ngc", "p.blossom", "--gcode.as", "contours"});
  QCOMPARE(converted.code, 0);
  QCOMPARE(blossom({"info", "p.blossom"}).json.at("result"), converted.json.at("result"));
  QVERIFY(converted.json.at("result").at("kind") != blossom({"info", "a.ngc"}).json.at("result").at("kind"));
}

void CliFilesTest::aStrangersDocumentReadsNothingOutsideItsFolder_data() {
  QTest::addColumn<QString>("path");
  QTest::newRow("absolute") << QString("ROOT/secret.off");
  QTest::newRow("up") << QString("../secret.off");
  QTest::newRow("up from below") << QString("below/../../secret.off");
  QTest::newRow("a link to the file") << QString("linked.off");
  QTest::newRow("a link to its folder") << QString("way/secret.off");
  QTest::newRow("a link and back") << QString("way/theirs/../secret.off");
}

void CliFilesTest::aStrangersDocumentReadsNothingOutsideItsFolder() {
  QFETCH(QString, path);
  path.replace("ROOT", folder_->path());
  fs::create_symlink(place("secret.off"), place("theirs/linked.off"));
  fs::create_directory_symlink(place(""), place("theirs/way"));
  const std::string text = path.toStdString();
  const QString document = QString::fromStdString(place("theirs/s.blossom").string());
  const auto infoIsRefused = [&](const char* from) {
    const auto info = blossom({"info", document}, from);
    ++ways_;
    read_ += info.json.at("result").empty() ? 0 : 1;
    QVERIFY2(errorOf(info).find("outside") != std::string::npos, info.json.dump().c_str());
    const auto allowed = blossom({"info", document, "--allow-files"}, from);
    COMPARE_NEAR(allowed.result("area"), 15, 1e-12);
    ++allowed_;
  };
  writeStranger("theirs/s.blossom", text);  // a plain text, which the format takes as well
  infoIsRefused("");
  writeStranger("theirs/s.blossom", {{"path", text}, {"asset", ""}});
  infoIsRefused("");
  infoIsRefused("theirs");
  QCOMPARE(blossom({"convert", document, "taken.stl"}).code, 1);
  QCOMPARE(blossom({"run", document, "--export", "taken.blossom"}).code, 1);
  QVERIFY(!fs::exists(place("taken.stl")));
  QVERIFY(openDocument(place("taken.blossom")).document.assets().empty());
}

void CliFilesTest::whatLiesBelowTheFolderIsReadFromWhereverOneStands() {
  fs::copy_file(place("secret.off"), place("theirs/below/part.off"));
  fs::create_directories(place("below"));
  writeAtomically(place("below/part.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");  // what the old way would read
  writeStranger("theirs/s.blossom", {{"path", "below/part.off"}, {"asset", ""}});
  const QString document = QString::fromStdString(place("theirs/s.blossom").string());
  for (const char* from : {"", "theirs", "elsewhere"})
    COMPARE_NEAR(blossom({"info", document}, from).result("area"), 15, 1e-12);
  COMPARE_NEAR(blossom({"info", "s.blossom"}, "theirs").result("area"), 15, 1e-12);
  // Saved elsewhere it carries the file in itself.
  QCOMPARE(blossom({"run", document, "--export", "moved.blossom"}, "elsewhere").code, 0);
  fs::remove_all(place("theirs"));
  COMPARE_NEAR(blossom({"info", "moved.blossom"}, "elsewhere").result("area"), 15, 1e-12);
}

void CliFilesTest::filesThatTheUserNamesAreRead() {
  writeStranger("theirs/s.blossom", {{"path", "/nowhere/at/all.off"}, {"asset", ""}});
  const auto set = blossom({"run", "theirs/s.blossom", "--set", "import-1.file=secret.off", "-o", "mine.blossom"});
  QVERIFY2(set.code == 0, set.json.dump().c_str());
  COMPARE_NEAR(blossom({"info", "mine.blossom"}, "").result("area"), 15, 1e-12);
}

void CliFilesTest::aStrangersFeatureStaysAStrangersInAnotherDocument() {
  writeStranger("theirs/s.blossom", {{"path", "../secret.off"}, {"asset", ""}});
  const auto refused = blossom({"convert", "theirs/s.blossom#import-1", "taken.blossom"});
  QCOMPARE(refused.code, 1);
  QVERIFY(refused.message().find("outside") != std::string::npos);
  QVERIFY(refused.hint().find("--allow-files") != std::string::npos);
  QVERIFY(!fs::exists(place("taken.blossom")));
  QCOMPARE(blossom({"convert", "theirs/s.blossom#import-1", "taken.blossom", "--allow-files"}).code, 0);
  COMPARE_NEAR(blossom({"info", "taken.blossom"}).result("area"), 15, 1e-12);
}

void CliFilesTest::aSavedDocumentTellsNoFolder() {
  QCOMPARE(blossom({"convert", QString::fromStdString(place("secret.off").string()), "s.blossom"}).code, 0);
  const Document document = openDocument(place("s.blossom")).document;
  QCOMPARE(document.at("import-1").parameters.at("file").at("path"), Value("secret.off"));
  QVERIFY(toJson(document).find(folder_->path().toStdString()) == std::string::npos);
}

void CliFilesTest::resourcesAreNotWritten() {
  // An installation in miniature: the program finds its resources by the variable.
  fs::create_directories(place("share/samples"));
  fs::copy_file(test::sample("bracket.blossom"), place("share/samples/bracket.blossom"));
  const std::string before = readFile(place("share/samples/bracket.blossom"));
  qputenv("BLOSSOM_RESOURCES", place("share").c_str());
  const auto over = blossom({"convert", "secret.off", "share/samples/bracket.blossom"});
  const auto beside = blossom({"convert", "secret.off", "share/samples/new.stl"});
  qunsetenv("BLOSSOM_RESOURCES");
  QCOMPARE(over.code, 1);
  QCOMPARE(beside.code, 1);
  QVERIFY(over.message().find("belongs to Blossom") != std::string::npos);
  QCOMPARE(readFile(place("share/samples/bracket.blossom")), before);
  QVERIFY(!fs::exists(place("share/samples/new.stl")));
}

/// Frames of an earlier run are inputs of the next one; also by a link, and by an absolute path.
void CliFilesTest::framesReplaceNoInput() {
  QCOMPARE(blossom({"morph", "polygon:3:20", "star:5:24:9", "--frames", "3", "-o", "w.dxf"}).code, 0);
  const std::string before = readFile(place("w-0002.dxf"));
  fs::create_symlink("w-0002.dxf", place("link.dxf"));
  const QString absolute = QString::fromStdString(place("w.dxf").string());
  for (const auto& [input, output] : std::vector<std::pair<QString, QString>>{
           {"w-0002.dxf", "w.dxf"}, {"./w-0002.dxf", absolute}, {"link.dxf", "w.dxf"}}) {
    const test::Answer answer = blossom({"morph", input, "circle:1", "--frames", "3", "-o", output});
    QCOMPARE(answer.code, 2);
    QVERIFY(readFile(place("w-0002.dxf")) == before);
  }
  // Fewer frames reach none.
  QCOMPARE(blossom({"morph", "w-0003.dxf", "circle:1", "--frames", "2", "-o", "w.dxf"}).code, 0);
}

BLOSSOM_TEST(CliFilesTest)
#include "cli_files_test.moc"
