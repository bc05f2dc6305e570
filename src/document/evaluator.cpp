#include "document/evaluator.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/thread_priority.h"
#include "document/evaluation/background_evaluation.h"
#include "results/result_store.h"

namespace blossom {
namespace {

struct BackgroundRun {
  Document document;
  Progress progress;
  Evaluator::Show show;
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

  // The background thread goes through documents and gives their features to the workshop. One job waits at most, for only
  // the newest matters. `mutex` guards all of the following and is never held while a callback runs or a job is destroyed.
  std::mutex mutex;
  std::condition_variable changed;
  std::optional<BackgroundRun> waiting;
  std::optional<CancelToken> running;  ///< of the job under way
  bool ending = false;
  std::thread thread;

  // Another thread writes results to the store, so that no evaluation waits for a disk.
  std::deque<Evaluation::Worthy> toKeep;
  bool writing = false;        ///< one that was taken out of these
  bool allHandedOver = false;  ///< nothing comes any more
  std::thread keeper;
  CancelToken keeping;

  Workshop workshop;  // ends first: its threads use all of these

  [[nodiscard]] EvaluationSources sources() { return {*registry, cache, files, costs, anew ? nullptr : store.get()}; }

  Results evaluate(const Document& document, const Progress& progress, const Done& done) {
    Evaluation evaluation(document, sources());
    try {
      Results results = evaluation.run(progress, done);
      keep(evaluation.worthKeeping());
      return results;
    } catch (const Error&) {
      keep(evaluation.worthKeeping());  // what was done before it was cancelled
      throw;
    }
  }

  void keep(const std::vector<Evaluation::Worthy>&);
  void writeKept();
  void work();
  void perform(BackgroundRun&);
  void end();
};

void Evaluator::State::keep(const std::vector<Evaluation::Worthy>& worthy) {
  if (!store || worthy.empty()) return;
  const std::lock_guard lock(mutex);
  toKeep.insert(toKeep.end(), worthy.begin(), worthy.end());
  if (!keeper.joinable()) keeper = std::thread([this] { writeKept(); });
  changed.notify_all();
}

void Evaluator::State::writeKept() {
  lowerThreadPriority();
  const Progress progress(keeping, {});
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return allHandedOver || !toKeep.empty(); });
    if (toKeep.empty() || progress.cancelled()) return;
    const Evaluation::Worthy next = std::move(toKeep.front());
    toKeep.pop_front();
    writing = true;
    lock.unlock();
    store->keep(next.first, next.second->evaluated, progress);
    lock.lock();
    writing = false;
    changed.notify_all();
  }
}

// The evaluation, which was cancelled, ends first: it hands over what it has done. That is still written, as far as it takes
// a moment only.
void Evaluator::State::end() {
  constexpr auto moment = std::chrono::seconds(1);
  {
    const std::lock_guard lock(mutex);
    ending = true;
  }
  changed.notify_all();
  if (thread.joinable()) thread.join();
  workshop.waitUntilIdle();
  if (!keeper.joinable()) return;
  {
    std::unique_lock lock(mutex);
    allHandedOver = true;
    changed.notify_all();
    changed.wait_for(lock, moment, [&] { return toKeep.empty() && !writing; });
  }
  keeping.cancel();
  keeper.join();
}

void Evaluator::State::perform(BackgroundRun& job) {
  try {
    cache.makeRoomFor(job.document.features().size());
    BackgroundEvaluation evaluation(job.document, sources(), workshop, std::move(job.show),
                                    [this](const Evaluation::Worthy& worthy) { keep({worthy}); });
    Results results = evaluation.run(job.progress);
    if (job.finished && !job.progress.cancelled()) job.finished(std::move(results));
  } catch (const Error& e) {
    if (e.code() != ErrorCode::Cancelled) throw;
  }
}

void Evaluator::State::work() {
  lowerThreadPriority();
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return ending || waiting; });
    if (ending) return;
    std::optional<BackgroundRun> job;
    job.swap(waiting);
    running = job->progress.token();
    lock.unlock();
    perform(*job);
    job.reset();
    lock.lock();
    if (!waiting) workshop.cancel();  // no document follows that could want what goes on
    running.reset();
    changed.notify_all();
  }
}

Evaluator::Evaluator(std::shared_ptr<const Registry> registry, std::size_t cacheLimit, std::shared_ptr<ResultStore> store)
    : state_(std::make_unique<State>(std::move(registry), cacheLimit, std::move(store))) {}

Evaluator::~Evaluator() {
  cancelBackground();
  state_->end();
}

Results Evaluator::evaluate(const Document& document, const Progress& progress, const Done& done) {
  state_->cache.makeRoomFor(document.features().size());
  return state_->evaluate(document, progress, done);
}

Results Evaluator::evaluateBeside(const Document& document, const Progress& progress) {
  return state_->evaluate(document, progress, {});
}

void Evaluator::evaluateInBackground(Document document, std::function<void(double, const std::string&)> progress, Show show,
                                     std::function<void(Results)> finished) {
  std::optional<BackgroundRun> job(BackgroundRun{std::move(document), Progress(CancelToken(), std::move(progress)),
                                                 std::move(show), std::move(finished)});
  const std::lock_guard lock(state_->mutex);
  if (state_->running) state_->running->cancel();
  state_->waiting.swap(job);  // the one replaced is destroyed after the lock is gone: `job` is older than `lock`
  if (!state_->thread.joinable()) state_->thread = std::thread([state = state_.get()] { state->work(); });
  state_->changed.notify_all();
  state_->workshop.wake();
}

void Evaluator::cancelBackground() {
  std::optional<BackgroundRun> dropped;
  const std::lock_guard lock(state_->mutex);
  if (state_->running) state_->running->cancel();
  dropped.swap(state_->waiting);
  state_->workshop.cancel();
  state_->changed.notify_all();  // wakes waitForBackground
}

void Evaluator::forget() {
  state_->anew = true;
  state_->cache.clear();
}

void Evaluator::waitForBackground() {
  if (state_->workshop.ownsThisThread()) return;  // a callback would wait for itself
  {
    std::unique_lock lock(state_->mutex);
    if (state_->thread.get_id() == std::this_thread::get_id()) return;
    state_->changed.wait(lock, [&] { return !state_->running && !state_->waiting; });
  }
  state_->workshop.waitUntilIdle();
}

}  // namespace blossom
