#include <fmt/format.h>

#include <QFile>
#include <QTemporaryDir>
#include <map>

#include "exchange/format/format.h"
#include "geometry/planar/planar.h"
#include "support/command_line.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

int sums(const Answer& answer) { return answer.json["stats"]["sums"].get<int>(); }

double areaInFile(const fs::path& file) { return area(toRegion(*readShape(*theApp().formats, file).shape.get<Curves>())); }

/// What `info` tells of the features of a document.
class SampleResults {
 public:
  explicit SampleResults(const Value& info) {
    for (const Value& feature : info.at("features")) byId_[feature.at("id").get<std::string>()] = feature;
  }
  [[nodiscard]] Value of(const std::string& id) const { return byId_.at(id); }
  [[nodiscard]] double area(const std::string& id) const { return of(id)["result"]["area"].get<double>(); }

 private:
  std::map<std::string, Value> byId_;
};

}  // namespace

/// Morphs, sums and differences through the real command line.
class MinkowskiCliTest : public QObject {
  Q_OBJECT

 private slots:
  void sumsAndDifferencesOfLiterals() {
    const Answer sum = blossom({"minkowski-sum", "rectangle:40:10", "rectangle:5:6", "-o", "sum.svg"});
    QCOMPARE(sum.code, 0);
    COMPARE_NEAR(sum.result("area"), 45 * 16, 1e-9);
    QCOMPARE(sum.json["feature"], Value("minkowski.minkowski-sum"));
    QCOMPARE(sums(sum), 1);
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
    QCOMPARE(sums(few), 4);
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
      QCOMPARE(sums(first) + sums(last), 0);
    }
  }

  void tableOneIsPrinted() {
    const QStringList three{"morph", "star:3:20:8", "star:4:22:7", "star:5:24:9", "--frames", "7", "--evaluation"};
    // Five of seven frames lie between the ends; n = 2.
    QCOMPARE(sums(blossom(three + QStringList{"recursive"})), 3 * 5);
    QCOMPARE(sums(blossom(three + QStringList{"bottom-up"})), 3 * 5);
    QCOMPARE(sums(blossom(three + QStringList{"explicit"})), 2 * 5 + 1);
    const Answer convex =
        blossom({"morph", "star:3:20:8", "circle:9", "star:5:24:9", "--frames", "7", "--evaluation", "convex"});
    QCOMPARE(sums(convex), 2 * 5);
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
    QCOMPARE(sums(apart), 1);
    QVERIFY(apart.result("area") > 0 && apart.result("components") == 1);
    QVERIFY(apart.json["stats"].contains("worker_ms") && !here.json["stats"].contains("worker_ms"));
  }

  /// The numbers and names that documents of earlier versions hold.
  void oldValuesAreStillTaken() {
    for (const char* way : {"recursive", "bottom-up", "explicit"})
      QCOMPARE(blossom({"morph", "star:3:20:8", "circle:9", "--evaluation", way, "--tolerance", "0.01"}).code, 0);
    const Answer coarse = blossom({"minkowski-sum", "circle:0.001", "circle:0.001", "--tolerance", "0.01"});
    QCOMPARE(coarse.json["error"]["code"], Value("InvalidParameter"));
    QVERIFY2(coarse.hint().find("0.0002 mm") != std::string::npos, coarse.hint().c_str());
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

  void theSamplesHoldTheirMorphs() {
    const Answer star = blossom({"info", samplePath("triangle-to-star.blossom")});
    QCOMPARE(star.json["result"]["kind"], Value("sequence"));
    QCOMPARE(star.json["result"]["frames"], Value(49));
    QCOMPARE(blossom({"info", samplePath("phi-to-flower.blossom")}).json["result"]["kind"], Value("sequence"));
    const Answer cut = blossom({"info", samplePath("cutter-room.blossom")});
    QCOMPARE(cut.json["result"]["kind"], Value("region"));
    QCOMPARE(cut.result("holes"), 1.0);
  }

  /// The figures of the paper by its number, and what each is to show.
  void theSamplesShowTheFiguresOfThePaper() {
    // 1: A + A is 2 A for the triangle; B + B is more for the star.
    const SampleResults doubled(inSample("figure-1-doubled-star.blossom"));
    COMPARE_NEAR(doubled.area("region-repeat-1"), doubled.area("transform-1"), 1e-9);
    QVERIFY(doubled.area("region-repeat-2") > 1.3 * doubled.area("transform-5"));
    // 2: fuller with every copy, and inside the hull.
    const SampleResults fuller(inSample("figure-2-towards-the-hull.blossom"));
    double before = 0;
    for (int n = 1; n <= 10; ++n) {
      const double now = fuller.area(fmt::format("region-repeat-{}", n));
      QVERIFY(now > before && now < fuller.area("region-hull-1"));
      before = now;
    }
    // 3: flower, outer sweep, hole sweep and the sum have one hole each, and the sum is the largest.
    const SampleResults flower(inSample("figure-3-flower-and-butterfly.blossom"));
    for (const char* part : {"boolean-2", "outline-sweep-1", "outline-sweep-2", "minkowski-sum-1"}) {
      QCOMPARE(flower.of(part)["result"]["holes"], Value(1));
      QVERIFY(flower.area(part) <= flower.area("minkowski-sum-1"));
    }
    // 4 to 6: sequences.
    const std::pair<const char*, int> sequences[] = {{"figure-4-triangle-to-square.blossom", 1},
                                                     {"figure-5-five-pairs.blossom", 5},
                                                     {"figure-6-rounded-by-a-circle.blossom", 4}};
    for (const auto& [name, morphs] : sequences) {
      const SampleResults results(inSample(name));
      for (int k = 1; k <= morphs; ++k) QCOMPARE(results.of(fmt::format("morph-{}", k))["result"]["frames"], Value(25));
      if (morphs == 4) QCOMPARE(results.of("morph-4")["stats"]["degree"], Value(2));
    }
  }

  /// Two icons that nobody here drew: every in-between has an area between nothing and the sum of both boxes, and the ends
  /// are the icons.
  void realIconsMorph() {
    NEED_SHARED_DATA();
    const fs::path folder = sharedData() / "svg";
    const QString cat = QString::fromStdString((folder / "cat.svg").string()),
                  dog = QString::fromStdString((folder / "dog-side.svg").string());
    const double catArea = areaInFile(folder / "cat.svg"), dogArea = areaInFile(folder / "dog-side.svg");
    COMPARE_NEAR(blossom({"morph", cat, dog, "--t", "0"}).result("area"), catArea, 1e-9 * catArea);
    COMPARE_NEAR(blossom({"morph", cat, dog, "--t", "1"}).result("area"), dogArea, 1e-9 * dogArea);
    // Brunn and Minkowski: the root of the area is concave along the morph.
    for (const double t : {0.25, 0.5, 0.75}) {
      const Answer between = blossom({"morph", cat, dog, "--t", QString::number(t)});
      QVERIFY(std::sqrt(between.result("area")) >= ((1 - t) * std::sqrt(catArea) + t * std::sqrt(dogArea)) * (1 - 1e-4));
    }
  }

 private:
  Value inSample(const char* name) const { return blossom({"info", samplePath(name)}).json; }
  static QString samplePath(const char* name) { return QString::fromStdString(sample(name).string()); }

  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(MinkowskiCliTest)
#include "minkowski_cli_test.moc"
