// Results are kept in files of their own and found again; whatever is wrong with such a file is no error.
#include "results/result_store.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <atomic>
#include <fstream>

#include "core/file.h"
#include "document/evaluation/result_cache.h"
#include "document/evaluator.h"
#include "geometry/planar/planar.h"
#include "support/support.h"

using namespace blossom;

namespace {

namespace fs = std::filesystem;

Path triangle() {
  const Vec2 a(0, 0), b(3, 0), c(1, 2);
  Path path;
  path.segments = {Line2{a, b}, Line2{b, c}, Line2{c, a}};
  path.closed = true;
  return path;
}

MedialAxis axis() {
  MedialAxis axis;
  axis.vertices = {{{0, 0}, 2, true}, {{5, 1}, 0, false}};
  const MedialFeet feet{{0, 3, 0.5, {0, 2}}, {1, 0, 2.25, {0, -2}}};
  axis.edges = {{0, 1, {{0, 0, 2}, {3, 0.5, 1}, {5, 1, 0}}, {feet, feet, {}}}};
  return axis;
}

Toolpath path() {
  Toolpath path;
  path.cutter = {6, 0.5, 0, 3, 12000};
  path.start = {1, 2, 3};
  path.moves = {{MoveKind::Plunge, {1, 2, -1}, 0, {0, 0}, 300, 0}, {MoveKind::Feed, {4, 2, -1}, 1, {2.5, 2}, 900, 7}};
  path.stock.add(Vec3(-1, -2, -3));
  path.stock.add(Vec3(9, 8, 0));
  path.workOffset = "G55";
  path.flood = true;
  path.task = PocketTask{{1, 1, 0}, 4, 0.1, 0.2};
  path.passes = 2;
  path.gouge = 1e-7;
  path.marks = {{{1, 1, 1}, MarkKind::Gouge}, {{2, 1, 1}, MarkKind::Left}};
  return path;
}

bool same(const Toolpath& a, const Toolpath& b) {
  return a.cutter == b.cutter && a.start == b.start && a.moves == b.moves && a.rapidFeed == b.rapidFeed &&
         a.stock.low == b.stock.low && a.stock.high == b.stock.high && a.workOffset == b.workOffset && a.flood == b.flood &&
         a.mist == b.mist && a.task == b.task && a.passes == b.passes && a.gouge == b.gouge && a.residue == b.residue &&
         a.marks == b.marks && a.centred == b.centred && a.blending == b.blending;
}

Evaluated storedFeature(Shape shape) {
  return {std::move(shape), {{"loops", 3}, {"share", 0.1}}, {"Look at this."}, {{"error", 0.25, MeasureUnit::None}}};
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

std::uintmax_t sizeOf(const fs::path& folder) {
  std::uintmax_t all = 0;
  for (const fs::path& file : filesIn(folder)) all += fs::file_size(file);
  return all;
}

/// A mesh of so many points: 24 bytes each.
Mesh points(std::size_t count) {
  Mesh mesh;
  for (std::size_t k = 0; k < count; ++k) mesh.points.emplace_back(static_cast<double>(k), 0.1, 0.2);
  return mesh;
}

}  // namespace

class ResultStoreTest : public QObject {
  Q_OBJECT
 private slots:
  void keptResultsAreFoundAsTheyWere();
  void resultsOfOtherBuildsAreNotFound();
  void damagedFilesAreIgnored();
  void theOldestGoBeyondTheLimit();
  void aFolderThatCannotBeMadeIsNoError();
  void oneThatIsTooLargeIsNotKept();
  void passingTroubleRemovesNothing();
  void nobodyElseReadsThem();
  void whatChangesWithTheWorldIsComputedAgain();
  void aFileThatChangesMeanwhileGivesNoResult();
  void whatWasDoneBeforeACancelIsKept();
  void endingDuringAnEvaluationKeepsWhatWasDone();
  void whatWasForgottenStaysForgotten();
  void evaluationsAreFoundAfterARestart();
};

namespace {

/// A type that counts its evaluations and takes long enough to be worth keeping: computing, not sleeping.
struct Counted {
  double value = 1;
  FileValue file;
};

Feature countedFeature(const char* id, double value = 1, std::vector<FeatureId> inputs = {}) {
  Feature feature;
  feature.id = feature.name = id;
  feature.type = "test.counted";
  feature.parameters = {{"value", value}};
  feature.inputs = std::move(inputs);
  return feature;
}

double busy(double value) {
  double sum = 0;
  for (int k = 1; k < 40000000; ++k) sum += 1 / (value + k);
  return sum;
}

}  // namespace

void ResultStoreTest::oneThatIsTooLargeIsNotKept() {
  const TemporaryFolder folder;
  ResultStore store(folder.path(), "v1", 200000);
  store.keep("a", storedFeature(points(4000)));
  store.keep("b", storedFeature(points(40000)));
  QVERIFY(store.find("a") && !store.find("b"));
  QCOMPARE(filesIn(folder.path()).size(), std::size_t{1});
}

void ResultStoreTest::passingTroubleRemovesNothing() {
  const TemporaryFolder folder;
  ResultStore store(folder.path(), "v1");
  store.keep("a", storedFeature(points(10)));
  const QByteArray before = qgetenv("TMPDIR");
  qputenv("TMPDIR", (folder.path() / "nowhere").c_str());
  QVERIFY(!store.find("a"));
  before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
  QVERIFY(store.find("a"));
}

void ResultStoreTest::nobodyElseReadsThem() {
  const TemporaryFolder folder;
  ResultStore store(folder.path() / "results", "v1");
  store.keep("a", storedFeature(axis()));
  QCOMPARE(fs::status(folder.path() / "results").permissions(), fs::perms::owner_all);
}

void ResultStoreTest::whatChangesWithTheWorldIsComputedAgain() {
  const TemporaryFolder folder;
  auto world = std::make_shared<std::string>("font 1");
  int count = 0;
  const auto registry = std::make_shared<Registry>();
  registry->add(feature<Counted>("test.counted", "Counted", "Counts.")
                    .parameter("value", &Counted::value, number(), "A number.")
                    .dependsOn([world](const Counted&) { return *world; })
                    .evaluate([&count](const Counted&, const Inputs&, const Progress&) -> Evaluated {
                      ++count;
                      return storedFeature(axis());
                    }));
  Evaluator evaluator(registry);
  const Document document = Document().with(countedFeature("a"));
  for (const char* const state : {"font 1", "font 1", "font 2", "font 1"}) {
    *world = state;
    (void)evaluator.evaluate(document, Progress::none());
  }
  QCOMPARE(count, 2);
}

void ResultStoreTest::aFileThatChangesMeanwhileGivesNoResult() {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "input.txt";
  bool disturb = true;
  const auto registry = std::make_shared<Registry>();
  registry->add(feature<Counted>("test.counted", "Counted", "Measures a file.")
                    .parameter("file", &Counted::file, optional(blossom::file("txt")), "A file.")
                    .evaluate([&](const Counted& p, const Inputs&, const Progress&) -> Evaluated {
                      if (disturb) std::ofstream(file) << "12345";
                      Evaluated measured = storedFeature(axis());
                      measured.figures = {{"size", static_cast<double>(readFile(p.file.path).size()), MeasureUnit::None}};
                      return measured;
                    }));
  Feature feature = countedFeature("a");
  feature.parameters = {{"file", file.string()}};
  Evaluator evaluator(registry);
  const auto size = [&] {
    const auto result = evaluator.evaluate(Document().with(feature), Progress::none()).at("a");
    return std::get<double>(result->evaluated.figures.at(0).value);
  };
  std::ofstream(file) << "123";
  QCOMPARE(size(), 5.0);  // it was read as it was then
  disturb = false;
  std::ofstream(file) << "123";
  QCOMPARE(size(), 3.0);
}

void ResultStoreTest::whatWasDoneBeforeACancelIsKept() {
  const TemporaryFolder folder;
  const auto registry = std::make_shared<Registry>();
  const CancelToken token;
  registry->add(feature<Counted>("test.counted", "Counted", "Takes its time.")
                    .input({.name = "part", .help = "What is before.", .kinds = {ShapeKind::MedialAxis}, .minimum = 0})
                    .parameter("value", &Counted::value, number(), "A number.")
                    .evaluate([](const Counted& p, const Inputs&, const Progress& progress) -> Evaluated {
                      Evaluated result = storedFeature(axis());
                      result.stats["sum"] = busy(p.value);
                      progress.check();
                      return result;
                    }));
  const Document document = Document().with(countedFeature("a", 1)).with(countedFeature("b", 2, {"a"}));
  {
    Evaluator evaluator(registry, 16, std::make_shared<ResultStore>(folder.path(), "v1"));
    const auto cancelAfterFirst = [&](const FeatureId&, const auto&) { token.cancel(); };
    VERIFY_ERROR(evaluator.evaluate(document, Progress(token), cancelAfterFirst), ErrorCode::Cancelled);
  }  // which writes what there is
  QCOMPARE(filesIn(folder.path()).size(), std::size_t{1});
  Evaluator again(registry, 16, std::make_shared<ResultStore>(folder.path(), "v1"));
  QVERIFY(again.evaluate(document.without("b"), Progress::none()).at("a")->fromCache);
}

// As a window is closed while it computes: the first results to be kept come when the evaluator ends already.
void ResultStoreTest::endingDuringAnEvaluationKeepsWhatWasDone() {
  const TemporaryFolder folder;
  const auto registry = std::make_shared<Registry>();
  registry->add(feature<Counted>("test.counted", "Counted", "Takes its time, or until it is cancelled.")
                    .input({.name = "part", .help = "What is before.", .kinds = {ShapeKind::MedialAxis}, .minimum = 0})
                    .parameter("value", &Counted::value, number(), "A number.")
                    .evaluate([](const Counted& p, const Inputs&, const Progress& progress) -> Evaluated {
                      Evaluated result = storedFeature(axis());
                      result.stats["sum"] = busy(p.value);
                      while (p.value > 1) progress.check();
                      return result;
                    }));
  const Document document = Document().with(countedFeature("a", 1)).with(countedFeature("b", 2, {"a"}));
  {
    Evaluator evaluator(registry, 16, std::make_shared<ResultStore>(folder.path(), "v1"));
    std::atomic<bool> first = false;
    evaluator.evaluateInBackground(document, {}, [&](const FeatureId&, const auto&, const auto&) { first = true; }, {});
    QTRY_VERIFY_WITH_TIMEOUT(first, 60000);
  }
  QCOMPARE(filesIn(folder.path()).size(), std::size_t{1});
}

// A run that began before everything was to be forgotten ends afterwards.
void ResultStoreTest::whatWasForgottenStaysForgotten() {
  ResultCache cache(10);
  const std::uint64_t before = cache.generation();
  cache.store("a", std::make_shared<FeatureResult>(), before);
  QVERIFY(cache.find("a"));
  cache.clear();
  cache.store("a", std::make_shared<FeatureResult>(), before);
  QVERIFY(!cache.find("a"));
  cache.store("a", std::make_shared<FeatureResult>(), cache.generation());
  QVERIFY(cache.find("a"));
}

void ResultStoreTest::keptResultsAreFoundAsTheyWere() {
  const TemporaryFolder folder;
  ResultStore store(folder.path() / "results", "v1");
  QVERIFY(!store.find("a1"));
  const Region region{{triangle()}};
  store.keep("a1", storedFeature(region));
  store.keep("a2", storedFeature(axis()));
  store.keep("a3", storedFeature(path()));
  store.keep("a4", storedFeature(Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Box", Color{1, 2, 3})));
  const auto found = store.find("a1");
  QVERIFY(found && *found->evaluated.shape.get<Region>() == region && !found->gougeLeftOut);
  QCOMPARE(found->evaluated.stats, storedFeature(region).stats);
  QCOMPARE(found->evaluated.warnings, storedFeature(region).warnings);
  QCOMPARE(found->evaluated.figures.size(), std::size_t{1});
  QCOMPARE(std::get<double>(found->evaluated.figures[0].value), 0.25);
  QVERIFY(*store.find("a2")->evaluated.shape.get<MedialAxis>() == axis());
  QVERIFY(same(*store.find("a3")->evaluated.shape.get<Toolpath>(), path()));
  QCOMPARE(store.find("a4")->evaluated.shape.get<Brep>()->roots().at(0).name, std::string("Box"));
  // A function is not kept, and that is told.
  Toolpath measuring = path();
  measuring.gougeOf = [](const Toolpath&, const Progress&) { return 0.5; };
  store.keep("a5", storedFeature(measuring));
  QVERIFY(store.find("a5")->gougeLeftOut && same(*store.find("a5")->evaluated.shape.get<Toolpath>(), path()));
  // No key leads out of the folder.
  store.keep("../a6", storedFeature(region));
  QVERIFY(!store.find("../a6"));
  QCOMPARE(filesIn(folder.path()).size(), std::size_t{1});
}

void ResultStoreTest::resultsOfOtherBuildsAreNotFound() {
  const TemporaryFolder folder;
  ResultStore(folder.path(), "v1").keep("a", storedFeature(axis()));
  QVERIFY(ResultStore(folder.path(), "v1").find("a"));
  QVERIFY(!ResultStore(folder.path(), "v2").find("a"));
}

void ResultStoreTest::damagedFilesAreIgnored() {
  auto random = test::seededRandom();
  const TemporaryFolder folder;
  ResultStore store(folder.path(), "v1");
  const Mesh mesh = points(200);
  store.keep("a", storedFeature(mesh));
  const fs::path file = filesIn(folder.path()).at(0);
  const std::string good = readFile(file);
  int ignored = 0;
  for (int k = 0; k < 200; ++k) {
    std::string bad = good;
    if (k % 4 == 0)
      bad.resize(std::uniform_int_distribution<std::size_t>(0, good.size() - 1)(random));
    else
      bad[std::uniform_int_distribution<std::size_t>(0, good.size() - 1)(random)] ^= static_cast<char>(1 << (k % 8));
    std::ofstream(file, std::ios::binary) << bad;
    const auto found = store.find("a");
    if (found) QVERIFY(found->evaluated.shape.get<Mesh>()->points == mesh.points);  // a byte that means nothing
    if (!found) QVERIFY(!fs::exists(file));
    ignored += found ? 0 : 1;
  }
  QVERIFY(ignored > 150);
}

void ResultStoreTest::theOldestGoBeyondTheLimit() {
  const TemporaryFolder folder;
  constexpr std::uintmax_t limit = 500000;
  ResultStore store(folder.path(), "v1", limit);
  const auto name = [](int k) { return "r" + std::to_string(k); };
  for (int k = 0; k < 10; ++k) {
    store.keep(name(k), storedFeature(points(4000)));  // 96 kB
    for (const fs::path& file : filesIn(folder.path()))
      if (file.filename().string().find("-" + name(k) + ".") != std::string::npos)
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(100 - k));
    QVERIFY(sizeOf(folder.path()) <= limit);
    QVERIFY(store.find(name(0)) || k > 9);  // used all the time
  }
  QVERIFY(store.find(name(9)) && !store.find(name(2)));
}

void ResultStoreTest::aFolderThatCannotBeMadeIsNoError() {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  ResultStore store(folder.path() / "file" / "results", "v1");
  store.keep("a", storedFeature(axis()));
  QVERIFY(!store.find("a"));
}

void ResultStoreTest::evaluationsAreFoundAfterARestart() {
  const TemporaryFolder folder;
  const auto count = std::make_shared<std::atomic<int>>(0);
  const auto registry = std::make_shared<Registry>();
  struct Slow {
    double value = 1;
  };
  // Long enough to be worth keeping: computing, not sleeping.
  registry->add(feature<Slow>("test.slow", "Slow", "Takes its time.")
                    .parameter("value", &Slow::value, number(), "A number.")
                    .evaluate([count](const Slow& p, const Inputs&, const Progress&) -> Evaluated {
                      ++*count;
                      double sum = 0;
                      for (int k = 1; k < 40000000; ++k) sum += 1 / (p.value + k);
                      Toolpath made = path();
                      made.rapidFeed = sum;
                      made.gougeOf = [sum](const Toolpath&, const Progress&) { return sum; };
                      return {std::move(made), Value::object(), {}};
                    }));
  Feature feature;
  feature.id = feature.name = "slow";
  feature.type = "test.slow";
  const Document document = Document().with(feature);
  double sum = 0;
  {
    const auto store = std::make_shared<ResultStore>(folder.path(), "v1");
    Evaluator evaluator(registry, 16, store);
    std::atomic<bool> finished = false;
    evaluator.evaluateInBackground(document, {}, {}, [&](const Results& results) {
      sum = results.at("slow")->evaluated.shape.get<Toolpath>()->rapidFeed;
      finished = true;
    });
    QTRY_VERIFY_WITH_TIMEOUT(finished && filesIn(folder.path()).size() == 1, 60000);
  }
  QTRY_COMPARE(filesIn(folder.path()).size(), std::size_t{1});
  Evaluator evaluator(registry, 16, std::make_shared<ResultStore>(folder.path(), "v1"));
  const auto result = evaluator.evaluate(document, Progress::none()).at("slow");
  QVERIFY(result->fromCache);
  QCOMPARE(count->load(), 1);
  const Toolpath& found = *result->evaluated.shape.get<Toolpath>();
  QCOMPARE(found.rapidFeed, sum);
  QCOMPARE(found.gougeOf(found, Progress::none()), sum);  // which computes it anew
  QCOMPARE(count->load(), 2);
  // What is to be computed anew is not taken from the disk either.
  evaluator.forget();
  QVERIFY(!evaluator.evaluate(document, Progress::none()).at("slow")->fromCache);
  QCOMPARE(count->load(), 3);
}

BLOSSOM_TEST(ResultStoreTest)
#include "result_store_test.moc"
