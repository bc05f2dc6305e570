#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <numbers>

#include "exchange/format/format.h"
#include "support/command_line.h"
#include "support/modeling.h"
#include "support/planar_parts.h"

using namespace blossom;
using namespace blossom::test;

/// Pockets and simulations through the real command line.
class PocketCliTest : public QObject {
  Q_OBJECT

 private slots:
  void aProgramIsWrittenAndSimulated() {
    writePart("part.dxf");
    const Answer made =
        blossom({"pocket", "part.dxf", "--tool-diameter", "6", "--depth", "5", "--stepdown", "2", "-o", "part.ngc"});
    QCOMPARE(made.code, 0);
    QCOMPARE(made.json["feature"], Value("pocket.pocket"));
    QCOMPARE(made.json["result"]["kind"], Value("toolpath"));
    QCOMPARE(made.result("passes"), 3.0);
    QCOMPARE(made.result("residue_mm2"), 0.0);
    QVERIFY(made.result("gouge_mm") <= 0.005);
    QVERIFY(made.result("length_mm") > 0 && made.result("time_s") > 0);
    // by name and by place
    for (const QStringList& part : {QStringList{"--part", "part.dxf"}, QStringList{"part.dxf"}}) {
      const Answer swept = blossom(QStringList{"simulate", "part.ngc"} + part);
      QCOMPARE(swept.code, 0);
      QVERIFY(swept.result("gouge_mm") <= 0.0051);
      QCOMPARE(swept.result("residue_mm2"), 0.0);
      QCOMPARE(swept.json["stats"]["rapids_in_stock"], Value(0));
    }
    const Answer twice = blossom({"simulate", "part.ngc", "part.dxf", "--part", "part.dxf"});
    QVERIFY(twice.code != 0 && !twice.hint().empty());
    COMPARE_NEAR(blossom({"simulate", "part.ngc", "part.dxf", "--tool-diameter", "6.5"}).result("gouge_mm"), 0.25, 0.0051);
    COMPARE_NEAR(blossom({"simulate", "part.ngc", "part.dxf", "--depth", "4"}).result("gouge_mm"), 1, 1e-9);
    QVERIFY(blossom({"simulate", "part.ngc", "part.dxf", "--tool-diameter", "3"}).result("residue_mm2") > 10);
  }

  void theWorksZeroAndItsStock() {
    // a part whose lower left corner lies at (10, 20); the stock reaches 5 beyond it, 2 below the pocket
    const QStringList part{"pocket", "part.dxf", "--depth", "4"};
    writePart("part.dxf", {10, 20});
    for (const auto& [zero, height, low] : {std::tuple{"drawing", "top", Vec3(5, 15, -6)},
                                            {"corner", "top", Vec3(0, 0, -6)},
                                            {"center", "bottom", Vec3(-35, -25, 0)}}) {
      const Answer made =
          blossom(part + QStringList{"--zero", zero, "--zero-height", height, "--work-offset", "G55", "-o", "z.ngc"});
      QCOMPARE(made.code, 0);
      const Imported read = readShape(*theApp().formats, (folder_.path() + "/z.ngc").toStdString());
      const auto* path = read.shape.get<Toolpath>();
      QVERIFY(path);
      QCOMPARE(path->workOffset, std::string("G55"));
      QVERIFY((path->stock.low - low).norm() < 1e-9);
      QVERIFY((path->stock.high - low - Vec3(70, 50, 6)).norm() < 1e-9);
      QCOMPARE(blossom({"simulate", "z.ngc", "part.dxf"}).result("residue_mm2"), 0.0);
    }
  }

  void everyPostIsWritten() {
    for (const char* post : {"linuxcnc", "grbl", "mach3", "fanuc"}) {
      QCOMPARE(blossom({"pocket", "circle:20", "--post", post, "--gcode.unit", "inch", "-o", "post.nc"}).code, 0);
      QFile file(folder_.path() + "/post.nc");
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QByteArray program = file.readAll();
      QVERIFY(program.contains("G20") && program.contains("\nG3 "));
    }
  }

