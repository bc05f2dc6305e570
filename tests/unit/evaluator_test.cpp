#include "document/evaluation/evaluation.h"

#include <Standard_OutOfRange.hxx>
#include <atomic>
#include <fstream>
#include <future>
#include <mutex>
#include <new>
#include <thread>

#include "core/file.h"
#include "document/storage.h"
#include "support/support.h"

using namespace blossom;
using namespace std::chrono_literals;

namespace {

/// Meshes with one point each: (sum of inputs + add, number of evaluations so far, 0).
struct Types {
  std::shared_ptr<std::atomic<int>> evaluations = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<Registry> registry = std::make_shared<Registry>();

  Types() {
    struct Sum {
      double add = 0;
      std::string fail;
    };
    registry->add(
        feature<Sum>("test.sum", "Sum", "Adds numbers.")
            .input({"part", "What is added.", {ShapeKind::Mesh}, 0, anyNumber})
            .parameter("add", &Sum::add, number(), "Number.")
            .parameter("fail", &Sum::fail, text(), "How to fail.")
            .evaluate([count = evaluations](const Sum& p, const Inputs& in, const Progress& progress) -> Evaluated {
              ++*count;
              progress.report(0.5, "adding");
              failAs(p.fail);
              double sum = p.add;
              for (const Shape& part : in.of(0)) sum += part.get<Mesh>()->points.at(0).x();
              return {mesh(sum), {{"sum", sum}}, {}};
            }));
    struct Read {
      FileValue file;
    };
    registry->add(feature<Read>("test.read", "Read", "Length of a file.")
                      .parameter("file", &Read::file, blossom::file("txt"), "The file.")
                      .evaluate([count = evaluations](const Read& p, const Inputs&, const Progress&) -> Evaluated {
                        ++*count;
                        return {mesh(static_cast<double>(readFile(p.file.path).size())),
                                {{"name", p.file.path.filename().string()}},
                                {}};
                      }));
    struct Slow {
      int id = 0;
    };
    registry->add(feature<Slow>("test.endless", "Endless", "Works until it is cancelled.")
                      .parameter("id", &Slow::id, blossom::count(), "Which.")
                      .evaluate([count = evaluations](const Slow&, const Inputs&, const Progress& progress) -> Evaluated {
                        ++*count;
                        while (true) progress.check();
                      }));
  }

  static Shape mesh(double value) {
    Mesh m;
    m.points = {Vec3(value, 0, 0)};
    return m;
  }

  static void failAs(const std::string& how) {
    if (how == "error") throw Error(ErrorCode::Degenerate, "It collapses.", "Make it larger.");
    if (how == "memory") throw std::bad_alloc();
    if (how == "occt") throw Standard_OutOfRange("index 7");
    if (how == "standard") throw std::runtime_error("surprise");
    if (how == "other") throw 42;
    if (how == "missing") throw Error(ErrorCode::FileNotFound, "It is away.");
  }
};

Feature sum(const FeatureId& id, double add, std::vector<FeatureId> inputs = {}) {
  Feature f;
  f.id = id;
  f.type = "test.sum";
  f.name = "Number " + id;
  f.parameters["add"] = add;
  f.inputs = std::move(inputs);
  return f;
}

Feature failing(Feature f, const std::string& how) {
  f.parameters["fail"] = how;
  return f;
}

Feature endless(int id) {
  Feature f;
  f.id = "e";
  f.type = "test.endless";
  f.parameters["id"] = id;
  return f;
}

double value(const Results& results, const FeatureId& id) {
  return results.at(id)->evaluated.shape.get<Mesh>()->points.at(0).x();
}

/// What a background evaluation finished with, to wait for.
class Finished {
 public:
  std::function<void(Results)> callback() {
    return [this](Results results) {
      const std::lock_guard lock(mutex_);
      all_.push_back(std::move(results));
    };
  }
  std::vector<Results> all() {
    const std::lock_guard lock(mutex_);
    return all_;
  }

 private:
  std::mutex mutex_;
  std::vector<Results> all_;
};

void waitUntil(const std::function<bool()>& reached) {
  while (!reached()) std::this_thread::yield();
}

}  // namespace

class EvaluatorTest : public QObject {
  Q_OBJECT

