#include "document/evaluator.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/thread_priority.h"
#include "document/evaluation.h"
#include "results/result_store.h"

namespace blossom {
namespace {

struct BackgroundRun {
  Document document;
  Progress progress;
  Evaluator::Done done;
  std::function<void(Results)> finished;
};

}  // namespace

struct Evaluator::State {
  State(std::shared_ptr<const Registry> types, std::size_t cacheLimit, std::shared_ptr<ResultStore> kept)
      : registry(std::move(types)), cache(cacheLimit), store(std::move(kept)) {}

  std::shared_ptr<const Registry> registry;
  ResultCache cache;
  FileSource files;
  Costs costs;
  std::shared_ptr<ResultStore> store;
  std::atomic<bool> anew = false;  ///< what was kept before is not to be found any more

  // The background thread: one job waits at most, for only the newest matters. `mutex` guards all of the following and is
  // never held while a callback runs or a job is destroyed.
  std::mutex mutex;
  std::condition_variable changed;
  std::optional<BackgroundRun> waiting;
  std::optional<CancelToken> running;     ///< of the job under way
  std::deque<Evaluation::Worthy> toKeep;  ///< written while there is nothing else to do
  bool ending = false;
  std::thread thread;

  Results evaluate(const Document& document, const Progress& progress, const Done& done) {
    cache.makeRoomFor(document.features().size());
    Evaluation evaluation(document, *registry, cache, files, costs, anew ? nullptr : store.get());
    Results results = evaluation.run(progress, done);
    if (!store) return results;
    const std::vector<Evaluation::Worthy> worthy = evaluation.worthKeeping();
    const std::lock_guard lock(mutex);
    toKeep.insert(toKeep.end(), worthy.begin(), worthy.end());
    return results;
  }

  void work();
  void perform(const BackgroundRun&);
};

void Evaluator::State::perform(const BackgroundRun& job) {
  try {
    Results results =
        evaluate(job.document, job.progress, [&](const FeatureId& id, const std::shared_ptr<const FeatureResult>& result) {
          if (job.done && !job.progress.cancelled()) job.done(id, result);
        });
    if (job.finished && !job.progress.cancelled()) job.finished(std::move(results));
  } catch (const Error& e) {
    if (e.code() != ErrorCode::Cancelled) throw;
  }
}

void Evaluator::State::work() {
  lowerThreadPriority();
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return ending || waiting || !toKeep.empty(); });
    if (ending) return;
    if (!waiting) {
      const Evaluation::Worthy next = std::move(toKeep.front());
      toKeep.pop_front();
      lock.unlock();
      store->keep(next.first, next.second->evaluated);
      lock.lock();
      continue;
    }
    std::optional<BackgroundRun> job;
    job.swap(waiting);
    running = job->progress.token();
    lock.unlock();
    perform(*job);
    job.reset();
    lock.lock();
    running.reset();
    changed.notify_all();
  }
}

Evaluator::Evaluator(std::shared_ptr<const Registry> registry, std::size_t cacheLimit, std::shared_ptr<ResultStore> store)
    : state_(std::make_unique<State>(std::move(registry), cacheLimit, std::move(store))) {}

Evaluator::~Evaluator() {
  cancelBackground();
  {
    const std::lock_guard lock(state_->mutex);
    state_->ending = true;
  }
  state_->changed.notify_all();
  if (state_->thread.joinable()) state_->thread.join();
}

Results Evaluator::evaluate(const Document& document, const Progress& progress, const Done& done) {
  return state_->evaluate(document, progress, done);
}

void Evaluator::evaluateInBackground(Document document, std::function<void(double, const std::string&)> progress, Done done,
                                     std::function<void(Results)> finished) {
  std::optional<BackgroundRun> job(BackgroundRun{std::move(document), Progress(CancelToken(), std::move(progress)),
                                                 std::move(done), std::move(finished)});
  const std::lock_guard lock(state_->mutex);
  if (state_->running) state_->running->cancel();
  state_->waiting.swap(job);  // the one replaced is destroyed after the lock is gone: `job` is older than `lock`
  if (!state_->thread.joinable()) state_->thread = std::thread([state = state_.get()] { state->work(); });
  state_->changed.notify_all();
}

void Evaluator::cancelBackground() {
  std::optional<BackgroundRun> dropped;
  const std::lock_guard lock(state_->mutex);
  if (state_->running) state_->running->cancel();
  dropped.swap(state_->waiting);
  state_->changed.notify_all();  // wakes waitForBackground
}

void Evaluator::forget() {
  state_->anew = true;
  state_->cache.clear();
}

void Evaluator::waitForBackground() {
  std::unique_lock lock(state_->mutex);
  if (state_->thread.get_id() == std::this_thread::get_id()) return;  // a callback would wait for itself
  state_->changed.wait(lock, [&] { return !state_->running && !state_->waiting; });
}

}  // namespace blossom