  void rubbishIsRefusedWithPlaceAndRemedy() {
    writePart("part.dxf");
    const auto refuses = [&](const QStringList& words, const char* said, const char* hint) {
      const Answer answer = blossom(words);
      QVERIFY2(answer.code == 1 || answer.code == 2, qPrintable(words.join(' ')));
      QVERIFY2(answer.message().find(said) != std::string::npos, answer.message().c_str());
      QVERIFY2(answer.hint().find(hint) != std::string::npos, answer.hint().c_str());
    };
    refuses({"pocket", "rectangle:60:8", "--tool-diameter", "10"}, "does not fit", "of 8 mm");
    refuses({"pocket", "part.dxf", "--stepover", "140%"}, "wider than the tool", "100 %");
    refuses({"pocket", "part.dxf", "--stepover", "much"}, "\"much\"", "45%");
    refuses({"pocket", "part.dxf", "--stepover", "nan"}, "nan", "45%");
    refuses({"pocket", "part.dxf", "--depth", "4", "--leave-floor", "4"}, "as thick as", "Leave less");
    refuses({"pocket", "part.dxf", "--depth", "4", "--stock-thickness", "3"}, "3 mm thick", "thicker");
    refuses({"pocket", "part.dxf", "--tool-corner", "4"}, "Corners of 4 mm", "half");
    refuses({"pocket", "missing.dxf"}, "missing.dxf", "");
    refuses({"simulate", "part.dxf", "part.dxf"}, "", "");
    Path open = boxPath(0, 0, 20, 20);
    open.segments.pop_back();
    open.closed = false;
    writeShape(*theApp().formats, Curves{{open}, FillRule::EvenOdd}, folder_.filePath("open.dxf").toStdString());
    refuses({"pocket", "open.dxf"}, "its only line runs from", "Close");
    write("bow.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9' width='9mm' height='9mm'>"
          "<path d='M0 0L9 9V0L0 6Z'/></svg>");
    refuses({"pocket", "bow.svg", "--tool-diameter", "1"}, "crosses itself near (3.6", "Redraw");
    write("air.ngc", "G21\nT1 M6\nS100 M3\nG0 Z5\nG1 X10 Y10 Z2 F100\nZ3\nM2\n");
    refuses({"simulate", "air.ngc", "part.dxf", "--tool-diameter", "3"}, "does not cut below", "zero");
    refuses({"simulate", "air.ngc", "part.dxf"}, "which tool", "--tool-diameter");
    // before anything is computed: else it would say that the tool does not fit
    refuses({"pocket", "circle:20", "--tool-diameter", "100", "-o", "part.stl"}, "cannot hold a toolpath", "a mesh");
  }

  // No M3, no T: taken for a drawing elsewhere, but here a program is asked for.
  void programsOfFewWordsAreSimulated() {
    write("bar.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 60' width='100mm' height='60mm'>"
          "<path d='M0 0H100V60H0Z'/></svg>");
    const std::string moves = "G0 Z5\nG0 X50 Y30\nG1 Z-2 F100\nX60\nG0 Z5\nM2\n";
    write("full.nc", ("G21 G90\nT1 M6\nS12000 M3\n" + moves).c_str());
    write("few.nc", ("G21 G90\n" + moves).c_str());
    const QStringList onBar{"--part", "bar.svg", "--depth", "2"}, tool{"--tool-diameter", "6"};
    const Answer toolless = blossom(QStringList{"simulate", "few.nc"} + onBar);
    QVERIFY2(toolless.message().find("which tool") != std::string::npos, toolless.message().c_str());
    QVERIFY2(toolless.hint().find("--tool-diameter") != std::string::npos, toolless.hint().c_str());
    const Answer full = blossom(QStringList{"simulate", "full.nc"} + onBar + tool),
                 few = blossom(QStringList{"simulate", "few.nc"} + onBar + tool);
    QCOMPARE(few.json["result"], full.json["result"]);
    QCOMPARE(few.json["warnings"].size(), full.json["warnings"].size() + 1);
    const std::string told = few.json["warnings"].dump();
    QVERIFY2(told.find("neither starts a spindle (M3) nor names a tool (T)") != std::string::npos, told.c_str());
    QVERIFY2(full.json["warnings"].dump().find("neither") == std::string::npos, full.json["warnings"].dump().c_str());
    // What cannot be followed is named, here too.
    write("drill.nc", "G21 G90\nG0 Z5\nG81 X5 Y5 Z-2 R1 F100\nG80\nM2\n");
    const Answer drilled = blossom(QStringList{"simulate", "drill.nc"} + onBar + tool);
    QVERIFY2(drilled.message().find("Line 3") != std::string::npos, drilled.message().c_str());
    QVERIFY2(drilled.hint().find("plain moves") != std::string::npos, drilled.hint().c_str());
  }