 private slots:
  void onlyWhatChangedIsComputedAgain() {
    Types types;
    Evaluator evaluator(types.registry);
    Document document =
        Document().with(sum("a", 1)).with(sum("b", 10, {"a"})).with(sum("c", 100, {"a"})).with(sum("d", 0, {"b", "c"}));
    QCOMPARE(value(evaluator.evaluate(document, {}), "d"), 112.0);
    QCOMPARE(types.evaluations->load(), 4);
    document = document.with(sum("c", 200, {"a"}));
    const Results results = evaluator.evaluate(document, {});
    QCOMPARE(value(results, "d"), 212.0);
    QCOMPARE(types.evaluations->load(), 6);
    QVERIFY(results.at("b")->fromCache && !results.at("c")->fromCache);
    QCOMPARE(results.at("b")->kernelMs, 0.0);
    QVERIFY(results.at("c")->kernelMs > 0);
    // the content counts, not names, ids or how a number is written
    Feature renamed = sum("x", 1);
    renamed.name = "Other";
    renamed.parameters = {{"fail", ""}, {"add", 1}};
    evaluator.evaluate(Document().with(renamed), {});
    QCOMPARE(types.evaluations->load(), 6);
  }

  void theLeastRecentlyUsedResultGoesFirst() {
    Types types;
    Evaluator evaluator(types.registry, 2);
    const auto evaluate = [&](double add) { evaluator.evaluate(Document().with(sum("a", add)), {}); };
    evaluate(1), evaluate(2), evaluate(1), evaluate(3);
    QCOMPARE(types.evaluations->load(), 3);
    evaluate(1);
    QCOMPARE(types.evaluations->load(), 3);
    evaluate(2);
    QCOMPARE(types.evaluations->load(), 4);
  }

  void aDocumentOfMoreFeaturesThanTheLimitIsKeptWhole() {
    Types types;
    Evaluator evaluator(types.registry, 2);
    Document document;
    constexpr int features = 20;
    for (int i = 0; i < features; ++i) document = document.with(sum(std::to_string(i), i));
    evaluator.evaluate(document, {});
    QCOMPARE(types.evaluations->load(), features);
    const Document edited = document.with(sum("7", 700));
    for (const Document& each : {edited, document, edited}) evaluator.evaluate(each, {});
    QCOMPARE(types.evaluations->load(), features + 1);
  }

  void aFailureStaysWhereItIs() {
    Types types;
    Evaluator evaluator(types.registry);
    const Document document = Document()
                                  .with(failing(sum("gear", 1), "error"))
                                  .with(sum("b", 1, {"gear"}))
                                  .with(sum("c", 1, {"b"}))
                                  .with(sum("other", 5));
    const Results results = evaluator.evaluate(document, {});
    QCOMPARE(results.at("gear")->error->code(), ErrorCode::Degenerate);
    QCOMPARE(results.at("b")->error->code(), ErrorCode::InvalidInput);
    QCOMPARE(results.at("b")->error->message(), std::string("Its input \"Number gear\" failed: It collapses."));
    QCOMPARE(results.at("c")->error->message(), std::string("Its input \"Number b\" failed: It collapses."));
    QCOMPARE(results.at("c")->error->hint(), std::string("Make it larger."));
    QVERIFY(results.at("gear")->evaluated.shape.empty());
    QCOMPARE(value(results, "other"), 5.0);
  }

  void everySortOfExceptionEndsOnTheFeature() {
    Types types;
    Evaluator evaluator(types.registry);
    const auto errorOf = [&](const std::string& how) {
      return *evaluator.evaluate(Document().with(failing(sum("a", 1), how)), {}).at("a")->error;
    };
    QCOMPARE(errorOf("memory").code(), ErrorCode::LimitExceeded);
    QCOMPARE(errorOf("occt").code(), ErrorCode::Internal);
    QVERIFY(errorOf("occt").message().find("Standard_OutOfRange index 7") != std::string::npos);
    QCOMPARE(errorOf("standard").message(), std::string("Number a failed unexpectedly: surprise."));
    QCOMPARE(errorOf("other").code(), ErrorCode::Internal);
  }

  void figuresThatAreNoNumbersAreErrors() {
    Types types;
    Evaluator evaluator(types.registry);
    const Document document = Document().with(sum("a", 1e308)).with(sum("b", 1e308, {"a"}));
    const Results results = evaluator.evaluate(document, {});
    QVERIFY(!results.at("a")->error);
    QVERIFY(results.at("b")->error);
    QCOMPARE(results.at("b")->error->code(), ErrorCode::LimitExceeded);
    QVERIFY(results.at("b")->error->message().find("\"sum\"") != std::string::npos);
  }

