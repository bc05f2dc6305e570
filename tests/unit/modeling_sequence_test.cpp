// Sequences in time, and features of several plugins that take them frame by frame.
#include <QTemporaryDir>

#include "document/evaluator.h"
#include "modeling/kernel/parts/sequence_times.h"
#include "support/command_line.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::modeling;
using namespace blossom::test;
using std::numbers::pi;

namespace {

/// A rectangle of 10 x 10 that grows to one of 20 x 30; and the area of it at a time.
Shape growing(int frames) {
  return made("morph", {{"frames", frames}}, {rectangle(0, 0, 10, 10), rectangle(0, 0, 20, 30)}).shape;
}
double grown(double t) { return (10 + 10 * t) * (10 + 20 * t); }

const std::vector<Shape>& framesOf(const Shape& shape) { return shape.get<Sequence>()->frames; }
const std::vector<double>& timesOf(const Shape& shape) { return shape.get<Sequence>()->times; }

/// Frames that are told apart: squares of side 1, 2, 3 ..
Sequence numbered(const std::vector<double>& times) {
  Sequence sequence{{}, times};
  for (std::size_t k = 0; k < times.size(); ++k) sequence.frames.emplace_back(rectangle(0, 0, double(k + 1), double(k + 1)));
  return sequence;
}
std::vector<int> numbersOf(const Sequence& sequence) {
  std::vector<int> numbers;
  for (const Shape& frame : sequence.frames) numbers.push_back(int(std::lround(std::sqrt(area(*frame.get<Region>())))));
  return numbers;
}

/// Every frame of a sequence has the figure that a function of the time tells.
template <class F>
void compareFrames(const Shape& shape, const char* name, double tolerance, const F& expected) {
  QVERIFY(shape.get<Sequence>());
  const auto& frames = framesOf(shape);
  QCOMPARE(timesOf(shape).size(), frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double wanted = expected(timesOf(shape)[k]);
    COMPARE_NEAR(figure(frames[k], name), wanted, tolerance * wanted);
  }
}

Feature featureOf(const FeatureId& id, const char* command, Value parameters, std::vector<FeatureId> inputs = {}) {
  Feature feature;
  feature.id = feature.name = id;
  feature.type = theApp().registry->at(command)->id;
  feature.parameters = std::move(parameters);
  feature.inputs = std::move(inputs);
  return feature;
}

constexpr std::array eases{Ease::Linear, Ease::In, Ease::Out, Ease::InOut};

}  // namespace

class ModelingSequenceTest : public QObject {
  Q_OBJECT

 private slots:
  void aMorphIsExtruded() {
    const Shape plates = made("extrude", {{"height", 5.0}}, {growing(5)}).shape;
    QCOMPARE(timesOf(plates), (std::vector{0.0, 0.25, 0.5, 0.75, 1.0}));
    compareFrames(plates, "volume", 1e-9, [](double t) { return 5 * grown(t); });
  }

  void sequencesAreCombined() {
    const Shape holes = made("morph", {{"frames", 4}}, {rectangle(2, 2, 4, 4), rectangle(2, 2, 8, 5)}).shape;
    const auto left = [](double t) { return grown(t) - (2 + 4 * t) * (2 + t); };
    const Shape frames = made("boolean", {{"operation", "difference"}}, {growing(4), holes}).shape;
    compareFrames(frames, "area", 1e-9, left);
    const Shape plates = made("extrude", {{"height", 5.0}}, {growing(4)}).shape;
    const Shape pins = made("extrude", {{"height", 3.0}}, {holes}).shape;
    compareFrames(made("boolean", {{"operation", "difference"}}, {plates, pins}).shape, "volume", 1e-9,
                  [](double t) { return 5 * grown(t) - 3 * (2 + 4 * t) * (2 + t); });
    const Shape block = made("box", {{"width", 5.0}, {"depth", 5.0}, {"height", 5.0}}).shape;
    compareFrames(made("boolean", {{"operation", "intersection"}}, {plates, block}).shape, "volume", 1e-9,
                  [](double) { return 125; });
    VERIFY_REFUSED(refusal("boolean", {}, {growing(4), growing(5)}), ErrorCode::InvalidInput, "4 frames, another 5");
  }