  void simulationsTellWhatWouldHurt() {
    write("plate.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 60' width='100mm' height='60mm'>"
          "<path d='M0 0H100V60H0Z'/></svg>");
    const QStringList onPlate{"--part", "plate.svg", "--tool-diameter", "6", "--depth", "2"};
    const auto warningsOf = [&](const char* program) {
      write("it.nc", program);
      const Answer answer = blossom(QStringList{"simulate", "it.nc"} + onPlate);
      return answer.json.value("warnings", Value::array()).dump();
    };
    const std::string begin = "G21 G90\nT1 M6\nS12000 M3\nG0 Z5\nG0 X50 Y30\n";
    // Of what a tool of 6 mm opens of the plate, a slot of 10 mm is cut.
    const Answer slot = [&] {
      write("slot.nc", (begin + "G1 Z-2 F100\nX60\nG0 Z5\nM2\n").c_str());
      return blossom(QStringList{"simulate", "slot.nc"} + onPlate);
    }();
    QCOMPARE(slot.json["warnings"].size(), std::size_t(1));
    const std::string left = slot.json["warnings"][0].get<std::string>();
    const double corners = (4 - std::numbers::pi) * 9, cut = 10 * 6 + std::numbers::pi * 9;
    COMPARE_NEAR(std::stod(left), 100 * 60 - corners - cut, 5);
    const std::size_t where = left.find(" near (");
    QVERIFY2(left.find("that the tool could reach are left") != std::string::npos && where != std::string::npos,
             left.c_str());
    double x = 0, y = 0;
    QCOMPARE(std::sscanf(left.c_str() + where, " near (%lf, %lf)", &x, &y), 2);
    QVERIFY(x > 0 && x < 100 && y > 0 && y < 60);
    QVERIFY(std::hypot(x - std::clamp(x, 50.0, 60.0), y - 30) > 3);  // not where it cut
    const auto tells = [&](const std::string& rest, const char* what) {
      const std::string told = warningsOf((begin + rest + "G0 Z5\nM2\n").c_str());
      QVERIFY2(told.find(what) != std::string::npos, told.c_str());
    };
    tells("G0 Z-2\nG1 X60 F100\n", "rapid runs through material, the first to (50.00, 30.00, -2.00)");
    tells("G1 Z-2 F100\nX99\n", "The part is gouged by 2.000 mm at");
    tells("G1 Z-2\nX60 F100\n", "ine 6 cuts without a feed above 0 (F)");
    tells("M5\nG1 Z-2 F100\n", "cuts while the spindle stands still");
    tells("(stock X -2 102 Y -2 62 Z -4 0)\nG1 Z-9 F100\n", "through the stock, which ends at z = -4.000");
    tells("M0\nG1 Z-2 F100\n", "is without its stops (M0)");
    // and with the line
    tells("G0 Z-2\nG1 X60 F100\n", "-2.00), line 6.");
    tells("G1 Z-2 F100\nX99\n", ", line 7.");
    tells("G1 Z-2.1 F100\nX60\n", "gouged by 0.100 mm at (50.000, 30.000, -2.100), line 6.");
    tells("G1 Z-1.9 F100\nX60\n", "floor at z = -2.000 is not reached: the deepest cut ends at z = -1.900, line 6.");
    write("turned.nc", (begin + "G68 X0 Y0 R10\nG1 Z-2 F100\nX60\nM2\n").c_str());
    const Answer turned = blossom(QStringList{"simulate", "turned.nc"} + onPlate);
    QCOMPARE(turned.code, 1);
    QVERIFY2(turned.message().find("Line 6: scaling or rotation (G68)") != std::string::npos, turned.message().c_str());
  }

