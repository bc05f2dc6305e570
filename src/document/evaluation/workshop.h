#pragma once
#include <condition_variable>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/progress.h"
#include "document/evaluator.h"

namespace blossom {

/// Threads that compute features and show their results. Pieces of work have content keys: one that is wanted by the next
/// document too goes on undisturbed, however many documents come meanwhile. The cheapest are begun first, and long ones
/// leave some of the threads to the others. Thread-safe, but only one evaluation at a time may ask for pieces.
class Workshop {
 public:
  using Result = std::shared_ptr<const FeatureResult>;

  /// What is expected to take as many ms, or more, counts as long.
  static constexpr double longFrom = 500;

  struct Piece {
    // What it is; never changed once it was handed over.
    std::string key;                                 ///< content key; empty: no other can join
    std::uint64_t generation = 0;                    ///< of the cache
    double expectedMs = 0;                           ///< 0: a result that is there already
    double computing = 1;                            ///< share of the work that is not showing, 0..1
    std::function<Result(const Progress&)> compute;  ///< may be empty when there is a result

    // Guarded by the workshop.
    std::function<void(const Result&, const Progress&)> show;  ///< the one of the newest document that wants it
    Result result;
    double fraction = 0;
    std::string stage;
    bool wanted = true, begun = false, showing = false, ended = false;
    CancelToken token;
  };
  using Handle = std::shared_ptr<Piece>;

  /// As it is now.
  struct Look {
    Result result;
    double fraction = 0;
    std::string stage;
    bool ended = false;
  };

  Workshop();
  ~Workshop();  ///< cancels all pieces and waits for them
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  struct Joined {
    Handle piece;
    bool shows = false;  ///< by the function given; else it shows the result in another way
  };
  /// A piece of this content that is under way, which is wanted from here on; a null piece when there is none.
  /// @param show takes the place of the former one, unless that is at work or belongs to the same document
  Joined join(const std::string& key, std::uint64_t generation, std::function<void(const Result&, const Progress&)> show);
  Handle begin(Piece);

  void wantNothing();   ///< a new document comes; what it does not ask for is dropped by
  void dropUnwanted();  ///< which cancels all pieces that nobody has asked for since
  void cancel();        ///< all pieces; does not wait
  [[nodiscard]] Look look(const Handle&);

  /// Until something has changed since the last call, or the token is cancelled and `wake` was called.
  void waitForNews(const CancelToken&);
  void wake();
  void waitUntilIdle();
  [[nodiscard]] bool ownsThisThread();  ///< which must not wait for the workshop

 private:
  void serve();
  void perform(Piece&);
  void computeAndShow(Piece&, const Progress&);
  [[nodiscard]] Handle next();
  void drop(const Handle&);
  void tell(Piece&, double fraction, const std::string& stage);

  const std::size_t longAtOnce_, atOnce_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Handle> pieces_;                 ///< that have not ended
  std::multimap<double, Handle> waiting_;    ///< of these, by the time they are expected to take
  std::size_t active_ = 0, activeLong_ = 0;  ///< of these
  bool news_ = false, ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace blossom
