#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "core/progress.h"
#include "parameter/value.h"

namespace blossom {

/// A call that may run in a child process: arguments and result are JSON; bulk data travel as files in `folder`, which both
/// sides see.
using WorkerFunction = std::function<Value(const Value& arguments, const std::filesystem::path& folder, const Progress&)>;

/// Makes a function callable by name from `blossom-worker`. Called at static initialisation of the room that owns it, or
/// from its `registerXxxCalls()`.
void registerWorkerCall(std::string name, WorkerFunction);

struct WorkerOptions {
  std::string activity{};          ///< what the child does, for messages: "reading wheel.step"; empty: the name of the call
  double cpuSeconds = 0;           ///< computing time after which the child is ended, up to a second later; 0: unlimited
  std::uintmax_t memory = 0;       ///< address space of the child in bytes; 0: as much as the machine has memory
  std::filesystem::path module{};  ///< shared module that the child loads for the call; empty: the worker knows it itself
  double idleSeconds = 60;         ///< how long the child is kept for further calls after this one; 0: not at all
};

/// The shared module (or program) that a function or object belongs to: `moduleOf(&anchor)` is a plugin's way to find
/// itself.
std::filesystem::path moduleOf(const void* address);

/// Runs a registered call in a child process (`blossom-worker`, found beside the running program, in ../libexec/blossom, or
/// named by $BLOSSOM_WORKER). Blocks; polls `progress` about every 20 ms and kills the child, with all it started, when
/// cancelled. The child also ends when this process dies. Callable from several threads at once. `folder` is a
/// TemporaryFolder of the caller.
///
/// Starting a child costs 50 to 100 ms, mostly dynamic linking. One that has returned a result, and holds little memory
/// afterwards, is therefore kept and serves the next call of any thread, within that call's own limits; a call meets the
/// same environment, working folder and priority as in a new child. After an error, a crash or a cancelled call there is a
/// new one.
/// @throws Error as thrown by the call in the child (code, message, hint kept); Cancelled; WorkerDied when the child crashed
/// or was ended by hand, with the signal in the message; LimitExceeded when it took more memory or computing time than
/// `options` allow; FileNotFound when the worker program is missing.
Value runInWorker(const std::string& name, const Value& arguments, const std::filesystem::path& folder, const Progress&,
                  const WorkerOptions& options = {});

/// Ends the child processes that are kept for further calls, and returns when they are gone.
void endIdleWorkers();

/// Ends every child process of this one, whoever waits for it, and returns when they are gone; for a process that is about
/// to end itself.
void endAllWorkers() noexcept;

/// The child's side: serves calls read from stdin, one after the other, and writes progress and results as JSON lines to
/// stdout. What a call itself prints to stdout is dropped. Returns the exit code.
///
/// Every worker also knows the call "worker.selftest", by which a test or a diagnosis sees that processes start, report and
/// end as they should. Its argument "mode" is one of these, of which those without another result return the process id:
/// "echo" returns the arguments; "pid" does nothing; "threads" returns the limit of threads; "tell" reports the process id
/// as stage, "wait" reports it and waits to be ended; "abort" crashes; "throw" throws the Error that "code", "message" and
/// "hint" describe; "noise" prints to stdout; "memory" reserves "bytes" (without them, all it can get) and gives them back,
/// "hoard" fills "bytes" and keeps them; "spin" takes "seconds" of computing time (without them, all it can get).
int workerMain();

}  // namespace blossom