  void sequencesAreMovedRepeatedAndMirrored() {
    compareFrames(made("transform", {{"scale", 2.0}, {"move", {3, 4, 0}}}, {growing(3)}).shape, "area", 1e-9,
                  [](double t) { return 4 * grown(t); });
    compareFrames(made("pattern", {{"count", 3}, {"step", {100, 0, 0}}}, {growing(3)}).shape, "area", 1e-9,
                  [](double t) { return 3 * grown(t); });
    compareFrames(made("mirror", {{"point", {-1, 0, 0}}}, {growing(3)}).shape, "area", 1e-9,
                  [](double t) { return 2 * grown(t); });
  }

  void otherPluginsTakeThemToo() {
    const Shape rounded = made("minkowski-sum", {}, {growing(3), Region{{circle({0, 0}, 1)}}}).shape;
    compareFrames(rounded, "area", 1e-9, [](double t) { return grown(t) + 2 * (20 + 30 * t) + pi; });
    const Shape between = made("morph", {{"t", 0.5}}, {growing(3), rectangle(0, 0, 10, 10)}).shape;
    compareFrames(between, "area", 1e-9, [](double t) { return (10 + 5 * t) * (10 + 10 * t); });
    VERIFY_REFUSED(refusal("morph", {{"frames", 5}}, {growing(3), rectangle(0, 0, 10, 10)}), ErrorCode::InvalidInput,
                   "A sequence of sequences");
  }

  void whatFailsIsNamedByItsFrame() {
    const Shape plates = made("extrude", {{"height", 5.0}}, {growing(3)}).shape;
    compareFrames(made("fillet", {{"radius", 0.5}}, {plates}).shape, "closed", 1e-12, [](double) { return 1; });
    const Error error = refusal("fillet", {{"radius", 25}}, {plates});
    QVERIFY2(error.message().starts_with("Frame 1 (t = 0): "), error.what());
    const Document document =
        Document()
            .with(featureOf("a", "rectangle", {{"width", 10}, {"height", 10}}))
            .with(featureOf("b", "rectangle", {{"width", 20}, {"height", 30}}))
            .with(featureOf("m", "morph", {{"frames", 3}}, {"a", "b"}))
            .with(featureOf("e", "extrude", {{"height", 5}}, {"m"}))
            .with(featureOf("f", "fillet", {{"edges", Value::array({{{"input", "shape"}, {"kind", "edge"}, {"index", 2}}})}},
                            {"e"}));
    const Results results = Evaluator(theApp().registry).evaluate(document, {});
    QVERIFY(!results.at("e")->error);
    QVERIFY(results.at("f")->error);
    QCOMPARE(results.at("f")->error->message(),
             std::string("Fillet names edge 2 of a sequence, and each of its frames has its own."));
  }

  void oneFrameIsTakenOut() {
    const Shape run = growing(5);
    for (int k = 1; k <= 5; ++k)
      COMPARE_NEAR(figure(made("frame", {{"number", k}}, {run}).shape, "area"), grown((k - 1) / 4.0), 1e-9);
    const std::vector<std::pair<double, int>> nearest{{0.3, 2}, {0.375, 2}, {0.376, 3}, {-4.0, 1}, {9.0, 5}};
    for (const auto& [time, number] : nearest) {
      const Evaluated frame = made("frame", {{"time", time}}, {run});
      QCOMPARE(frame.stats.at("frame"), Value(number));
      COMPARE_NEAR(figure(frame.shape, "area"), grown((number - 1) / 4.0), 1e-9);
      QCOMPARE(frame.warnings.empty(), time >= 0 && time <= 1);  // such a time was hardly meant
    }
    const Error error = refusal("frame", {{"number", 6}}, {run});
    QCOMPARE(error.message(), std::string("Frame 6 is asked for, and the sequence has 5 frames."));
    QCOMPARE(error.hint(), std::string("Give a number from 1 to 5."));
    QCOMPARE(refusal("frame", {}, {rectangle(0, 0, 1, 1)}).code(), ErrorCode::InvalidInput);
  }

