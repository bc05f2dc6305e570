#include "feature/frame_keys.h"

#include <algorithm>

#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Value keyValue(int frame, double t, const char* ease = "linear") { return {{"frame", frame}, {"t", t}, {"ease", ease}}; }

Value canonical(const Value& keys) { return checked(frameKeys(), keys); }

std::vector<double> timesOfFrames(const Value& keys, int frames) {
  const std::vector<FrameKey> sorted = frameKeysOf(keys);
  std::vector<double> times;
  for (int frame = 1; frame <= frames; ++frame)
    times.push_back(keyedTime(sorted, static_cast<double>(frame - 1) / (frames - 1), frames));
  return times;
}

}  // namespace

/// Keys of a timeline.
class FrameKeysTest : public QObject {
  Q_OBJECT

 private slots:
  void withoutKeysTimeRunsEvenly() {
    for (const double place : {0.0, 0.3, 1.0}) QCOMPARE(keyedTime({}, place, 7), place);
  }

  void framesWithKeysAreWhereTheySay() {
    auto random = seededRandom();
    for (int round = 0; round < 100; ++round) {
      const int frames = uniformInt(random, 2, 60);
      std::vector<int> at(static_cast<std::size_t>(frames));
      for (std::size_t k = 0; k < at.size(); ++k) at[k] = static_cast<int>(k) + 1;
      std::shuffle(at.begin(), at.end(), random);
      Value keys = Value::array();
      const std::array<const char*, 5> eases{"linear", "in", "out", "in-out", "hold"};
      for (int k = 0; k < std::min(frames, 5); ++k)
        keys.push_back(keyValue(at[static_cast<std::size_t>(k)], uniform(random, 0, 1), eases[static_cast<std::size_t>(k)]));
      keys = canonical(keys);
      const std::vector<double> times = timesOfFrames(keys, frames);
      for (const Value& key : keys)
        COMPARE_NEAR(times[key.at("frame").get<std::size_t>() - 1], key.at("t").get<double>(), 1e-12);
      for (const double t : times) QVERIFY(t >= 0 && t <= 1);
    }
  }

  void betweenKeysItIsEased() {
    const Value keys =
        canonical({keyValue(3, 0.2, "in"), keyValue(7, 0.6, "hold"), keyValue(9, 1, "in-out"), keyValue(13, 0)});
    const std::vector<double> times = timesOfFrames(keys, 15);
    const std::vector<double> wanted{0.2,
                                     0.2,
                                     0.2,
                                     0.2 + 0.4 / 16,
                                     0.2 + 0.4 / 4,
                                     0.2 + 0.4 * 9 / 16,
                                     0.6,
                                     0.6,
                                     1,
                                     1 - (3.0 / 16 - 2.0 / 64),
                                     0.5,
                                     3.0 / 16 - 2.0 / 64,
                                     0,
                                     0,
                                     0};
    for (std::size_t k = 0; k < wanted.size(); ++k) COMPARE_NEAR(times[k], wanted[k], 1e-12);
    // A key after the last frame is gone towards, and not reached.
    COMPARE_NEAR(timesOfFrames(canonical({keyValue(1, 0), keyValue(21, 1)}), 11).back(), 0.5, 1e-12);
  }

  void aKeyMoreChangesNothingWhereItIsLinear() {
    auto random = seededRandom();
    for (int round = 0; round < 100; ++round) {
      const int frames = uniformInt(random, 3, 40);
      Value keys = Value::array();
      for (int more = 0; more < 4; ++more) {
        const std::vector<double> before = timesOfFrames(keys, frames);
        keys = canonical(withKeyAt(keys, uniformInt(random, 1, frames), frames));
        const std::vector<double> after = timesOfFrames(keys, frames);
        for (std::size_t k = 0; k < before.size(); ++k) COMPARE_NEAR(after[k], before[k], 1e-12);
        keys[0]["t"] = uniform(random, 0, 1);
      }
    }
    QCOMPARE(withKeyAt(Value::array(), 4, 9).size(), std::size_t{3});
    const Value three = canonical({keyValue(1, 0), keyValue(4, 0.3), keyValue(9, 1)});
    QCOMPARE(withKeyAt(three, 4, 9), three);
    QCOMPARE(withKeyAt(canonical({keyValue(1, 0, "hold"), keyValue(9, 1)}), 4, 9)[1],
             canonical(Value::array({keyValue(4, 0, "hold")}))[0]);
  }

  void keysDoNotPassOneAnother() {
    const Value keys = canonical({keyValue(9, 1), keyValue(1, 0), keyValue(5, 0.3)});
    const auto at = [&](int frame) { return withKeyMoved(keys, 2, frame, 9)[2].at("frame").get<int>(); };
    QCOMPARE(at(3), 3);
    QCOMPARE(at(-4), 2);
    QCOMPARE(at(20), 8);
    QCOMPARE(withKeyMoved(keys, 0, 20, 12)[0].at("frame").get<int>(), 12);
    VERIFY_ERROR(frameKeysOf(canonical({keyValue(2, 0), keyValue(2, 1)})), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(FrameKeysTest)
#include "frame_keys_test.moc"
