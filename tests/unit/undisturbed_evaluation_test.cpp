// Documents that change while they are evaluated: what stays the same goes on, whatever else is done meanwhile.
#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include "document/evaluation/costs.h"
#include "document/evaluator.h"
#include "support/gate.h"
#include "support/support.h"

using namespace blossom;
using test::Gate;

namespace {

void waitFor(const std::function<bool()>& reached) {
  while (!reached()) std::this_thread::yield();
}

struct Number {
  double value = 0;
  int frames = 0;
};

Shape mesh(double value) {
  Mesh made;
  made.points = {Vec3(value, 0, 0)};
  return made;
}

/// A type whose evaluation passes the gate, if any.
FeatureType numberType(const char* id, Gate* gate) {
  return feature<Number>(id, "Number", "A number.")
      .input({"part", "What comes before.", {ShapeKind::Mesh}, 0, anyNumber})
      .parameter("value", &Number::value, number(), "The number.")
      .parameter("frames", &Number::frames, count(), "Frames, which are not made.")
      .evaluate([gate](const Number& p, const Inputs& in, const Progress& progress) -> Evaluated {
        if (gate) gate->pass(progress);
        double sum = p.value;
        for (const Shape& part : in.of(0)) sum += part.get<Mesh>()->points.at(0).x();
        return {mesh(sum), Value::object(), {}};
      });
}

Feature valueFeature(const char* type, const FeatureId& id, double value, std::vector<FeatureId> inputs = {}) {
  Feature feature;
  feature.id = feature.name = id;
  feature.type = type;
  feature.parameters = {{"value", value}};
  feature.inputs = std::move(inputs);
  return feature;
}

Feature quick(const FeatureId& id, double value) { return valueFeature("test.quick", id, value); }
Feature slow(const FeatureId& id, double value, std::vector<FeatureId> inputs = {}) {
  return valueFeature("test.slow", id, value, std::move(inputs));
}

/// What was shown and finished, from any thread.
class Seen {
 public:
  Evaluator::Show show() {
    return [this](const FeatureId& id, const auto&, const Progress&) {
      const std::lock_guard lock(mutex_);
      shown_.insert(id);
    };
  }
  std::function<void(Results)> finished() {
    return [this](Results results) {
      const std::lock_guard lock(mutex_);
      finished_.push_back(std::move(results));
    };
  }
  bool shown(const FeatureId& id) {
    const std::lock_guard lock(mutex_);
    return shown_.contains(id);
  }
  std::vector<Results> all() {
    const std::lock_guard lock(mutex_);
    return finished_;
  }
  double value(const FeatureId& id) { return all().back().at(id)->evaluated.shape.get<Mesh>()->points.at(0).x(); }

 private:
  std::mutex mutex_;
  std::set<FeatureId> shown_;
  std::vector<Results> finished_;
};

std::shared_ptr<Registry> typesWith(Gate& gate) {
  auto registry = std::make_shared<Registry>();
  registry->add(numberType("test.quick", nullptr));
  registry->add(numberType("test.slow", &gate));
  return registry;
}

}  // namespace

class UndisturbedEvaluationTest : public QObject {
  Q_OBJECT
 private slots:
  void anUnrelatedEditDoesNotDisturb();
  void quickOnesDoNotWaitForLongOnes();
  void anEditOfItsInputCancelsAtOnce();
  void whatIsRemovedIsCancelled();
  void whatIsForgottenBeginsAnew();
  void whatIsBeingShownGoesOn();
  void equalFeaturesAreComputedOnce();
  void cancellingEndsWhatWentOn();
  void endingWhileItComputes();
  void showingHasItsShareOfTheProgress();
};

