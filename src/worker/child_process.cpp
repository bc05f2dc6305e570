#include "worker/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>

#include "core/error.h"
#include "worker/per_process.h"
#include "worker/worker.h"

namespace blossom {

namespace {

/// Group of its own, no signals blocked or ignored: the child must die of SIGTERM and SIGXCPU whatever the parent does with
/// them.
class SpawnSettings {
 public:
  explicit SpawnSettings(int channel) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, channel, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, channel, STDOUT_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  int spawn(pid_t& pid, const std::string& program) const {
    std::string name = program;
    std::array<char*, 2> arguments{name.data(), nullptr};
    return posix_spawn(&pid, program.c_str(), &actions_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

/// All children there are.
struct Children {
  std::mutex mutex;
  std::set<pid_t> running;
};

}  // namespace

void endAllWorkers() noexcept {
  Children& all = ofThisProcess<Children>();
  const std::lock_guard lock(all.mutex);
  for (const pid_t pid : all.running) ::kill(-pid, SIGKILL);
  // Left as zombies for those who wait for them; gone already when one of these was quicker.
  siginfo_t ended;
  for (const pid_t pid : all.running)
    while (::waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
    }
}

ChildProcess::ChildProcess(const std::filesystem::path& program) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw Error(ErrorCode::Internal,
                std::string("No channel to a helper process could be opened: ") + std::strerror(errno) + ".");
  Children& all = ofThisProcess<Children>();
  std::unique_lock lock(all.mutex);
  const int problem = SpawnSettings(ends[1]).spawn(pid_, program.string());
  if (problem == 0) all.running.insert(pid_);
  lock.unlock();
  ::close(ends[1]);
  channel_ = ends[0];
  if (problem == 0) return;
  ::close(channel_);
  const ErrorCode code = problem == ENOENT || problem == EACCES ? ErrorCode::FileNotFound : ErrorCode::Internal;
  throw Error(code, "The helper program " + program.string() + " could not be started: " + std::strerror(problem) + ".");
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    ::kill(-pid_, SIGKILL);
    wait();
  }
  ::close(channel_);
}

bool ChildProcess::exchange(std::string& pending, std::string& received, int milliseconds) {
  pollfd watched{channel_, static_cast<short>(POLLIN | (pending.empty() ? 0 : POLLOUT)), 0};
  if (::poll(&watched, 1, milliseconds) <= 0) return true;
  if (watched.revents & POLLOUT) {
    const ssize_t sent = ::send(channel_, pending.data(), pending.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    // A child that is gone shows below as the end of its output; a full channel as 0 bytes sent.
    pending.erase(0, sent > 0 ? static_cast<std::size_t>(sent) : errno == EPIPE ? pending.size() : 0);
  }
  if (!(watched.revents & (POLLIN | POLLHUP | POLLERR))) return true;
  std::array<char, 1 << 16> buffer;
  const ssize_t count = ::recv(channel_, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (count > 0) received.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

bool ChildProcess::silent() const {
  pollfd watched{channel_, POLLIN, 0};
  return ::poll(&watched, 1, 0) == 0;
}

int ChildProcess::wait() {
  int status = 0;
  siginfo_t ended;
  while (::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  Children& all = ofThisProcess<Children>();
  const std::lock_guard lock(all.mutex);
  all.running.erase(pid_);  // before its number can belong to another process
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

}  // namespace blossom
