#include <fstream>

#include "core/file.h"
#include "exchange/formats.h"
#include "support/motions.h"
#include "support/support.h"
#include "transport/spline_transport.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// A valid motion file: 2 x 2 poles, a straight trajectory.
Value small() {
  return Value::parse(R"({
    "trajectory": {"degree": 1, "knots": [0, 0, 1, 1], "poles": [[0, 0, 0], [0, 0, 1]], "weights": [1, 2]},
    "orientation": {"degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]], "poles": [[[1,0,0,0],[1,0,0,0]],[[1,0,0,1],[1,0,0,1]]]},
    "scaling": {"degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]], "poles": [[[1,1,1,1],[1,1,1,1]],[[1,1,1,1],[1,1,1,1]]]},
    "point": [1, 0, 0]})");
}

/// Other signs for about a third of the orientation's poles, rows that repeat others with them.
void turnSomeAround(Random& random, Motion& motion) {
  Surface& r = motion.orientation;
  const std::size_t free = r.countU() - (motion.closedU == ClosedU::No ? 0 : static_cast<std::size_t>(r.degreeU));
  for (std::size_t i = 0; i < free; ++i)
    for (std::size_t j = 0; j < r.countV(); ++j) {
      if (uniformInt(random, 0, 2) != 0) continue;
      for (std::size_t k = i; k < r.countU(); k += free) r.pole(k, j) = -r.pole(k, j);
    }
}

}  // namespace

class MotionTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;
  Format format_ = motionFormat();

  Imported readText(const std::string& text) const {
    const auto path = folder_.path() / "motion.json";
    std::ofstream(path, std::ios::binary) << text;
    return format_.read(path, Value::object(), Progress::none());
  }
  Imported read(const Value& json) const { return readText(json.dump()); }
  Motion motionOf(const Value& json) const { return *read(json).shape.get<Motion>(); }

  /// Reading fails and says `path` and `words`.
  void expectError(const Value& json, const char* path, const char* words) const {
    try {
      read(json);
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::FormatDamaged);
      QVERIFY2(error.message().find(path) != std::string::npos && error.message().find(words) != std::string::npos,
               error.what());
      return;
    }
    QFAIL(qPrintable(QString("accepted, but %1 is wrong").arg(path)));
  }

 private slots:
  void readsAClampedMotion() {
    const Motion motion = motionOf(small());
    validate(motion);
    QCOMPARE(motion.closedU, ClosedU::No);
    QVERIFY(motion.trajectory.poles[1] == Vec4(0, 0, 2, 2));
    QVERIFY(motion.orientation.pole(1, 0) == Vec4(1, 0, 0, 1));
  }

  void samplesAreValidAndClosedAsTheySay() {
    for (const auto& [name, closed] : {std::pair{"cylinder.json", true},
                                       {"torus.json", true},
                                       {"propeller.json", true},
                                       {"twisted-tube.json", true},
                                       {"helicoid.json", false}}) {
      const Imported imported = format_.read(sample(name), Value::object(), Progress::none());
      const Motion& motion = *imported.shape.get<Motion>();
      validate(motion);
      QVERIFY(imported.warnings.empty());
      QCOMPARE(motion.closedU, closed ? ClosedU::AntiPeriodic : ClosedU::No);
    }
  }

  void writesBackTheSameDoubles() {
    auto random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      // Signs that an alignment would not leave as they are.
      if (k % 2 == 0) turnSomeAround(random, motion);
      // Homogeneous poles come from weight times point; let them be such products.
      for (Vec4& pole : motion.trajectory.poles) pole.head<3>() = Vec3(pole.head<3>() / pole[3]) * pole[3];
      const auto path = folder_.path() / "again.json";
      format_.write(motion, path, Value::object(), Progress::none());
      const Imported imported = format_.read(path, Value::object(), Progress::none());
      QVERIFY(*imported.shape.get<Motion>() == motion);
      QVERIFY(imported.warnings.empty());
      QVERIFY(toMotion(Value::from_cbor(Value::to_cbor(motionValue(motion)))) == motion);
    }
  }

  /// A pole that points away from its neighbours, as a twist of one place by more than half a turn leaves.
  void signsThatAFileKeepsAreNotAligned() {
    Value json = Value::parse(readFile(sample("cylinder.json")));
    for (auto& component : json["orientation"]["poles"][2][3]) component = -component.get<double>();
    const Imported guessed = read(json);
    QCOMPARE(guessed.warnings.size(), std::size_t(1));
    json["orientation"]["signs"] = "kept";
    const Imported kept = read(json);
    QVERIFY(kept.warnings.empty());
    const Surface &guess = guessed.shape.get<Motion>()->orientation, &found = kept.shape.get<Motion>()->orientation;
    QVERIFY(found.pole(2, 3) == -guess.pole(2, 3));
    QVERIFY(found.pole(2, 2) == guess.pole(2, 2));
    json["orientation"]["signs"] = "lost";
    expectError(json, "orientation.signs", "kept");
  }

  void whatCannotBeReadAgainIsNotWritten() {
    const Motion good = *format_.read(sample("cylinder.json"), Value::object(), Progress::none()).shape.get<Motion>();
    const auto refused = [&](const Motion& motion, const char* place) {
      const auto path = folder_.path() / "refused.json";
      try {
        format_.write(motion, path, Value::object(), Progress::none());
        QFAIL("It was written.");
      } catch (const Error& error) {
        QCOMPARE(error.code(), ErrorCode::OutputNotSupported);
        QVERIFY2(error.message().starts_with(place), error.message().c_str());
      }
      QVERIFY(!std::filesystem::exists(path));
    };
    Motion far = good;
    far.trajectory.poles[1].x() = 1e12;
    refused(far, "trajectory.poles[1][0] would be 1000000000000;");
    Motion heavy = good;
    heavy.trajectory.poles[2] *= 1e200;
    refused(heavy, "trajectory.weights[2] would be 1e+200;");
    Motion wide = good;
    wide.scaling.pole(5, 3).y() = -2e9;
    refused(wide, "scaling.poles[5][3][1] would be -2000000000;");
  }

  void periodAndUnwrappedKnotsAreTheSameMotion() {
    Value json = Value::parse(readFile(sample("cylinder.json")));
    const Motion period = motionOf(json);
    json["orientation"]["knots"][0] = period.orientation.knotsU;
    json["scaling"]["knots"][0] = period.scaling.knotsU;
    QVERIFY(motionOf(json) == period);
    json["orientation"]["knots"][0][1] = -0.3;
    expectError(json, "orientation.knots[0][1]", "to continue the period");
  }

  void antiPeriodicRowsFollowNegated() {
    const Motion motion = *format_.read(sample("cylinder.json"), Value::object(), Progress::none()).shape.get<Motion>();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < motion.orientation.countV(); ++j) {
        QVERIFY(motion.orientation.pole(i + 8, j) == -motion.orientation.pole(i, j));
        QVERIFY(motion.scaling.pole(i + 8, j) == motion.scaling.pole(i, j));
      }
  }

  void signsOfQuaternionsAreAligned() {
    auto random = seededRandom();
    Value json = Value::parse(readFile(sample("propeller.json")));
    const Motion wanted = motionOf(json);
    for (auto& row : json["orientation"]["poles"])
      for (auto& pole : row)
        if (uniformInt(random, 0, 1))
          for (auto& component : pole) component = -component.get<double>();
    const Imported imported = read(json);
    const Motion& found = *imported.shape.get<Motion>();
    QCOMPARE(imported.warnings.size(), std::size_t(1));
    // All of them may be turned around together: still the same rotations.
    const double sign = found.orientation.poles[0].dot(wanted.orientation.poles[0]) > 0 ? 1 : -1;
    for (std::size_t i = 0; i < wanted.orientation.poles.size(); ++i)
      QVERIFY(found.orientation.poles[i] == sign * wanted.orientation.poles[i]);
  }

  void wrongClosureIsTold() {
    Value json = Value::parse(readFile(sample("cylinder.json")));
    json["orientation"]["closed_u"] = "periodic";
    QVERIFY(!read(json).warnings.empty());
  }

  void everyMistakeIsNamedWithItsPlace() {
    const auto broken = [](auto change) {
      Value json = small();
      change(json);
      return json;
    };
    expectError(Value::array(), "This motion file", "one JSON object");
    expectError(broken([](Value& j) { j.erase("scaling"); }), "scaling", "is missing");
    expectError(broken([](Value& j) { j["colour"] = 1; }), "colour", "not a key");
    expectError(broken([](Value& j) { j["trajectory"]["degree"] = 0; }), "trajectory.degree", "between 1 and 25");
    expectError(broken([](Value& j) { j["trajectory"]["degree"] = 1e300; }), "trajectory.degree", "whole number");
    expectError(broken([](Value& j) { j["trajectory"]["poles"][1][2] = "x"; }), "trajectory.poles[1][2]", "number");
    expectError(broken([](Value& j) { j["trajectory"]["weights"][1] = -2; }), "trajectory.weights[1]", "above 0");
    expectError(broken([](Value& j) { j["trajectory"]["weights"] = {1}; }), "trajectory.weights", "2 poles");
    expectError(broken([](Value& j) { j["trajectory"]["knots"] = {0, 0, 1}; }), "trajectory.knots", "4 knots");
    expectError(broken([](Value& j) { j["trajectory"]["knots"] = {0, 0.5, 1, 1}; }), "trajectory.knots", "clamped");
    expectError(broken([](Value& j) { j["trajectory"]["knots"] = {0, 0, 2, 2}; }), "trajectory", "0 to 1");
    expectError(broken([](Value& j) { j["orientation"]["knots"][1] = {0, 0, 1, 0}; }), "orientation.knots[1][3]", "smaller");
    expectError(broken([](Value& j) {
                  j["orientation"]["poles"][1][0] = {1, 0, 0};
                }),
                "orientation.poles[1][0]", "quaternion");
    expectError(broken([](Value& j) { j["orientation"]["poles"][1].erase(1); }), "orientation.poles[1]", "2 poles");
    expectError(broken([](Value& j) { j["orientation"]["closed_u"] = "yes"; }), "orientation.closed_u", "anti-periodic");
    expectError(broken([](Value& j) { j["scaling"]["poles"][0][1][3] = 0; }), "scaling.poles[0][1][3]", "above 0");
    expectError(broken([](Value& j) { j["scaling"]["knots"] = {{0, 0, 2, 2}, {0, 0, 1, 1}}; }), "scaling", "in u");
    expectError(broken([](Value& j) { j["point"] = {1, 2}; }), "point", "[x, y, z]");
    expectError(broken([](Value& j) { j["orientation"]["degree"] = 3; }), "orientation.degree", "two degrees");
    // Sizes at which a surface could not be measured any more.
    expectError(broken([](Value& j) { j["scaling"]["poles"][0][0][1] = 1e200; }), "scaling.poles[0][0][1]", "1e9");
    expectError(broken([](Value& j) { j["point"][2] = -1e15; }), "point[2]", "1e9");
  }

  void rubbishIsNotAMotion() {
    VERIFY_ERROR(readText(""), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText("{\"trajectory\": {"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText(std::string(100000, '[')), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText("{\"trajectory\": {\"degree\": 1, \"knots\": [0, 0, 1e999, 1]}}"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(format_.read(folder_.path() / "absent.json", Value::object(), Progress::none()), ErrorCode::FileNotFound);
  }

  void brokenTextIsNamedWithItsLine() {
    const auto message = [this](const std::string& text) -> std::string {
      try {
        (void)readText(text);
      } catch (const Error& error) {
        return error.message();
      }
      return "";
    };
    const std::string nan = message("{\"point\": [\n  0, NaN, 1]}");
    QVERIFY2(nan.find("line 2, column 6") != std::string::npos, nan.c_str());
    const std::string cut = message("{\"point\": [");
    QVERIFY2(cut.find("line 1, column 12") != std::string::npos, cut.c_str());
    const std::string large = message("{\"point\": [1e309, 0, 0]}");
    QVERIFY2(large.find("1e309") != std::string::npos, large.c_str());
  }

  void closedKnotsWithASeamOfHigherMultiplicity() {
    // u0 = u1: the seam is a double knot; the unwrapped vector repeats it on both sides, exactly.
    const std::vector<double> knots = unwrappedKnots(2, {0, 0, 0.3, 0.7, 1});
    QCOMPARE(knots.size(), std::size_t(9));
    COMPARE_NEAR(knots[0], -0.7, 1e-15);
    COMPARE_NEAR(knots[1], -0.3, 1e-15);
    COMPARE_NEAR(knots[8], 1.3, 1e-15);
    QCOMPARE(knots[2], knots[3]);
    QCOMPARE(knots[6], knots[7]);
  }

  /// The seam of a closed factor is a knot like others, which stands at both ends of the period.
  void seamsThatTearAreRefused() {
    Value closed = small();
    closed["orientation"]["closed_u"] = "anti-periodic";
    closed["orientation"]["knots"][0] = {0, 0.5, 1};
    closed["scaling"] = Value::parse(R"({"degree": [3, 1], "knots": [[0, 0, 0, 0.5, 1, 1], [0, 0, 1, 1]], "poles": []})");
    for (const double r : {10, 10, 14, 14, 10}) {
      const Value pole{r, r, r, 1.0};
      closed["scaling"]["poles"].push_back({pole, pole});
    }
    expectError(closed, "scaling.knots[0]", "repeats the knot of the seam, 0 = 1, 4 times");
    closed["scaling"]["knots"][0] = {0.3, 0.3, 0.3, 0.5, 0.9, 1.3};  // three times: a corner
    for (auto& knot : closed["orientation"]["knots"][0]) knot = knot.get<double>() + 0.3;
    Motion motion = motionOf(closed);
    validate(motion);
    // Numbers of which one period later is not the same sum in floating point.
    const Surface& s = motion.scaling;
    std::vector<Vec4> poles(s.poles.begin(), s.poles.begin() + 10);
    motion.scaling = unwrapped(3, 1, {0.3, 0.3, 0.3, 0.5, 1.3, 1.3}, s.knotsV, poles, 1);
    try {
      validate(motion);
      QFAIL("accepted");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::InvalidInput);
      QVERIFY2(error.message().find("at its seam u = 0.3") != std::string::npos, error.what());
    }
  }
};

BLOSSOM_TEST(MotionTest)
#include "motion_test.moc"
