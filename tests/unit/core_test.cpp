#include <sys/resource.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <mutex>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include "core/file.h"
#include "core/parallel.h"
#include "core/place_text.h"
#include "core/progress.h"
#include "core/sanitizers.h"
#include "core/units.h"
#include "support/support.h"

using namespace blossom;
using blossom::test::seededRandom;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path().filename());
  return files;
}

}  // namespace

class CoreTest : public QObject {
  Q_OBJECT
 private slots:
  /// A freed block serves the next one, instead of a new one that the system clears page by page.
  void freedMemoryIsUsedAgain() {
    if (hasShadowMemory) QSKIP("a sanitizer allocates in its own way");
    const auto faultsOfABlock = [] {
      rusage before{}, after{};
      ::getrusage(RUSAGE_THREAD, &before);
      const std::vector<char> block(8 << 20, 'x');
      ::getrusage(RUSAGE_THREAD, &after);
      return block.back() == 'x' ? after.ru_minflt - before.ru_minflt : 0;
    };
    const long first = faultsOfABlock(), again = faultsOfABlock();
    QVERIFY2(again < 100, qPrintable(QStringLiteral("%1 pages were new, %2 at first").arg(again).arg(first)));
  }

  void lengthsAreUnderstood() {
    const std::vector<std::pair<const char*, double>> cases{
        {"12", 12},      {"12mm", 12},     {"3cm", 30},       {"1/2 in", 12.7},     {"1 1/2 in", 38.1},
        {"0.5\"", 12.7}, {"2'", 609.6},    {"1e-3 m", 1},     {"-1 1/2 in", -38.1}, {" 7 dm ", 700},
        {"+2.5", 2.5},   {"250 um", 0.25}, {"10 mil", 0.254}, {"3/4", 0.75},        {"1 ft", 304.8}};
    for (const auto& [text, wanted] : cases) COMPARE_NEAR(parseLength(text), wanted, 1e-12 * std::abs(wanted));
  }
  void otherTextIsNoLength() {
    for (const char* text : {"", " ", "abc", "3 apples", "1/0", "1 2", "1,5", "nan", "inf", "1e999", "--1", "in", "0x10"})
      VERIFY_ERROR(parseLength(text), ErrorCode::InvalidParameter);
    try {
      parseLength("3 apples");
    } catch (const Error& error) {
      QVERIFY(error.message().find("3 apples") != std::string::npos);
      QVERIFY(!error.hint().empty());
    }
  }
  void anglesAreUnderstood() {
    COMPARE_NEAR(parseAngle("30"), 30, 0);
    COMPARE_NEAR(parseAngle("30deg"), 30, 0);
    COMPARE_NEAR(parseAngle("30°"), 30, 0);
    COMPARE_NEAR(parseAngle("0.5rad"), 28.64788975654116, 1e-13);
    COMPARE_NEAR(parseAngle("0.25turn"), 90, 0);
    VERIFY_ERROR(parseAngle("30mm"), ErrorCode::InvalidParameter);
    COMPARE_NEAR(parseNumber("3/4"), 0.75, 0);
    VERIFY_ERROR(parseNumber("3mm"), ErrorCode::InvalidParameter);
  }
  void numbersReadBackAsTheSameDouble() {
    auto random = seededRandom();
    for (int i = 0; i < 20000; ++i) {
      double value = 0;
      const std::uint64_t bits = random();
      std::memcpy(&value, &bits, sizeof value);
      if (!std::isfinite(value)) continue;
      QVERIFY(std::strtod(formatNumber(value).c_str(), nullptr) == value);
      if (std::abs(value) < 1e300) QVERIFY(parseNumber(formatNumber(value)) == value);
    }
    QCOMPARE(formatNumber(0.1), std::string("0.1"));
  }
  /// "at least 0.1 mm" of 0.0998 mm would not be true.
  void boundsAreNeverPrintedTooLarge() {
    for (const auto& [value, wanted] : std::vector<std::pair<double, const char*>>{
             {0.0998, "0.099"}, {0.104, "0.1"}, {0.106, "0.1"}, {0.1, "0.1"}, {2.5, "2.5"}, {9.96, "9.9"}, {123, "1.2e+02"}})
      QCOMPARE(leastText(value), std::string(wanted));
    auto random = seededRandom();
    std::uniform_real_distribution<double> exponent(-12, 6);
    for (int i = 0; i < 20000; ++i) {
      const double value = std::pow(10, exponent(random)), printed = std::strtod(leastText(value).c_str(), nullptr);
      QVERIFY2(printed <= value && printed >= 0.9 * value, qPrintable(QString::number(value, 'g', 17)));
    }
  }
  void placesHaveTheDigitsThatHelp() {
    const Vec3 place(123.4567, -0.04, 1e-12);
    QCOMPARE(placeText(place), std::string("(123.457, -0.04, 0)"));
    QCOMPARE(placeText(place, 250, 4), std::string("(123.5, 0, 0)"));
    QCOMPARE(placeText(place, 250, 5), std::string("(123.46, -0.04, 0)"));
    QCOMPARE(placeText(place, 99, 4), std::string("(123.46, -0.04, 0)"));
    QCOMPARE(placeText(place, 0, 4), placeText(place));  // of no size: all digits
  }
  void errorNamesRoundTrip() {
    std::set<std::string_view> names;
    for (int code = 0; code <= static_cast<int>(ErrorCode::Internal); ++code) {
      const auto name = errorCodeName(static_cast<ErrorCode>(code));
      QVERIFY(names.insert(name).second);
      QVERIFY(errorCodeFromName(name) == static_cast<ErrorCode>(code));
    }
    QVERIFY(errorCodeFromName("Gremlins") == ErrorCode::Internal);
    const Error error(ErrorCode::InUse, "It is in use.", "Let go of it.");
    QCOMPARE(std::string(error.what()), std::string("It is in use."));
  }
  void progressTellsEachPercentOnce() {
    std::vector<double> told;
    const Progress progress(CancelToken(), [&](double fraction, const std::string&) { told.push_back(fraction); });
    const Progress half = progress.part(0.5, 1);
    for (int i = 0; i <= 10000; ++i) half.report(i / 10000.0);
    QVERIFY(told.size() <= 101);
    COMPARE_NEAR(told.front(), 0.5, 1e-12);
    COMPARE_NEAR(told.back(), 1, 1e-12);
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    progress.report(7);  // clamped
    COMPARE_NEAR(told.back(), 1, 1e-12);
  }
  void anotherThreadCancelsInTheMiddle() {
    const CancelToken token;
    const Progress progress(token);
    std::atomic<bool> started = false;
    std::thread other([&] {
      while (!started) std::this_thread::yield();
      token.cancel();
    });
    std::size_t rounds = 0;
    const auto work = [&] {
      for (;; ++rounds) {  // would never end by itself
        progress.part(0, 1).report(0.5);
        started = true;
      }
    };
    VERIFY_ERROR(work(), ErrorCode::Cancelled);
    other.join();
    QVERIFY(rounds > 0);
  }
  void parallelForCoversEveryIndexOnce() {
    for (const std::size_t count : {0, 1, 7, 1000, 100003}) {
      std::vector<std::atomic<int>> visits(count);
      parallelFor(count, 16, Progress::none(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      QVERIFY(std::all_of(visits.begin(), visits.end(), [](const auto& v) { return v == 1; }));
    }
  }
  void parallelForHandsOnExceptions() {
    const auto fail = [](std::size_t begin, std::size_t end) {
      if (begin <= 500 && 500 < end) throw Error(ErrorCode::Degenerate, "Number 500 is bad.");
    };
    VERIFY_ERROR(parallelFor(1000, 1, Progress::none(), fail), ErrorCode::Degenerate);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, parallelFor(10, 1, Progress::none(), [](std::size_t, std::size_t) {
                               throw std::runtime_error("no");
                             }));
  }
  void aLoopWithinALoopThatFailsIsNotCutShortInSilence() {
    if (std::thread::hardware_concurrency() < 2) QSKIP("needs two cores");
    constexpr std::size_t count = 100;
    const QDeadlineTimer deadline(20'000);
    std::atomic<bool> begun = false, cutShort = false;
    const auto body = [&](std::size_t begin, std::size_t) {
      if (begin == 0) {
        while (!begun && !deadline.hasExpired()) std::this_thread::yield();
        throw Error(ErrorCode::Degenerate, "The first piece is bad.");
      }
      while (!deadline.hasExpired()) {
        std::atomic<std::size_t> done = 0;
        begun = true;
        parallelFor(count, 1, Progress::none(), [&](std::size_t first, std::size_t last) { done += last - first; });
        if (done != count) cutShort = true;
        if (cutShort) return;
      }
    };
    VERIFY_ERROR(parallelFor(2, 1, Progress::none(), body), ErrorCode::Degenerate);
    QVERIFY(begun);
    QVERIFY(!cutShort);
  }
  void parallelForStopsWhenCancelled() {
    for (const int threads : {1, 0}) {
      setThreadLimit(threads);
      const CancelToken token;
      std::atomic<std::size_t> done = 0;
      constexpr std::size_t count = 10'000'000;
      const auto work = [&] {
        parallelFor(count, 1, Progress(token), [&](std::size_t begin, std::size_t end) {
          if ((done += end - begin) > 1000) token.cancel();
        });
      };
      VERIFY_ERROR(work(), ErrorCode::Cancelled);
      QVERIFY(done < count);
    }
  }
  void filesAreReplacedWhole() {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "shape.txt";
    writeAtomically(file, "first");
    writeAtomically(file, std::string("second\0half", 11));
    QCOMPARE(readFile(file), std::string("second\0half", 11));
    QCOMPARE(filesBelow(folder.path()).size(), std::size_t{1});
  }
  void failedWritingKeepsTheOldFile() {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "shape.step";
    writeAtomically(file, "precious");
    const auto fail = [&] {
      writeAtomically(file, [&](const fs::path& temporary) {
        if (temporary.extension() != ".step") throw std::logic_error("writers need the extension");
        std::ofstream(temporary) << "half of it";
        throw Error(ErrorCode::Degenerate, "The writer gave up.");
      });
    };
    VERIFY_ERROR(fail(), ErrorCode::Degenerate);
    QCOMPARE(readFile(file), std::string("precious"));
    QCOMPARE(filesBelow(folder.path()).size(), std::size_t{1});
  }
  void impossiblePlacesAreNamed() {
    const TemporaryFolder folder;
    VERIFY_ERROR(writeAtomically(folder.path() / "no" / "such" / "file", "x"), ErrorCode::FileUnwritable);
    VERIFY_ERROR(writeAtomically(folder.path(), "x"), ErrorCode::FileUnwritable);
    VERIFY_ERROR(readFile(folder.path() / "missing"), ErrorCode::FileNotFound);
    VERIFY_ERROR(readFile(folder.path()), ErrorCode::FileUnreadable);
  }
  void temporaryFoldersVanish() {
    fs::path path;
    {
      const TemporaryFolder folder;
      path = folder.path();
      writeAtomically(path / "a", "b");
      QVERIFY(fs::exists(path / "a"));
    }
    QVERIFY(!fs::exists(path));
  }
};

BLOSSOM_TEST(CoreTest)
#include "core_test.moc"
