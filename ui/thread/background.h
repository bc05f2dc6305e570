#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace blossom::ui {

/// A thread of its own that does one thing after another, behind the window's own work.
class Background {
 public:
  using Work = std::function<void()>;

  Background() = default;
  ~Background();  ///< waits for what is under way; what waits is dropped
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  void start(Work);  ///< must not throw
  void drop();       ///< what waits

 private:
  void run();

  std::mutex guard_;
  std::condition_variable changed_;
  std::deque<Work> waiting_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace blossom::ui
