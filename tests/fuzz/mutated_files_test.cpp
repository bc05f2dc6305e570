// Damaged files through every reader: each gives a shape that is sound or one blossom::Error, within its time, and no crash.
// BLOSSOM_FUZZ_FILES sets how many files in all, BLOSSOM_TEST_SEED repeats a run. A file that ends the test stays in
// fuzz-failures in the build folder.
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstring>
#include <map>

#include "core/zip_archive.h"
#include "exchange/format/finite.h"
#include "fuzz/mutations.h"
#include "geometry/occt/occt.h"
#include "geometry/shape/brep.h"
#include "support/exchange.h"
#include "support/solids.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr std::size_t largestSeed = 200'000;
constexpr unsigned secondsInProcess = 60, secondsOfWorker = 300;
constexpr double memoryInGigabytes = 3;

std::string currentFile;

/// Async-signal-safe: says which file did it and ends the test.
void onAlarm(int) {
  const char start[] = "\nA reader did not end in its time. The file is ";
  (void)!write(2, start, sizeof start - 1);
  (void)!write(2, currentFile.c_str(), currentFile.size());
  (void)!write(2, "\n", 1);
  _exit(3);
}

/// Coordinates are numbers and indices stay inside.
bool isSound(const Shape& shape) {
  if (const Mesh* mesh = shape.get<Mesh>()) {
    const int count = static_cast<int>(mesh->points.size());
    return std::all_of(mesh->points.begin(), mesh->points.end(), [](const Vec3& p) { return p.allFinite(); }) &&
           std::all_of(mesh->faceVertices.begin(), mesh->faceVertices.end(), [&](int v) { return v >= 0 && v < count; });
  }
  if (const Curves* curves = shape.get<Curves>()) {
    return std::all_of(curves->paths.begin(), curves->paths.end(), allFinite);
  }
  return !shape.empty();
}

}  // namespace

class MutatedFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    if (!std::getenv("BLOSSOM_WORKER")) qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str());
    const char* seed = std::getenv("BLOSSOM_TEST_SEED");
    seed_ = seed ? std::strtoull(seed, nullptr, 10) : std::random_device{}();
    qInfo("random seed %llu (repeat with BLOSSOM_TEST_SEED)", static_cast<unsigned long long>(seed_));
    const char* total = std::getenv("BLOSSOM_FUZZ_FILES");
    total_ = total ? static_cast<std::size_t>(std::strtoull(total, nullptr, 10)) : 2000;
    failures_ = buildFolder() / "fuzz-failures";
    fs::create_directories(failures_);
    signal(SIGALRM, onAlarm);
    gather();
  }

  /// Else the readers below would refuse everything and prove nothing.
  void undamagedFilesOpen() {
    for (const auto& [extension, seeds] : seeds_) {
      if (isInWorker(extension) && !hasWorker()) continue;
      try {
        QVERIFY(isSound(readText(seeds.front(), extension).shape));
      } catch (const Error& error) {
        QFAIL(qPrintable(QString::fromStdString(extension + ": " + error.message())));
      }
    }
  }

  void textFormats_data() {
    QTest::addColumn<QString>("extension");
    for (const auto& [extension, seeds] : seeds_)
      if (!isInWorker(extension)) QTest::newRow(extension.c_str()) << QString::fromStdString(extension);
  }
  void textFormats() {
    QFETCH(QString, extension);
    const std::size_t formatCount = static_cast<std::size_t>(
        std::count_if(seeds_.begin(), seeds_.end(), [](const auto& s) { return !isInWorker(s.first); }));
    run(extension.toStdString(), (total_ - workerShare()) / formatCount + 1, secondsInProcess);
  }

  void workerFormats_data() {
    QTest::addColumn<QString>("extension");
    for (const char* extension : {"step", "iges", "brep"}) QTest::newRow(extension) << extension;
  }
  void workerFormats() {
    QFETCH(QString, extension);
    if (!hasWorker()) QSKIP("blossom-worker is not built");
    run(extension.toStdString(), workerShare() / 3, secondsOfWorker);
  }

  void nothingIsLeftOver() {
    // A failure would have left its file.
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    qInfo("%zu files: %zu read, %zu refused; at most %.0f MB", read_ + refused_, read_, refused_,
          static_cast<double>(usage.ru_maxrss) / 1024);
    QVERIFY(static_cast<double>(usage.ru_maxrss) < memoryInGigabytes * 1024 * 1024);
    if (std::getenv("BLOSSOM_FUZZ_FILES") == nullptr) QVERIFY(read_ + refused_ >= 2000);
    QVERIFY(refused_ > 0);
  }

 private:
  static bool isInWorker(const std::string& extension) {
    return extension == "step" || extension == "iges" || extension == "brep";
  }
  static bool hasWorker() { return fs::exists(std::getenv("BLOSSOM_WORKER")); }
  /// Each of these starts a process.
  [[nodiscard]] std::size_t workerShare() const { return std::max<std::size_t>(3, total_ * 3 / 100); }

  void addSeed(const fs::path& path) {
    const Format* format = formats().find(path.extension().string());
    if (!format || !format->read || fs::file_size(path) > largestSeed) return;
    seeds_[path.extension().string().substr(1)].push_back(readFile(path));
  }

  void gather() {
    for (const fs::path& folder : {sourceFolder() / "tests/fixtures", sourceFolder() / "resources/samples", sharedData()}) {
      if (!fs::exists(folder)) continue;
      std::vector<fs::path> files;
      for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
      std::sort(files.begin(), files.end());  // so that a seed repeats a run
      for (const fs::path& path : files) addSeed(path);
    }
    const TemporaryFolder folder;
    const auto addWritten = [&](const Shape& shape, const std::string& extension, const Value& options = Value::object()) {
      const fs::path path = folder.path() / ("written." + extension);
      writeShape(formats(), shape, path, options);
      addSeed(path);
    };
    const Mesh cube = boxMesh({0, 0, 0}, {1, 1, 1});
    addWritten(cube, "stl");
    addWritten(cube, "ply");
    addWritten(cube, "3mf");
    const Brep solid(toShape(cube), "cube");
    for (const char* extension : {"step", "iges", "brep"}) addWritten(solid, extension);
    // STEP files come under two names.
    for (const auto& [other, id] : {std::pair{"stp", "step"}, {"igs", "iges"}, {"cptw", "cpt"}}) {
      const auto it = seeds_.find(other);
      if (it == seeds_.end()) continue;
      seeds_[id].insert(seeds_[id].end(), it->second.begin(), it->second.end());
      seeds_.erase(it);
    }
  }

  /// In a zip, checksums would find every damage before the reader does: what is mutated of every second one is the text
  /// of its model.
  static void writeMutated(const fs::path& path, std::uint64_t seed, const std::string& whole) {
    if (path.extension() != ".3mf" || seed % 2 == 0) return writeText(path, Mutator(seed)(whole));
    const std::string name = "3D/3dmodel.model";
    const std::string text = readZip(whole, [&](std::string_view each) { return each == name; }).entries.at(name);
    const std::string mutated = Mutator(seed)(text);
    writeZip(path, {{name, mutated}}, Progress::none());
  }

  void run(const std::string& extension, std::size_t count, unsigned seconds) {
    const std::vector<std::string>& seeds = seeds_.at(extension);
    QVERIFY(!seeds.empty());
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t seed = seed_ + i;
      const fs::path path = failures_ / fmt::format("seed-{}.{}", seed, extension);
      writeMutated(path, seed, seeds[i % seeds.size()]);
      currentFile = path.string();
      alarm(seconds);
      try {
        const Imported imported = readShape(formats(), path);
        QVERIFY2(isSound(imported.shape), path.c_str());
        (void)imported.entities.dump();
        (void)imported.skipped.dump();
        (void)Value(imported.warnings).dump();
        ++read_;
      } catch (const Error& error) {
        (void)Value{error.message(), error.hint()}.dump();
        const bool isAllowed = error.code() == ErrorCode::FormatDamaged || error.code() == ErrorCode::LimitExceeded ||
                               (error.code() == ErrorCode::WorkerDied && isInWorker(extension));
        QVERIFY2(isAllowed && !error.message().empty(),
                 qPrintable(QString::fromStdString(path.string() + ": " + std::string(errorCodeName(error.code())) + ": " +
                                                   error.message())));
        ++refused_;
      }
      alarm(0);
      fs::remove(path);
    }
  }

  std::uint64_t seed_ = 0;
  std::size_t total_ = 0, read_ = 0, refused_ = 0;
  fs::path failures_;
  std::map<std::string, std::vector<std::string>> seeds_;
};

BLOSSOM_TEST(MutatedFilesTest)
#include "mutated_files_test.moc"
