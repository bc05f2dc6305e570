#include <fstream>

#include "core/file.h"
#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "support/errors.h"
#include "support/modeling.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/edit/apply_edits.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/grid/motion_point.h"
#include "transport/shape_transport.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

MotionEdit randomEdit(Random& random) {
  const auto place = [&] { return MotionPlace{uniform(random, 0, 1), uniform(random, 0, 1)}; };
  const auto vector = [&] { return Vec3(uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9)); };
  std::vector<MotionPlace> at, pins;
  for (int i = uniformInt(random, 1, 3); i > 0; --i) at.push_back(place());
  for (int i = uniformInt(random, 0, 2); i > 0; --i) pins.push_back(place());
  const EditSymmetry symmetry{uniformInt(random, 1, 4), uniformInt(random, 0, 1) == 1};
  const int level = uniformInt(random, coarsestLevel, finestLevel);
  if (uniformInt(random, 0, 1)) return MotionTwist{at, vector(), uniform(random, -360, 360), pins, symmetry, level};
  MotionPull pull{at, {}, {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)}};
  for (std::size_t i = 0; i < at.size(); ++i) pull.to.push_back(vector());
  if (uniformInt(random, 0, 1)) pull.axis = vector();
  pull.pins = pins, pull.symmetry = symmetry, pull.level = level;
  return pull;
}

}  // namespace

class SweepEditsTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;
  Format format_ = motionFormat();

  Motion readEdited(const Value& edits) const {
    Value json = Value::parse(readFile(sample("cylinder.json")));
    json["edits"] = edits;
    const auto path = folder_.path() / "edited.json";
    std::ofstream(path, std::ios::binary) << json.dump();
    return *format_.read(path, Value::object(), Progress::none()).shape.get<Motion>();
  }
  Motion written(const Motion& motion) const {
    const auto path = folder_.path() / "again.json";
    format_.write(motion, path, Value::object(), Progress::none());
    return *format_.read(path, Value::object(), Progress::none()).shape.get<Motion>();
  }
  void expectDamaged(const char* edits, const char* place, const char* words) const {
    const Error error = errorOf([&] { (void)readEdited(Value::parse(edits)); });
    QVERIFY2(error.code() == ErrorCode::FormatDamaged, error.what());
    QVERIFY2(error.message().find(place) != std::string::npos && error.message().find(words) != std::string::npos,
             error.what());
  }
  static Evaluated evaluated(const char* id, const Value& parameters, const Motion& motion) {
    const auto type = theApp().registry->at(id);
    const Shape shape(motion);
    const Evaluated out =
        type->evaluate(completed(type->parameters, parameters), arrangedInputs(*type, {&shape, 1}), Progress::none());
    checkResult(*type, out.shape);
    return out;
  }

 private slots:
  void editsAreReadAsTheyAreWritten() {
    const Motion motion = readEdited(Value::parse(R"([
      {"at": [0.25, 0.5], "to": [1, 2, 3], "weights": {"translate": 0, "rotate": 0, "scale": 1}},
      {"at": [0.25, 0.5], "twist": {"axis": [0, 1, 0], "angle": 30}},
      {"at": [[0.25, 0.5], [0.5, 0.5]], "to": [[1, 2, 3], [4, 5, 6]], "pins": [[0, 0.5]], "symmetry": {"fold": 4, "mirror": false}}])"));
    QCOMPARE(motion.edits.size(), std::size_t(3));
    QVERIFY(motion.edits[0] == MotionEdit(MotionPull{{{0.25, 0.5}}, {{1, 2, 3}}, {0, 0, 1}}));
    QVERIFY(motion.edits[1] == MotionEdit(MotionTwist{{{0.25, 0.5}}, {0, 1, 0}, 30}));
    QVERIFY(motion.edits[2] ==
            MotionEdit(MotionPull{
                {{0.25, 0.5}, {0.5, 0.5}}, {{1, 2, 3}, {4, 5, 6}}, {0, 1, 1}, Vec3::Zero(), {{0, 0.5}}, {4, false}}));
    QVERIFY(readEdited(Value::array()).edits.empty());
    const Measures measures = measure(Shape(motion));
    QVERIFY(std::any_of(measures.values.begin(), measures.values.end(), [](const Measure& each) {
      return each.name == "edits" && std::get<std::int64_t>(each.value) == 3;
    }));
  }

  void everyEditSurvivesItsFile() {
    auto random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      Motion motion = readEdited(Value::array());
      for (int i = uniformInt(random, 0, 4); i > 0; --i) motion.edits.push_back(randomEdit(random));
      QVERIFY(written(motion) == motion);
      const Shape sent = loadShape(saveShape(motion, folder_.path(), "motion"), folder_.path());
      QVERIFY(*sent.get<Motion>() == motion);
    }
  }

  void mistakesAreNamedWithTheirPlace() {
    expectDamaged(R"({})", "edits", "a list");
    expectDamaged(R"([3])", "edits[0]", "an object");
    expectDamaged(R"([{"at": [0, 0]}])", "edits[0]", "either");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "twist": {"axis": [0, 0, 1], "angle": 3}}])", "edits[0]", "either");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2]}])", "edits[0].to", "[x, y, z]");
    expectDamaged(R"([{"at": [[0, 0], [1, 0]], "to": [1, 2, 3]}])", "edits[0].to", "2 places");
    expectDamaged(R"([{"at": [], "to": [1, 2, 3]}])", "edits[0].at", "empty");
    expectDamaged(R"([{"at": [], "to": []}])", "edits[0].at", "empty");
    expectDamaged(R"([{"at": [0, 0], "to": []}])", "edits[0].to", "empty");
    expectDamaged(R"([{"at": [], "twist": {"axis": [0, 0, 1], "angle": 3}}])", "edits[0].at", "empty");
    expectDamaged(R"([{"at": [0, "x"], "to": [1, 2, 3]}])", "edits[0].at[1]", "number");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "weight": {}}])", "edits[0].weight", "not a key");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "weights": {"scale": 2}}])", "edits[0].weights.scale",
                  "between 0 and 1");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "weights": {"scale": 0}}])", "edits[0].weights", "above 0");
    expectDamaged(R"([{"at": [0, 0], "twist": {"axis": [0, 0, 0], "angle": 3}}])", "edits[0].twist.axis", "a length");
    expectDamaged(R"([{"at": [0, 0], "twist": {"axis": [0, 0, 1], "angle": 400}}])", "edits[0].twist.angle", "360");
    expectDamaged(R"([{"at": [0, 0], "twist": {"axis": [0, 0, 1]}}])", "edits[0].twist.angle", "missing");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "symmetry": {"fold": 0}}])", "edits[0].symmetry.fold", "between 1");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "symmetry": {"mirror": 1}}])", "edits[0].symmetry.mirror",
                  "true or false");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "pins": [[1]]}])", "edits[0].pins[0]", "[u, v]");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 1e12]}])", "edits[0].to[2]", "1e9");
  }

  void levelsSurviveTheirFile() {
    Motion motion = readEdited(Value::parse(R"([{"at": [0.3, 0.4], "to": [3, 12, 16], "level": 2}])"));
    QCOMPARE(std::get<MotionPull>(motion.edits.at(0)).level, 2);
    const Motion applied = withEditsApplied(motion);
    QVERIFY(applied.base && applied.scaling.countU() > motion.scaling.countU());
    QVERIFY((evaluate(applied, 0.3, 0.4).point - Vec3(3, 12, 16)).norm() < 1e-11);
    QVERIFY(written(applied) == applied);
    const Shape sent = loadShape(saveShape(applied, folder_.path(), "refined"), folder_.path());
    QVERIFY(*sent.get<Motion>() == applied);
    // The same by a feature.
    const Motion plain = readEdited(Value::array());
    const Value pulls = Value::parse(R"([{"u": 0.3, "v": 0.4, "to": [3, 12, 16]}])");
    const Evaluated out = evaluated("sweep.pull", {{"pulls", pulls}, {"level", 2}}, plain);
    QVERIFY(*out.shape.get<Motion>() == applied);
    VERIFY_ERROR(evaluated("sweep.pull", {{"pulls", pulls}, {"level", 9}}, plain), ErrorCode::InvalidParameter);
    // Of a target in space no coordinate is guessed.
    const Value flat = Value::parse(R"([{"u": 0.3, "v": 0.4, "to": [3, 12]}])");
    VERIFY_ERROR(evaluated("sweep.pull", {{"pulls", flat}}, plain), ErrorCode::InvalidParameter);
    VERIFY_ERROR(evaluated("sweep.twist", {{"level", -9}}, plain), ErrorCode::InvalidParameter);
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "level": 1.5}])", "edits[0].level", "whole number");
    expectDamaged(R"([{"at": [0, 0], "to": [1, 2, 3], "level": 9}])", "edits[0].level", "between -8 and 8");
    expectDamaged(R"([{"at": [0, 0], "twist": {"axis": [0, 0, 1], "angle": 3}, "level": "fine"}])", "edits[0].level",
                  "whole number");
  }

  void wrongBaseKnotsAreNamed() {
    const auto error = [&](const char* base) {
      Value json = Value::parse(readFile(sample("cylinder.json")));
      json["base"] = Value::parse(base);
      const auto path = folder_.path() / "base.json";
      std::ofstream(path, std::ios::binary) << json.dump();
      return errorOf([&] { (void)format_.read(path, Value::object(), Progress::none()); });
    };
    const auto names = [&](const char* base, const char* place) {
      const Error found = error(base);
      QVERIFY2(found.code() == ErrorCode::FormatDamaged && found.message().starts_with(place), found.what());
    };
    names(R"({"trajectory": [], "orientation": [[], []]})", "base.scaling is missing");
    names(R"({"trajectory": [0.123], "orientation": [[], []], "scaling": [[], []]})", "base.trajectory[0] must be one of");
    names(R"({"trajectory": [], "orientation": [[0.5, 0.5], []], "scaling": [[], []]})", "base.orientation[0][1] must be");
    names(R"({"trajectory": [], "orientation": [[], []], "scaling": [[], [1]]})", "base.scaling[1][0] must be");
    names(R"({"trajectory": [], "orientation": [[], []], "scaling": [[]]})", "base.scaling must be two lists");
    QVERIFY(error(R"({"trajectory": [], "orientation": [[0.5], []], "scaling": [[], []]})").code() == ErrorCode::Internal);
  }

  void editsAreAppliedInOrder() {
    const Motion given = readEdited(Value::parse(R"([
      {"at": [0.125, 0.5], "to": [30, 30, 20], "symmetry": {"fold": 4}},
      {"at": [0.125, 0.5], "twist": {"axis": [1, 1, 0], "angle": 40}, "symmetry": {"fold": 4}},
      {"at": [0.125, 0.5], "to": [40, 40, 20], "weights": {"scale": 1}}])"));
    const Motion applied = withEditsApplied(given);
    QVERIFY(applied.edits.empty());
    Motion one = given;
    one.edits.clear();
    for (const MotionEdit& edit : given.edits) one = edited(one, edit).motion;
    QVERIFY(applied == one);
    QVERIFY((evaluate(applied, 0.125, 0.5).point - Vec3(40, 40, 20)).norm() < 1e-11);
    QVERIFY((evaluate(applied, 0.625, 0.5).point - Vec3(-30, -30, 20)).norm() < 1e-11);
    // Sweeping it is sweeping the result.
    const Evaluated swept = evaluated("sweep.sweep", Value::object(), given);
    QCOMPARE(swept.stats.at("edits").get<int>(), 3);
    const Surface& surface = *swept.shape.get<Surface>();
    auto random = seededRandom();
    for (int i = 0; i < 200; ++i) {
      const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
      QVERIFY((blossom::point(surface, u, v) - evaluate(applied, u, v).point).norm() < 1e-9);
    }
  }

  /// More knots are finer levels: edits of the file come first, or they would change other parts.
  void refiningKeepsWhatTheEditsMake() {
    const Motion given = readEdited(Value::parse(R"([
      {"at": [0.5, 0.5], "to": [-16, 0, 20], "weights": {"scale": 1}},
      {"at": [0.125, 0.25], "twist": {"axis": [1, 1, 0], "angle": 20}}])"));
    const Motion applied = withEditsApplied(given);
    const Evaluated refined =
        evaluated("sweep.refine", {{"u", Value::array({0.45, 0.55})}, {"v", Value::array({0.45, 0.55})}}, given);
    QCOMPARE(refined.stats.at("edits").get<int>(), 2);
    const Motion& fine = *refined.shape.get<Motion>();
    QVERIFY(fine.edits.empty());
    auto random = seededRandom();
    for (int i = 0; i < 200; ++i) {
      const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
      QVERIFY((evaluate(fine, u, v).point - evaluate(applied, u, v).point).norm() < 1e-10);
    }
  }

  void editsOutOfReachAreErrorsWithTheirPlace() {
    const Motion scaled = readEdited(Value::parse(R"([
      {"at": [0, 0.5], "to": [15, 0, 20]}, {"at": [0, 0.5], "to": [10, 0, 20]},
      {"at": [0, 0.5], "to": [15, 3, 20], "weights": {"scale": 1}}])"));
    const Error error = errorOf([&] { (void)withEditsApplied(scaled); });
    QCOMPARE(error.code(), ErrorCode::InvalidInput);
    QVERIFY2(error.message().starts_with("edits[2] cannot be reached: 3 mm are left."), error.what());
    QVERIFY(error.message().find("scaling") != std::string::npos);
    QVERIFY(error.hint().find("rotate") != std::string::npos);
    const Error swept = errorOf([&] { (void)evaluated("sweep.sweep", Value::object(), scaled); });
    QCOMPARE(swept.message(), error.message());
    const Error outside =
        errorOf([&] { (void)withEditsApplied(readEdited(Value::parse(R"([{"at": [0, 1.5], "to": [15, 0, 20]}])"))); });
    QCOMPARE(outside.code(), ErrorCode::InvalidInput);
    QVERIFY2(outside.message().starts_with("edits[0] cannot be applied. v = 1.5"), outside.what());
    const Error folded = errorOf([&] {
      (void)withEditsApplied(readEdited(Value::parse(R"([{"at": [0, 0.5], "to": [15, 0, 20], "symmetry": {"fold": 3}}])")));
    });
    QVERIFY2(folded.message().starts_with("edits[0] cannot be applied. The orientation"), folded.what());
    QVERIFY(!folded.hint().empty());
  }

  void pullAndTwistAreFeatures() {
    const Motion motion = readEdited(Value::array());
    const Value pulls = Value::parse(R"([{"u": 0.125, "v": 0.5, "to": [30, 30, 20]}])");
    const Evaluated out = evaluated("sweep.pull", {{"pulls", pulls}, {"fold", 4}}, motion);
    QVERIFY(out.warnings.empty());
    QVERIFY(out.stats.at("remainder").get<double>() < 1e-12);
    MotionPull edit{{{0.125, 0.5}}, {{30, 30, 20}}};
    edit.symmetry.fold = 4;
    const EditResult wanted = pull(motion, edit);
    QVERIFY(*out.shape.get<Motion>() == wanted.motion);
    QCOMPARE(out.stats.at("moved_poles").get<std::size_t>(), wanted.movedPoles);
    // A motion with edits of its own: they come first.
    Motion before = motion;
    before.edits = {edit};
    const Evaluated twisted =
        evaluated("sweep.twist",
                  {{"places", Value::parse(R"([{"u": 0.125, "v": 0.5}])")}, {"axis", {1, 1, 0}}, {"angle", 40}}, before);
    QVERIFY(*twisted.shape.get<Motion>() == edited(wanted.motion, MotionTwist{{{0.125, 0.5}}, {1, 1, 0}, 40}).motion);
    QCOMPARE(twisted.stats.at("edits").get<int>(), 1);
    const Evaluated short_ = evaluated("sweep.pull", {{"pulls", pulls}, {"rotate", 1}, {"scale", 0}}, motion);
    QCOMPARE(short_.warnings.size(), std::size_t(1));
    COMPARE_NEAR(short_.stats.at("remainder").get<double>(), std::hypot(30, 30) - 10, 1e-11);
    const Evaluated nothing = evaluated("sweep.pull", Value::object(), motion);
    QVERIFY(*nothing.shape.get<Motion>() == motion && nothing.warnings.size() == 1);
  }
};

BLOSSOM_TEST(SweepEditsTest)
#include "sweep_edits_test.moc"