  /// Without the depth nothing can be too deep: it comes from the program's head, or is asked for.
  void theDepthIsThatOfThePocket() {
    writePart("part.dxf");
    QCOMPARE(blossom({"pocket", "part.dxf", "--depth", "5", "--leave-floor", "0.5", "-o", "part.ngc"}).code, 0);
    const auto simulated = [&] { return blossom({"simulate", "part.ngc", "part.dxf"}); };
    QCOMPARE(simulated().json["warnings"].dump(), std::string("[]"));
    QVERIFY(simulated().result("gouge_mm") < 1e-3);
    const std::string text = read("part.ngc");
    std::string head = text.substr(0, text.find("(part X 0 Y 0 Z 0 depth 5 wall 0 floor 0.5)"));
    QVERIFY(head.size() < text.size());
    std::string deeper = text;
    for (std::size_t at = 0; (at = deeper.find("Z-4.5", at)) != std::string::npos; at += 5) deeper.replace(at, 5, "Z-4.6");
    write("part.ngc", deeper.c_str());
    COMPARE_NEAR(simulated().result("gouge_mm"), 0.1, 1e-9);
    // Without the head nobody knows.
    write("part.ngc", text.substr(text.find("G21")).c_str());
    const std::string told = blossom({"simulate", "part.ngc", "part.dxf", "--tool-diameter", "6"}).json["warnings"].dump();
    QVERIFY2(told.find("tells how deep the pocket is") != std::string::npos && told.find("--depth") != std::string::npos,
             told.c_str());
  }

  /// The part lies at its zero, wherever the stock has its middle.
  void thePartLiesAtItsZero() {
    write("plate.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 60' width='100mm' height='60mm'>"
          "<path d='M0 0H100V60H0Z'/></svg>");
    write("it.nc",
          "(stock X -5 125 Y -5 65 Z -10 0)\nG21 G90\nT1 M6\nS9000 M3\nG0 X3 Y3 Z5\nG1 Z-2 F100\nX97\nY57\nX3\nY3\n"
          "G0 Z5\nM2\n");
    const Answer swept = blossom({"simulate", "it.nc", "plate.svg", "--tool-diameter", "6", "--depth", "2"});
    COMPARE_NEAR(swept.result("gouge_mm"), 0, 1e-9);
    QCOMPARE(swept.json["warnings"].size(), std::size_t(1));  // only of what lies within the way around
    COMPARE_NEAR(std::stod(swept.json["warnings"][0].get<std::string>()), 88 * 48, 6);
    // One made for a part elsewhere does not fit, whatever its zero.
    writePart("part.dxf", {10, 20});
    writePart("beside.dxf", {10.2, 20});
    for (const char* zero : {"drawing", "corner", "center"}) {
      QCOMPARE(blossom({"pocket", "beside.dxf", "--zero", zero, "-o", "beside.ngc"}).code, 0);
      COMPARE_NEAR(blossom({"simulate", "beside.ngc", "beside.dxf"}).result("gouge_mm"), 0, 1e-3);
      COMPARE_NEAR(blossom({"simulate", "beside.ngc", "part.dxf"}).result("gouge_mm"), 0.2, 1e-3);
    }
  }

