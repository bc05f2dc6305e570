#include <QElapsedTimer>
#include <QTemporaryDir>
#include <thread>

#include "geometry/occt/occt.h"
#include "support/command_line.h"
#include "support/modeling.h"
#include "support/polyhedra.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// As on the command line: "ball:2:1".
Shape literal(const std::string& text) { return theApp().registry->literal(text); }

}  // namespace

/// The features as the evaluator and the command line call them.
class MorphologyFeatureTest : public QObject {
  Q_OBJECT

 private slots:
  void solidsOfCadAreTakenApartToTheirDeviation() {
    const Shape box = made("box", {{"width", 4}, {"depth", 3}, {"height", 2}}).shape;
    const Shape ball = made("ball", {{"radius", 1}, {"subdivisions", 1}}).shape;
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {box, ball})), volumeWithCuboid(*ball.get<Mesh>(), {4, 3, 2}),
                 1e-9);
    const Shape cylinder = made("cylinder", {{"radius", 5}, {"height", 10}}).shape;
    double before = 0;
    for (const double deviation : {0.5, 0.1}) {
      const double sum = volume(made("solid-sum", {{"deviation", deviation}}, {cylinder, box}));
      const double exact = (25 * std::numbers::pi + 12 + 10 * 7) * 12;
      QVERIFY(sum > before && sum <= exact + 1e-9);
      QVERIFY(exact - sum <= deviation * 2 * std::numbers::pi * 6 * 12);
      before = sum;
    }
  }

  void everyStructuringElement() {
    const Shape box = made("box", {{"width", 4}, {"depth", 3}, {"height", 2}}).shape;
    const Shape ball = literal("ball:0.5:2");
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {box, ball})), volumeWithCuboid(*ball.get<Mesh>(), {4, 3, 2}),
                 1e-9);
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {box, literal("segment:0:0:5")})), 4 * 3 * 7, 1e-9);
    COMPARE_NEAR(volume(made("solid-difference", Value::object(), {box, literal("segment:0:0:0.5")})), 4 * 3 * 1.5, 1e-9);
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {box, rectangle(0, 0, 1, 2)})), 5 * 5 * 2, 1e-9);
    const Shape flat = made("rectangle", {{"width", 1}, {"height", 2}}).shape;
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {box, flat})), 5 * 5 * 2, 1e-9);
    const Region frame{{polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}), polygon({{1, 1}, {1, 5}, {5, 5}, {5, 1}})}};
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {cuboid({0, 0, 0}, {1, 1, 1}), frame})), 7 * 7 - 3 * 3, 1e-9);
    for (const char* wrong :
         {"ball:", "ball:-1", "ball:1:2:3", "ball:1:1.5", "ball:1:9", "ball:x", "segment:1:2", "segment:0:0:0"})
      VERIFY_ERROR(literal(wrong), ErrorCode::InvalidParameter);
  }

  /// Two squares at a right angle and a unit cube: two plates. A surface that is curved lies in between.
  void openSurfaces() {
    Mesh bent;
    bent.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}};
    bent.addFace(std::array{0, 1, 2, 3});
    bent.addFace(std::array{0, 3, 5, 4});
    const Mesh cube = cuboid({0, 0, 0}, {1, 1, 1});
    const Shape sheet = Brep(toShape(bent));
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {cube, sheet})), 6, 1e-9);
    COMPARE_NEAR(volume(made("solid-sum", Value::object(), {sheet, cube})), 6, 1e-9);
    // As a mesh it may as well be a solid with a hole in its skin.
    const Error error = refusal("solid-sum", Value::object(), {cube, bent});
    QVERIFY(error.message().find("is open: an edge near (") != std::string::npos);
    QCOMPARE(refusal("solid-difference", Value::object(), {sheet, cube}).code(), ErrorCode::InvalidInput);

    Surface saddle;
    saddle.degreeU = saddle.degreeV = 1;
    saddle.knotsU = saddle.knotsV = {0, 0, 1, 1};
    saddle.poles = {{0, 0, 0, 1}, {0, 2, 1, 1}, {2, 0, 1, 1}, {2, 2, 0, 1}};
    const double sum = volume(made("solid-sum", {{"deviation", 0.01}}, {cube, saddle}));
    QVERIFY2(sum > 3 * 3 * 1 && sum < 3 * 3 * 2, qPrintable(QString::number(sum)));
  }

  void sequences() {
    const std::vector<Shape> solids{cuboid({0, 0, 0}, {1, 2, 3}), cuboid({0, 0, 0}, {4, 2, 1})};
    const Evaluated morph = made("solid-morph", {{"frames", 5}, {"control", "ease"}}, solids);
    const auto* sequence = morph.shape.get<Sequence>();
    QVERIFY(sequence && sequence->frames.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
      const double t = static_cast<double>(k) / 4, w = t * t * (3 - 2 * t);
      COMPARE_NEAR(figure(sequence->frames[k], "volume"), (1 + 3 * w) * 2 * (3 - 2 * w), 1e-12);
      COMPARE_NEAR(sequence->times[k], t, 1e-15);
    }
    const Evaluated melting = made("melt", {{"radius", 0.4}, {"frames", 3}}, {lBlock()});
    QCOMPARE(melting.shape.get<Sequence>()->frames.size(), std::size_t{3});
    const Evaluated curve =
        made("solid-morph", {{"t", 0.5}, {"control", "curve"}, {"curve", {{0, 0}, {0.5, 1}, {1, 1}}}}, solids);
    COMPARE_NEAR(volume(curve), 4 * 2 * 1, 1e-12);
  }

  /// The product of the weights along x is that of no single t.
  void blossoms() {
    const std::vector<Shape> solids{cuboid({0, 0, 0}, {1, 1, 1}), cuboid({0, 0, 0}, {5, 1, 1}),
                                    cuboid({0, 0, 0}, {2, 1, 1})};
    const Evaluated between = made("solid-morph", {{"blossom", {0.2, 0.9}}}, solids);
    COMPARE_NEAR(volume(between), 0.8 * 0.1 * 1 + (0.2 * 0.1 + 0.8 * 0.9) * 5 + 0.2 * 0.9 * 2, 1e-12);
    COMPARE_NEAR(volume(made("solid-morph", {{"blossom", {0.3, 0.3}}}, solids)),
                 volume(made("solid-morph", {{"t", 0.3}}, solids)), 1e-12);
    VERIFY_ERROR(made("solid-morph", {{"blossom", {0.2}}}, solids), ErrorCode::InvalidParameter);
    VERIFY_ERROR(made("solid-morph", {{"blossom", {0.2, 0.9}}, {"frames", 3}}, solids), ErrorCode::InvalidParameter);
  }

  void figuresOfTheWork() {
    const Evaluated sum = made("solid-sum", Value::object(), {lBlock(), cornerTetrahedron()});
    for (const char* key : {"candidates", "check_ms", "sum_ms", "unite_ms", "output_ms"})
      QVERIFY2(sum.stats.contains(key), key);
    std::size_t families = 0;
    for (const char* key : {"of_corners_and_faces", "of_faces_and_corners", "of_edges"}) {
      QVERIFY2(sum.stats.at(key).get<std::size_t>() > 0, key);
      families += sum.stats.at(key).get<std::size_t>();
    }
    QCOMPARE(families, sum.stats.at("candidates").get<std::size_t>());
    QCOMPARE(figure(sum.shape, "genus"), 0.0);
    QCOMPARE(figure(sum.shape, "components"), 1.0);
    QVERIFY(made("inflate", Value::object(), {lBlock()}).stats.at("ball_deviation").get<double>() > 0);
  }

  void facetsDeepInsideAreLeftOutOfLargeSums() {
    std::mt19937_64 random = seededRandom();
    const Mesh large = spikyRing(random, 5, 3, 24), other = spikyRing(random, 4, 3, 24);
    const Evaluated sum = made("solid-sum", Value::object(), {large, other});
    const std::size_t deep = sum.stats.at("deep_inside").get<std::size_t>();
    QVERIFY(deep > 0 && deep < sum.stats.at("candidates").get<std::size_t>());
    QCOMPARE(made("solid-sum", Value::object(), {lBlock(), cornerTetrahedron()}).stats.at("deep_inside").get<int>(), 0);
  }

  void valuesWithoutEffectAreTold() {
    const Shape block = cuboid({0, 0, 0}, {9, 9, 9}), element = cuboid({-1, -1, -1}, {1, 1, 1});
    for (const char* operation : {"melt", "inflate"}) {
      QVERIFY(made(operation, {{"radius", 2}}, {block}).warnings.empty());
      QVERIFY(made(operation, {{"size", 2}}, {block, element}).warnings.empty());
      for (const Evaluated& told :
           {made(operation, {{"radius", 2}}, {block, element}), made(operation, {{"size", 2}}, {block})}) {
        QCOMPARE(told.warnings.size(), std::size_t{1});
        QVERIFY2(told.warnings[0].find("no effect") != std::string::npos, told.warnings[0].c_str());
      }
    }
  }

  void longWorkIsCancelledInTheMiddle() {
    const std::vector<Shape> inputs = secondsOfWork();
    const CancelToken token;
    QElapsedTimer sinceCancel;
    std::atomic<bool> asked = false;
    const Progress cancelling(token, [&](double, const std::string& stage) {
      if (stage != "Cutting faces") return;
      if (asked.exchange(true)) return;
      sinceCancel.start();
      token.cancel();
    });
    VERIFY_ERROR(made("solid-sum", Value::object(), inputs, cancelling), ErrorCode::Cancelled);
    QVERIFY(asked);
    qInfo("figure cancel_ms %lld", static_cast<long long>(sinceCancel.elapsed()));
  }

  void throughTheCommandLine() {
    blossom({"box", "--width", "10", "--depth", "8", "--height", "6", "-o", "box.step"});
    for (const char* format : {"off", "obj", "stl", "ply", "3mf", "step"}) {
      const QString file = QString("sum.") + format;
      const Answer ran = blossom({"solid-sum", "box.step", "ball:1:1", "-o", file});
      QVERIFY2(ran.code == 0, ran.json.dump().c_str());
      QCOMPARE(ran.json["feature"], Value("morphology.solid-sum"));
      const double expected = ran.json["result"]["volume"].get<double>();
      const Answer info = blossom({"info", file});
      QVERIFY2(info.code == 0, info.json.dump().c_str());
      COMPARE_NEAR(info.json["result"]["volume"].get<double>(), expected, 1e-5 * expected);
      QCOMPARE(info.json["result"]["closed"], Value(true));
    }
    const Answer melting = blossom({"melt", "box.step", "--radius", "2", "--frames", "3", "-o", "frame.obj"});
    QVERIFY2(melting.code == 0, melting.json.dump().c_str());
    QCOMPARE(melting.json["outputs"].size(), std::size_t{3});
    const Answer refused = blossom({"melt", "box.step", "--radius", "9", "-o", "none.off"});
    QCOMPARE(refused.code, 1);
    QVERIFY(!refused.json["error"]["hint"].get<std::string>().empty());
    QVERIFY(!QFile::exists(folder_.filePath("none.off")));
  }

  void everyFeatureExplainsItself() {
    int features = 0;
    for (const auto& type : theApp().registry->types()) {
      if (!type->id.starts_with("morphology.")) continue;
      ++features;
      QVERIFY2(!type->examples.empty(), type->id.c_str());
      QVERIFY2(fs::exists(sourceFolder() / "resources/icons" / (type->icon + ".svg")), type->id.c_str());
      for (const std::string& example : type->examples)
        QVERIFY2(example.starts_with("blossom " + type->command), example.c_str());
    }
    QCOMPARE(features, 9);
    QVERIFY(fs::exists(sourceFolder() / "resources/icons/morphology.svg"));
  }

  void theSampleDocumentsAreWhole() {
    for (const char* name : {"block-to-wedge", "convex-pair", "notched-sum", "gear-with-clearance", "melting-ice",
                             "inflated-letter", "rounded-letters", "smooth-ice", "by-way-of-a-ball"}) {
      const Answer info = blossom({"info", QString::fromStdString((sample(std::string(name) + ".blossom")).string())});
      QVERIFY2(info.code == 0, info.json.dump().c_str());
    }
  }

 private:
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }
  QTemporaryDir folder_;
};

BLOSSOM_TEST(MorphologyFeatureTest)
#include "morphology_feature_test.moc"
