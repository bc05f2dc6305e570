#include "worker/kept_children.h"

#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "worker/per_process.h"
#include "worker/worker.h"

namespace blossom {

namespace {

using Clock = std::chrono::steady_clock;
using ChildPointer = std::unique_ptr<WorkerChild>;

/// Each takes some 50 MB; more are in use at a time only by parallel work.
constexpr std::size_t mostIdle = 4;

struct Kept {
  ChildPointer child;
  Clock::time_point until;
};

struct Pool {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Kept> idle;  ///< the one used last at the end
  bool watched = false;    ///< a thread ends those whose time is over
  bool closed = false;     ///< this process is ending
};

Pool& pool() { return ofThisProcess<Pool>(); }

Surroundings surroundingsOf(const std::filesystem::path& program) {
  std::error_code ignored;
  Surroundings now{program.string(),
                   std::filesystem::current_path(ignored).string(),
                   ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid())),
                   {}};
  for (char** entry = environ; entry && *entry; ++entry) now.environment.emplace_back(*entry);
  return now;
}

/// nullptr when none is idle that could have been started now.
ChildPointer takeIdle(const Surroundings& now, const std::string& module) {
  Pool& all = pool();
  const std::lock_guard lock(all.mutex);
  auto chosen = all.idle.end();
  for (auto each = all.idle.begin(); each != all.idle.end(); ++each) {
    if (each->child->surroundings != now) continue;
    const bool loaded = module.empty() || each->child->modules.contains(module);
    if (loaded || chosen == all.idle.end() || !chosen->child->modules.contains(module)) chosen = each;
  }
  if (chosen == all.idle.end()) return nullptr;
  ChildPointer child = std::move(chosen->child);
  all.idle.erase(chosen);
  return child;
}

/// Under the mutex.
std::vector<Kept> takeOver(std::vector<Kept>& idle, Clock::time_point now) {
  const auto firstOver = std::stable_partition(idle.begin(), idle.end(), [&](const Kept& each) { return each.until > now; });
  std::vector<Kept> over(std::make_move_iterator(firstOver), std::make_move_iterator(idle.end()));
  idle.erase(firstOver, idle.end());
  return over;
}

/// Ends children whose time is over until none is idle.
void watch(Pool& all) {
  std::unique_lock lock(all.mutex);
  while (!all.idle.empty()) {
    const auto next =
        std::min_element(all.idle.begin(), all.idle.end(), [](const Kept& a, const Kept& b) { return a.until < b.until; });
    const Clock::time_point until = next->until;
    all.changed.wait_until(lock, until);
    std::vector<Kept> over = takeOver(all.idle, Clock::now());
    lock.unlock();
    over.clear();  // waits for their end
    lock.lock();
  }
  all.watched = false;
}

/// In a thread that no signal is delivered to. @returns false when the system refuses another thread.
bool startWatch(Pool& all) {
  sigset_t every, before;
  sigfillset(&every);
  ::pthread_sigmask(SIG_SETMASK, &every, &before);
  bool started = true;
  try {
    std::thread([&all] { watch(all); }).detach();
  } catch (const std::system_error&) {
    started = false;
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return started;
}

std::vector<Kept> takeAll(bool forEver) {
  Pool& all = pool();
  const std::lock_guard lock(all.mutex);
  if (forEver) all.closed = true;
  all.changed.notify_all();
  return std::exchange(all.idle, {});
}

/// A program that has ended leaves no child behind.
struct EndWithProgram {
  ~EndWithProgram() { takeAll(true).clear(); }
};

}  // namespace

ChildPointer takeChild(const std::filesystem::path& program, const std::string& module) {
  const Surroundings now = surroundingsOf(program);
  while (ChildPointer child = takeIdle(now, module))
    if (child->process.silent()) return child;  // else somebody ended it
  return std::make_unique<WorkerChild>(now);
}

void keepChild(ChildPointer child, double seconds) {
  static const EndWithProgram atEnd;
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  Pool& all = pool();
  std::vector<Kept> surplus;  // destroyed, and waited for, without the mutex
  const std::lock_guard lock(all.mutex);
  if (all.closed) return;
  if (!all.watched && !(all.watched = startWatch(all))) return;
  all.idle.push_back({std::move(child), until});
  if (all.idle.size() > mostIdle) {
    surplus.push_back(std::move(all.idle.front()));
    all.idle.erase(all.idle.begin());
  }
  all.changed.notify_all();
}

void endIdleWorkers() { takeAll(false).clear(); }

}  // namespace blossom
