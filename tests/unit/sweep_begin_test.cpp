#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "app/app.h"
#include "feature/feature_type.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/motion.h"
#include "support/command_line.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;

/// How a motion begins, by the real command line.
class SweepBeginTest : public QObject {
  Q_OBJECT
 private slots:
  void everyKindBeginsWithoutAFile() {
    for (const char* kind : {"cylinder", "cone", "sphere", "torus", "tube", "helicoid", "plane", "sheet"}) {
      const Answer made = blossom({"sweep-motion", "--kind", kind, "-o", "begin.json"});
      QVERIFY2(made.code == 0, kind);
      const Answer swept = blossom({"sweep", "begin.json", "-o", "begin.step"});
      QVERIFY2(swept.code == 0, kind);
      QVERIFY(swept.result("area") > 0);
    }
    const Answer solid = blossom({"sweep-motion", "-o", "hub.json"});
    QCOMPARE(solid.code, 0);
    const double wanted = std::numbers::pi * 400 * 40;
    COMPARE_NEAR(blossom({"sweep", "hub.json", "--solid", "-o", "hub.step"}).result("volume"), wanted, 1e-6 * wanted);
  }

  void everyFeatureHasAnIconOfItsOwn() {
    std::map<std::string, std::string> typeOf;
    for (const auto& type : theApp().registry->types()) {
      if (!type->id.starts_with("sweep.") || type->icon.empty()) continue;
      QVERIFY2(std::filesystem::exists(sourceFolder() / "resources/icons" / (type->icon + ".svg")), type->id.c_str());
      const auto [other, alone] = typeOf.emplace(type->icon, type->id);
      QVERIFY2(alone, (type->id + " and " + other->second).c_str());
      QVERIFY2(type->icon != "grid", type->id.c_str());  // that of the ground grid
    }
    QVERIFY(typeOf.size() >= 7);
  }

  // The panel hides what does not apply: it must not count, whatever it is set to.
  void sizesOfOtherKindsDoNotCount() {
    const auto type = theApp().registry->at("sweep-motion");
    std::size_t hidden = 0;
    for (const std::string& kind : type->parameters.front().choices) {
      const Value given{{"kind", kind}};
      const Shape plain = made("sweep-motion", given).shape;
      for (const ParameterSpec& spec : type->parameters) {
        const bool counts = applies(spec, type->parameters, given);
        if (spec.condition.choice.empty()) continue;
        const double allowed = spec.name == "profile" ? 3.5 : 21.5, extreme = spec.name == "turns" ? 0 : 359;
        for (const double other : {allowed, counts ? allowed : extreme}) {
          Value changed = given;
          changed[spec.name] = other;
          const Shape shape = made("sweep-motion", changed).shape;
          QVERIFY2((*shape.get<Motion>() == *plain.get<Motion>()) != counts, (kind + ' ' + spec.name).c_str());
        }
        hidden += counts ? 0 : 1;
      }
    }
    QCOMPARE(hidden, std::size_t{37});
    const QString help = QString::fromStdString(plainAnswer({"help", "sweep-motion"})).simplified();
    QVERIFY2(help.contains(QLatin1String("only if kind is torus or tube; default 6 mm")), qPrintable(help));
    QVERIFY2(help.contains(QLatin1String("only if kind is helicoid; default 2")), qPrintable(help));
  }

  void curvesOfAnyFileCarryTubes() {
    QCOMPARE(blossom({"stroke", "--points", "0,0,0; 20,5,3; 40,-5,8; 60,0,0", "-o", "path.step"}).code, 0);
    const Answer made = blossom({"sweep-along", "path.step", "--radius", "2", "-o", "tube.json"});
    QCOMPARE(made.code, 0);
    QVERIFY(made.json["stats"]["deviation"].get<double>() <= 1e-3);
    QCOMPARE(made.json["stats"]["closed"], Value(false));
    QVERIFY(blossom({"sweep", "tube.json", "--solid", "-o", "tube.step"}).result("volume") > 700);
    // A drawing as the path, another as the profile.
    std::ofstream(folder_.filePath("bend.svg").toStdString())
        << R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">)"
        << R"(<path d="M0 0 H30 A20 20 0 0 1 50 20 V60" fill="none" stroke="black"/></svg>)";
    const Answer bent = blossom({"sweep-along", "bend.svg", "rectangle:8:4", "-o", "bent.json"});
    QVERIFY2(bent.code == 0, bent.code == 1 ? bent.message().c_str() : "");
    const Answer solid = blossom({"sweep", "bent.json", "--solid", "-o", "bent.step"});
    QCOMPARE(solid.code, 0);
    const double wanted = 32 * (30 + 10 * std::numbers::pi + 40);
    COMPARE_NEAR(solid.result("volume"), wanted, 1e-3 * wanted);
  }

