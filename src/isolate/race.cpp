#include "isolate/race.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "core/error.h"

namespace blossom {

namespace {

/// One attempt in its thread.
class Runner {
 public:
  Runner(std::mutex& mutex, std::condition_variable& changed) : mutex_(mutex), changed_(changed) {}
  ~Runner() {
    token_.cancel();
    if (thread_.joinable()) thread_.join();
  }
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  void start(const Attempt& attempt, const Progress::Listener& listener) {
    thread_ = std::thread([this, attempt, progress = Progress(token_, listener)] { run(attempt, progress); });
  }
  [[nodiscard]] bool started() const { return thread_.joinable(); }

  // The rest under the mutex.
  [[nodiscard]] bool done() const { return result_ || failure_; }
  [[nodiscard]] std::optional<Evaluated>& result() { return result_; }
  /// Whether it has failed in a way that leaves hope for the other.
  [[nodiscard]] bool failedItsChecks() const {
    try {
      if (failure_) std::rethrow_exception(failure_);
    } catch (const Error& error) {
      return error.code() == ErrorCode::Internal;
    } catch (...) {
      return false;
    }
    return false;
  }
  [[noreturn]] void rethrow() const { std::rethrow_exception(failure_); }

 private:
  void run(const Attempt& attempt, const Progress& progress) {
    std::optional<Evaluated> result;
    std::exception_ptr failure;
    try {
      result = attempt(progress);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
    failure_ = failure;
    changed_.notify_all();
  }

  std::mutex& mutex_;
  std::condition_variable& changed_;
  CancelToken token_;
  std::optional<Evaluated> result_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace

Evaluated firstOf(const Attempt& first, const Attempt& second, double headStart, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  std::mutex mutex;
  std::condition_variable changed;
  Runner a(mutex, changed), b(mutex, changed);
  std::unique_lock lock(mutex);
  a.start(first, [&progress](double fraction, const std::string& stage) { progress.report(fraction, stage); });
  for (;;) {
    changed.wait_for(lock, std::chrono::milliseconds(20));
    progress.check();
    if (a.result()) return std::move(*a.result());
    if (b.result()) return std::move(*b.result());
    if (a.done() && (!a.failedItsChecks() || b.done())) a.rethrow();
    const bool due = std::chrono::duration<double>(Clock::now() - start).count() >= headStart || a.done();
    if (due && !b.started()) b.start(second, {});
  }
}

}  // namespace blossom
