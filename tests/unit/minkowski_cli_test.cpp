#include <QFile>
#include <QTemporaryDir>

#include "parameter/start_value.h"
#include "support/minkowski_answers.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

/// Sums and differences through the real command line.
class MinkowskiCliTest : public QObject {
  Q_OBJECT

 private slots:
  void sumsAndDifferencesOfLiterals() {
    const Answer sum = blossom({"minkowski-sum", "rectangle:40:10", "rectangle:5:6", "-o", "sum.svg"});
    QCOMPARE(sum.code, 0);
    COMPARE_NEAR(sum.result("area"), 45 * 16, 1e-9);
    QCOMPARE(sum.json["feature"], Value("minkowski.minkowski-sum"));
    QCOMPARE(sumsOf(sum), 1);
    const Answer room = blossom({"minkowski-difference", "rectangle:40:30", "rectangle:10:10", "-o", "room.dxf"});
    COMPARE_NEAR(room.result("area"), 30 * 20, 1e-9);
    const Answer rounded = blossom({"minkowski-sum", "rectangle:40:10", "circle:2", "--tolerance", "1e-4"});
    COMPARE_NEAR(rounded.result("area"), 400 + 100 * 2 + 4 * pi, 1e-9);
    const Answer weighted = blossom({"minkowski-sum", "rectangle:4:2", "circle:3", "--weights", "2,-1"});
    COMPARE_NEAR(weighted.result("area"), 8 * 4 + 3 * 24 + 9 * pi, 1e-9);
    const Answer opened = blossom({"region-open", "rectangle:40:10", "circle:2", "-o", "opened.dxf"});
    COMPARE_NEAR(opened.result("area"), 400 - 16 + 4 * pi, 1e-9);
    QCOMPARE(opened.result("arcs"), 4.0);
  }

  /// Curves of degree 1 are lines, which stay lines.
  void segmentsAreLines() {
    const Answer stadium = blossom({"minkowski-sum", "segment:10:0:0", "circle:1"});
    COMPARE_NEAR(stadium.result("area"), 20 + pi, 1e-12);
    QCOMPARE(stadium.result("lines"), 2.0);
    QCOMPARE(stadium.result("arcs"), 2.0);
  }

  /// What would vanish on the grid of so large a shape is refused with its width.
  void whatIsTooThinForItsLengthIsRefused() {
    for (const char* command : {"minkowski-sum", "morph"}) {
      const Answer thin = blossom({command, "rectangle:1e7:1e-6", "circle:1"});
      QCOMPARE(thin.code, 1);
      QVERIFY2(thin.message().find("only 1e-06 mm wide") != std::string::npos, thin.message().c_str());
    }
    COMPARE_NEAR(blossom({"minkowski-sum", "rectangle:1e6:1e-6", "circle:1"}).result("area"), 2e6 + pi + 1, 0.1);
  }

  void copiesAndHulls() {
    const Answer three = blossom({"region-repeat", "rectangle:4:2", "--count", "3"});
    COMPARE_NEAR(three.result("area"), 9 * 8, 1e-9);
    const Answer many = blossom({"region-repeat", "star:5:20:8", "--count", "100000", "--normalised"});
    const Answer hull = blossom({"region-hull", "star:5:20:8"});
    COMPARE_NEAR(hull.result("area"), 2.5 * 400 * std::sin(2 * pi / 5), 1e-9);
    COMPARE_NEAR(many.result("area"), hull.result("area"), 1e-9);
    QVERIFY(many.json["stats"]["is_hull"].get<bool>() && many.json["warnings"].size() == 1);
    const Answer few = blossom({"region-repeat", "star:5:20:8", "--count", "10", "--normalised"});
    QVERIFY(few.json["stats"]["hull_distance"].get<double>() < few.json["stats"]["hull_bound"].get<double>());
    QCOMPARE(sumsOf(few), 4);
  }

  /// h (|A| + V(A, B) + |B|) / 3 of squares of 4 and 2 is 10 (16 + 8 + 4) / 3.
  void solidsBetweenOutlines() {
    const Answer box = blossom({"morph-solid", "rectangle:4:4", "rectangle:4:4", "--height", "10", "-o", "box.step"});
    QCOMPARE(box.code, 0);
    COMPARE_NEAR(box.result("volume"), 160, 1e-9);
    QCOMPARE(box.result("faces"), 6.0);
    const Answer frustum = blossom({"morph-solid", "rectangle:4:4", "rectangle:2:2", "--height", "10", "-o", "frustum.stl"});
    COMPARE_NEAR(frustum.result("volume"), 10 * 28 / 3.0, 1e-9);
    QVERIFY(blossom({"morph-solid", "rectangle:4:4", "rectangle:2:2", "circle:1"}).code != 0);
    QVERIFY(blossom({"morph-solid", "rectangle:4:4", "rectangle:2:2", "--height", "0"}).code != 0);
  }

