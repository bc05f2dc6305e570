#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace blossom::ui {

/// A background thread that runs one function after the other.
class Background {
 public:
  using Work = std::function<void()>;

  Background() = default;
  ~Background();  ///< waits for the running function; drops queued ones
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  void start(Work);  ///< must not throw
  void drop();       ///< drops queued functions

 private:
  void run();

  std::mutex guard_;
  std::condition_variable changed_;
  std::deque<Work> waiting_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace blossom::ui
