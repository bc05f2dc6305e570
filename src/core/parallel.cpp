#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <memory>

#include "core/error.h"

namespace blossom {

namespace {

/// Counts what a loop has done, and so repeats the synchronisation that TBB does itself: a piece runs after everything
/// before the loop and before everything after it. ThreadSanitizer does not see that of TBB and would report every loop as a
/// race.
class Tally {
 public:
  Tally() { done_.store(0, std::memory_order_release); }
  void begin() const { (void)done_.load(std::memory_order_acquire); }
  void add(std::size_t count) { done_.fetch_add(count, std::memory_order_release); }
  [[nodiscard]] std::size_t done() const { return done_.load(std::memory_order_acquire); }

 private:
  std::atomic<std::size_t> done_;
};

}  // namespace

void parallelFor(std::size_t count, std::size_t grain, const Progress& progress,
                 const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  Tally tally;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)), [&](const auto& range) {
    tally.begin();
    progress.check();
    body(range.begin(), range.end());
    tally.add(range.size());
  });
  // When a piece of a loop around this one has thrown, TBB ends this one early and says nothing. What is thrown here is
  // dropped there: the loop around hands on the first exception.
  if (tally.done() != count)
    throw Error(ErrorCode::Cancelled, "The work was cancelled, because another part of it has failed.");
}

namespace {
std::atomic<int> chosenThreads = 0;
}

int threadLimit() { return chosenThreads; }

void setThreadLimit(int threads) {
  static std::unique_ptr<tbb::global_control> limit;
  chosenThreads = threads;
  limit.reset();
  if (threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(threads));
}

}  // namespace blossom
