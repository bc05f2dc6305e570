#include <fmt/format.h>

#include <QTemporaryDir>
#include <array>

#include "support/minkowski_answers.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

/// Morphs through the real command line.
class MinkowskiMorphCliTest : public QObject {
  Q_OBJECT

 private slots:
  /// Squares of side 4 and 2: matched vertices and sums give squares, distance fields round their corners.
  void waysToMorphAreCompared() {
    const Answer table = blossom({"morph-compare", "rectangle:4:4", "rectangle:2:2", "--steps", "3", "-o", "compared.dxf"});
    QCOMPARE(table.code, 0);
    const Value& stats = table.json["stats"];
    QCOMPARE(stats["times"], Value({0.0, 0.5, 1.0}));
    for (std::size_t k = 0; k < 3; ++k) {
      const double square = std::pow(4.0 - static_cast<double>(k), 2);
      COMPARE_NEAR(stats["area_by_vertices"][k].get<double>(), square, 1e-9);
      COMPARE_NEAR(stats["area_by_sums"][k].get<double>(), square, 1e-9);
      COMPARE_NEAR(stats["area_by_fields"][k].get<double>(), square, 0.02 * square);
    }
    QCOMPARE(stats["crossings_by_vertices"], Value({0, 0, 0}));
    QCOMPARE(table.json["result"]["kind"], Value("curves"));
    QCOMPARE(table.json["result"]["curves"], Value(9 + 4));  // with the areas over t
    QVERIFY(table.json.value("warnings", Value::array()).empty());
    const Answer frames = blossom({"morph-compare", "rectangle:4:4", "circle:2", "--frames", "4", "--resolution", "40"});
    QCOMPARE(frames.json["result"]["kind"], Value("sequence"));
    QCOMPARE(frames.json["result"]["frames"], Value(4));
    QVERIFY(blossom({"morph-compare", "rectangle:4:4", "circle:2", "circle:3"}).code != 0);
    // Nothing matches the vertices of a ring: two rows are left.
    QCOMPARE(blossom({"boolean", "circle:9", "circle:4", "--operation", "difference", "-o", "ring.dxf"}).code, 0);
    const Answer ring = blossom({"morph-compare", "ring.dxf", "circle:5", "--steps", "2"});
    QCOMPARE(ring.code, 0);
    QVERIFY(!ring.json["stats"].contains("area_by_vertices"));
    QCOMPARE(ring.json["warnings"].size(), std::size_t{1});
    QCOMPARE(ring.json["result"]["curves"], Value(6 + 3));
  }

