#pragma once
#include <signal.h>

#include <cerrno>
#include <functional>
#include <string>

#include "core/file.h"
#include "support/support.h"
#include "worker/worker.h"

/// Calls of the self-test that every worker knows.
namespace blossom::test {

inline Value selftest(const Value& arguments, const Progress& progress = Progress::none(),
                      const WorkerOptions& options = {}) {
  const TemporaryFolder folder;
  return runInWorker("worker.selftest", arguments, folder.path(), progress, options);
}

/// Error of a call that is expected to fail.
inline Error failure(const Value& arguments, const Progress& progress = Progress::none(),
                     const WorkerOptions& options = {}) {
  try {
    selftest(arguments, progress, options);
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::Internal, "nothing was thrown");
}

/// Process id of the child that serves a call now.
inline int servingPid(const WorkerOptions& options = {}) {
  return selftest({{"mode", "pid"}}, Progress::none(), options).get<int>();
}

/// A process that has ended and that nobody has waited for exists.
inline bool exists(int pid) { return ::kill(pid, 0) == 0 || errno != ESRCH; }

/// Does something to the waiting child as soon as it has told its process id.
inline Progress whenWaiting(const CancelToken& token, std::function<void(int pid)> act) {
  return Progress(token, [act = std::move(act)](double, const std::string& stage) { act(std::stoi(stage)); });
}

}  // namespace blossom::test
