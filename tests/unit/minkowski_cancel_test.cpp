#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "support/modeling.h"
#include "support/regions.h"
#include "support/timing.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Clock = std::chrono::steady_clock;

/// Cancels at a moment, as a user does: whatever the work is about then.
class CancelledAfter {
 public:
  CancelledAfter(const CancelToken& token, double seconds) {
    thread_ = std::thread([this, token, seconds] {
      std::unique_lock lock(mutex_);
      if (ended_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return over_; })) return;
      moment_ = Clock::now();
      token.cancel();
    });
  }
  ~CancelledAfter() { end(); }
  CancelledAfter(const CancelledAfter&) = delete;
  CancelledAfter& operator=(const CancelledAfter&) = delete;

  /// The work is over. Returns how long it went on after it was cancelled, if it was.
  std::optional<double> end() {
    const Clock::time_point now = Clock::now();
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    ended_.notify_all();
    if (thread_.joinable()) thread_.join();
    if (!moment_) return std::nullopt;
    return std::max(0.0, std::chrono::duration<double>(now - *moment_).count());
  }

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::optional<Clock::time_point> moment_;
  std::thread thread_;
};

struct Work {
  const char* command;
  Value parameters;
  std::vector<Shape> inputs;
};

Region spiky(Random& random, int corners) { return polygonRegion(spikyPoints(random, {0, 0}, 50, corners)); }

/// Squares with a hole each, beside one another.
Region frames(int across, double size) {
  Region region;
  for (int x = 0; x < across; ++x)
    for (int y = 0; y < across; ++y) {
      const Vec2 low(2 * size * x, 2 * size * y), high = low + Vec2(size, size), inset(0.3 * size, 0.3 * size);
      region.loops.push_back(rectanglePath(low, high));
      Path hole = rectanglePath(low + inset, high - inset);
      region.loops.push_back(reversed(hole));
    }
  return region;
}

Region regularRegion(double reach, int corners) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back(reach * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygonRegion(points);
}

Region wavy(double reach, int corners) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back((reach + std::sin(7 * angle)) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygonRegion(points);
}

}  // namespace

/// Every feature of the plugin ends soon after it is cancelled, in this process or in the worker, wherever it is.
class MinkowskiCancelTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFeatureEndsSoon() {
    Random random = seededRandom();
    const Region round = regularRegion(30, 4000);
    const std::vector<Work> works{
        {"minkowski-sum", {}, {spiky(random, 400), spiky(random, 300)}},
        {"minkowski-sum", {}, {frames(40, 1), circleRegion(0.3)}},
        {"minkowski-sum", {}, {wavy(80, 150'000), circleRegion(2)}},
        {"minkowski-difference", {}, {spiky(random, 300), circleRegion(1)}},
        {"region-open", {}, {spiky(random, 300), circleRegion(1)}},
        {"region-close", {}, {frames(30, 1), ellipseRegion(0.3, 0.2)}},
        {"outline-sweep", {}, {spiky(random, 300), spiky(random, 100)}},
        {"region-repeat", {{"count", 1000}}, {spiky(random, 40)}},
        {"region-hull", {}, {wavy(80, 150'000)}},
        {"morph-solid", {{"height", 5}}, {spiky(random, 60), spiky(random, 50)}},
        {"morph-compare", {}, {spiky(random, 60), frames(3, 10)}},
        {"morph", {{"frames", 400}}, {spiky(random, 40), spiky(random, 30)}},
        {"morph", {{"frames", 60}, {"area-preserving", true}}, {spiky(random, 40), spiky(random, 30), circleRegion(20)}},
        {"morph", {{"t", 1.4}}, {round, made("minkowski-sum", Value::object(), {round, circleRegion(5)}).shape}},
        {"morph", {{"frames", 100}, {"degree", 2}}, {ellipseRegion(9, 4), spiky(random, 20), circleRegion(8), wavy(9, 60)}},
    };
    double worst = 0;
    int cancelled = 0;
    for (const Work& work : works) {
      const double seconds = std::min(4.0, timeOf(work));
      for (const double share : {0.02, 0.15, 0.4, 0.65, 0.9}) {
        const std::optional<double> late = lateness(work, share * seconds);
        if (!late) continue;
        ++cancelled;
        if (*late > worst) qInfo("%s, %.2f of %.2f s: ends %.3f s later", work.command, share * seconds, seconds, *late);
        worst = std::max(worst, *late);
      }
    }
    QVERIFY2(refused_.empty(), fmt::format("{}", fmt::join(refused_, "\n")).c_str());
    QVERIFY(cancelled > 2 * static_cast<int>(works.size()));
    qInfo("figure cancel_everywhere_s %.3f", worst);
  }

 private:
  /// How long the work takes; 4 seconds when it takes longer.
  double timeOf(const Work& work) {
    const CancelToken token;
    CancelledAfter limit(token, 4);
    return secondsOf([&] { run(work, token); });
  }

  /// How long it goes on when it is cancelled then; nullopt when it is done before.
  std::optional<double> lateness(const Work& work, double seconds) {
    const CancelToken token;
    CancelledAfter cancelling(token, seconds);
    const bool ended = run(work, token);
    const std::optional<double> late = cancelling.end();
    return ended ? std::nullopt : late;
  }

  /// Whether it came to its end. Nothing else than having been cancelled is a reason not to.
  bool run(const Work& work, const CancelToken& token) {
    try {
      made(work.command, work.parameters.is_null() ? Value::object() : work.parameters, work.inputs, Progress(token));
      return true;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Cancelled) refused_.insert(fmt::format("{}: {}", work.command, error.message()));
      return false;
    }
  }

  std::set<std::string> refused_;
};

BLOSSOM_TEST(MinkowskiCancelTest)
#include "minkowski_cancel_test.moc"