  /// Where no helper process can start, short sums go on and long ones say so; with one they give what the kernel gives.
  void longSumsRunInTheWorkerAndShortOnesHere() {
    const QStringList small{"minkowski-sum", "star:5:20:8", "star:6:20:8"},
        large{"minkowski-sum", "star:300:50:10", "star:301:40:8"};
    const QByteArray worker = qgetenv("BLOSSOM_WORKER");
    qputenv("BLOSSOM_WORKER", "/nonexistent");
    const Answer here = blossom(small), none = blossom(large);
    worker.isNull() ? qunsetenv("BLOSSOM_WORKER") : qputenv("BLOSSOM_WORKER", worker);
    QCOMPARE(here.code, 0);
    QCOMPARE(none.code, 1);
    QCOMPARE(none.json["error"]["code"], Value("FileNotFound"));
    const Answer apart = blossom(large);
    QCOMPARE(apart.code, 0);
    QCOMPARE(sumsOf(apart), 1);
    QVERIFY(apart.result("area") > 0 && apart.result("components") == 1);
    QVERIFY(apart.json["stats"].contains("worker_ms") && !here.json["stats"].contains("worker_ms"));
  }

  /// The numbers and names that documents of earlier versions hold.
  void oldValuesAreStillTaken() {
    for (const char* way : {"recursive", "bottom-up", "explicit"})
      QCOMPARE(blossom({"morph", "star:3:20:8", "circle:9", "--evaluation", way, "--tolerance", "0.01"}).code, 0);
    const Answer coarse = blossom({"minkowski-sum", "circle:0.001", "circle:0.001", "--tolerance", "0.01"});
    QCOMPARE(coarse.json["error"]["code"], Value("InvalidParameter"));
    QVERIFY2(coarse.hint().find("0.00019 mm") != std::string::npos, coarse.hint().c_str());
    COMPARE_NEAR(blossom({"minkowski-sum", "circle:0.001", "circle:0.001"}).result("area"), 4e-6 * pi, 4e-9);
  }

  void rubbishIsRefusedWithPlaceAndRemedy() {
    const struct {
      const char *name, *drawing, *says;
    } cases[] = {
        {"open.svg", "<path fill='none' stroke='black' d='M0 0H20V20'/>", "open"},
        {"crossing.svg", "<path d='M0 0L20 20V2L0 6Z'/>", "crosses itself at (5, 15)"},
        {"flat.svg", "<path d='M0 0H20H5Z'/>", "enclose no area"},
        {"empty.svg", "", "enclose no area"},
        {"nan.svg", "<path d='M0 0LNaN 20V0Z'/>", "cannot be understood"},
        {"cut.svg", "<path d='M0 0H20V", "cannot be read"},
    };
    for (const auto& each : cases) {
      QFile file(folder_.filePath(QLatin1String(each.name)));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write("<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm' viewBox='0 0 20 20'>");
      file.write(each.drawing);
      if (each.name != std::string("cut.svg")) file.write("</svg>");
      file.close();
      for (const char* command : {"minkowski-sum", "minkowski-difference", "morph"}) {
        if (each.name == std::string("open.svg") && command != std::string("morph")) continue;  // a curve will do
        const Answer answer = blossom({command, "rectangle:40:30", each.name});
        QVERIFY2(answer.code == 1, each.name);
        QVERIFY2(answer.message().find(each.says) != std::string::npos, answer.message().c_str());
        QVERIFY2(!answer.hint().empty(), answer.message().c_str());
      }
    }
    const Answer solid = blossom({"minkowski-sum", "ball:5:1", "circle:5"});
    QVERIFY(solid.code == 1);
  }

