#include "cli/interruption.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <utility>

#include "core/temporaries.h"
#include "worker/worker.h"

namespace blossom {
namespace {

constexpr int endOfWatch = SIGUSR2;
constexpr long patienceMs = 300;  ///< with the clean-up, less than half a second in all

sigset_t watchedSignals() {
  sigset_t watched;
  sigemptyset(&watched);
  for (const int number : {SIGINT, SIGTERM, SIGQUIT, endOfWatch}) sigaddset(&watched, number);
  struct sigaction hangup {};
  ::sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaddset(&watched, SIGHUP);  // ignored under nohup
  return watched;
}

int nextSignal(const sigset_t& watched) {
  int number = 0;
  while (::sigwait(&watched, &number) != 0) {
  }
  return number;
}

/// Whether the work ended by itself.
bool endsInTime(const sigset_t& watched) {
  const timespec patience{0, patienceMs * 1'000'000};
  int number = 0;
  while ((number = ::sigtimedwait(&watched, nullptr, &patience)) < 0 && errno == EINTR) {
  }
  return number == endOfWatch;
}

void watch(const sigset_t& watched, CancelToken token, const std::function<void()>& beforeLeaving) {
  if (nextSignal(watched) == endOfWatch) return;
  token.cancel();
  if (endsInTime(watched)) return;
  endAllWorkers();
  removeTemporaries();
  beforeLeaving();
  ::_exit(1);
}

}  // namespace

Interruption::Interruption(CancelToken token, std::function<void()> beforeLeaving) {
  const sigset_t watched = watchedSignals();
  ::pthread_sigmask(SIG_BLOCK, &watched, nullptr);
  watcher_ =
      std::thread([watched, token = std::move(token), tell = std::move(beforeLeaving)] { watch(watched, token, tell); });
}

Interruption::~Interruption() {
  ::pthread_kill(watcher_.native_handle(), endOfWatch);
  watcher_.join();
}

}  // namespace blossom
