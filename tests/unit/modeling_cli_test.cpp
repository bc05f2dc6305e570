#include <QTemporaryDir>

#include "support/command_line.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

/// Ordinary CAD through the real command line.
class ModelingCliTest : public QObject {
  Q_OBJECT

 private slots:
  void aDrilledRoundedPlate() {
    COMPARE_NEAR(volumeOf({"box", "--width", "60", "--depth", "40", "--height", "10", "-o", "plate.step"}), 24000, 1e-9);
    COMPARE_NEAR(volumeOf({"cylinder", "--radius", "5", "--position", "30,20,-5", "-o", "pin.step"}), 750 * pi, 1e-9);
    const Answer drilled = blossom({"boolean", "plate.step", "pin.step", "--operation", "difference", "-o", "drilled.step"});
    QCOMPARE(drilled.code, 0);
    COMPARE_NEAR(drilled.json["result"]["volume"].get<double>(), 24000 - 250 * pi, 1e-6);
    QCOMPARE(drilled.json["result"]["genus"], Value(1));
    const Answer rounded = blossom({"fillet", "plate.step", "--radius", "2", "-o", "soft.step"});
    const double steiner = 56 * 36 * 6 + 4 * (56 * 36 + 36 * 6 + 6 * 56) + 4 * pi * (56 + 36 + 6) + 32 * pi / 3;
    COMPARE_NEAR(rounded.json["result"]["volume"].get<double>(), steiner, 1e-5 * steiner);
    QCOMPARE(rounded.json["stats"]["rounded_edges"], Value(12));
  }

  void drawingsBecomeSolids() {
    COMPARE_NEAR(areaOf({"rectangle", "--width", "30", "--height", "20", "--centre", "25,0,0", "-o", "r.dxf"}), 600, 1e-9);
    COMPARE_NEAR(volumeOf({"extrude", "r.dxf", "--height", "5", "-o", "e.step"}), 3000, 1e-9);
    COMPARE_NEAR(volumeOf({"revolve", "r.dxf", "-o", "v.step"}), 600 * 2 * pi * 25, 1e-6);
    COMPARE_NEAR(areaOf({"circle", "--radius", "2", "-o", "c.svg"}), 4 * pi, 1e-9);
    const Answer pipe = blossom({"pipe", "c.svg", "r.dxf", "-o", "frame.step"});
    QCOMPARE(pipe.code, 0);
    COMPARE_NEAR(pipe.json["result"]["volume"].get<double>(), 4 * pi * 100, 1e-3);
    QCOMPARE(pipe.json["result"]["genus"], Value(1));
  }

  void edgesAreNamedInWords() {
    blossom({"box", "-o", "box.step"});
    const Answer two =
        blossom({"chamfer", "box.step", "--edges", "shape:edge:0,shape:edge:6", "--distance", "1", "-o", "c.step"});
    QCOMPARE(two.code, 0);
    QCOMPARE(two.json["stats"]["chamfered_edges"], Value(2));
    const Answer tooMuch = blossom({"fillet", "box.step", "--edges", "shape:edge:3", "--radius", "25", "-o", "f.step"});
    QCOMPARE(tooMuch.code, 1);
    const auto message = tooMuch.json["error"]["message"].get<std::string>();
    QVERIFY2(message.starts_with("Edge 3 cannot be rounded with 25 mm: the largest radius here is about "), message.c_str());
    QVERIFY(!fs::exists(fs::path(folder_.path().toStdString()) / "f.step"));
    const Answer missing = blossom({"fillet", "box.step", "--edges", "shape:edge:12", "-o", "f.step"});
    QCOMPARE(missing.json["error"]["code"], Value("NotFound"));
    const Answer stranger = blossom({"fillet", "box.step", "--edges", "nonsense:edge:3", "-o", "f.step"});
    QCOMPARE(stranger.code, 1);
    QCOMPARE(stranger.message(), "\"nonsense:edge:3\" names no input of Fillet.");
    QCOMPARE(stranger.hint(), "Its input is called \"shape\".");
    QCOMPARE(blossom({"fillet", "box.step", "--edges", "edge:3", "-o", "f.step"}).code, 0);
  }

  void everyFeatureExplainsItself() {
    for (const auto& type : theApp().registry->types()) {
      if (!type->id.starts_with("modeling.")) continue;
      QProcess help;
      help.start(blossomProgram(), {QString::fromStdString(type->command), "--help"});
      QVERIFY(help.waitForFinished(-1));
      QCOMPARE(help.exitCode(), 0);
      const QString text = help.readAllStandardOutput();
      for (const ParameterSpec& spec : type->parameters) {
        const QString name = QString::fromStdString(spec.name);
        QVERIFY2(text.contains("--" + name) || text.contains("--[no-]" + name), qPrintable(text));
      }
      QVERIFY2(!type->examples.empty(), type->id.c_str());
      QVERIFY2(fs::exists(sourceFolder() / "resources/icons" / (type->icon + ".svg")), type->id.c_str());
      for (const std::string& example : type->examples)
        QVERIFY2(example.starts_with("blossom " + type->command), example.c_str());
    }
  }

  void theSampleDocumentsAreWhole() {
    for (const auto& entry : fs::directory_iterator(sourceFolder() / "resources/samples")) {
      if (entry.path().extension() != ".blossom") continue;
      const Answer info = blossom({"info", QString::fromStdString(entry.path().string())});
      QVERIFY2(info.code == 0, entry.path().c_str());
      if (info.json["result"]["kind"] == Value("solid"))
        QVERIFY2(info.json["result"]["closed"] == Value(true), entry.path().c_str());
    }
  }

 private:
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }
  double resultOf(const QStringList& arguments, const char* name) {
    const Answer ran = blossom(arguments);
    return ran.code == 0 ? ran.result(name) : std::nan("");
  }
  double volumeOf(const QStringList& arguments) { return resultOf(arguments, "volume"); }
  double areaOf(const QStringList& arguments) { return resultOf(arguments, "area"); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(ModelingCliTest)
#include "modeling_cli_test.moc"