  void easesAreWhatTheySay() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> any(0, 1);
    for (int i = 0; i < 2000; ++i) {
      const double s = any(random), way = any(random);
      QCOMPARE(easedWay(Ease::Linear, s), s);
      COMPARE_NEAR(easedWay(Ease::In, s), s * s, 1e-15);
      COMPARE_NEAR(easedWay(Ease::Out, s), 2 * s - s * s, 1e-15);
      COMPARE_NEAR(easedWay(Ease::InOut, s), 3 * s * s - 2 * s * s * s, 1e-15);
      for (const Ease ease : eases) {
        COMPARE_NEAR(easedWay(ease, easedTime(ease, way)), way, 1e-14);
        COMPARE_NEAR(easedWay(ease, s) + easedWay(ease == Ease::In    ? Ease::Out
                                                  : ease == Ease::Out ? Ease::In
                                                                      : ease,
                                                  1 - s),
                     1, 1e-14);
      }
    }
    for (const Ease ease : eases) {
      QCOMPARE(easedTime(ease, 0), 0.0);
      QCOMPARE(easedTime(ease, 1), 1.0);
      QCOMPARE(easedWay(ease, -1), 0.0);
      QCOMPARE(easedWay(ease, 2), 1.0);
    }
  }

  /// Frames stay and their times move: at its time, each is where the ease has come to.
  void easedFramesKeepTheirPlaces() {
    const Sequence run = numbered({2, 2.5, 3, 3.5, 6});
    for (const Ease ease : eases) {
      const Sequence eased = retimed(run, {.ease = ease});
      QCOMPARE(numbersOf(eased), numbersOf(run));
      for (std::size_t k = 0; k < run.times.size(); ++k)
        COMPARE_NEAR(2 + 4 * easedWay(ease, (eased.times[k] - 2) / 4), run.times[k], 1e-12);
    }
    QCOMPARE(retimed(run, {}).times, run.times);
    QCOMPARE(retimed(numbered({0, 0.25, 1}), {.ease = Ease::In}).times, (std::vector{0.0, 0.5, 1.0}));
  }

  void reversedTwiceIsTheSame() {
    const Sequence run = numbered({0, 0.25, 0.5, 1});
    const Sequence back = retimed(run, {.reverse = true});
    QCOMPARE(numbersOf(back), (std::vector{4, 3, 2, 1}));
    QCOMPARE(back.times, (std::vector{0.0, 0.5, 0.75, 1.0}));
    const Sequence again = retimed(back, {.reverse = true});
    QCOMPARE(numbersOf(again), numbersOf(run));
    QCOMPARE(again.times, run.times);
    QCOMPARE(numbersOf(retimed(run, {.reverse = true, .ease = Ease::In, .frames = 3})), (std::vector{4, 4, 1}));
  }

  /// Each of the new frames is an old one, and none is nearer to where the ease has come to.
  void resampledFramesAreTheNearest() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> step(0, 1);
    for (int i = 0; i < 50; ++i) {
      std::vector<double> times{-3};
      while (times.size() < 12) times.push_back(times.back() + step(random));
      const Sequence run = numbered(times);
      const double span = times.back() - times.front();
      for (const Ease ease : eases) {
        const Sequence made = retimed(run, {.ease = ease, .frames = 29});
        const std::vector<int> numbers = numbersOf(made);
        QCOMPARE(numbers.size(), std::size_t{29});
        for (std::size_t j = 0; j < 29; ++j) {
          COMPARE_NEAR(made.times[j], -3 + span * double(j) / 28, 1e-12);
          const double wanted = -3 + span * easedWay(ease, double(j) / 28);
          const double distance = std::abs(times[std::size_t(numbers[j]) - 1] - wanted);
          for (const double time : times) QVERIFY(distance <= std::abs(time - wanted) + 1e-12);
        }
      }
    }
    QCOMPARE(numbersOf(retimed(numbered({0, 0.5, 1}), {.frames = 1})), std::vector{1});
    QCOMPARE(numbersOf(retimed(numbered({4}), {.frames = 3})), (std::vector{1, 1, 1}));
    VERIFY_ERROR(retimed(Sequence(), {}), ErrorCode::InvalidInput);
  }

  void joinedFramesFollowEachOther() {
    const Shape three = numbered({0, 0.5, 1}), two = numbered({5, 7}), one = rectangle(0, 0, 9, 9);
    const std::vector<Shape> parts{three, two, one};
    const Sequence even = joinedInTime(parts, {});
    QCOMPARE(numbersOf(even), (std::vector{1, 2, 3, 1, 2, 9}));
    QCOMPARE(even.times, (std::vector{0.0, 0.2, 0.4, 0.6, 0.8, 1.0}));
    // 1 and 2 long in three steps: a step is 1, so that it is 1 + 1 + 2 + 1 long
    const Sequence long5 = joinedInTime(parts, {.keepLengths = true});
    const std::vector wanted{0.0, 0.1, 0.2, 0.4, 0.8, 1.0};
    for (std::size_t k = 0; k < wanted.size(); ++k) COMPARE_NEAR(long5.times[k], wanted[k], 1e-15);
    const Sequence merged = joinedInTime(std::vector{three, two, three}, {.keepLengths = true, .mergeEnds = true});
    QCOMPARE(numbersOf(merged), (std::vector{1, 2, 3, 2, 2, 3}));
    const std::vector steps{0.0, 0.125, 0.25, 0.75, 0.875, 1.0};
    for (std::size_t k = 0; k < steps.size(); ++k) COMPARE_NEAR(merged.times[k], steps[k], 1e-15);
    QCOMPARE(joinedInTime(std::vector{one, one, one}, {.keepLengths = true}).times, (std::vector{0.0, 0.5, 1.0}));
    const Shape many = Sequence{std::vector<Shape>(maximumFrames, one), std::vector<double>(maximumFrames, 0)};
    VERIFY_ERROR(joinedInTime(std::vector{many, one}, {}), ErrorCode::LimitExceeded);
    QCOMPARE(joinedInTime(std::vector{many}, {}).frames.size(), maximumFrames);
  }

  /// There and back is the same from both ends.
  void featuresJoinAndReverse() {
    const Shape there = growing(4);
    const Shape back = made("sequence-retime", {{"reverse", true}}, {there}).shape;
    const Shape both = made("sequence-join", {{"merge-ends", true}}, {there, back}).shape;
    QCOMPARE(framesOf(both).size(), std::size_t{7});
    compareFrames(both, "area", 1e-9, [](double t) { return grown(1 - std::abs(1 - 2 * t)); });
    const Shape few = made("sequence-retime", {{"frames", 2}, {"ease", "in-out"}}, {there}).shape;
    compareFrames(made("boolean", {}, {few, growing(2)}).shape, "area", 1e-9, grown);
  }

  void theRecipe() {
    QTemporaryDir folder;
    const auto blossom = [&](const QStringList& arguments) { return answerOf(folder.path(), arguments); };
    const auto sizeOf = [&](const char* file) { return fs::file_size(fs::path(folder.path().toStdString()) / file); };
    QCOMPARE(blossom({"morph", "rectangle:10:10", "rectangle:20:30", "--frames", "3", "-o", "grow.blossom"}).code, 0);
    const Answer plates = blossom({"extrude", "grow.blossom", "--height", "5", "-o", "plate.step,plates.blossom"});
    QVERIFY2(plates.code == 0, plates.json.dump().c_str());
    QCOMPARE(plates.json["result"]["kind"], Value("sequence"));
    QCOMPARE(plates.json["result"]["frames"], Value(3));
    QCOMPARE(plates.json["outputs"].size(), std::size_t{4});
    QVERIFY(sizeOf("plate-0001.step") > 0 && sizeOf("plate-0003.step") > 0);
    COMPARE_NEAR(blossom({"info", "plate-0002.step"}).result("volume"), 5 * grown(0.5), 1e-6);
    const Answer middle = blossom({"frame", "plates.blossom", "--number", "2"});
    COMPARE_NEAR(middle.result("volume"), 5 * grown(0.5), 1e-6);
    QCOMPARE(middle.json["stats"]["frame_time"], Value(0.5));
    const Answer odd = blossom({"boolean", "plates.blossom", "plates.blossom", "grow.blossom"});
    QCOMPARE(odd.code, 1);
    QVERIFY2(odd.message().starts_with("Frame 1 (t = 0): "), odd.message().c_str());
  }
};

BLOSSOM_TEST(ModelingSequenceTest)
#include "modeling_sequence_test.moc"
