// Sequences are shapes: one rule by which every feature takes them frame by frame, with features made up for it.
#include "feature/frame_by_frame.h"

#include <QTemporaryDir>
#include <atomic>

#include "document/evaluation/evaluation.h"
#include "document/storage.h"
#include "feature/acceptance.h"
#include "feature/registry.h"
#include "geometry/planar/planar.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Shape pointOnAxis(double value) {
  Mesh mesh;
  mesh.points = {Vec3(value, 0, 0)};
  return mesh;
}

double abscissaOf(const Shape& shape) { return shape.get<Mesh>()->points.at(0).x(); }

Sequence sequenceOf(std::vector<Shape> frames) {
  Sequence sequence{std::move(frames), {}};
  const std::size_t count = sequence.frames.size();
  for (std::size_t k = 0; k < count; ++k) sequence.times.push_back(count < 2 ? 0 : double(k) / double(count - 1));
  return sequence;
}

Shape series(const std::vector<double>& values) {
  std::vector<Shape> frames;
  for (const double value : values) frames.push_back(pointOnAxis(value));
  return sequenceOf(std::move(frames));
}

std::vector<double> abscissasOf(const Shape& shape) {
  std::vector<double> values;
  for (const Shape& frame : shape.get<Sequence>()->frames) values.push_back(abscissaOf(frame));
  return values;
}

struct Add {
  double add = 0, failAt = -1, endlessAt = -1;
  int frames = 0;
  Value part;
};

/// The sum of points on the x axis. It tells and fails by what comes out.
Evaluated added(const Add& p, const Inputs& in, const Progress& progress) {
  double sum = p.add;
  for (const Shape& part : in.of(0)) sum += abscissaOf(part);
  progress.report(0.5, "adding");
  if (sum == p.failAt) throw Error(ErrorCode::Degenerate, "It collapses.", "Make it larger.");
  while (sum == p.endlessAt) progress.check();
  Evaluated out{pointOnAxis(sum), {{"sum", sum}, {"terms", in.of(0).size()}, {"kernel_ms", 2.0}, {"gap_mm", sum / 2}}, {}};
  out.figures = {{"size", sum, MeasureUnit::Length}, {"kind of", std::string("sum"), MeasureUnit::None}};
  if (sum > 2) out.warnings = {"It is large."};
  if (p.frames > 0) {
    std::vector<Shape> frames;
    for (int k = 0; k < p.frames; ++k) frames.push_back(pointOnAxis(sum + k));
    out.shape = sequenceOf(std::move(frames));
  }
  return out;
}

std::shared_ptr<Registry> registry(const std::shared_ptr<std::atomic<int>>& evaluations = {}) {
  auto made = std::make_shared<Registry>();
  made->add(feature<Add>("test.add", "Sum", "Adds points.")
                .produces({ShapeKind::Mesh})
                .playedBy({.parameter = "frames"})
                .input({.name = "part",
                        .help = "What is added.",
                        .kinds = {ShapeKind::Mesh},
                        .minimum = 0,
                        .maximum = anyNumber,
                        .use = InputUse::Consumed})
                .parameter("add", &Add::add, number(), "Number.")
                .parameter("fail-at", &Add::failAt, number(), "Fails at this sum.")
                .parameter("endless-at", &Add::endlessAt, number(), "Works for ever at this sum.")
                .parameter("frames", &Add::frames, count(0, 100), "A sequence of that many.")
                .parameter("corner", &Add::part, optional(subShape("vertex")), "A part of the input.")
                .evaluate([evaluations](const Add& p, const Inputs& in, const Progress& progress) {
                  if (evaluations) ++*evaluations;
                  return added(p, in, progress);
                }));
  struct None {};
  made->add(feature<None>("test.area", "Area", "Takes regions.")
                .input({.name = "outline", .help = "An outline.", .kinds = {ShapeKind::Region}, .use = InputUse::Outline})
                .evaluate([](const None&, const Inputs& in, const Progress&) -> Evaluated {
                  return {pointOnAxis(area(in.get<Region>())), Value::object(), {}};
                }));
  made->add(feature<None>("test.length", "Number of frames", "Takes sequences as they are.")
                .input({.name = "sequence", .help = "A sequence.", .kinds = {ShapeKind::Sequence}})
                .evaluate([](const None&, const Inputs& in, const Progress&) -> Evaluated {
                  return {pointOnAxis(double(in.get<Sequence>().frames.size())), Value::object(), {}};
                }));
  return made;
}

