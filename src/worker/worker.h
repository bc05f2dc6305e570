#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "core/progress.h"
#include "parameter/value.h"

namespace blossom {

/// A call that may run in a child process: arguments and result are JSON; bulk data travel as files in `folder`, which both sides see.
using WorkerFunction = std::function<Value(const Value& arguments, const std::filesystem::path& folder, const Progress&)>;

/// Makes a function callable by name from `blossom-worker`. Called at static initialisation of the room that owns it, or from
/// its `registerXxxCalls()`.
void registerWorkerCall(std::string name, WorkerFunction);

/// Runs a registered call in a child process (`blossom-worker`, found beside the running program, in ../libexec/blossom, or
/// named by $BLOSSOM_WORKER). Blocks; polls `progress` about every 20 ms and kills the child when cancelled.
/// `folder` is a TemporaryFolder of the caller.
/// @throws Error as thrown by the call in the child (code, message, hint kept); Cancelled; WorkerDied when the child crashed or was
/// ended by hand, with the signal in the message; FileNotFound when the worker program is missing.
Value runInWorker(const std::string& name, const Value& arguments, const std::filesystem::path& folder, const Progress&);

/// The child's side: serves one call read from stdin, writes progress and result as JSON lines to stdout. Returns the exit code.
int workerMain();

}  // namespace blossom
