#pragma once
#include <QtTest>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "core/error.h"
#include "support/test_main.h"

/// |actual - expected| <= tolerance, with the three numbers in the message.
#define COMPARE_NEAR(actual, expected, tolerance)                                                          \
  do {                                                                                                     \
    const double actual_ = (actual), expected_ = (expected), tolerance_ = (tolerance);                     \
    QVERIFY2(std::abs(actual_ - expected_) <= tolerance_, qPrintable(QString("%1 = %2, expected %3 +- %4") \
                                                                         .arg(#actual)                     \
                                                                         .arg(actual_, 0, 'g', 17)         \
                                                                         .arg(expected_, 0, 'g', 17)       \
                                                                         .arg(tolerance_)));               \
  } while (false)

/// Skips the test function when the folder of shared data is not there. A macro: QSKIP only leaves the function it stands
/// in.
#define NEED_SHARED_DATA() \
  if (!std::filesystem::exists(blossom::test::sharedData())) QSKIP("the folder of shared data is not there")

/// The expression throws blossom::Error with this code.
#define VERIFY_ERROR(expression, wanted)                                                                \
  do {                                                                                                  \
    bool thrown_ = false;                                                                               \
    try {                                                                                               \
      (void)(expression);                                                                               \
    } catch (const blossom::Error& error_) {                                                            \
      thrown_ = true;                                                                                   \
      QVERIFY2(error_.code() == (wanted),                                                               \
               (std::string(blossom::errorCodeName(error_.code())) + ": " + error_.message()).c_str()); \
    }                                                                                                   \
    QVERIFY2(thrown_, #expression " did not throw");                                                    \
  } while (false)

namespace blossom::test {

namespace fs = std::filesystem;

/// Folder with real files nobody here wrote; tests of it say "skipped" when it is not there.
inline fs::path sharedData() {
  const char* overridden = std::getenv("BLOSSOM_SHARED_DATA");
  return overridden ? fs::path(overridden) : fs::path(BLOSSOM_SHARED_DATA);
}
inline fs::path sourceFolder() { return BLOSSOM_SOURCE_DIR; }
inline fs::path buildFolder() { return BLOSSOM_BINARY_DIR; }
inline fs::path sample(const std::string& name) { return sourceFolder() / "resources/samples" / name; }

/// Generator with a printed seed; BLOSSOM_TEST_SEED repeats a run.
inline std::mt19937_64 seededRandom() {
  const char* given = std::getenv("BLOSSOM_TEST_SEED");
  const std::uint64_t seed = given ? std::strtoull(given, nullptr, 10) : std::random_device{}();
  qInfo("random seed %llu (repeat with BLOSSOM_TEST_SEED)", static_cast<unsigned long long>(seed));
  return std::mt19937_64(seed);
}

}  // namespace blossom::test