  /// Under the columns, as high as the areas are large: 16, 9, 4.
  void areasOfComparedWaysAreDrawnOverTime() {
    const Evaluated compared = made("morph-compare", {{"steps", 3}}, {rectangle(0, 0, 4, 4), rectangle(0, 0, 2, 2)});
    const Curves& picture = *compared.shape.get<Curves>();
    const auto isOpen = [](const Path& path) { return !path.closed; };
    const auto axes = std::ranges::find_if(picture.paths, isOpen);
    QVERIFY(axes != picture.paths.end() && axes->layer == "axes");
    const Vec2 origin = startPoint(axes->segments.back()), top = startPoint(axes->segments.front());
    const auto curve = std::ranges::find_if(
        picture.paths, [&](const Path& path) { return isOpen(path) && path.layer == "minkowski sums"; });
    QVERIFY(curve != picture.paths.end());
    QCOMPARE(curve->segments.size(), std::size_t{2});
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 at = (k < 2 ? startPoint(curve->segments[k]) : endPoint(curve->segments[1])) - origin;
      COMPARE_NEAR(at.y() / (top - origin).y(), std::pow(4.0 - static_cast<double>(k), 2) / 16, 1e-9);
      COMPARE_NEAR(at.x(), 4.8 * static_cast<double>(k), 1e-9);
    }
  }

  void splinesOfShapesAndSectors() {
    const QStringList discs{"morph", "circle:2", "circle:4", "circle:6", "circle:3"};
    const Answer spline = blossom(discs + QStringList{"--degree", "2", "--t", "0.25"});
    // Knots 0 0 0 1 2 2 2 at 0.5: 1/4, 5/8, 1/8.
    COMPARE_NEAR(spline.result("area"), pi * std::pow(2 * 0.25 + 4 * 0.625 + 6 * 0.125, 2), 1e-9);
    QCOMPARE(spline.json["stats"]["continuity"], Value(1));
    QCOMPARE(spline.json["stats"]["influences"], Value({0.25, 0.625, 0.125, 0.0}));
    const Answer given = blossom(discs + QStringList{"--degree", "2", "--t", "0.25", "--knots", "0,0,0,1,2,2,2"});
    COMPARE_NEAR(given.result("area"), spline.result("area"), 1e-12);
    QVERIFY(blossom(discs + QStringList{"--knots", "0,0,0,1,2,2"}).code != 0);
    QVERIFY(blossom(discs + QStringList{"--degree", "2", "--blossom", "0.1,0.2,0.3"}).code != 0);
    // Half of the second disc: the upper one, about the first disc's centre.
    const Answer half = blossom(
        {"morph", "circle:2", "circle:4", "--t", "1", "--sectors", R"([{"from": 0, "to": 0}, {"from": 0, "to": 180}])"});
    COMPARE_NEAR(half.result("area"), 8 * pi, 1e-9);
    QCOMPARE(half.result("lines"), 1.0);
    // Too narrow to hold anything, and all around.
    for (const char* narrow : {R"([{"from": 0, "to": 1e-9}])", R"([{"from": 90, "to": 90.0001}])"})
      QCOMPARE(blossom({"morph", "circle:2", "circle:4", "--t", "0.5", "--sectors", narrow}).hint(),
               std::string("Give a wider sector."));
    const Answer all = blossom({"morph", "circle:2", "circle:4", "--t", "0.5", "--sectors", R"([{"from": 90, "to": 450}])"});
    COMPARE_NEAR(all.result("area"), 9 * pi, 1e-9);
    const double dented = blossom({"morph", "star:5:20:8", "circle:10", "--t", "0.5"}).result("area");
    for (const char* turn : {R"([{"from": 0, "to": 360}])", R"([{"from": 0, "to": 7200}])"})
      COMPARE_NEAR(blossom({"morph", "star:5:20:8", "circle:10", "--t", "0.5", "--sectors", turn}).result("area"), dented,
                   1e-9);
  }

  void whatHasNoEffectIsTold() {
    const auto warnings = [&](const QStringList& more) {
      return blossom(QStringList{"morph", "circle:2", "circle:4"} + more).json.value("warnings", Value::array()).dump();
    };
    const std::string late = warnings({"--frames", "5", "--keys", R"([{"frame": 1, "t": 0}, {"frame": 9, "t": 1}])"});
    QVERIFY2(late.find("1 key lies after the last frame, 5") != std::string::npos, late.c_str());
    const std::string fixed = warnings({"--blossom", "0.5", "--t", "0.9"});
    QVERIFY2(fixed.find("t has no effect") != std::string::npos, fixed.c_str());
    QCOMPARE(warnings({"--t", "0.9"}), std::string("[]"));
  }

  /// A bar with a bulge and one with a dent, both less than the tolerance: the bulge goes on at both ends of the dent.
  void flatBulgesAndDents() {
    for (const double h : {0.001, 0.01, 0.1}) {
      for (const int side : {1, -1}) {
        const std::string segments = fmt::format(
            R"([{{"kind":"arc","through":[[50,{},0]],"to":[100,0,0]}},{{"kind":"line","to":[100,-10,0]}},{{"kind":"line","to":[0,-10,0]}}])",
            side * h);
        QCOMPARE(
            blossom({"outline", "--segments", QString::fromStdString(segments), "-o", side > 0 ? "bulge.dxf" : "dent.dxf"})
                .code,
            0);
      }
      // Two bulges of half the width and height; an arc of a small sagitta s over a chord c encloses 2/3 s c.
      const double expected = 1000 + 2 * (2.0 / 3) * (h / 2) * 50;
      for (const bool turned : {false, true}) {
        const QStringList shapes = turned ? QStringList{"dent.dxf", "bulge.dxf"} : QStringList{"bulge.dxf", "dent.dxf"};
        const Answer made = blossom(QStringList{"morph"} + shapes +
                                    QStringList{"--t", "0.5", "--tolerance", QString::number(std::max(h, 0.01))});
        QCOMPARE(made.code, 0);
        COMPARE_NEAR(made.result("area"), expected, 1e-4 * h * 100 + 1e-5);
        QCOMPARE(made.result("arcs"), 2.0);
      }
    }
  }

  /// Radii are blended as numbers are: r (1-t1)(1-t2) + s (t1 + t2 - 2 t1 t2) + q t1 t2.
  void aPathLeadsThroughTheBlossom() {
    const QStringList discs{"morph", "circle:2", "circle:8", "circle:3", "--path", "0,0; 0.2,0.9; 1,1"};
    const auto areaAt = [](double t1, double t2) {
      return pi * std::pow(2 * (1 - t1) * (1 - t2) + 8 * (t1 + t2 - 2 * t1 * t2) + 3 * t1 * t2, 2);
    };
    COMPARE_NEAR(blossom(discs + QStringList{"--t", "0.25"}).result("area"), areaAt(0.1, 0.45), 1e-9);
    COMPARE_NEAR(blossom(discs + QStringList{"--t", "0.5"}).result("area"), areaAt(0.2, 0.9), 1e-9);
    COMPARE_NEAR(blossom(discs + QStringList{"--t", "0.75"}).result("area"), areaAt(0.6, 0.95), 1e-9);
    QCOMPARE(blossom(discs + QStringList{"--frames", "5", "-o", "path.svg"}).code, 0);
    const std::array<std::array<double, 2>, 5> passed{{{0, 0}, {0.1, 0.45}, {0.2, 0.9}, {0.6, 0.95}, {1, 1}}};
    for (std::size_t k = 0; k < passed.size(); ++k)
      COMPARE_NEAR(areaInFile(fs::path(folder_.path().toStdString()) / fmt::format("path-{:04}.svg", k + 1)),
                   areaAt(passed[k][0], passed[k][1]), 1e-6);
    // As JSON, and at one point, which stays there.
    const QStringList there{"morph", "circle:2", "circle:8", "circle:3", "--path", "[[0.2,0.9]]", "--t", "0.7"};
    COMPARE_NEAR(blossom(there).result("area"), areaAt(0.2, 0.9), 1e-9);
    for (const QStringList& wrong :
         {QStringList{"--path", "0,0; 1"}, QStringList{"--path", "0,0; 1,1.5"},
          QStringList{"--path", "0,0; 1,1", "--blossom", "0.1,0.2"}, QStringList{"--path", "0,0; 1,1", "--degree", "1"}}) {
      const Answer refused = blossom(QStringList{"morph", "circle:2", "circle:8", "circle:3"} + wrong);
      QVERIFY(refused.code != 0);
      QCOMPARE(refused.json["error"]["code"], Value("InvalidParameter"));
    }
  }

  /// Squares of 10 and 20: at t the side is 10 + 10 t.
  void keysTellTheTimesOfFrames() {
    const QStringList morph{"morph", "rectangle:10:10", "rectangle:20:20", "--frames", "5", "--keys"};
    const QString keys =
        R"([{"frame": 2, "t": 0.2, "ease": "in"}, {"frame": 4, "t": 1}, {"frame": 5, "t": 0.5, "ease": "hold"}])";
    QCOMPARE(blossom(morph + QStringList{keys, "-o", "keyed.svg"}).code, 0);
    const std::array<double, 5> times{0.2, 0.2, 0.2 + 0.8 * 0.25, 1, 0.5};
    for (std::size_t k = 0; k < times.size(); ++k)
      COMPARE_NEAR(areaInFile(fs::path(folder_.path().toStdString()) / fmt::format("keyed-{:04}.svg", k + 1)),
                   std::pow(10 + 10 * times[k], 2), 1e-6);
    const Answer twice = blossom(morph + QStringList{R"([{"frame": 2, "t": 0.2}, {"frame": 2, "t": 0.3}])"});
    QVERIFY(twice.code != 0);
    QCOMPARE(twice.json["error"]["code"], Value("InvalidParameter"));
  }

  /// The ends are the control shapes, with their arcs: not polygons of them.
  void theMorphStartsAtTheFirstAndEndsAtTheLast() {
    QCOMPARE(blossom({"slot", "--length", "40", "--width", "12", "-o", "slot.dxf"}).code, 0);
    for (const char* evaluation : {"recursive", "bottom-up", "explicit"}) {
      const QStringList shapes{"morph", "circle:15", "star:5:24:9", "slot.dxf", "--evaluation", evaluation};
      const Answer first = blossom(shapes + QStringList{"--t", "0"}), last = blossom(shapes + QStringList{"--t", "1"});
      COMPARE_NEAR(first.result("area"), 225 * pi, 1e-9);
      QVERIFY(first.result("arcs") >= 1 && first.result("lines") == 0);
      COMPARE_NEAR(last.result("area"), 28 * 12 + 36 * pi, 1e-9);
      QCOMPARE(last.result("arcs"), 2.0);
      QCOMPARE(sumsOf(first) + sumsOf(last), 0);
    }
  }

  void tableOneIsPrinted() {
    const QStringList three{"morph", "star:3:20:8", "star:4:22:7", "star:5:24:9", "--frames", "7", "--evaluation"};
    // Five of seven frames lie between the ends; n = 2.
    QCOMPARE(sumsOf(blossom(three + QStringList{"recursive"})), 3 * 5);
    QCOMPARE(sumsOf(blossom(three + QStringList{"bottom-up"})), 3 * 5);
    QCOMPARE(sumsOf(blossom(three + QStringList{"explicit"})), 2 * 5 + 1);
    const Answer convex =
        blossom({"morph", "star:3:20:8", "circle:9", "star:5:24:9", "--frames", "7", "--evaluation", "convex"});
    QCOMPARE(sumsOf(convex), 2 * 5);
    QCOMPARE(convex.json["result"]["frames"], Value(7));
  }

  void framesBecomeFiles() {
    const Answer answer = blossom({"morph", "rectangle:10:10", "rectangle:20:30", "--frames", "5", "-o", "grow.svg"});
    QCOMPARE(answer.code, 0);
    QCOMPARE(answer.json["outputs"].size(), std::size_t{5});
    for (int k = 0; k < 5; ++k)
      COMPARE_NEAR(areaInFile(fs::path(folder_.path().toStdString()) / fmt::format("grow-{:04}.svg", k + 1)),
                   (10 + 10 * k / 4.0) * (10 + 20 * k / 4.0), 1e-9);
    QCOMPARE(blossom({"morph", "rectangle:10:10", "rectangle:20:30", "--frames", "5", "-o", "one.svg", "--svg.animate"})
                 .json["outputs"]
                 .size(),
             std::size_t{1});
    for (const char* file : {"grow.dxf", "grow.step", "grow.blossom"})
      QVERIFY2(blossom({"morph", "rectangle:10:10", "rectangle:20:30", "--t", "0.5", "-o", file}).code == 0, file);
  }

  void sequencesBecomeFilmsAndContactSheets() {
    const QStringList morph{"morph", "rectangle:10:10", "rectangle:20:30"};
    const QStringList frames = morph + QStringList{"--frames", "5"};
    const Answer film = blossom(frames + QStringList{"-o", "walk.ogv", "--ogv.size", "64x48", "--ogv.seconds", "0.2"});
    QCOMPARE(film.code, 0);
    QCOMPARE(film.json["outputs"].size(), std::size_t{1});
    const Answer sheet = blossom(frames + QStringList{"-o", "walk.png", "--png.size", "320x240", "--png.sheet", "3"});
    QCOMPARE(sheet.code, 0);
    QCOMPARE(sheet.json["outputs"].size(), std::size_t{1});
    // A single in-between is no film, and a solid that is never a sequence is refused before it is made.
    for (const QStringList& single : {morph, QStringList{"box"}}) {
      const Answer refused = blossom(single + QStringList{"-o", "single.ogv"});
      QVERIFY(refused.code != 0);
      QCOMPARE(refused.json["error"]["code"], Value("OutputNotSupported"));
    }
    QVERIFY(!fs::exists(fs::path(folder_.path().toStdString()) / "single.ogv"));
  }

 private:
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(MinkowskiMorphCliTest)
#include "minkowski_morph_cli_test.moc"
