#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace blossom {

/// Request to stop long work. Copies share one flag; `cancel` may be called from any thread.
class CancelToken {
 public:
  CancelToken() : flag_(std::make_shared<std::atomic<bool>>(false)) {}
  void cancel() const noexcept { flag_->store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const noexcept { return flag_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

/// Progress and cancellation of long work; every long loop polls it. `check`, `report` and `cancelled` may be called from
/// several threads at once; the listener runs in the reporting thread, at most once per percent.
class Progress {
 public:
  /// @param fraction done so far, 0..1  @param stage what is being done, for the user
  using Listener = std::function<void(double fraction, const std::string& stage)>;

  Progress() = default;
  explicit Progress(CancelToken token, Listener listener = {});

  /// A progress without listener that is never cancelled; for tests and short calls.
  static Progress none() { return Progress(); }

  [[nodiscard]] bool cancelled() const noexcept { return token_.cancelled(); }
  [[nodiscard]] const CancelToken& token() const noexcept { return token_; }

  /// @throws Error Cancelled when the token was cancelled.
  void check() const;
  /// Reports and checks. @param fraction is clamped to 0..1.
  void report(double fraction, const std::string& stage = {}) const;

  /// Progress of one step of the work, mapped to [from, to] of this one.
  [[nodiscard]] Progress part(double from, double to) const;

 private:
  CancelToken token_;
  Listener listener_;
  std::shared_ptr<std::atomic<int>> lastPercent_ = std::make_shared<std::atomic<int>>(-1);
};

}  // namespace blossom