void UndisturbedEvaluationTest::anUnrelatedEditDoesNotDisturb() {
  Gate gate;
  Seen before, after;
  Evaluator evaluator(typesWith(gate));
  Document document = Document().with(slow("s", 1));
  evaluator.evaluateInBackground(document, {}, before.show(), before.finished());
  waitFor([&] { return gate.entered == 1; });
  constexpr int edits = 30;
  for (int i = 0; i < edits; ++i) {
    document = document.with(quick("q", i));
    evaluator.evaluateInBackground(document, {}, after.show(), after.finished());
  }
  waitFor([&] { return after.shown("q"); });
  QVERIFY(!after.shown("s"));
  QCOMPARE(gate.entered.load(), 1);
  gate.open = true;
  evaluator.waitForBackground();
  QCOMPARE(gate.entered.load(), 1);
  QCOMPARE(gate.cancelled.load(), 0);
  QVERIFY(before.all().empty() && after.shown("s"));
  QCOMPARE(after.all().size(), std::size_t{1});
  QCOMPARE(after.value("s"), 1.0);
  QCOMPARE(after.value("q"), double(edits - 1));
}

void UndisturbedEvaluationTest::quickOnesDoNotWaitForLongOnes() {
  Gate gate;
  Seen seen;
  Evaluator evaluator(typesWith(gate));
  Document document;
  for (int i = 0; i < 20; ++i) {
    Feature sequence = slow("s" + std::to_string(i), i);
    sequence.parameters["frames"] = 4000;
    document = document.with(sequence);
  }
  document = document.with(quick("q", 7))
                 .with(valueFeature("test.quick", "r", 1, {"q"}))
                 .with(valueFeature("test.quick", "t", 1, {"s0"}));
  evaluator.evaluateInBackground(document, {}, seen.show(), seen.finished());
  waitFor([&] { return seen.shown("q") && seen.shown("r"); });
  QVERIFY(!seen.shown("t"));
  gate.open = true;
  evaluator.waitForBackground();
  QCOMPARE(gate.entered.load(), 20);
  QCOMPARE(seen.value("r"), 8.0);
  QCOMPARE(seen.value("t"), 1.0);
}

void UndisturbedEvaluationTest::anEditOfItsInputCancelsAtOnce() {
  Gate gate;
  Seen seen;
  Evaluator evaluator(typesWith(gate));
  const Document document = Document().with(quick("q", 1)).with(slow("s", 10, {"q"}));
  evaluator.evaluateInBackground(document, {}, seen.show(), seen.finished());
  waitFor([&] { return gate.entered == 1; });
  evaluator.evaluateInBackground(document.with(quick("q", 2)), {}, seen.show(), seen.finished());
  waitFor([&] { return gate.cancelled == 1 && gate.entered == 2; });
  gate.open = true;
  evaluator.waitForBackground();
  QCOMPARE(seen.all().size(), std::size_t{1});
  QCOMPARE(seen.value("s"), 12.0);
}

void UndisturbedEvaluationTest::whatIsRemovedIsCancelled() {
  Gate gate;
  Seen seen;
  Evaluator evaluator(typesWith(gate));
  for (const Document& after : {Document().with(quick("q", 1)), Document()}) {
    const int before = gate.entered;
    evaluator.evaluateInBackground(Document().with(slow("s", 1)), {}, seen.show(), seen.finished());
    waitFor([&] { return gate.entered > before; });
    evaluator.evaluateInBackground(after, {}, seen.show(), seen.finished());
    evaluator.waitForBackground();
    QCOMPARE(gate.cancelled.load(), before + 1);
  }
  QCOMPARE(seen.all().size(), std::size_t{2});
}

void UndisturbedEvaluationTest::whatIsForgottenBeginsAnew() {
  Gate gate;
  Seen seen;
  Evaluator evaluator(typesWith(gate));
  const Document document = Document().with(slow("s", 1));
  evaluator.evaluateInBackground(document, {}, seen.show(), seen.finished());
  waitFor([&] { return gate.entered == 1; });
  evaluator.forget();
  evaluator.evaluateInBackground(document, {}, seen.show(), seen.finished());
  waitFor([&] { return gate.cancelled == 1 && gate.entered == 2; });
  gate.open = true;
  evaluator.waitForBackground();
  QCOMPARE(seen.all().size(), std::size_t{1});
}