  void lastingErrorsAreKeptPassingOnesAreTriedAgain() {
    Types types;
    Evaluator evaluator(types.registry);
    for (int i = 0; i < 3; ++i) evaluator.evaluate(Document().with(failing(sum("a", 1), "error")), {});
    QCOMPARE(types.evaluations->load(), 1);
    for (int i = 0; i < 3; ++i) evaluator.evaluate(Document().with(failing(sum("a", 1), "missing")), {});
    QCOMPARE(types.evaluations->load(), 4);
  }

  void unknownTypesAndParametersAreTold() {
    Types types;
    Evaluator evaluator(types.registry);
    Feature unknown = sum("u", 0);
    unknown.type = "pocket.offset";
    Feature misspelt = sum("m", 0);
    misspelt.parameters = {{"ad", 1}};
    const Results results = evaluator.evaluate(Document().with(unknown).with(misspelt), {});
    QCOMPARE(results.at("u")->error->code(), ErrorCode::NotFound);
    QVERIFY(results.at("u")->error->hint().find("plugin \"pocket\"") != std::string::npos);
    QCOMPARE(results.at("m")->error->code(), ErrorCode::InvalidParameter);
    QCOMPARE(results.at("m")->error->hint(), std::string("Did you mean add?"));
  }

  void aSuppressedFeatureHandsOnItsFirstInput() {
    Types types;
    Evaluator evaluator(types.registry);
    Feature off = sum("b", 10, {"a"}), source = sum("s", 1);
    off.suppressed = source.suppressed = true;
    const Document document =
        Document().with(sum("a", 1)).with(off).with(sum("c", 100, {"b"})).with(source).with(sum("d", 1, {"s"}));
    const Results results = evaluator.evaluate(document, {});
    QCOMPARE(value(results, "c"), 101.0);
    QVERIFY(results.at("s")->evaluated.shape.empty() && !results.at("s")->error);
    QCOMPARE(results.at("d")->error->message(), std::string("Its input \"Number s\" is suppressed."));
  }

  void filesCountByTheirContent() {
    Types types;
    Evaluator evaluator(types.registry);
    const TemporaryFolder folder;
    const auto path = folder.path() / "numbers.txt";
    writeAtomically(path, "12345");
    Feature read;
    read.id = "r";
    read.type = "test.read";
    read.parameters["file"] = {{"path", path.string()}, {"asset", ""}};
    Document document = Document().with(read);
    QCOMPARE(value(evaluator.evaluate(document, {}), "r"), 5.0);
    evaluator.evaluate(document, {});
    QCOMPARE(types.evaluations->load(), 1);
    writeAtomically(path, "123456");
    QCOMPARE(value(evaluator.evaluate(document, {}), "r"), 6.0);
    // content in the document is read under the name of the original file, which need not exist
    const std::string content = "1234567";
    read.parameters["file"] = {{"path", "/nowhere/numbers.txt"}, {"asset", contentHash(content)}};
    document = document.with(read);
    QCOMPARE(evaluator.evaluate(document, {}).at("r")->error->code(), ErrorCode::FileNotFound);
    const Results results =
        evaluator.evaluate(document.withAsset(contentHash(content), std::make_shared<const std::string>(content)), {});
    QCOMPARE(value(results, "r"), 7.0);
    QCOMPARE(results.at("r")->evaluated.stats.at("name"), Value("numbers.txt"));
  }

  void whatIsForgottenIsComputedAgain() {
    Types types;
    Evaluator evaluator(types.registry);
    const Document document = Document().with(sum("a", 1)).with(sum("b", 10, {"a"}));
    evaluator.evaluate(document, {});
    evaluator.forget();
    const Results results = evaluator.evaluate(document, {});
    QCOMPARE(types.evaluations->load(), 4);
    QVERIFY(!results.at("a")->fromCache && !results.at("b")->fromCache);
  }

  // A bar that counts features stands still at the one that takes all the time.
  void progressFollowsTheTimeThatFeaturesTook() {
    Types types;
    ResultCache cache(10);
    FileSource files;
    const Document document =
        Document().with(sum("a", 1)).with(sum("b", 2, {"a"})).with(sum("c", 3, {"b"})).with(sum("d", 4, {"c"}));
    std::map<std::string, std::vector<double>> at;
    const auto evaluate = [&](const Document& evaluated) {
      Costs costs;
      for (const auto& [id, took] : std::map<std::string, double>{{"a", 10}, {"b", 10}, {"c", 960}, {"d", 20}})
        costs.took(document.at(id), took);
      at.clear();
      const Progress progress(
          CancelToken(), [&](double f, const std::string& stage) { at[stage.substr(0, stage.find(':'))].push_back(f); });
      Evaluation(evaluated, *types.registry, cache, files, costs).run(progress, {});
    };
    evaluate(document);
    QVERIFY(std::abs(at.at("Number c").front() - 0.02) < 1e-12);
    QVERIFY(std::abs(at.at("Number c").at(1) - 0.5) < 1e-12);  // halfway through the long one
    QVERIFY(std::abs(at.at("Number d").front() - 0.98) < 1e-12);
    // What is known already is no work.
    evaluate(document.with(sum("c", 7, {"b"})));
    QVERIFY(std::abs(at.at("Number c").back() - 0.5 * 960 / 980) < 1e-12);
    QVERIFY(std::abs(at.at("Number d").front() - 960.0 / 980) < 1e-12);
  }

