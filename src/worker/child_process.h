#pragma once
#include <sys/types.h>

#include <filesystem>
#include <string>

namespace blossom {

/// A child process in a process group of its own, with one socket as its stdin and stdout. The destructor kills the group
/// and waits for the child, so that no path out of the caller leaves a process or a zombie behind.
///
/// posix_spawn rather than fork (and Boost.Process 1.74, which forks): it does not copy the page tables of a workbench
/// holding gigabytes, runs no code of ours between fork and exec in a program with many threads, and with close-on-exec
/// descriptors two children started at the same time never hold each other's channel open.
class ChildProcess {
 public:
  /// @throws Error FileNotFound, Internal when the system refuses another process.
  explicit ChildProcess(const std::filesystem::path& program);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sends what it can of `pending` (and removes it there), appends what has arrived to `received`; waits at most
  /// `milliseconds`.
  /// @returns false when the child has closed its end.
  bool exchange(std::string& pending, std::string& received, int milliseconds);
  /// Whether it is there and has sent nothing that was not received.
  [[nodiscard]] bool silent() const;
  /// Waits for the end. @returns the status as of waitpid.
  int wait();

 private:
  pid_t pid_ = -1;
  int channel_ = -1;
};

}  // namespace blossom