// Drawing the frames of a sequence takes longer than to compute them.
void UndisturbedEvaluationTest::whatIsBeingShownGoesOn() {
  Gate computing, drawing;
  computing.open = true;
  Seen seen;
  Evaluator evaluator(typesWith(computing));
  const Document document = Document().with(slow("s", 1));
  evaluator.evaluateInBackground(
      document, {}, [&](const FeatureId&, const auto&, const Progress& progress) { drawing.pass(progress); },
      seen.finished());
  waitFor([&] { return drawing.entered == 1; });
  evaluator.evaluateInBackground(document.with(quick("q", 2)), {}, seen.show(), seen.finished());
  waitFor([&] { return seen.shown("q"); });
  QVERIFY(!seen.shown("s"));  // what draws it will have it ready
  drawing.open = true;
  evaluator.waitForBackground();
  QVERIFY(seen.shown("s"));
  QCOMPARE(drawing.cancelled.load(), 0);
  QCOMPARE(computing.entered.load(), 1);
  QCOMPARE(seen.all().size(), std::size_t{1});
}

void UndisturbedEvaluationTest::equalFeaturesAreComputedOnce() {
  Gate gate;
  Seen seen;
  Evaluator evaluator(typesWith(gate));
  const Document document = Document().with(slow("a", 3)).with(slow("b", 3));
  evaluator.evaluateInBackground(document, {}, seen.show(), seen.finished());
  waitFor([&] { return gate.entered == 1; });
  evaluator.evaluateInBackground(document.with(slow("c", 3)), {}, seen.show(), seen.finished());
  gate.open = true;
  evaluator.waitForBackground();
  QCOMPARE(gate.entered.load(), 1);
  for (const char* id : {"a", "b", "c"}) QVERIFY(seen.shown(id) && seen.value(id) == 3);
}

void UndisturbedEvaluationTest::cancellingEndsWhatWentOn() {
  Gate gate;
  Seen seen;
  Evaluator evaluator(typesWith(gate));
  const Document document = Document().with(slow("s", 1));
  evaluator.evaluateInBackground(document, {}, seen.show(), seen.finished());
  waitFor([&] { return gate.entered == 1; });
  evaluator.evaluateInBackground(document.with(quick("q", 1)), {}, seen.show(), seen.finished());
  evaluator.cancelBackground();
  evaluator.waitForBackground();
  QCOMPARE(gate.cancelled.load(), gate.entered.load());
  QVERIFY(seen.all().empty());
  gate.open = true;
  evaluator.evaluateInBackground(document, {}, seen.show(), seen.finished());
  evaluator.waitForBackground();
  QCOMPARE(seen.all().size(), std::size_t{1});
}

void UndisturbedEvaluationTest::endingWhileItComputes() {
  for (int i = 0; i < 20; ++i) {
    Gate gate;
    Evaluator evaluator(typesWith(gate));
    Document document = Document().with(slow("s", 1)).with(slow("t", 2));
    evaluator.evaluateInBackground(document, {}, {}, {});
    if (i % 2 == 0) waitFor([&] { return gate.entered >= 1; });
    evaluator.evaluateInBackground(document.with(quick("q", i)), {}, {}, {});
  }
}

// A bar that leaves it out stands near its end for most of the time.
void UndisturbedEvaluationTest::showingHasItsShareOfTheProgress() {
  Gate open;
  open.open = true;
  Evaluator evaluator(typesWith(open));
  std::atomic<double> reached = 0, atTheBeginning = 1, inTheMiddle = 1;
  Feature sequence = slow("s", 1);
  sequence.parameters["frames"] = 4000;
  evaluator.evaluateInBackground(
      Document().with(sequence), [&](double fraction, const std::string&) { reached = fraction; },
      [&](const FeatureId&, const auto&, const Progress& progress) {
        atTheBeginning = reached.load();
        progress.report(0.5);
        waitFor([&] { return reached > 0.5; });
        inTheMiddle = reached.load();
      },
      {});
  evaluator.waitForBackground();
  QVERIFY2(atTheBeginning <= 0.25, qPrintable(QString::number(atTheBeginning)));
  COMPARE_NEAR(inTheMiddle.load(), 0.625, 1e-9);
  // What it took counts from then on, for a sequence and for a single shape.
  Costs costs;
  costs.showingTook(sequence, true, 9);
  QCOMPARE(costs.expectedShowing(slow("other", 1), true), 9.0);
  QVERIFY(costs.expectedShowing(sequence, false) < 1);
}

BLOSSOM_TEST(UndisturbedEvaluationTest)
#include "undisturbed_evaluation_test.moc"