  void progressRunsFromNothingToAllAndCancelsInTheMiddle() {
    Types types;
    Evaluator evaluator(types.registry);
    Document document;
    for (int i = 0; i < 10; ++i) document = document.with(sum("f" + std::to_string(i), i));
    std::vector<double> fractions;
    evaluator.evaluate(document, Progress(CancelToken(), [&](double f, const std::string&) { fractions.push_back(f); }));
    QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
    QCOMPARE(fractions.back(), 1.0);
    const CancelToken token;
    int done = 0;
    document = document.with(sum("f0", 99));
    VERIFY_ERROR(evaluator.evaluate(document, Progress(token),
                                    [&](const FeatureId&, const auto&) {
                                      if (++done == 4) token.cancel();
                                    }),
                 ErrorCode::Cancelled);
    QCOMPARE(done, 4);
  }

  void theNewestBackgroundEvaluationWins() {
    Types types;
    Finished finished;
    Evaluator evaluator(types.registry);
    for (int i = 0; i < 50; ++i) {
      evaluator.evaluateInBackground(Document().with(endless(i)), {}, {}, finished.callback());
      if (i % 10 == 0)
        waitUntil([&, before = types.evaluations->load()] {
          return types.evaluations->load() >= before && types.evaluations->load() > 0;
        });
    }
    evaluator.evaluateInBackground(Document().with(sum("a", 3)), {}, {}, finished.callback());
    evaluator.waitForBackground();
    QCOMPARE(finished.all().size(), std::size_t{1});
    QCOMPARE(value(finished.all().front(), "a"), 3.0);
  }

  void cancellingEndsWithoutAResult() {
    Types types;
    Finished finished;
    Evaluator evaluator(types.registry);
    evaluator.evaluateInBackground(Document().with(endless(1)), {}, {}, finished.callback());
    waitUntil([&] { return types.evaluations->load() == 1; });
    evaluator.cancelBackground();
    evaluator.waitForBackground();
    QVERIFY(finished.all().empty());
    evaluator.evaluateInBackground(Document().with(sum("a", 3)), {}, {}, finished.callback());
    evaluator.waitForBackground();
    QCOMPARE(finished.all().size(), std::size_t{1});
  }

  void destructionCancels() {
    Types types;
    for (int i = 0; i < 20; ++i) {
      const int before = types.evaluations->load();
      Evaluator evaluator(types.registry);
      evaluator.evaluateInBackground(Document().with(endless(i)), {}, {}, [](Results) {});
      if (i % 2 == 0) waitUntil([&] { return types.evaluations->load() > before; });
    }
  }

  void callbacksMayCallBack() {
    Types types;
    Evaluator evaluator(types.registry);
    std::promise<double> result;
    evaluator.evaluateInBackground(Document().with(sum("a", 1)), {}, {}, [&](Results) {
      evaluator.waitForBackground();
      evaluator.evaluateInBackground(Document().with(sum("a", 2)), {}, {},
                                     [&](Results r) { result.set_value(value(r, "a")); });
    });
    QCOMPARE(result.get_future().get(), 2.0);
  }

  void manyThreadsShareOneEvaluator() {
    Types types;
    Evaluator evaluator(types.registry, 8);
    std::vector<std::thread> threads;
    std::atomic<int> wrong = 0;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&, t] {
        for (int i = 0; i < 200; ++i) {
          const int n = (i * 7 + t) % 20;
          const Results results = evaluator.evaluate(Document().with(sum("a", n)).with(sum("b", 1, {"a"})), {});
          if (value(results, "b") != n + 1) ++wrong;
          if (i % 20 == t) evaluator.evaluateInBackground(Document().with(endless(i)), {}, {}, {});
        }
      });
    for (auto& thread : threads) thread.join();
    QCOMPARE(wrong.load(), 0);
  }
};

BLOSSOM_TEST(EvaluatorTest)
#include "evaluator_test.moc"
