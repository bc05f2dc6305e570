#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <memory>

namespace blossom {

namespace {

/// Repeats the synchronisation that TBB does itself: a piece runs after everything before the loop and before everything
/// after it. ThreadSanitizer does not see that of TBB and would report every loop as a race.
class Order {
 public:
  class Piece {
   public:
    explicit Piece(Order& order) : order_(order) { (void)order_.pieces_.load(std::memory_order_acquire); }
    ~Piece() { order_.pieces_.fetch_add(1, std::memory_order_release); }
    Piece(const Piece&) = delete;
    Piece& operator=(const Piece&) = delete;

   private:
    Order& order_;
  };
  Order() { pieces_.store(0, std::memory_order_release); }
  void allDone() const { (void)pieces_.load(std::memory_order_acquire); }

 private:
  std::atomic<std::size_t> pieces_;
};

}  // namespace

void parallelFor(std::size_t count, std::size_t grain, const Progress& progress,
                 const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  Order order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)), [&](const auto& range) {
    const Order::Piece piece(order);
    progress.check();
    body(range.begin(), range.end());
  });
  order.allDone();
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