  /// The rim of a plate with rounded corners, whose edges are named in any order.
  void edgesOfASolidCarryTubes() {
    const Shape outline = made("rectangle", {{"width", 40}, {"height", 30}, {"corner", 8}}).shape;
    const Shape plate = made("extrude", {{"height", 10}}, {outline}).shape;
    std::vector<Value> rim, sides;
    const auto edges = subShapesOf(plate.get<Brep>()->shape(), TopAbs_EDGE);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Bounds box = bounds(Brep(edges[k]));
      if (box.low.z() < 9.9) continue;
      rim.push_back({{"input", "path"}, {"kind", "edge"}, {"index", k}});
      if ((box.high - box.low).head<2>().minCoeff() < 1e-3) sides.push_back(rim.back());
    }
    QCOMPARE(rim.size(), std::size_t{8});
    QCOMPARE(sides.size(), std::size_t{4});
    std::mt19937_64 random = seededRandom();
    std::shuffle(rim.begin(), rim.end(), random);
    const Evaluated motion = made("sweep-along", {{"radius", 2}, {"edges", rim}}, {plate});
    QCOMPARE(motion.stats["closed"], Value(true));
    const Shape bead = made("sweep", {{"solid", true}}, {motion.shape}).shape;
    const double wanted = 4 * std::numbers::pi * (2 * (24 + 14) + 2 * std::numbers::pi * 8);
    COMPARE_NEAR(figure(bead, "volume"), wanted, 1e-3 * wanted);
    VERIFY_REFUSED(refusal("sweep-along", {{"edges", sides}}, {plate}), ErrorCode::InvalidInput, "apart");
  }

  void edgesOfADrawingCarryTubes() {
    const Shape outline = made("rectangle", {{"width", 40}, {"height", 30}}).shape;
    const Value second{{"input", "path"}, {"kind", "edge"}, {"index", 1}},
        none{{"input", "path"}, {"kind", "edge"}, {"index", 4}};
    const Evaluated motion = made("sweep-along", {{"radius", 2}, {"edges", {second}}}, {outline});
    const Shape bar = made("sweep", {{"solid", true}}, {motion.shape}).shape;
    COMPARE_NEAR(figure(bar, "volume"), 4 * std::numbers::pi * 30, 1e-6 * 400);
    VERIFY_REFUSED(refusal("sweep-along", {{"edges", {none}}}, {outline}), ErrorCode::NotFound, "4 edges");
    VERIFY_REFUSED(refusal("sweep-along", {{"edges", {second, second}}}, {outline}), ErrorCode::InvalidParameter, "twice");
    const Value other{{"input", "profile"}, {"kind", "edge"}, {"index", 1}};
    VERIFY_REFUSED(refusal("sweep-along", {{"edges", {other}}}, {outline, outline}), ErrorCode::InvalidParameter, "profile");
  }

  void whatIsNoSmoothCurveIsSaid() {
    QCOMPARE(blossom({"stroke", "--points", "0,0,0; 20,0,0; 20,20,0", "--no-smooth", "-o", "corner.step"}).code, 0);
    const Answer corner = blossom({"sweep-along", "corner.step", "-o", "corner.json"});
    QCOMPARE(corner.code, 1);
    QVERIFY2(corner.message().find("corner of 90 degrees") != std::string::npos, corner.message().c_str());
    QVERIFY(!corner.hint().empty());
    const Answer solid = blossom({"sweep-along", "hub.step", "-o", "none.json"});
    QCOMPARE(solid.code, 1);
  }

  void refinedMotionsSweepTheSame() {
    QCOMPARE(blossom({"sweep-motion", "--kind", "torus", "-o", "ring.json"}).code, 0);
    const Answer refined = blossom({"sweep-refine", "ring.json", "--u", "0.1,0.2", "--v", "0.55", "-o", "fine.json"});
    QCOMPARE(refined.code, 0);
    const double before = blossom({"sweep", "ring.json", "-o", "ring.step"}).result("area"),
                 after = blossom({"sweep", "fine.json", "-o", "fine.step"}).result("area");
    COMPARE_NEAR(after, before, 1e-9 * before);
    QCOMPARE(blossom({"sweep-refine", "ring.json", "--u", "2", "-o", "fine.json"}).code, 1);
    QCOMPARE(blossom({"sweep-refine", "ring.json", "--u", "0.1", "--factors", "trajectory", "-o", "fine.json"}).code, 1);
  }

 private:
  static std::string plainAnswer(const QStringList& arguments) {
    QProcess process;
    process.start(blossomProgram(), arguments);
    if (!process.waitForFinished(-1)) return {};
    return process.readAllStandardOutput().toStdString();
  }
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }
  QTemporaryDir folder_;
};

BLOSSOM_TEST(SweepBeginTest)
#include "sweep_begin_test.moc"