Evaluated evaluated(const std::string& command, const Value& parameters, const std::vector<Shape>& inputs,
                    const Progress& progress = Progress::none()) {
  const auto type = registry()->at(command);
  return evaluatedFeature(*type, completed(type->parameters, parameters), arrangedInputs(*type, inputs), progress);
}

Error refused(const std::string& command, const Value& parameters, const std::vector<Shape>& inputs) {
  try {
    evaluated(command, parameters, inputs);
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::Internal, "");
}

bool holds(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

Feature featureOf(const FeatureId& id, const char* type, Value parameters, std::vector<FeatureId> inputs = {}) {
  Feature made;
  made.id = made.name = id;
  made.type = type;
  made.parameters = std::move(parameters);
  made.inputs = std::move(inputs);
  return made;
}

/// A sequence of three, and it with 10 added.
Document document() {
  return Document()
      .with(featureOf("run", "test.add", {{"add", 1}, {"frames", 3}}))
      .with(featureOf("ten", "test.add", {{"add", 10}}))
      .with(featureOf("all", "test.add", Value::object(), {"run", "ten"}));
}

}  // namespace

class FrameByFrameTest : public QObject {
  Q_OBJECT

 private slots:
  void aPlainShapeIsTheSameInEveryFrame() {
    const Shape run = series({1, 2, 4});
    const Evaluated made = evaluated("add", {{"add", 0.5}}, {run, pointOnAxis(10)});
    QCOMPARE(abscissasOf(made.shape), (std::vector{11.5, 12.5, 14.5}));
    QCOMPARE(made.shape.get<Sequence>()->times, run.get<Sequence>()->times);
    QCOMPARE(abscissasOf(evaluated("add", {}, {pointOnAxis(10), run}).shape), (std::vector{11.0, 12.0, 14.0}));
    QCOMPARE(abscissaOf(evaluated("add", {}, {pointOnAxis(10), pointOnAxis(1)}).shape), 11.0);
  }