  /// What is told is what stands in the file.
  void theProgramIsMeasuredAsItIsWritten() {
    writePart("part.dxf", {0.3, 0.7});
    const Answer coarse =
        blossom({"pocket", "part.dxf", "--gcode.unit", "inch", "--gcode.decimals", "2", "-o", "coarse.ngc"});
    QCOMPARE(coarse.code, 0);
    const double swept = blossom({"simulate", "coarse.ngc", "part.dxf"}).result("gouge_mm");
    QVERIFY2(swept > 0.002, std::to_string(swept).c_str());  // planned without any
    COMPARE_NEAR(coarse.result("gouge_mm"), swept, 1e-9);
    QVERIFY(coarse.json["warnings"].dump().find("--gcode.decimals") != std::string::npos);
    QVERIFY(read("coarse.ngc").find(QString("as it stands here: gouge %1 mm").arg(swept, 0, 'f', 4).toStdString()) !=
            std::string::npos);
    const Answer fine = blossom({"pocket", "part.dxf", "-o", "fine.ngc"});
    QCOMPARE(fine.json["warnings"].dump(), std::string("[]"));
    QVERIFY(fine.result("gouge_mm") < 2e-3);
  }

  void whatIsHardlyMeantIsTold() {
    writePart("part.dxf");
    const auto tells = [&](const QStringList& flags, const char* what, const char* remedy) {
      const Answer made = blossom(QStringList{"pocket", "part.dxf"} + flags);
      QCOMPARE(made.code, 0);
      const std::string told = made.json["warnings"].dump();
      QVERIFY2(told.find(what) != std::string::npos && told.find(remedy) != std::string::npos, told.c_str());
    };
    tells({"--depth", "80", "--tool-diameter", "3"}, "80 mm deep, 26.7 times", "at least 16 mm");
    tells({"--safe-height", "0.001"}, "only 0.001 mm above the stock", "at least 1 mm");
    tells({"--approach", "0.001"}, "only 0.001 mm above the material", "at least 0.1 mm");
    tells({"--depth", "20", "--stepdown", "20"}, "Each pass is 20 mm deep", "at most 12 mm");
    tells({"--plunge-feed", "900"}, "900 mm a minute", "at most 800");
    tells({"--spindle", "100"}, "8 mm in each turn", "turn faster");
    QCOMPARE(blossom({"pocket", "part.dxf"}).json["warnings"].dump(), std::string("[]"));
  }

  void aPartIsTextByFlags() {
    const QStringList tool{"--tool-diameter", "0.5", "--depth", "1"};
    const Answer written = blossom(QStringList{"pocket", "text:Blossom"} + tool);
    const Answer made = blossom(QStringList{"pocket", "--text", "Blossom", "--font", "DejaVuSans", "-o", "text.ngc"} + tool);
    QCOMPARE(made.code, 0);
    QCOMPARE(made.result("length_mm"), written.result("length_mm"));
    const Answer high = blossom({"offset", "--text", "Hi", "--text.height", "30", "--text.style", "bold", "--distance", "1",
                                 "--side", "outside", "-o", "hi.dxf,hi.blossom"});
    QCOMPARE(high.code, 0);
    QCOMPARE(high.result("components"), 3.0);  // H, i and its dot
    // the text is a feature of the document that comes out
    QCOMPARE(blossom({"run", "hi.blossom"}).json["features"][0]["type"], Value("modeling.text"));
    // the part of a simulation stands behind the program, wherever the flags do
    QCOMPARE(blossom({"simulate", "--text", "Blossom", "text.ngc"}).result("residue_mm2"), 0.0);
    QCOMPARE(blossom({"minkowski-sum", "circle:1", "--text", "O"}).code, 0);
  }