  void curvesAndPointsAreAdded() {
    QFile file(folder_.filePath("hook.svg"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm' viewBox='0 0 20 20'>"
        "<path fill='none' stroke='black' d='M0 0H20'/></svg>");
    file.close();
    const Answer stadium = blossom({"minkowski-sum", "hook.svg", "circle:2", "-o", "stadium.dxf"});
    COMPARE_NEAR(stadium.result("area"), 80 + 4 * pi, 1e-9);
    QVERIFY(stadium.result("arcs") == 2 && stadium.result("lines") == 2);
    COMPARE_NEAR(areaInFile(fs::path(folder_.path().toStdString()) / "stadium.dxf"), 80 + 4 * pi, 1e-6);
    COMPARE_NEAR(blossom({"minkowski-difference", "rectangle:40:30", "hook.svg"}).result("area"), 20 * 30, 1e-9);
    const Answer moved = blossom({"minkowski-sum", "rectangle:4:3", "point:5:-6", "-o", "moved.svg"});
    COMPARE_NEAR(moved.result("area"), 12, 1e-12);
    const Answer curve = blossom({"minkowski-sum", "hook.svg", "point:1:1", "-o", "curve.svg"});
    QCOMPARE(curve.json["result"]["kind"], Value("curves"));
    QCOMPARE(curve.result("length"), 20.0);
    const Answer line = blossom({"minkowski-sum", "hook.svg", "hook.svg"});
    QCOMPARE(line.json["error"]["code"], Value("Degenerate"));
  }

  /// A square of which one side is an arc of a circle that is larger than all shapes: what is drawn of it counts.
  void nearlyStraightArcs() {
    for (const char* radius : {"1e8", "1e9"}) {
      QFile file(folder_.filePath("flat.svg"));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(QStringLiteral("<svg xmlns='http://www.w3.org/2000/svg' width='30mm' height='30mm' viewBox='0 0 30 30'>"
                                "<path d='M10 10 L20 10 L20 20 A%1 %1 0 0 1 10 20 Z'/></svg>")
                     .arg(QString::fromLatin1(radius))
                     .toUtf8());
      file.close();
      const double r = 0.002;
      const Answer grown = blossom({"minkowski-sum", "flat.svg", "circle:0.002", "--tolerance", "1e-5"});
      QCOMPARE(grown.code, 0);
      COMPARE_NEAR(grown.result("area"), 100 + 40 * r + pi * r * r, 5e-4);
    }
  }

  /// Nothing is a shape: what is made of it says so.
  void nothingIsLeft() {
    const Answer none =
        blossom({"minkowski-difference", "rectangle:4:3", "circle:5", "-o", "none.svg", "-o", "none.blossom"});
    QCOMPARE(none.code, 0);
    QCOMPARE(none.result("area"), 0.0);
    QVERIFY(none.json["stats"]["empty"].get<bool>() && none.json["warnings"].size() == 1);
    QVERIFY(none.json["warnings"][0].get<std::string>().starts_with("Nothing is left: "));
    const Answer sum = blossom({"minkowski-sum", "none.blossom", "circle:5"});
    QVERIFY(sum.code == 0 && sum.result("area") == 0 && sum.json["warnings"].size() >= 1);
    for (const QStringList& next :
         {QStringList{"extrude", "none.blossom", "--height", "3"}, QStringList{"morph", "none.blossom", "circle:5"},
          QStringList{"region-hull", "none.blossom"}, QStringList{"offset", "none.blossom", "--distance", "1"}}) {
      const Answer refused = blossom(next);
      QCOMPARE(refused.code, 1);
      QVERIFY2(refused.message().find("empty") != std::string::npos, refused.message().c_str());
    }
    const Answer opened = blossom({"region-open", "none.blossom", "circle:1"});
    QVERIFY(opened.code == 0 && opened.result("area") == 0 && opened.json["stats"].value("empty", false));
    const Answer moved = blossom({"minkowski-difference", "rectangle:4:3", "point:1:1"});
    QVERIFY(moved.code == 0 && moved.result("area") == 12.0 && !moved.json["stats"].value("empty", false));
  }

  /// One that a form adds for each shape leaves the sum as it is.
  void aNewWeightIsOne() {
    const auto type = theApp().registry->at("minkowski.minkowski-sum");
    const auto weights = std::find_if(type->parameters.begin(), type->parameters.end(),
                                      [](const ParameterSpec& each) { return each.name == "weights"; });
    QVERIFY(weights != type->parameters.end());
    QCOMPARE(startValue(weights->fields.front()), Value(1.0));
    QCOMPARE(weights->filling.input, std::string("shape"));
  }

  void everyFeatureExplainsItself() {
    int found = 0;
    for (const auto& type : theApp().registry->types()) {
      if (!type->id.starts_with("minkowski.")) continue;
      ++found;
      QVERIFY2(!type->examples.empty(), type->id.c_str());
      QVERIFY2(fs::exists(sourceFolder() / "resources/icons" / (type->icon + ".svg")), type->id.c_str());
    }
    QCOMPARE(found, 10);
  }

 private:
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(MinkowskiCliTest)
#include "minkowski_cli_test.moc"