  void sequencesGoTogether() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> any(-5, 5);
    std::vector<double> a(17), b(17), sum(17);
    for (std::size_t k = 0; k < a.size(); ++k) sum[k] = (a[k] = any(random)) + (b[k] = any(random));
    QCOMPARE(abscissasOf(evaluated("add", {}, {series(a), series(b)}).shape), sum);
  }

  void oneFrameMakesASequenceOfOne() { QCOMPARE(abscissasOf(evaluated("add", {}, {series({3})}).shape), std::vector{3.0}); }

  void differentNumbersOfFramesAreRefused() {
    const Error error = refused("add", {}, {series({1, 2, 3}), pointOnAxis(0), series({1, 2})});
    QCOMPARE(error.code(), ErrorCode::InvalidInput);
    QVERIFY2(holds(error.message(), "3 frames, another 2."), error.what());
    QVERIFY2(holds(error.hint(), "sequence-retime"), error.hint().c_str());
  }

  void framesMustBeOfAKindThatIsTaken() {
    const Shape disc = circleRegion(1);
    const auto message = [&](const Shape& given) { return refused("add", {}, {given}).message(); };
    QCOMPARE(message(sequenceOf({pointOnAxis(1), disc})),
             std::string("The input \"part\" of Sum takes a mesh; it got a sequence whose frame 2 is a region."));
    QVERIFY(holds(message(Sequence()), "it got a sequence without frames."));
    QVERIFY(holds(message(sequenceOf({series({1, 2})})), "it got a sequence whose frame 1 is a sequence."));
  }

  /// As a single outline is: its frames become regions, and one that is open is named.
  void framesOfCurvesBecomeRegions() {
    const auto outline = [](double side, bool closed) {
      Curves curves{{rectanglePath({0, 0}, {side, side})}};
      if (!closed) curves.paths.front().segments.pop_back();
      curves.paths.front().closed = closed;
      return Shape(curves);
    };
    const Evaluated made = evaluated("area", {}, {sequenceOf({outline(1, true), outline(2, true), outline(3, true)})});
    QCOMPARE(abscissasOf(made.shape), (std::vector{1.0, 4.0, 9.0}));
    const Error open = refused("area", {}, {sequenceOf({outline(1, true), outline(2, true), outline(3, false)})});
    QVERIFY2(open.message().starts_with("Frame 3 (t = 1): "), open.what());
  }

  void whatIsDeclaredToTakeSequencesGetsThem() {
    QCOMPARE(abscissaOf(evaluated("length", {}, {series({7, 7, 7, 7})}).shape), 4.0);
    QCOMPARE(refused("length", {}, {pointOnAxis(1)}).code(), ErrorCode::InvalidInput);
  }

  void theRuleOfWhatIsAccepted() {
    const auto types = registry();
    const InputSpec& parts = types->at("add")->inputs[0];
    const InputSpec& outline = types->at("area")->inputs[0];
    const InputSpec& whole = types->at("length")->inputs[0];
    const Shape run = series({1, 2}), discs = sequenceOf({circleRegion(1), circleRegion(2)});
    QVERIFY(accepts(parts, run) && !accepts(parts, discs) && accepts(outline, discs) && !accepts(outline, run));
    QVERIFY(accepts(whole, run) && accepts(whole, discs) && !accepts(whole, pointOnAxis(1)));
    QVERIFY(takenByFrames(parts, run) && !takenByFrames(whole, run) && !takenByFrames(parts, pointOnAxis(1)));
    QVERIFY(!takenByFrames(InputSpec{.name = "any", .help = "", .kinds = {}}, run));
    QVERIFY(consumes(parts, run) && consumes(outline, discs) && !consumes(whole, run));
  }

  void anErrorNamesItsFrame() {
    const Error error = refused("add", {{"fail-at", 4}}, {series({1, 2, 3, 4, 5})});
    QCOMPARE(error.code(), ErrorCode::Degenerate);
    QCOMPARE(error.message(), std::string("Frame 4 (t = 0.75): It collapses."));
    QCOMPARE(error.hint(), std::string("Make it larger."));
  }

  void figuresAndWarningsAreToldTogether() {
    const Evaluated made = evaluated("add", {}, {series({1, 3, 5, 2, 4})});
    QCOMPARE(made.stats, (Value{{"gap_least_mm", 0.5},
                                {"gap_most_mm", 2.5},
                                {"kernel_ms", 10.0},
                                {"sum_least", 1.0},
                                {"sum_most", 5.0},
                                {"terms", 1}}));
    QCOMPARE(made.figures.size(), std::size_t{3});
    QCOMPARE(made.figures[0].name, std::string("size_least"));
    QCOMPARE(std::get<double>(made.figures[1].value), 5.0);
    QCOMPARE(std::get<std::string>(made.figures[2].value), std::string("sum"));
    QCOMPARE(made.warnings, std::vector<std::string>{"Frames 2, 3 and 5: It is large."});
    QCOMPARE(evaluated("add", {}, {series({1, 4, 5, 6, 0, 7})}).warnings,
             std::vector<std::string>{"Frames 2 to 4 and 6: It is large."});
    QCOMPARE(evaluated("add", {}, {series({3, 4})}).warnings, std::vector<std::string>{"Every frame: It is large."});
    QCOMPARE(evaluated("add", {}, {series({1, 4})}).warnings, std::vector<std::string>{"Frame 2: It is large."});
  }

  void sequencesOfSequencesAreRefused() {
    const Error early = refused("add", {{"frames", 4}}, {series({1, 2})});
    QCOMPARE(early.code(), ErrorCode::InvalidInput);
    QVERIFY2(early.message().starts_with("A sequence of sequences would come out: Sum "), early.what());
    QVERIFY2(holds(early.hint(), "Set \"frames\" to 0") && holds(early.hint(), "\"frame\""), early.hint().c_str());
    const Error late = refused("add", {{"frames", 1}}, {series({1, 2})});
    QVERIFY2(holds(late.message(), "A sequence of sequences"), late.what());
    QCOMPARE(abscissasOf(evaluated("add", {{"frames", 4}}, {pointOnAxis(1)}).shape), (std::vector{1.0, 2.0, 3.0, 4.0}));
  }

  void thereIsALimit() {
    const std::vector<double> many(maximumFrames + 1, 1);
    QCOMPARE(refused("add", {}, {series(many)}).code(), ErrorCode::LimitExceeded);
  }

  void progressIsDividedAmongTheFrames() {
    std::vector<double> told;
    std::vector<std::string> stages;
    evaluated("add", {}, {series({1, 2, 3, 4})}, Progress({}, [&](double fraction, const std::string& stage) {
                told.push_back(fraction);
                stages.push_back(stage);
              }));
    QCOMPARE(told, (std::vector{0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}));
    QCOMPARE(stages.at(3), std::string("frame 2 of 4, adding"));
  }

  void itIsCancelledBetweenAndWithinFrames() {
    for (const double endless : {-1.0, 3.0}) {
      const CancelToken token;
      int told = 0;
      const Progress progress(token, [&](double fraction, const std::string&) {
        ++told;
        if (fraction >= 0.6) token.cancel();  // in the middle of frame 3
      });
      VERIFY_ERROR(evaluated("add", {{"endless-at", endless}}, {series({1, 2, 3, 4})}, progress), ErrorCode::Cancelled);
      QCOMPARE(told, 6);
    }
  }

  /// Saved, loaded and computed anew it is the same; what did not change is not computed again.
  void documentsHoldThem() {
    const auto evaluations = std::make_shared<std::atomic<int>>(0);
    Evaluator evaluator(registry(evaluations));
    const Results results = evaluator.evaluate(document(), {});
    QVERIFY(!results.at("all")->error);
    QCOMPARE(abscissasOf(results.at("all")->evaluated.shape), (std::vector{11.0, 12.0, 13.0}));
    QCOMPARE(evaluations->load(), 2 + 3);
    evaluator.evaluate(document(), {});
    QCOMPARE(evaluations->load(), 2 + 3);
    evaluator.evaluate(document().with(featureOf("ten", "test.add", {{"add", 20}})), {});
    QCOMPARE(evaluations->load(), 2 + 3 + 1 + 3);
    QTemporaryDir folder;
    const fs::path file = fs::path(folder.path().toStdString()) / "run.blossom";
    saveDocument(document(), file);
    const Results again = Evaluator(registry()).evaluate(openDocument(file).document, {});
    QCOMPARE(abscissasOf(again.at("all")->evaluated.shape), (std::vector{11.0, 12.0, 13.0}));
  }

  void theBackgroundTakesThemToo() {
    Evaluator evaluator(registry());
    Results results;
    evaluator.evaluateInBackground(document(), {}, {}, [&](Results made) { results = std::move(made); });
    evaluator.waitForBackground();
    QCOMPARE(abscissasOf(results.at("all")->evaluated.shape), (std::vector{11.0, 12.0, 13.0}));
  }

  void partsOfASequenceAreRefused() {
    const Value corner{{"input", "part"}, {"kind", "vertex"}, {"index", 0}};
    const Document picked = document().with(featureOf("all", "test.add", {{"corner", corner}}, {"run"}));
    const auto result = Evaluator(registry()).evaluate(picked, {}).at("all");
    QVERIFY(result->error);
    QCOMPARE(result->error->message(), std::string("Sum names vertex 0 of a sequence, and each of its frames has its own."));
    QVERIFY(holds(result->error->hint(), "\"frame\""));
  }
};

BLOSSOM_TEST(FrameByFrameTest)
#include "frame_by_frame_test.moc"