  void flagsThatMakeAnInputAreRefused() {
    const Answer alone = blossom({"pocket", "circle:20", "--font", "DejaVu Sans"});
    QCOMPARE(alone.code, 2);
    QVERIFY(alone.message().find("--font") != std::string::npos && alone.hint().find("--text") != std::string::npos);
    QCOMPARE(blossom({"pocket", "--text", "O", "--tool", "3"}).hint(),
             std::string("Did you mean --tool-diameter, --tool-corner or --tool-number?"));
    QCOMPARE(blossom({"minkowski", "circle:1"}).hint(), std::string("Did you mean minkowski-sum or minkowski-difference?"));
    const Answer two = blossom({"pocket", "circle:20", "--text", "O"});  // two parts
    QCOMPARE(two.code, 2);
    QVERIFY2(two.hint().starts_with("--text makes one of them"), two.hint().c_str());
    const Answer font = blossom({"pocket", "--text", "O", "--font", "No Such Font"});
    QVERIFY(font.code == 1 && font.message().find("No Such Font") != std::string::npos);
    QCOMPARE(blossom({"pocket", "--text", "O", "--text.height", "-3"}).code, 2);
    QCOMPARE(blossom({"pocket", "--text", ""}).code, 1);
    QCOMPARE(blossom({"text", "--text.height", "3"}).code, 2);  // where it is the command itself, its flags are plain
  }

  /// Of a rectangle: its middle line, and four edges that rise as they go in.
  void medialAxesAreWrittenInSpace() {
    write("bar.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 60 40' width='60mm' height='40mm'><path d='M0 "
          "0H60V40H0Z'/></svg>");
    const double inSpace = 20 + 4 * 20 * std::sqrt(3.0), flat = 20 + 4 * 20 * std::sqrt(2.0);
    for (const char* file : {"axis.step", "axis.brep", "axis.iges"}) {
      QCOMPARE(blossom({"medial-axis", "bar.svg", "-o", file}).code, 0);
      COMPARE_NEAR(blossom({"info", file}).result("length"), inSpace, 1e-9);
    }
    QCOMPARE(blossom({"medial-axis", "bar.svg", "--step.no-heights", "-o", "flat.step"}).code, 0);
    COMPARE_NEAR(blossom({"info", "flat.step"}).result("length"), flat, 1e-9);
    QCOMPARE(blossom({"medial-axis", "bar.svg", "-o", "flat.dxf"}).code, 0);
    QVERIFY(read("flat.dxf").find("AcDb3dPolyline") == std::string::npos);
    QCOMPARE(blossom({"medial-axis", "bar.svg", "--dxf.heights", "-o", "axis.dxf"}).code, 0);
    QVERIFY(read("axis.dxf").find("AcDb3dPolyline") != std::string::npos);
    const Value axis = blossom({"medial-axis", "bar.svg"}).json["result"]["axis"];
    QCOMPARE(axis["vertices"].size(), std::size_t(6));
    for (const Value& edge : axis["edges"]) {
      QCOMPARE(edge["feet"].size(), edge["points"].size());
      for (std::size_t i = 0; i < edge["points"].size(); ++i)
        for (const Value& foot : edge["feet"][i])
          COMPARE_NEAR(std::hypot(foot["at"][0].get<double>() - edge["points"][i][0].get<double>(),
                                  foot["at"][1].get<double>() - edge["points"][i][1].get<double>()),
                       edge["points"][i][2].get<double>(), 1e-9);
    }
  }

  void theSamplesHoldTheirPockets() {
    for (const char* name : {"pocket-cover.blossom", "pocket-sign.blossom", "clamped-block.blossom"}) {
      const Answer run = blossom({"run", QString::fromStdString(sample(name).string())});
      QCOMPARE(run.code, 0);
      const Value& last = run.json["features"].back();
      QCOMPARE(last["result"]["kind"], Value("toolpath"));
      QCOMPARE(last["result"]["residue_mm2"], Value(0.0));
    }
  }

 private:
  void write(const char* name, const char* text) const {
    QFile file(folder_.filePath(QLatin1String(name)));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  std::string read(const char* name) const {
    QFile file(folder_.filePath(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
  }
  /// A plate of 60 x 40 with a round island.
  void writePart(const char* name, const Vec2& at = {0, 0}) const {
    const Curves part{{boxPath(at.x(), at.y(), at.x() + 60, at.y() + 40), circlePath(at + Vec2(30, 20), 8, true)},
                      FillRule::EvenOdd};
    writeShape(*theApp().formats, part, folder_.filePath(QLatin1String(name)).toStdString());
  }
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(PocketCliTest)
#include "pocket_cli_test.moc"
