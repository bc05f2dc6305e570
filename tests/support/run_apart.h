#pragma once
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace blossom::test {

/// What `work` returns in a process of its own, which is ended after some seconds; nothing when that was necessary, or when
/// it failed, which is told on standard error. For peers that may take minutes, or crash.
template <class Work>
auto runApart(const Work& work, double seconds) {
  using Result = std::invoke_result_t<Work>;
  static_assert(std::is_trivially_copyable_v<Result>);
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    for (const int crash : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) std::signal(crash, SIG_DFL);  // no test has failed
    try {
      const Result result = work();
      _exit(write(pipe[1], &result, sizeof result) == sizeof result ? 0 : 1);
    } catch (const std::exception& problem) {
      fmt::print(stderr, "{}\n", problem.what());
      _exit(1);
    }
  }
  close(pipe[1]);
  pollfd ready{pipe[0], POLLIN, 0};
  Result result{};
  const bool done = poll(&ready, 1, static_cast<int>(1e3 * seconds)) == 1 &&
                    read(pipe[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
  if (!done) kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(pipe[0]);
  return done ? std::optional<Result>(result) : std::nullopt;
}

}  // namespace blossom::test
